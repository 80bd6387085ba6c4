"""The page: what it holds, who reads it, and that plans of any domain are plans of it, by others' word.

So it is with SAS+, and with what a plan touches of a page. Run this file as a program to write the golden
files anew.
"""

import re
from pathlib import Path

import numpy as np
import pytest
import rehearsed
import tables
import toy_domain
import toy_places
import toy_relations
from independent.ground_pddl import judge
from msgspec.structs import replace
from places import GOLDEN, ROOT
from plan_forms import edited
from tables import BOUNDS, grounding, item, mode, problem, table, total_cost
from toy_relations import LIE, PUT_IN, PUT_ON, REST, relearned
from validators import unified_planning_accepts

from neurosym.choices import DOMAINS
from neurosym.errors import UnknownChoice
from neurosym.grounding import Grounding
from neurosym.operators import Operator, OperatorTable
from neurosym.pddl import compile_domain, domain_text, problem_text
from neurosym.pddl.compiler import excerpt_for, ground_plan, parameters_of, with_every_outcome
from neurosym.pddl.durative import durative_domain_text, durative_problem_text
from neurosym.pddl.grid import grid_of, levels
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.sas import sas_text
from neurosym.pddl.strips import WORDS, page
from neurosym.pddl.strips_plan import action_for
from neurosym.pddl.syntax import ENCODINGS, EncodingName
from neurosym.planners import PlanStatus, plan
from neurosym.planners.bfs import branching_of
from neurosym.planners.external import PORTFOLIO, Search, plan_fast_downward
from neurosym.problems import Problem, Trial
from neurosym.tasks.options import cost, puts_of
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
        "toy.pddl": domain_text(toy_domain.grounding()),
        "domain-relations.pddl": domain_text(KINDS["sorting"][0]),
        "sorting.pddl": problem_text(KINDS["sorting"][1], KINDS["sorting"][0]),
        "domain-durative.pddl": durative_domain_text(KINDS["both"][0]),
        "swap.durative.pddl": durative_problem_text(toy_places.swap(), KINDS["both"][0]),
    }


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
def test_everything_is_positive_strips_in_small_letters(learned: Grounding, task: Problem):
    """That every word is declared, once and of its type, is for the judge to say."""
    domain = page(learned)
    code, text = (re.sub(r";.*", "", one) for one in (domain.text(), problem_text(task, learned)))
    assert (code, text) == (code.lower(), text.lower())
    assert not set("._") & set(code)
    assert re.findall(r":requirements ([^)]*)", code) == [":strips :typing :action-costs"]
    assert not re.search(r"\b(forall|exists|when|or|imply|either)\b", code)
    assert "(not " not in "".join(line for line in code.splitlines() if ":precondition" in line)
    words = {name for name, _ in (*domain.types, *domain.constants)} | {one.name for one in domain.actions}
    assert words <= {*WORDS.split(), *(one.name for one in learned.objects.categories)}


@of_each_kind
def test_plan_of_fast_downward_is_valid_and_so_is_ours_of_the_same_steps(learned, task, tmp_path: Path):
    domain, file = tmp_path / "domain.pddl", tmp_path / "problem.pddl"
    domain.write_text(domain_text(learned))
    file.write_text(problem_text(task, learned))
    answer = plan_fast_downward(domain, file, time_limit=60.0)
    assert answer.status is PlanStatus.SOLVED, answer.reason
    assert judge(domain.read_text(), file.read_text(), answer.text) == ""
    steps = parse_plan(answer.text, tmp_path / "plan", learned, task)
    again = ground_plan(steps, task, learned)
    assert sorted(again.lines) == sorted(re.findall(r"^\(.*\)$", answer.text, re.MULTILINE))
    if learned.places:  # the judge is enough for cells without places, which are slow to read
        assert unified_planning_accepts(domain, file, again.text)
    assert again.missing(file.read_text()) == ()
    for row, line in enumerate(again.lines):
        if not line.startswith("(reach-"):
            fewer = "".join(f"{other}\n" for at, other in enumerate(again.lines) if at != row)
            assert judge(domain.read_text(), file.read_text(), fewer) != "", line


def test_each_operator_is_one_of_a_few_actions():
    learned = tables.grounding()
    assert {action_for(one.name, learned) for one in learned.live} == {"push", "lift"}
    assert action_for("put-down-lift-010-block", learned) == "put-down"
    assert action_for(toy_places.NAME, toy_places.grounding()) == "put-at"
    assert action_for(PUT_ON, toy_relations.grounding()) == "put"
    with pytest.raises(UnknownChoice, match="fly"):
        action_for("fly", learned)


def test_what_fails_is_not_on_the_page():
    failing = relearned(PUT_IN, relearned(PUT_ON, laden=0), laden=0)  # with a third object on the target
    assert "put-loaded" not in {one.name for one in page(failing).actions}
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


