"""The page: what it holds, who reads it, and that plans of any domain are plans of it, by others' word.

Run this file as a program to write the golden files anew.
"""

import inspect
import json
import re
from pathlib import Path

import msgspec
import pddl as pddl_package
import pytest
import rehearsed
import tables
import toy_places
import toy_relations
from places import GOLDEN, ROOT
from toy_relations import LIE, PUT_IN, PUT_ON, REST, relearned
from validators import unified_planning_accepts

from neurosym.choices import DOMAINS
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding
from neurosym.pddl import compile_domain, domain_text, problem_text
from neurosym.pddl.compiler import ground_plan
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.strips import PUT_LOADED, WORDS, page
from neurosym.pddl.strips_plan import action_for, led_by, led_in, read, write
from neurosym.pddl.strips_problem import StripsProblem
from neurosym.pddl.syntax import ENCODINGS, FORMER, EncodingName
from neurosym.planners import PlanStatus
from neurosym.planners.external import plan_fast_downward
from neurosym.planners.unified_planning import validate_pddl
from neurosym.problems import Problem
from neurosym.tasks.options import left_out, puts_of
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep

LINES, BYTES, ACTIONS, LONGEST_NAME = 150, 12_000, 20, 32
SHIPPED = ROOT / "domains"
CELL = 0.02
"""Coarse, so that unified-planning reads it in a moment."""
KINDS: dict[str, tuple[Grounding, Problem]] = {
    "led": (tables.grounding(CELL), tables.problem()),
    "rehearsed": (rehearsed.grounding(CELL), msgspec.structs.replace(rehearsed.problem(), tolerance=0.05)),
    "carried": (toy_places.grounding(), toy_places.swap()),
    "both": (toy_places.grounding(), toy_places.mixed()),
    "tower": (toy_relations.grounding(), toy_relations.tower()),
    "tower-at-place": (toy_relations.grounding(), toy_relations.tower_at_place()),
    "sorting": (toy_relations.grounding(), toy_relations.sorting()),
}
"""A domain and a problem of each kind that the page is for."""
of_each_kind = pytest.mark.parametrize(("learned", "task"), KINDS.values(), ids=KINDS)


def texts() -> dict[str, str]:
    learned, task = KINDS["led"]
    return {
        "domain.pddl": domain_text(learned),
        "errand.pddl": problem_text(task, learned),
        "domain-numeric.pddl": domain_text(learned, "numeric"),
        "errand.numeric.pddl": problem_text(task, learned, "numeric"),
        "domain-places.pddl": domain_text(KINDS["both"][0]),
        "mixed.pddl": problem_text(KINDS["both"][1], KINDS["both"][0]),
        "domain-relations.pddl": domain_text(KINDS["sorting"][0]),
        "sorting.pddl": problem_text(KINDS["sorting"][1], KINDS["sorting"][0]),
    }


def code_of(text: str) -> str:
    return re.sub(r";.*", "", text)


@pytest.mark.parametrize("name", sorted(texts()))
def test_text_is_exactly_the_golden_one(name: str):
    assert texts()[name] == (GOLDEN / name).read_text()


@pytest.mark.parametrize("encoding", ENCODINGS)
def test_order_of_the_table_does_not_show_in_the_text(encoding: EncodingName):
    shuffled = tables.table()
    shuffled = msgspec.structs.replace(
        shuffled, operators=shuffled.operators[::-1], categories=shuffled.categories[::-1]
    )
    learned, task = KINDS["led"]
    other = compile_domain(shuffled, name="tabletop", cell=CELL, table_bounds=learned.table, lift_height=0.2)
    assert domain_text(other, encoding) == domain_text(learned, encoding)
    assert problem_text(task, other, encoding) == problem_text(task, learned, encoding)


@of_each_kind
@pytest.mark.parametrize("costs", [True, False])
def test_pddl_package_reads_the_text(learned: Grounding, task: Problem, costs: bool, tmp_path: Path):
    """It wants :numeric-fluents for costs, which Fast Downward refuses; competitions asked for neither."""
    domain_file, problem_file = tmp_path / "domain.pddl", tmp_path / "problem.pddl"
    text = domain_text(learned, costs=costs).replace(":action-costs)", ":action-costs :numeric-fluents)")
    domain_file.write_text(text)
    problem_file.write_text(problem_text(task, learned, costs=costs))
    domain, problem = pddl_package.parse_domain(domain_file), pddl_package.parse_problem(problem_file)
    assert {str(action.name) for action in domain.actions} == {one.name for one in page(learned).actions}
    assert problem.domain_name == domain.name == learned.name
    named = {str(one.name) for one in problem.objects}
    assert {*task.object_names} <= named
    assert ("cost" in code_of(text)) == costs


