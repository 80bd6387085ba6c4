"""Plans of the page, what is not so and refused; and the problem that goes with it, and its names."""

import re
from pathlib import Path

import pytest
import rehearsed
import tables
import toy_places
import toy_relations
from msgspec.structs import replace
from tables import DOWN, LEFT, LIFT, PULL, PUSH, TRAY_LEFT, grounding, problem
from toy_places import NAME
from toy_relations import PUT_IN, PUT_ON

from neurosym.errors import InvalidPlan, InvalidValue, NeurosymError
from neurosym.grounding import Grounding
from neurosym.pddl import problem_text
from neurosym.pddl.compiler import ground_plan
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.strips_problem import StripsProblem, printed_cell
from neurosym.pddl.syntax import Atom
from neurosym.planners import PlanStatus, plan
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep, print_plan, validate

PUSHED = """(push item-01 m-001 dx7 dy-1 cost16)
(move-x item-01 dx7 x15 x22)
(move-y item-01 dy-1 y31 y30)
"""
CELLS, PLACES, RELATIONS = (
    (grounding(), problem()),
    (toy_places.grounding(), toy_places.mixed()),
    (toy_relations.grounding(), toy_relations.sorting()),
)
SOLVED = [
    (toy_places.grounding(), toy_places.swap()),
    PLACES,
    *((toy_relations.grounding(), one) for one in (toy_relations.tower(), toy_relations.tower_at_place())),
    RELATIONS,
]


def parsed(text: str, kind: tuple[Grounding, Problem]) -> tuple[PlanStep, ...]:
    return parse_plan(text, Path("some.plan"), *kind)


def refusal(text: str, kind: tuple[Grounding, Problem]) -> str:
    with pytest.raises(InvalidPlan) as refused:
        parsed(text, kind)
    return str(refused.value)


def test_steps_over_cells_are_written_with_their_motion_and_where_it_leads():
    learned, task = CELLS
    text = ground_plan([PUSH, LIFT, DOWN, PULL], task, learned).text
    assert text.startswith(PUSHED)
    assert text.splitlines()[3:] == [
        "(lift item-01 m-010 dx1 dy-2 cost33)",
        "(move-x item-01 dx1 x22 x23)",
        "(move-y item-01 dy-2 y30 y28)",
        "(put-down item-01 m-010 dx0 dy0)",
        "(move-x item-01 dx0 x23 x23)",
        "(move-y item-01 dy0 y28 y28)",
        "(push item-02 m-010 dx-5 dy-5 cost16)",
        "(move-x item-02 dx-5 x30 x25)",
        "(move-y item-02 dy-5 y20 y15)",
        "(reach-cell item-01 x23 y28 zone1)",
        "(reach-cell item-02 x25 y15 zone1)",
    ]
    assert parsed(LIFTED, CELLS) == (LIFT,)
    held = ground_plan([PULL, LIFT], task, learned).text.splitlines()
    assert held[-2:] == ["(reach-lifted item-01 m-010 x16 y29 zone1)", "(reach-cell item-02 x25 y15 zone1)"]


@pytest.mark.parametrize("kind", SOLVED, ids=lambda kind: kind[1].name)
def test_plans_that_are_found_are_read_back_in_short_and_as_ground_actions(kind):
    learned, task = kind
    result = plan(task, learned)
    assert result.status is PlanStatus.SOLVED, result.reason
    assert parsed(print_plan(result.steps), kind) == result.steps
    assert parsed(ground_plan(result.steps, task, learned).text, kind) == result.steps


@pytest.mark.parametrize(
    "steps", [(PUSH, LIFT, DOWN, PULL), (PULL, LIFT), (LEFT, TRAY_LEFT, PULL, LIFT, DOWN, LIFT)]
)
@pytest.mark.parametrize(("cell", "encoding"), [(0.005, "strips"), (0.02, "strips"), (0.002, "numeric")])
def test_any_steps_over_cells_are_read_back_on_any_grid(steps, cell: float, encoding):
    kind = (grounding(cell), problem())
    assert parsed(ground_plan(steps, problem(), kind[0], encoding).text, kind) == steps


LIFTED = ground_plan([LIFT], problem(), grounding()).text.split("(reach-")[0]
OTHER_CELLS = ground_plan([PULL], problem(), grounding(0.002)).text


