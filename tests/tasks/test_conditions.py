"""Conditions: what people ask for is read, judged by geometry, and met by goals that are chosen for it."""

import json
import shutil

import msgspec
import numpy as np
import pytest
from places import ROOT

from neurosym.commands.cli import main
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding
from neurosym.problems import Problem, SceneObject
from neurosym.stages.planning import load_problem
from neurosym.tasks.conditions import conditions_in, options_of, unmet_conditions
from neurosym.tasks.goal_choice import with_goals
from neurosym.tasks.task import is_reached

TOWERS = Grounding.load(ROOT / "domains" / "towers" / "grounding.json")
SPOTS = {"item-01": (0.45, -0.15), "item-02": (0.45, 0.1), "item-03": (0.6, 0.1), "item-04": (0.75, -0.1)}
KINDS = {"item-01": "10", "item-02": "10", "item-03": "01", "item-04": "01"}


def scene(*conditions: str, **moved: tuple[float, float, float]) -> Problem:
    """Four low boxes, which nothing bears unless some are moved."""
    spots = {name: moved.get(name.replace("-", "_"), (*spot, 0.02)) for name, spot in SPOTS.items()}
    items = tuple(
        SceneObject(name, KINDS[name], (0.1, 0.06, 0.04, 0.0), spot) for name, spot in spots.items()
    )
    return Problem("asked", items, {}, conditions=conditions)


ON = {"item_02": (0.6, 0.1, 0.06)}  # item-02 on item-03
FORMS = (
    "item-01 x=0.6..0.8 y=0.05..0.25",
    "item-01 y=0..",
    "item-01 within-reach",
    "item-01 x=0.7",
    "item-01 at 0.6,-0.2 or item-04 at 0.6,0.2",
    "item-01 next-to item-04",
    "item-02 apart-from item-03",
    "item-03 under item-04",
    "all 10 x=0.65..",
    "2 of item-01,item-02,item-03 y=..-0.05",
    "item-04 on item-03 and item-04 at 0.6,-0.15",
    "1 of 01 x=..0.5 and all 10 x=0.6..",
    "item-04 at 0.6,0.1,0.06",
    "item-01 at 0.6,0.14",
)


def ended(asked: Problem, *, off: float = 0.0, seed: int = 0) -> Problem:
    """Return a problem with all objects at their goals, or beside these by so much of the tolerance."""
    rng, moved = np.random.default_rng(seed), dict[str, tuple[float, float, float]]()
    for name in asked.unmet:
        (x, y, z), angle = asked.goals[name], rng.uniform(0, 2 * np.pi)
        by = off * asked.tolerance * np.array([np.cos(angle), np.sin(angle)])
        moved[name.replace("-", "_")] = (x + by[0], y + by[1], z)
    for target, reference, _ in asked.relations:
        x, y, z = asked.goals.get(reference) or asked.object_named(reference).position
        moved[target.replace("-", "_")] = (x, y, z + 0.04)
    known = {"tolerance": asked.tolerance, "asked_within": asked.asked_within}
    return msgspec.structs.replace(scene(*asked.conditions, **moved), **known)


@pytest.mark.parametrize("text", FORMS)
def test_goals_that_are_chosen_meet_what_is_asked_for(text: str):
    asked = with_goals(scene(text), TOWERS)
    assert asked.goals or asked.relations
    assert is_reached(ended(asked), TOWERS)
    assert [*unmet_conditions(ended(asked), TOWERS)] == []
    for seed in range(20 if not asked.relations else 0):
        assert is_reached(ended(asked, off=0.99, seed=seed), TOWERS), seed


def test_what_holds_already_is_left_where_it_is():
    asked = with_goals(scene("2 of 10 y=-0.3..0.3"), TOWERS)
    assert asked.unmet == ()
    assert is_reached(asked, TOWERS)


def test_what_is_on_another_is_taken_off_it():
    text = "item-02 not-on item-03"
    assert [*unmet_conditions(scene(text, **ON), TOWERS)] == [text]
    asked = with_goals(scene(text, **ON), TOWERS)
    assert [*asked.goals] == ["item-02"]
    assert np.hypot(asked.goals["item-02"][0] - 0.6, asked.goals["item-02"][1] - 0.1) > 0.05
    assert [*unmet_conditions(scene("item-02 on item-03", "item-03 under item-02", **ON), TOWERS)] == []