@pytest.mark.parametrize("learned", [learned for learned, _ in KINDS.values()], ids=KINDS)
def test_everything_is_positive_strips_with_types_and_costs(learned: Grounding):
    domain = page(learned)
    code = code_of(domain.text())
    assert code == code.lower()
    assert not set("._") & set(code)
    assert re.findall(r":requirements ([^)]*)", code) == [":strips :typing :action-costs"]
    assert re.findall(r":requirements ([^)]*)", domain.text(costs=False).lower()) == [":strips :typing"]
    assert not re.search(r"\b(forall|exists|when|or|imply|either)\b", code)
    assert "(not " not in "".join(line for line in code.splitlines() if ":precondition" in line)
    kinds = [name for name, _ in domain.types]
    assert all(parent in ("object", *kinds[:row]) for row, (_, parent) in enumerate(domain.types))
    words = {name for name, _ in (*domain.types, *domain.constants)} | {one.name for one in domain.actions}
    assert words <= {*WORDS, *(one.name for one in learned.operators.categories)}


@of_each_kind
def test_every_word_of_a_problem_is_declared_and_its_parentheses_match(learned: Grounding, task: Problem):
    text = problem_text(task, learned)
    assert text == problem_text(task, learned)
    code = code_of(text)
    assert code.count("(") == code.count(")")
    assert code == code.lower()
    printed, domain = StripsProblem(understand(task, learned)).data(), page(learned)
    kinds = dict(domain.types)
    typed = dict((*domain.constants, *printed.objects))
    assert len(typed) == len(domain.constants) + len(printed.objects), "names are declared once"
    wanted = {one.name: [kind for _, kind in one.parameters] for one in domain.predicates}
    wanted |= {one.name: [kind for _, kind in one.parameters] for one in domain.costs}
    for name, *words in (*printed.atoms, *printed.costs, *printed.goals):
        assert len(words) == len(wanted[name])
        for word, kind in zip(words, wanted[name], strict=True):
            assert kind in (typed[word], kinds.get(typed[word])), (name, word)


@of_each_kind
def test_plan_of_fast_downward_is_valid_and_so_is_ours_of_the_same_steps(
    learned: Grounding, task: Problem, tmp_path: Path
):
    domain, file = tmp_path / "domain.pddl", tmp_path / "problem.pddl"
    domain.write_text(domain_text(learned))
    file.write_text(problem_text(task, learned))
    answer = plan_fast_downward(domain, file, time_limit=60.0)
    assert answer.status is PlanStatus.SOLVED, answer.reason
    assert unified_planning_accepts(domain, file, answer.text)
    steps = parse_plan(answer.text, tmp_path / "plan", learned, task)
    again = ground_plan(steps, task, learned)
    assert sorted(again.lines) == sorted(re.findall(r"^\(.*\)$", answer.text, re.MULTILINE))
    assert unified_planning_accepts(domain, file, again.text)
    assert again.missing(file.read_text()) == ()
    for row, line in enumerate(again.lines):
        if not line.startswith("(reach-"):
            fewer = "".join(f"{other}\n" for at, other in enumerate(again.lines) if at != row)
            assert not validate_pddl(domain.read_text(), file.read_text(), read_back(fewer)).valid, line


def read_back(text: str) -> list[tuple[str, ...]]:
    return [tuple(line.strip("()").split()) for line in text.splitlines()]


def test_a_table_without_live_operators_still_makes_a_domain():
    bare = msgspec.structs.replace(tables.table(), operators=())
    learned = compile_domain(bare, name="bare", table_bounds=tables.BOUNDS, lift_height=0.2)
    assert "(:action" not in domain_text(learned)
    text = problem_text(tables.problem(), learned)
    assert "(:goal (and (done item-01) (done item-02)))" in text


@pytest.mark.parametrize("encoding", FORMER)
def test_encodings_of_earlier_versions_are_refused_with_what_replaced_them(encoding: str):
    with pytest.raises(InvalidValue, match=f"encoding {encoding} is gone: one page, 'strips'"):
        inspect.unwrap(domain_text)(tables.grounding(), encoding)  # without the check of types


def test_unknown_encoding_is_refused():
    for ask in (domain_text, lambda learned, name: problem_text(tables.problem(), learned, name)):
        with pytest.raises(UnknownChoice, match="valid: numeric, strips"):
            inspect.unwrap(ask)(tables.grounding(), "numbers")


