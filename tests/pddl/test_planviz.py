"""Pictures of plans for an editor: what is written, and what the script draws when it is run."""

import json
import re
import shutil
import subprocess
from collections.abc import Iterable
from typing import Any
from xml.etree import ElementTree

import msgspec
import numpy as np
import pytest
import toy_domain
import toy_relations
from places import GOLDEN
from toy_places import grounding, mixed, swap

from neurosym.pddl.durative import durative_problem_text
from neurosym.pddl.encodings import print_ground_plan
from neurosym.pddl.planviz import planviz_json, planviz_script, scenes_of
from neurosym.pddl.problem import problem_text
from neurosym.planners import plan
from neurosym.problems import Problem
from neurosym.tasks.steps import print_plan

NODE = shutil.which("node")
needs_node = pytest.mark.skipif(NODE is None, reason="node is not installed")
DRIVER = """
const asked = JSON.parse(require("fs").readFileSync(0, "utf8"));
const visualization = eval(asked.script);
process.stdout.write(visualization[asked.name](...asked.arguments));
"""
"""What the extension does: it evaluates the script, and calls a function of the value."""
WIDTH, MARGIN = 400, 0.03
SVG = "{http://www.w3.org/2000/svg}"
ERRAND = toy_domain.problem({"item-01": (0.6, 0.16, 0.225)})


def texts() -> dict[str, str]:
    """What is written for the toy domain, but for the program."""
    scenes = planviz_script(grounding(), [swap(), mixed()]).rsplit("})(", 1)[1].removesuffix(");\n")
    return {
        "domain.planviz.json": planviz_json(),
        "planviz.scenes.json": msgspec.json.format(scenes, indent=1) + "\n",
    }


@pytest.mark.parametrize("name", ["domain.planviz.json", "planviz.scenes.json"])
def test_text_is_the_golden_one_to_the_letter(name):
    """Run this file as a program to write the golden files anew."""
    assert texts()[name] == (GOLDEN / name).read_text()


def test_script_loads_nothing_and_is_one_expression():
    script = planviz_script(grounding(), [])
    program = "\n".join(line for line in script.splitlines() if not line.startswith("//"))
    assert program.startswith("module.exports = (function (data) {")
    assert re.findall(r"require|import|fetch|XMLHttp|document|window|\bvis\b|google", program) == []
    assert re.findall(r"https?://[^\"]*", program) == ["http://www.w3.org/2000/svg"]


def test_scenes_are_found_again_and_others_are_added_with_the_same_bytes():
    first, both = (planviz_script(grounding(), some) for some in ([mixed()], [swap(), mixed()]))
    assert planviz_script(grounding(), [swap()], scenes_of(first)) == both
    assert list(scenes_of(both)) == ["mixed", "swap"]
    for strange in (
        "",
        "module.exports = {};",
        both[:-2],
        both.replace('"problems":', '"p":'),
        "[" * 100_000,
    ):
        assert scenes_of(strange) == {}


def test_problem_that_cannot_be_drawn_is_left_out():
    (item, *others) = swap().objects
    lost = msgspec.structs.replace(item, position=(5.0, 0.0, 0.025))
    off = msgspec.structs.replace(swap(), objects=(lost, *others))
    assert scenes_of(planviz_script(grounding(), [off, mixed()])).keys() == {"mixed"}
    assert scenes_of(planviz_script(grounding(), [off], {"swap": {}})) == {}


def test_size_that_features_do_not_say_is_guessed():
    objects = tuple(msgspec.structs.replace(item, features=(7.0,)) for item in ERRAND.objects)
    strange = msgspec.structs.replace(ERRAND, objects=objects)
    scene = scenes_of(planviz_script(toy_domain.grounding(), [strange]))["errand"]
    assert scene["objects"]["item-01"]["size"] == [0.04, 0.04]


