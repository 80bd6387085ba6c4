"""The page: what it holds, who reads it, and that plans of any domain are plans of it, by others' word.

So it is with SAS+, and with what a plan touches of a page. Run this file as a program to write the golden
files anew.
"""

import inspect
import re
from pathlib import Path

import numpy as np
import pytest
import rehearsed
import tables
import toy_places
import toy_relations
from independent.ground_pddl import judge
from msgspec.structs import replace
from places import GOLDEN, ROOT
from tables import grounding, item, problem, total_cost
from toy_relations import LIE, PUT_IN, PUT_ON, REST, relearned
from validators import unified_planning_accepts

from neurosym.choices import DOMAINS
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding
from neurosym.pddl import compile_domain, domain_text, problem_text
from neurosym.pddl.compiler import excerpt_for, ground_plan, parameters_of, tree_of
from neurosym.pddl.plan_reading import parse_plan, read_answer
from neurosym.pddl.sas import sas_text
from neurosym.pddl.strips import PUT_LOADED, WORDS, page
from neurosym.pddl.strips_plan import action_for, write
from neurosym.pddl.strips_problem import StripsProblem
from neurosym.pddl.syntax import ENCODINGS, FORMER, EncodingName
from neurosym.planners import PlanStatus, plan
from neurosym.planners.external import PORTFOLIO, Search, plan_fast_downward
from neurosym.problems import Problem
from neurosym.tasks.options import puts_of
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep

LINES, BYTES, ACTIONS, LONGEST_NAME = 150, 12_000, 20, 32
WITH_RELATIONS, WITH_CELLS = 15_000, 120_000
CELL = 0.02
"""Coarse, so that unified-planning reads it in a moment."""
KINDS: dict[str, tuple[Grounding, Problem]] = {
    "led": (tables.grounding(CELL), tables.problem()),
    "rehearsed": (rehearsed.grounding(CELL), replace(rehearsed.problem(), tolerance=0.05)),
    "both": (toy_places.grounding(), toy_places.mixed()),
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
    shuffled = replace(shuffled, operators=shuffled.operators[::-1], categories=shuffled.categories[::-1])
    learned, task = KINDS["led"]
    other = compile_domain(shuffled, name="tabletop", cell=CELL, table_bounds=learned.table, lift_height=0.2)
    assert domain_text(other, encoding) == domain_text(learned, encoding)
    assert problem_text(task, other, encoding) == problem_text(task, learned, encoding)


@of_each_kind
def test_everything_is_positive_strips_in_which_every_word_is_declared(learned: Grounding, task: Problem):
    domain = page(learned)
    code, text = code_of(domain.text()), code_of(problem_text(task, learned))
    assert (code, text) == (code.lower(), text.lower())
    assert not set("._") & set(code)
    assert text.count("(") == text.count(")")
    assert re.findall(r":requirements ([^)]*)", code) == [":strips :typing :action-costs"]
    assert re.findall(r":requirements ([^)]*)", domain.text(costs=False).lower()) == [":strips :typing"]
    assert not re.search(r"\b(forall|exists|when|or|imply|either)\b", code)
    assert "(not " not in "".join(line for line in code.splitlines() if ":precondition" in line)
    words = {name for name, _ in (*domain.types, *domain.constants)} | {one.name for one in domain.actions}
    assert words <= {*WORDS, *(one.name for one in learned.operators.categories)}
    printed, kinds = StripsProblem(understand(task, learned)).data(), dict(domain.types)
    typed = dict((*domain.constants, *printed.objects))
    assert len(typed) == len(domain.constants) + len(printed.objects), "names are declared once"
    declared = (*domain.predicates, *domain.costs)
    wanted = {one.name: [kind for _, kind in one.parameters] for one in declared}
    for name, *given in (*printed.atoms, *printed.costs, *printed.goals):
        for word, kind in zip(given, wanted[name], strict=True):
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
    assert judge(domain.read_text(), file.read_text(), answer.text) == ""
    steps = parse_plan(answer.text, tmp_path / "plan", learned, task)
    again = ground_plan(steps, task, learned)
    assert sorted(again.lines) == sorted(re.findall(r"^\(.*\)$", answer.text, re.MULTILINE))
    assert unified_planning_accepts(domain, file, again.text)
    assert again.missing(file.read_text()) == ()
    for row, line in enumerate(again.lines):
        if not line.startswith("(reach-"):
            fewer = "".join(f"{other}\n" for at, other in enumerate(again.lines) if at != row)
            assert judge(domain.read_text(), file.read_text(), fewer) != "", line


def test_a_table_without_live_operators_still_makes_a_domain():
    bare = replace(tables.table(), operators=())
    learned = compile_domain(bare, name="bare", table_bounds=tables.BOUNDS, lift_height=0.2)
    assert "(:action" not in domain_text(learned)
    text = problem_text(tables.problem(), learned)
    assert "(:goal (and (done item-01) (done item-02)))" in text


def test_unknown_encodings_are_refused_and_former_ones_with_what_replaced_them():
    """Without the check of types that tests have."""
    with pytest.raises(UnknownChoice, match="valid: numeric, strips"):
        inspect.unwrap(domain_text)(tables.grounding(), "numbers")
    for encoding in FORMER:
        with pytest.raises(InvalidValue, match=f"encoding {encoding} is gone: one page, 'strips'"):
            inspect.unwrap(domain_text)(tables.grounding(), encoding)


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


def test_what_was_not_learned_or_fails_is_not_on_the_page():
    led, carrying, relating = (
        {one.name for one in page(KINDS[kind][0]).actions} for kind in ("led", "both", "sorting")
    )
    assert led == {"push", "lift", "put-down", "move-x", "move-y", "reach-cell", "reach-lifted"}
    assert carrying == led | {"take", "put-at", "note-clear", "reach-place", "leave"}
    assert relating == {"take", "put-at", "note-clear", "reach-place", "take-off", "put", PUT_LOADED}
    failing = relearned(PUT_IN, relearned(PUT_ON, laden=0), laden=0)  # with a third object on the target
    assert PUT_LOADED not in {one.name for one in page(failing).actions}
    for name in ("take", "take-off"):
        assert ("bears", "?o", "n0") in page(failing).action(name).needs
        assert ("bears", "?o", "n0") not in page(toy_relations.grounding()).action(name).needs


def test_what_makes_its_target_lean_is_not_on_the_page():
    table, tilted = toy_relations.relations(), (0.0, 1.0, 1.0, 0.9, 0.0)
    states = tuple(replace(one, centre=tilted) if one.name == REST else one for one in table.states)
    leaning = replace(toy_relations.grounding(), relations=replace(table, states=states))
    assert leaning.relations.left_out[PUT_ON] == "makes its target lean"
    assert {put.state.name for put in puts_of(leaning)} == {LIE}


@pytest.mark.parametrize("name", DOMAINS)
def test_a_shipped_domain_fits_on_a_page_and_its_problems_are_short(name: str):
    domain = page(Grounding.load(ROOT / "domains" / name / "grounding.json"))
    text = domain.text()
    assert text.count("\n") <= LINES
    assert len(text.encode()) <= BYTES
    assert len(domain.actions) <= ACTIONS
    names = [one.name for one in (*domain.actions, *domain.predicates)]
    names += [name for name, _ in (*domain.types, *domain.constants)]
    assert max(map(len, names)) <= LONGEST_NAME
    for file in (ROOT / "domains" / name / "problems").glob("*[0-9].pddl"):
        most = WITH_CELLS if "(at-x " in file.read_text() else WITH_RELATIONS
        assert file.stat().st_size <= most, file


SHIPPED = Path("domains/tabletop")


@pytest.mark.parametrize(
    ("name", "search"),
    [("task-01", "astar(blind())"), ("task-03", "astar(lmcut())"), ("task-05", "astar(lmcut())")],
)
def test_cheapest_plan_is_one_of_the_page_and_as_cheap_as_after_translation(
    name: str, search: str, tmp_path: Path
):
    """On the same cells: the page of a folder has coarser ones."""
    learned = Grounding.load(SHIPPED / "grounding.json")
    task = understand(Problem.load(SHIPPED / "problems" / f"{name}.scene.json"), learned)
    page = StripsProblem(task, led=task.names, grid=learned)
    texts = {
        "task.sas": sas_text(task.problem, learned),
        "domain.pddl": domain_text(learned),
        "problem.pddl": page.data().text(),
    }
    for file, text in texts.items():
        (tmp_path / file).write_text(text)

    def solve(*files: str) -> tuple[PlanStep, ...]:
        domain, problem = (tmp_path / file for file in files)
        answer = plan_fast_downward(domain, problem, time_limit=60.0, searches=(Search(search),))
        assert answer.status is PlanStatus.SOLVED, answer.reason
        return read_answer(answer.text, problem, task, lambda _: page)

    def price(steps: tuple[PlanStep, ...]) -> int:
        costs = {move.name: move.cost for move in task.moves_on(learned, task.names[0])}
        return sum(costs[step.operator] for step in steps)

    ours, theirs = solve("task.sas", "task.sas"), solve("domain.pddl", "problem.pddl")
    assert price(ours) == price(theirs) > 0
    every = StripsProblem(task, led=task.names, grid=learned, every=True)
    lines = [f"({' '.join(words)})" for words in write(ours, every).actions]
    assert judge(texts["domain.pddl"], every.data().text(), "\n".join(lines)) == ""


@pytest.mark.parametrize("search", PORTFOLIO, ids=lambda one: one.configuration[:12])
def test_every_search_of_the_portfolio_takes_it(search: Search, tmp_path: Path):
    file = tmp_path / "task.sas"
    file.write_text(sas_text(problem(), grounding()))
    answer = plan_fast_downward(file, file, time_limit=60.0, searches=(search,))
    assert answer.status is PlanStatus.SOLVED, answer.reason


def test_objects_solved_at_once_cost_as_much_as_after_translation_and_impossible_ones_have_no_plan():
    task = problem()
    ours, theirs = (plan(task, grounding(), encoding=name, whole=True) for name in ("sas", "strips"))
    assert ours.status is theirs.status is PlanStatus.SOLVED, (ours.reason, theirs.reason)
    assert total_cost(ours.steps) == total_cost(theirs.steps)
    nowhere = Problem("p", (item("item-01", 0.45, 0.01),), {"item-01": (0.45, 0.01, 0.4)})
    found = {plan(nowhere, grounding(), encoding=name).status for name in ("sas", "strips")}
    assert found == {PlanStatus.UNSOLVABLE}
    fewer = replace(task, goals={"item-01": task.goals["item-01"]})
    assert "item-02" in sas_text(task, grounding())
    assert "item-02" not in sas_text(fewer, grounding())


CELLS = "tabletop/plans/task-07.fast-downward.plan"
PLACES = "places/plans/swap-2-06.fast-downward.plan"
RELATIONS = "towers/plans/tower-4-03.fast-downward.plan"


def case(plan: str) -> tuple[str, str, list[tuple[str, ...]]]:
    file = ROOT / "domains" / plan
    folder, problem = file.parent.parent, file.name.split(".")[0]
    actions = [tuple(str(word) for word in tree_of(line)) for line in file.read_text().splitlines()]
    texts = [(folder / name).read_text() for name in ("domain.pddl", f"problems/{problem}.pddl")]
    return texts[0], texts[1], actions


def spoilt(actions: list[tuple[str, ...]], rng: np.random.Generator) -> list[tuple[str, ...]]:
    """Drop, repeat, exchange or alter one of the actions."""
    changed, at, other = list(actions), *rng.integers(len(actions), size=2)
    kind = rng.integers(4)
    if kind == 0:
        del changed[at]
    elif kind == 1:
        changed.insert(other, changed[at])
    elif kind == 2:
        changed[at], changed[other] = changed[other], changed[at]
    else:
        word = rng.choice([word for action in actions for word in action[1:]])
        changed[at] = (*changed[at][:-1], str(word))
    return changed


def text_of(actions: list[tuple[str, ...]]) -> str:
    return "".join(f"({' '.join(action)})\n" for action in actions)


@pytest.mark.parametrize("plan", [CELLS, PLACES, RELATIONS])
def test_judge_says_of_the_excerpt_what_it_says_of_the_whole_and_no_more_is_in_it(plan: str):
    domain, problem, actions = case(plan)
    rng, verdicts = np.random.default_rng(0), []
    for changed in [actions, *(spoilt(actions, rng) for _ in range(9))]:
        part = excerpt_for(domain, problem, changed)
        said = judge(domain, problem, text_of(changed))
        assert judge(part.domain, part.problem, text_of(changed)) == said
        verdicts.append(said)
    assert verdicts[0] == ""
    assert sum(map(bool, verdicts)) > 4
    part = excerpt_for(domain, problem, actions)
    assert parameters_of(part.domain).keys() == {name for name, *_ in actions}
    assert parameters_of(part.domain).items() <= parameters_of(domain).items()
    spoken = set(re.findall(r"\(([a-z-]+)", part.domain.partition("(:action ")[2]))
    declared = next(one[1:] for one in tree_of(part.domain) if one[0] == ":predicates")
    assert {head[0] for head in declared} <= spoken
    assert len(part.problem) < len(problem)


@pytest.mark.parametrize("text", ["", "(define (domain x)", "(a))", "(a) (b)", "word"])
def test_text_whose_parentheses_do_not_fit_is_refused(text: str):
    with pytest.raises(InvalidValue, match="parentheses"):
        tree_of(text)


if __name__ == "__main__":
    for file_name, content in texts().items():
        (GOLDEN / file_name).write_text(content)