OVER_CELLS = [
    (PUSHED.replace("x15", "x01"), r"line 2: \(at-x item-01 x01\) does .* holds is \(at-x item-01 x15\)"),
    (PUSHED.replace("x22", "x99"), r"line 2: \(x-sum dx7 x15 x99\) does not hold"),
    (PUSHED.replace("cost16", "cost1"), r"line 1: \(pushes item-01 m-001 dx7 dy-1 cost1\) does not hold"),
    (PUSHED.replace("item-01", "item-02"), r"line 1: \(pushes item-02 m-001 .* does not hold"),
    (LIFTED + PUSHED, r"\(hand-empty\) does not hold there \(step 4"),
    (OTHER_CELLS, r"\(pushes item-02 m-010 dx-13 dy-12 cost16\) does not hold there \(step 1"),
    (PUSHED.splitlines()[0], "line 1: the step is not complete; move-x and move-y come after it"),
    (PUSHED.splitlines()[1], r"line 1: \(due-x item-01 dx7\) does not hold there"),
    (PUSHED + PUSHED, r"line 5: \(at-x item-01 x15\) does not hold .*step 5"),
    (PUSHED + "(reach-cell item-01 x22 y30)", "line 4: after it nothing notes that item-02 is"),
    (PUSHED + "(reach-lifted item-01 m-010 x22 y30)", r"\(lifted item-01 m-010\) does not hold"),
    (PUSHED + "(push-away-001-block item-01)", "line 1: push is an action of the page, and"),
    ("(push item-01 m-001)", r"line 1: it has 2 arguments; valid: \(push \?o \?m \?dx \?dy \?c\)"),
    ("(push item-02 m-010-item-02)\n(push item-01 m-010-item-01)", "line 2: .* is nothing that"),
]


def test_goals_are_noted_after_the_last_step_with_their_object_or_of_none():
    notes = "(reach-cell item-01 x22 y30)\n(reach-cell item-02 x30 y20)\n"
    assert parsed(PUSHED + notes, CELLS) == (PUSH,)
    assert parsed(PUSHED + notes + "(REACH-GOAL)\n", CELLS) == (PUSH,)
    again = PUSHED.replace("x22", "x29").replace("x15", "x22").replace("y30", "y29").replace("y31", "y30")
    assert parsed(PUSHED + again, CELLS) == (PUSH, PUSH)
    assert "nothing notes that item-01 is at its goal" in refusal(PUSHED + notes + again, CELLS)


TAKE, PUT = "(take item-01 start-item-01)", "(put-at item-01 {} cost6)"
CLEAR, PARK = "(note-clear item-01 goal-item-01 start-item-02 nowhere)", PUT.format("park-01")


OF_PLACES = [
    ("(take item-01 start-item-02)", r"\(stands item-01 start-item-02\) does .* holds is"),
    (TAKE, "item-01 was taken, and is put nowhere"),
    (TAKE + PUT.format("start-item-02"), r"\(check item-01 start-item-02 nowhere\) does not hold there"),
    (TAKE + PUT.format("goal-item-01"), r"\(check item-01 goal-item-01 nowhere\) does not hold"),
    (TAKE + CLEAR + PUT.format("goal-item-01"), r"\(free start-item-02\) does not hold there"),
    (TAKE + PUT.format("spot-5500-m5200"), "place spot-5500-m5200 lies at .* off the table"),
    (TAKE + PARK.replace("cost6", "cost1"), r"\(can-carry item-01 cost1\) does .* cost6\)"),
    (TAKE + PARK + "(reach-place item-01 park-01)", r"\(goal-place item-01 park-01\) does not hold"),
    ("(leave item-02 start-item-02)", r"\(done item-02\) does not hold there"),
]


def test_whether_two_spots_are_apart_is_for_the_replay_to_judge():
    learned, task = kind = (toy_places.grounding(), toy_places.swap())
    others = "(take item-02 start-item-02)(put-at item-02 {} cost6)"
    for spot, is_apart in (("spot-6000-1000", True), ("spot-6000-1800", False)):
        steps = parsed(TAKE + PUT.format("spot-6000-2000") + others.format(spot), kind)
        assert steps == (PlanStep(NAME, "item-01", "spot-6000-2000"), PlanStep(NAME, "item-02", spot))
        reason = validate(steps, task, learned).reason
        assert ("item-02 ends where item-01 is" in reason) != is_apart, reason


OFF = "(take-off item-01 rests-on-item-02 item-02 n0 n1)"
INTO = "(put item-01 lies-in-item-04 item-04 from-perch n0 n1 way1 cost10)"