def test_what_is_to_be_higher_than_on_the_table_is_put_on_another():
    over = scene("item-01 at 0.61,0.1,0.06 and item-04 at 0.6,0.1,0.1")
    assert [(one, other) for one, other, _ in with_goals(over, TOWERS).relations] == [
        ("item-01", "item-03"),
        ("item-04", "item-01"),
    ]
    moved = with_goals(scene("item-04 z=0.05.. and item-04 at 0.6,-0.2"), TOWERS)
    ((_, below, _),) = moved.relations
    assert moved.goals[below][:2] == pytest.approx((0.6, -0.2), abs=0.03)
    lower = {"item_02": (0.6, 0.1, 0.06), "item_01": (0.6, 0.1, 0.1)}  # a tower of three
    tall = with_goals(scene("item-01 z=0.1 and item-03 x=0.45", **lower), TOWERS)
    assert {(one, other) for one, other, _ in tall.relations} == {
        ("item-01", "item-02"),
        ("item-02", "item-03"),
    }
    stays = with_goals(scene("item-02 at 0.6,0.1,0.06 and item-04 at 0.6,-0.2", **ON), TOWERS)
    assert [(one, other) for one, other, _ in stays.relations] == [("item-02", "item-03")]
    assert stays.unmet == ("item-04",)


def test_a_point_where_another_stands_is_approached_beside_it():
    asked = with_goals(scene("item-01 at 0.6,0.14 and item-03 at 0.6,0.1"), TOWERS)
    assert asked.goals["item-01"][1] > 0.16
    assert asked.tolerance + asked.goals["item-01"][1] - 0.14 <= 0.05 + 1e-6


def test_the_option_that_moves_least_is_taken():
    asked = with_goals(scene("item-01 x=0.8.. or item-04 x=0.8.."), TOWERS)
    assert [*asked.goals] == ["item-04"]


def test_what_is_to_be_turned_is_carried_to_a_goal_of_its_own():
    turned = with_goals(scene("item-01 at 0.45,-0.15 and item-01 heading=50"), TOWERS)
    assert turned.headings == {"item-01": 50.0}
    assert turned.unmet == ("item-01",)
    assert (turned.tolerance, turned.asked_within) == (0.02, 0.05)
    assert np.hypot(*np.subtract(turned.goals["item-01"][:2], (0.45, -0.15))) < 0.03
    there = with_goals(scene("item-01 heading=170"), TOWERS)
    assert (there.unmet, there.asked_within) == ((), None)
    with pytest.raises(InvalidValue, match="Nothing that was learned carries item-01"):
        with_goals(scene("item-01 heading=50"), msgspec.structs.replace(TOWERS, turned=False))
    assert is_reached(there, TOWERS)
    assert not is_reached(turned, TOWERS)


def test_little_room_makes_the_tolerance_small():
    narrow = msgspec.structs.replace(scene("item-01 x=0.6"), tolerance=0.001)
    assert with_goals(narrow, TOWERS).tolerance == 0.001
    asked = with_goals(scene("item-01 x=0.60..0.65"), TOWERS)
    assert asked.tolerance == 0.02
    assert asked.goals["item-01"][0] == pytest.approx(0.625, abs=0.006)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("item-01", "says nothing of item-01; valid: x=LOW..HIGH"),
        ("item-01 near", "cannot be read"),
        ("item-01 x=0.6..0.4", "leaves no room along x"),
        ("item-01 x=..", "has no bound along x; valid: x=0.4"),
        ("item-01 x=0.5 x=0.6", "says x twice"),
        ("item-01 x=much", "cannot be read; write x=0.4"),
        ("item-01 x=3", "lies off the table; valid: x"),
        ("item-01 z=nan", "has no number along z; valid: z=0.4"),
        ("item-01 at 0.6,0.1,inf", "has no number along z"),
        ("item-01 x=0.95..", "x = 0.95 m is the edge of the table; ask for some room inside"),
        ("item-01 heading=1..2", "asks for no heading; valid: a number of degrees"),
        ("item-01 heading=30 and item-01 heading=60", "shall be turned by 30 and by 60 degrees"),
        ("item-01 heading=30 and item-01 on item-02", "its heading cannot be asked for"),
        ("5 of 10 y=0..", "asks for 5 of 2 objects; valid: 1 to 2"),
        ("all 11 y=0..", "No object of asked is of the category 11; valid: 01, 10"),
        ("item-01 on item-01", "cannot be on itself"),
        ("item-01 y=0.. and item-01 y=..-0.1", "What is asked of item-01 contradicts itself"),
        ("item-01 on item-02 and item-01 on item-03", "item-01 shall be on item-02 and on item-03"),
        ("", "There is an empty condition"),
        (
            "item-01 at 0.6,-0.2,0.3",
            "its middle is 0.020 m high there, and nothing brings it as high as asked",
        ),
    ],
)
def test_conditions_that_cannot_be_are_refused(text: str, said: str):
    with pytest.raises(InvalidValue, match=said.replace("(", r"\(")):
        with_goals(scene(text), TOWERS)