def test_one_motion_is_one_symbol_whatever_it_does_to_which_category():
    learned = tables.grounding()
    rows = [line for line in page(learned).head if re.match(r" +\d{3} ", line)]
    assert [row.split()[0] for row in rows] == ["000", "001", "010"]
    assert rows[2].split("  ")[-1].strip().startswith("pull 71")
    assert re.search(r"010 +lift 203 73% +pull 71 86%", rows[2])
    assert re.search(r"001 +push-away 72 86% +-$", rows[1]), "what topples trays is left out"
    found = [action_for(one.name, learned) for one in learned.live]
    assert set(found) == {"push", "lift"}
    assert action_for("put-down-lift-010-block", learned) == "put-down"
    assert action_for(toy_places.NAME, toy_places.grounding()) == "put-at"
    assert action_for(PUT_ON, toy_relations.grounding()) == "put"
    with pytest.raises(UnknownChoice, match="fly"):
        action_for("fly", learned)


def test_what_was_not_learned_is_not_on_the_page():
    led, carrying, relating = (
        {one.name for one in page(KINDS[kind][0]).actions} for kind in ("led", "both", "sorting")
    )
    assert led == {"push", "lift", "put-down", "move-x", "move-y", "reach-cell", "reach-lifted"}
    assert carrying == led | {"take", "put-at", "note-clear", "reach-place", "leave"}
    assert relating == {"take", "put-at", "note-clear", "reach-place", "take-off", "put", PUT_LOADED}


def test_what_fails_with_a_third_object_on_the_target_is_not_on_the_page():
    learned = toy_relations.grounding()
    for name in (PUT_ON, PUT_IN):
        learned = relearned(name, learned, laden=0)
    assert PUT_LOADED not in {one.name for one in page(learned).actions}
    for name in ("take", "take-off"):
        assert ("bears", "?o", "n0") in page(learned).action(name).needs
        assert ("bears", "?o", "n0") not in page(toy_relations.grounding()).action(name).needs


def test_what_makes_its_target_lean_is_not_on_the_page():
    table = toy_relations.relations()
    tilted = (0.0, 1.0, 1.0, 0.9, 0.0)
    states = tuple(
        msgspec.structs.replace(one, centre=tilted) if one.name == REST else one for one in table.states
    )
    leaning = msgspec.structs.replace(
        toy_relations.grounding(), relations=msgspec.structs.replace(table, states=states)
    )
    assert left_out(leaning.relations)[PUT_ON] == "makes its target lean"
    assert {put.state.name for put in puts_of(leaning)} == {LIE}
    assert not re.search(r"rests-on-001 \d", domain_text(leaning))
    assert re.search(r"rests-on-001 \d", domain_text(toy_relations.grounding()))


# The shipped domains


@pytest.fixture(scope="module", params=DOMAINS)
def folder(request):
    return SHIPPED / request.param


@pytest.fixture(scope="module")
def grounding(folder):
    return Grounding.load(folder / "grounding.json")


def test_a_domain_fits_on_a_page(grounding):
    domain = page(grounding)
    text = domain.text()
    assert text.count("\n") <= LINES
    assert len(text.encode()) <= BYTES
    assert len(domain.actions) <= ACTIONS
    names = [one.name for one in (*domain.actions, *domain.predicates)]
    names += [name for name, _ in (*domain.types, *domain.constants)]
    assert max(map(len, names)) <= LONGEST_NAME


def test_shipped_plans_are_plans_of_the_page(folder, grounding):
    domain = page(grounding).text()
    records = sorted((folder / "plans").glob("*.fast-downward.json"))
    assert records
    for record in records:
        found = json.loads(record.read_text())
        if not found["steps"]:
            continue
        problem = Problem.load(folder / "problems" / f"{found['problem']}.scene.json")
        task = understand(problem, grounding)
        steps = [PlanStep(*step) for step in found["steps"]]
        written = write(steps, StripsProblem(task, led=led_by(steps, task)))
        printed = StripsProblem(task, led=written.led, kept=written.moves)
        text = problem_text(problem, grounding, plans=[ground_plan(steps, problem, grounding)])
        assert validate_pddl(domain, text, written.actions).valid, record
        every = StripsProblem(task, led=led_in(written.actions, task), every=True)
        back = read(written.actions, every)
        assert [(one.object, one.place) for one in back] == [(one.object, one.place) for one in steps]
        assert write(back, printed).actions == written.actions


if __name__ == "__main__":
    for file_name, content in texts().items():
        (GOLDEN / file_name).write_text(content)