@pytest.mark.parametrize("encoding", ["sas", "strips"])
def test_lift_that_ended_above_all_cells_is_not_planned_with(encoding: str):
    past = (Trial("010", "held", (0.012, -0.021, 0.26), (0.0141, -0.0228, 0.0), (0.0, 0.0, 0.0, 1.0)),) * 3
    high = (0.46, -0.01, 0.285)
    block = replace(item("item-01", 0.4512, 0.0133), past=past)
    assert max(levels(block, grounding())) >= grid_of(grounding())[2].count
    tasks = (Problem("p", (block,), {"item-01": goal}) for goal in (high, (0.52, 0.0, 0.025)))
    found = [plan(task, grounding(), encoding=encoding).status for task in tasks]
    assert found == [PlanStatus.NOT_FOUND, PlanStatus.SOLVED]


PLANS = (
    "tabletop/plans/task-07.fast-downward.plan",
    "places/plans/swap-2-06.fast-downward.plan",
    "towers/plans/tower-4-03.fast-downward.plan",
)


@pytest.mark.parametrize("plan", PLANS)
def test_judge_says_of_the_excerpt_what_it_says_of_the_whole_and_no_more_is_in_it(plan: str):
    file = ROOT / "domains" / plan
    folder, name = file.parent.parent, file.name.split(".")[0]
    domain, problem = ((folder / text).read_text() for text in ("domain.pddl", f"problems/{name}.pddl"))
    actions = [tuple(words.split()) for words in re.findall(r"^\((.*)\)", file.read_text(), re.MULTILINE)]
    rng, verdicts = np.random.default_rng(0), []
    names = [one for words in actions for one in words[1:]]
    for number in range(8):
        changed = edited(actions, rng, names) if number else actions
        text = "".join(f"({' '.join(action)})\n" for action in changed)
        verdicts.append(judge(domain, problem, text))
        assert judge(*excerpt_for(domain, problem, changed), text) == verdicts[-1]
    assert verdicts[0] == ""
    assert sum(map(bool, verdicts)) > 3
    part, less = excerpt_for(domain, problem, actions)
    assert parameters_of(part).keys() == {name for name, *_ in actions}
    assert parameters_of(part).items() <= parameters_of(domain).items()
    assert len(less) < 0.7 * len(problem)


HELD = mode((0.012, -0.021, 0.203), kind="held", count=14, near=14, resting=(0.014, -0.023, 0.0))
SLIPPED = mode((0.06, 0.0, 0.0), count=6, near=5)


def lifting(*modes) -> OperatorTable:
    changed = (replace(op, outcomes=modes) if op.name == "lift-010-block" else op for op in table().operators)
    return replace(table(), operators=tuple(changed))


def of(*modes) -> list[Operator]:
    expanded = with_every_outcome(lifting(*modes))
    return [op for op in expanded.operators if (op.subject, op.primitive) == ("00", "010")]


def shares(*modes):
    return tuple(replace(each, share=each.count / 20) for each in modes)


def test_each_outcome_at_rest_or_held_is_an_operator_that_is_named_for_it_unless_it_is_too_rare():
    likeliest, other = of(*shares(HELD, SLIPPED))
    assert (likeliest.name, likeliest.promised) == ("lift-010-block", None)
    assert (other.name, other.promised) == ("push-forward-010-block", "resting")
    assert other.promise is not None
    assert (other.promise.outcome, other.successes, other.trials) == ((0.06, 0.0, 0.0), 5, 20)
    assert cost(other) > 3 * cost(likeliest)
    for left_out in (replace(SLIPPED, count=1, near_mean=1), replace(SLIPPED, kind="toppled")):
        assert len(of(*shares(HELD, left_out))) == 1


def test_compiled_domain_has_every_outcome_as_an_action_and_as_a_choice():
    changed = lifting(*shares(HELD, SLIPPED))
    learned = compile_domain(changed, name="tabletop", table_bounds=BOUNDS, lift_height=0.2)
    problem = Problem("p", (item("item-01", 0.5, 0.0),), {"item-01": (0.56, 0.0, 0.025)}, tolerance=0.01)
    text = problem_text(problem, learned)
    assert "(lifts item-01 m-010 dx2 dy-4 " in text
    assert "(pushes item-01 m-010 dx12 dy0 " in text
    steps = [PlanStep("push-forward-010-block", "item-01"), PlanStep("lift-010-block", "item-01")]
    for encoding in ENCODINGS:
        written = ground_plan(steps, problem, learned, encoding).text
        assert parse_plan(written, Path("p"), learned, problem) == tuple(steps)
    numbers = problem_text(problem, learned, "numeric")
    assert len(set(re.findall(r"\(along-x (\S+)\)", numbers))) == numbers.count("(along-x ")
    assert "push-forward-010-block" in branching_of(problem, learned).names[0]
    found = plan(problem, learned)
    assert found.status is PlanStatus.SOLVED
    assert [step.operator for step in found.steps] == ["push-forward-010-block"]
    assert plan(problem, grounding(), "bfs-operators").status is not PlanStatus.SOLVED


if __name__ == "__main__":
    for file_name, content in texts().items():
        (GOLDEN / file_name).write_text(content)