OF_RELATIONS = [
    (OFF.replace("rests-on-item-02 item-02", "rests-on-item-03 item-03"), r"\(stands item-01 rests-on-i"),
    (OFF.replace("n0 n1", "n1 n2"), r"\(bears item-02 n2\) does .* holds is \(bears item-02 n1\)"),
    (INTO, r"\(taken item-01 from-perch\) does not hold there"),
    (OFF + INTO.replace("from-perch", "from-spot"), r"\(taken item-01 from-spot\) does"),
    (OFF + INTO.replace("way1", "way2"), r"\(can-put item-01 lies-in-item-04 way2\) does not hold"),
    (OFF + INTO.replace("cost10", "cost6"), r"\(fee way1 from-perch n0 cost6\) does not hold"),
    (OFF + INTO.replace("lies-in-item-04", "lies-in-item-05"), r"\(on lies-in-item-05 item-04\) "),
    ("(take item-02 start-item-02)", r"\(stands item-02 start-item-02\) does not hold there"),
    (f"({PUT_ON} item-01 moon)", "line 1: .*no other object 'moon'; valid: item-02, item-03"),
    (f"({PUT_ON} item-01 item-01)", "no other object 'item-01'"),
    (f"({PUT_ON} item-01)", "it names no other object; valid: item-02, item-03"),
]


@pytest.mark.parametrize(
    ("kind", "text", "said"),
    [
        (kind, *row)
        for kind, rows in ((CELLS, OVER_CELLS), (PLACES, OF_PLACES), (RELATIONS, OF_RELATIONS))
        for row in rows
    ],
)
def test_what_is_not_so_is_refused_by_line_and_step(kind, text: str, said: str):
    assert parsed(OFF + INTO, RELATIONS) == (PlanStep(PUT_IN, "item-01", "item-04"),)
    assert re.search(said, refusal(text, kind))


@pytest.mark.parametrize(
    ("step", "kind", "said"),
    [
        (PlanStep("stay-111-block", "item-01"), CELLS, "stay-111-block is not in the domain for item-01"),
        (PlanStep(NAME, "item-02", "park-01"), PLACES, "nothing carries item-02 to places"),
        (PlanStep(PUT_ON, "item-01", "item-04"), RELATIONS, f"{PUT_ON} is not offered for item-01 with item"),
        (PlanStep("push-away-001-block", "item-09"), CELLS, "no object 'item-09'"),
        (PUSH, CELLS, "push-away-001-block leads item-01 off the grid along x"),
    ],
)
def test_steps_that_a_problem_does_not_offer_are_not_printed(step: PlanStep, kind, said: str):
    with pytest.raises(NeurosymError, match=said):
        ground_plan([step] * 9, kind[1], kind[0])


AWAY = "push-away-001-block"


def printed(problem: Problem, learned: Grounding, **options) -> StripsProblem:
    return StripsProblem(understand(problem, learned), **options)


def facts(problem: Problem, learned: Grounding, *names: str, **options) -> set[Atom]:
    return {atom for atom in printed(problem, learned, **options).data().atoms if atom[0] in names}


# Cells


@pytest.mark.parametrize(
    ("tolerance", "own", "cell"),
    [(0.05, 0.005, 0.01), (0.02, 0.005, 0.005), (0.5, 0.005, 0.01), (0.02, 0.02, 0.02)],
)
def test_cells_are_coarser_where_the_tolerance_is_larger(tolerance: float, own: float, cell: float):
    task = replace(tables.problem(), tolerance=tolerance)
    assert printed_cell(understand(task, tables.grounding(own))) == pytest.approx(cell)
    assert f"Cells of {1000 * cell:g} mm." in problem_text(task, tables.grounding(own))


def test_objects_of_one_category_get_steps_by_their_size():
    learned = rehearsed.grounding()
    for size, times, cells in ((0.037, 3, 12), (0.055, 2, 18)):  # of 5 mm; on average it is 83.2 mm
        one = rehearsed.item("item-01", 0.4, -0.1, size)
        goal = (0.4, -0.1 + times * 0.0832 * size / rehearsed.MEAN, 0.025)
        task = Problem("p", (one,), {"item-01": goal}, tolerance=0.012)
        assert {atom[2:5] for atom in facts(task, learned, "pushes")} >= {("m-000", "dx0", f"dy{cells}")}
        result = plan(task, learned, encoding="strips")
        assert result.steps == (PlanStep("push-left-000-block", "item-01"),) * times, result.reason