def test_unknown_names_are_refused():
    for text, said in (
        ("item-09 y=0..", "object 'item-09'"),
        ("all green y=0..", "category or object 'green'"),
        ("item-01 beyond item-02", "state"),
    ):
        with pytest.raises((UnknownChoice, InvalidValue), match=said):
            options_of(text, scene(), TOWERS)


def test_goals_as_people_write_them_are_conditions():
    points, said = conditions_in({"a": [0.7, None, 0.02], "b": {"x": [0.3, None]}, "c": [0.5, 0.1, 0.02]})
    assert points == {"c": [0.5, 0.1, 0.02]}
    assert said == ("a x=0.7 z=0.02", "b x=0.3..")
    assert conditions_in([{"a": [0.7, 0.2, 0.02]}, {"b": {"y": [None, 0]}}])[1] == (
        "a x=0.7 y=0.2 z=0.02 or b y=..0",
    )
    for wrong in (3, {"a": {}}):
        with pytest.raises(InvalidValue):
            conditions_in(wrong)


def test_a_condition_is_planned_and_judged(tmp_path, capsys):
    folder = tmp_path / "towers"
    shutil.copytree(ROOT / "domains" / "towers", folder, ignore=shutil.ignore_patterns("runs", "pictures"))
    goals = "--goal", "2 of item-02,item-03 x=..0.6", "--goal", "item-01=0.5,0.2"
    call(["new-problem", str(folder), "--name", "asked", "--objects", "3", *goals])
    assert "asked: 2 of item-02,item-03 x=..0.6" in capsys.readouterr().out
    problem = load_problem_of(folder)
    assert problem.conditions == ("2 of item-02,item-03 x=..0.6", "item-01 at 0.5,0.2")
    assert call(["plan", str(folder), "asked"]) == 0
    scene_file = folder / "problems" / "asked.scene.json"
    written = json.loads(scene_file.read_text())
    assert {*written} >= {"conditions", "goals"}
    (tmp_path / "again.json").write_text(json.dumps(written))
    call(["new-problem", str(folder), "--name", "again", "--scene", str(tmp_path / "again.json")])
    again = json.loads((folder / "problems" / "again.scene.json").read_text())
    assert {**again, "name": "", "provenance": ""} == {**written, "name": "", "provenance": ""}


@pytest.mark.parametrize(
    ("scene_part", "said"),
    [
        ({"conditions": ["item-01 x=0.7"]}, ""),
        ({"goals": {"item-01": [0.7, None, 0.02]}, "relations": 5}, "Expected `array`, got `int`"),
        (
            {"goals": {"item-01": [0.7, None, 0.02]}, "conditions": "item-01 y=0"},
            "Expected `array`, got `str`",
        ),
        ({"goals": {"item-01": {"x": [0.5, 0.6]}, "item-02": 3}}, "got"),
        ({"goals": {"item-01": {"x": [0.6, 0.5]}}}, "leaves no room along x"),
    ],
)
def test_scenes_say_conditions_as_people_write_them_or_are_refused(tmp_path, capsys, scene_part, said):
    folder, file = tmp_path / "places", tmp_path / "mine.json"
    shutil.copytree(ROOT / "domains" / "places", folder, ignore=shutil.ignore_patterns("runs", "plans"))
    whole = msgspec.to_builtins(scene())
    file.write_text(json.dumps({"name": "mine", "objects": whole["objects"]} | scene_part))
    code = call(["new-problem", str(folder), "--scene", str(file)])
    err = capsys.readouterr().err
    assert (code, len(err.splitlines())) == ((2, 1) if said else (0, 0))
    assert said in err


def load_problem_of(folder) -> Problem:
    from neurosym.stages.folder import DomainFolder

    return load_problem(DomainFolder(folder), "asked")


def call(typed: list[str]) -> int:
    try:
        main(typed)
    except SystemExit as ended:
        return int(ended.code or 0)
    return 0