def call(name: str, problem: Problem, *arguments: Any, learned: Any = None) -> str:
    """Call a function of the script, as the extension does."""
    script = planviz_script(learned or grounding(), [problem])
    asked = json.dumps({"script": script, "name": name, "arguments": arguments})
    assert NODE
    done = subprocess.run([NODE, "-e", DRIVER], input=asked, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    return done.stdout


def facts(text: str) -> list[dict[str, Any]]:
    """The initial state of a problem, as the extension passes states: names without brackets, and values."""
    bare = re.sub(r";.*", "", text).split("(:init")[1].split("(:goal")[0]
    names = re.findall(r"(?<!= )\(([a-z][^()=]*)\)", bare)
    return [{"variableName": name, "value": True} for name in names]


def serialised(lines: Iterable[str], problem: Problem, text: str) -> dict[str, Any]:
    """A plan as the extension passes it between its processes."""
    steps = [
        {"time": number, "fullActionName": re.findall(r"\(([^()]*)\)", line)[0], "isDurative": False}
        for number, line in enumerate(lines)
    ]
    return {"steps": steps, "problem": {"name": problem.name, "inits": facts(text)}}


def pictures(html: str) -> list[dict[str, tuple[tuple[float, float], str]]]:
    """Where each object is drawn in each picture [m], and how opaque; the table says the scale."""
    found = []
    for text in re.findall(r"<svg.*?</svg>", html):
        drawing = ElementTree.fromstring(text)
        rects = {
            kind: [one for one in drawing.iter(f"{SVG}rect") if one.get("class") == kind] for kind in KINDS
        }
        names = [one.text or "" for one in drawing.findall(f"{SVG}text")]
        spots = [(spot_of(one, drawing), one.get("fill-opacity", "")) for one in rects["object"]]
        found.append(dict(zip(names, spots, strict=True)))
        assert spot_of(rects["table"][0], drawing) == pytest.approx((0.7, 0.0), abs=2e-4)
    return found


KINDS = ("table", "goal", "object")


def spot_of(rect: ElementTree.Element, drawing: ElementTree.Element) -> tuple[float, float]:
    """The middle of a rectangle [m]; the toy's table is 0.6 m wide, from x = 0.4 and y = -0.3."""
    scale = float(drawing.get("width", 0)) / (0.6 + 2 * MARGIN)
    x, y, width, height = (float(rect.get(key, 0)) for key in ("x", "y", "width", "height"))
    return 1.0 + MARGIN - (y + height / 2) / scale, 0.3 + MARGIN - (x + width / 2) / scale


def near(spot: tuple[float, float], *wanted: float) -> bool:
    return bool(np.allclose(spot, wanted, atol=5e-4))


@needs_node
def test_spot_that_the_problem_does_not_name_is_drawn_where_its_name_says():
    text = problem_text(mixed(), grounding())
    task = serialised(["(put-at item-01 spot-6000-m2000 cost6)"], mixed(), text)
    states = pictures(call("visualizePlanHtml", mixed(), task, WIDTH))
    assert near(states[1]["item-01"][0], 0.6, -0.2)


@needs_node
def test_plan_that_carries_and_pushes_is_drawn_state_by_state():
    steps = plan(mixed(), grounding()).steps
    lines = print_ground_plan(steps, mixed(), grounding()).splitlines()
    task = serialised(lines, mixed(), problem_text(mixed(), grounding()))
    html = call("visualizePlanHtml", mixed(), task, WIDTH)
    states = pictures(html)
    assert [re.sub(r"<.*", "", part) for part in html.split("<figcaption>")[1:]] == [
        "start",
        "1. push item-02 m-001",
        "2. push item-02 m-001",
        "3. put-at item-01 goal-item-01",
    ]
    slab, cube = ([state[name][0] for state in states] for name in ("item-02", "item-01"))
    assert all(near(spot, 0.7, y) for spot, y in zip(slab, (0.0, 0.08, 0.16, 0.16), strict=True))
    assert all(near(spot, 0.5, -0.2) for spot in cube[:3])
    assert near(cube[3], 0.7, 0.0)
    short = serialised(print_plan(steps).splitlines()[2:3], mixed(), "(:init (:goal")
    assert near(pictures(call("visualizePlanHtml", mixed(), short, WIDTH))[-1]["item-01"][0], 0.7, 0.0)


@needs_node
def test_durative_plan_is_drawn_too():
    line = "0.0: (carry item-01 start-item-01 goal-item-01 start-item-02 nowhere nowhere) [6.1]"
    task = serialised([line], swap(), durative_problem_text(swap(), grounding()))
    assert near(pictures(call("visualizePlanHtml", swap(), task, WIDTH))[-1]["item-01"][0], 0.8, 0.1)


@needs_node
def test_plan_over_cells_is_drawn_and_what_is_held_is_pale():
    learned = toy_domain.grounding()
    lines = print_ground_plan(plan(ERRAND, learned).steps, ERRAND, learned).splitlines()
    task = serialised(lines, ERRAND, problem_text(ERRAND, learned))
    states = pictures(call("visualizePlanHtml", ERRAND, task, WIDTH, learned=learned))
    ends = [state.get("item-01") or state["item-01 (held)"] for state in states]
    assert all(near(spot, 0.6, y) for (spot, _), y in zip(ends, (0.0, 0.08, 0.16, 0.16), strict=True))
    assert [opacity for _, opacity in ends] == ["0.75", "0.75", "0.75", "0.3"]


@needs_node
def test_coarser_cells_of_a_problem_with_a_wide_goal_are_drawn_as_wide():
    learned = msgspec.structs.replace(toy_domain.grounding(), cell=0.01)
    wide = msgspec.structs.replace(ERRAND, tolerance=0.1)
    lines = print_ground_plan(plan(wide, learned).steps, wide, learned).splitlines()
    task = serialised(lines, wide, problem_text(wide, learned))
    assert scenes_of(planviz_script(learned, [wide]))["errand"]["cell"] == pytest.approx(0.02)
    states = pictures(call("visualizePlanHtml", wide, task, WIDTH, learned=learned))
    moved = [state["item-01"][0] for state in states if "item-01" in state]
    assert near(moved[0], 0.6, 0.0)
    assert near(moved[1], 0.6, 0.08)


@needs_node
def test_what_another_thing_bears_is_drawn_over_it_wherever_that_is():
    learned, tower = toy_relations.grounding(), toy_relations.tower()
    lines = print_ground_plan(plan(tower, learned).steps, tower, learned).splitlines()
    task = serialised(lines, tower, problem_text(tower, learned))
    html = call("visualizePlanHtml", tower, task, WIDTH, learned=learned)
    assert [re.sub(r"<.*", "", part) for part in html.split("<figcaption>")[1:]] == [
        "start",
        "1. put item-03 rests-on-item-02",
        "2. put item-01 rests-on-item-03",
    ]
    spots = re.findall(r'class="object" .*?>(item-\d\d)<', html)
    assert spots[-2:] == ["item-03", "item-01"]
    state = [{"variableName": "stands item-01 rests-on-item-02", "value": True}]
    drawn = call("visualizeStateHtml", tower, task, state, WIDTH, learned=learned)
    boxes = {
        name: (float(x) + float(width) / 2, float(y) + float(height) / 2)
        for x, y, width, height, name in re.findall(
            r'x="([\d.]+)" y="([\d.]+)" width="([\d.]+)" height="([\d.]+)" class="object".*?>(item-\d\d)<',
            drawn,
        )
    }
    assert boxes["item-01"] == pytest.approx(boxes["item-02"], abs=0.2)


@needs_node
def test_state_is_drawn_from_its_facts():
    dummy = {"steps": [], "problem": {"name": "mixed"}}
    state = facts(problem_text(mixed(), grounding()))
    assert near(pictures(call("visualizeStateHtml", mixed(), dummy, state, WIDTH))[0]["item-02"][0], 0.7, 0.0)
    state = [fact for fact in state if not re.match(r"(at-y|stands)", fact["variableName"])]
    state += [
        {"variableName": name, "value": True} for name in ("at-y item-02 y23", "stands item-01 park-02")
    ]
    state += [{"variableName": "stands item-01 goal-item-01", "value": False}]
    (drawn,) = pictures(call("visualizeStateHtml", mixed(), dummy, state, WIDTH))
    assert near(drawn["item-02"][0], 0.7, 0.16)
    assert near(drawn["item-01"][0], 0.8611, -0.2188)


@needs_node
def test_turned_object_is_drawn_turned():
    half = np.radians(30) / 2
    turned = (0.0, 0.0, float(np.sin(half)), float(np.cos(half)))
    objects = tuple(msgspec.structs.replace(item, orientation=turned) for item in swap().objects)
    problem = msgspec.structs.replace(swap(), objects=objects)
    svg = call("visualizeStateHtml", problem, {"steps": [], "problem": {"name": "swap"}}, [], WIDTH)
    assert svg.count("rotate(-30 ") == 2


@needs_node
def test_unknown_problem_is_said_and_harmless():
    for plan_of in ({"steps": [], "problem": {"name": "<b>"}}, {"steps": []}):
        for name, more in (("visualizePlanHtml", []), ("visualizeStateHtml", [[]])):
            said = call(name, swap(), plan_of, *more, WIDTH)
            assert "run neurosym compile-domain" in said
            assert "<b>" not in said


if __name__ == "__main__":
    for name, text in texts().items():
        (GOLDEN / name).write_text(text)