def test_operator_that_does_nothing_to_an_object_is_not_for_it():
    learned = rehearsed.grounding(0.02)
    widest = rehearsed.item("item-01", 0.4512, 0.0, rehearsed.WIDE)
    task = Problem("p", (widest,), {"item-01": (0.55, 0.0, 0.025)})
    assert {atom[2] for atom in facts(task, learned, "pushes", "lifts")} == {"m-000", "m-010"}
    numbers = problem_text(task, learned, "numeric")
    assert "m-001-item-01" not in numbers
    assert "(lifts item-01 m-010-item-01)" in numbers
    with pytest.raises(InvalidValue, match=f"{AWAY} is not in the domain for item-01"):
        ground_plan([PlanStep(AWAY, "item-01")], task, learned)
    strange = replace(task, objects=(rehearsed.item("item-01", 0.45, 0.0, 0.3),))
    asked = ("pushes", "lifts", "lowers")  # unlike all that were rehearsed: what its category is promised
    own, usual = (facts(strange, one, *asked) for one in (learned, tables.grounding(0.02)))
    assert {atom[:5] for atom in own} == {atom[:5] for atom in usual}
    assert own != usual, "at another price, since it is less sure"


def test_no_step_ends_in_the_margins_that_are_asked_for():
    sums = facts(tables.problem(), tables.grounding(0.02), "x-sum", margin=2)
    ends = {atom[3] for atom in sums if atom[1] != "dx0"}
    assert (min(ends), max(ends)) == ("x02", "x28")


def test_of_motions_that_do_the_same_the_cheapest_is_told_and_those_of_plans_beside_it():
    """They differ by a cell of the domain, and not by one of the problem."""
    learned, (block, *_) = tables.grounding(0.005), tables.problem().objects
    table = learned.objects
    modes = (tables.mode((0.0021, 0.0782, 0.0), near=15),)
    twin = replace(table.operators[0], name="push-left-001-block", primitive="001", outcomes=modes)
    others = tuple(one for one in table.operators if (one.primitive, one.subject) != ("001", "00"))
    both = replace(learned, objects=replace(table, operators=(*others, twin)))
    task = Problem("p", (block,), {"item-01": (0.45, 0.18, 0.025)})
    assert {atom[2] for atom in facts(task, both, "pushes")} == {"m-000"}
    assert {atom[2] for atom in facts(task, both, "pushes", every=True)} == {"m-000", "m-001"}
    steps = (PlanStep("push-left-001-block", "item-01"),) * 2
    assert validate(steps, task, both).valid
    beside = problem_text(task, both, plans=[ground_plan(steps, task, both)])
    assert "(pushes item-01 m-001 dx0 dy8 " in beside
    assert "m-001" not in problem_text(task, both)


# Places


def test_spots_of_plans_are_declared_in_the_problem_beside_them():
    learned, task = toy_places.grounding(), toy_places.swap()
    steps = (
        PlanStep(toy_places.NAME, "item-01", "spot-6000-m2000"),
        PlanStep(toy_places.NAME, "item-02", "goal-item-02"),
        PlanStep(toy_places.NAME, "item-01", "goal-item-01"),
    )
    assert validate(steps, task, learned).valid
    found = ground_plan(steps, task, learned)
    assert found.missing(problem_text(task, learned))
    beside = problem_text(task, learned, plans=[found])
    assert found.missing(beside) == ()
    assert "spot-6000-m2000 - spot" in beside


# Relations


# Names
NAMES_OF_ALL = "object thing price x12 y003 dx-3 dy cost12 way1 m-010 m-0110b-item-01"
NAMES_OF_CELLS = "block motion x-cell y-shift push lift put-down move-x move-y reach-lifted"
NAMES_OF_PLACES = "place spot take put-at note-clear reach-place nowhere park-01 goal-item-01 start-item-01"
NAMES_OF_RELATIONS = "tray perch origin way from-spot take-off put put-loaded spot-5000-m120"


@pytest.mark.parametrize(
    ("module", "names"),
    [
        (tables, f"{NAMES_OF_ALL} {NAMES_OF_CELLS}"),
        (toy_places, f"{NAMES_OF_ALL} cube leave {NAMES_OF_PLACES}"),
        (toy_relations, f"{NAMES_OF_ALL} {NAMES_OF_PLACES} {NAMES_OF_RELATIONS}"),
    ],
)
def test_object_named_like_a_part_of_the_domain_is_refused(module, names: str):
    learned = module.grounding()
    category = learned.objects.categories[0]
    (low, _), z = learned.table.x, category.feature_means[2] / 2
    for name in names.split():
        item = SceneObject(name, category.symbol, category.feature_means, (low + 0.2, 0.0, z))
        with pytest.raises(InvalidValue, match=f"No object can be called {name}"):
            problem_text(Problem("named", (item,), {}), learned)
