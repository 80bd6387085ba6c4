"""The problem that goes with the page: what it says of objects, places, pairs and cells, and of names."""

import pytest
import rehearsed
import tables
import toy_places
import toy_relations
from msgspec.structs import replace

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pddl import problem_text
from neurosym.pddl.compiler import ground_plan
from neurosym.pddl.strips_problem import StripsProblem, printed_cell
from neurosym.pddl.syntax import Atom
from neurosym.planners import plan
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep, validate

AWAY, LEFT, LIFT = "push-away-001-block", "push-left-000-block", "lift-010-block"


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
        assert result.steps == (PlanStep(LEFT, "item-01"),) * times, result.reason


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
    assert facts(strange, learned, *asked) == facts(strange, tables.grounding(0.02), *asked)


def test_of_motions_that_do_the_same_the_cheapest_is_told_and_those_of_plans_beside_it():
    """They differ by a cell of the domain, and not by one of the problem."""
    learned, (block, *_) = tables.grounding(0.005), tables.problem().objects
    table = learned.operators
    modes = (tables.mode((0.0021, 0.0782, 0.0), near=15),)
    twin = replace(table.operators[0], name="push-left-001-block", primitive="001", modes=modes)
    others = tuple(one for one in table.operators if (one.primitive, one.category) != ("001", "00"))
    both = replace(learned, operators=replace(table, operators=(*others, twin)))
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
OF_ALL = "object thing price x12 y003 dx-3 dy cost12 way1 m-010 m-0110b-item-01"
OF_CELLS = "block motion x-cell y-shift push lift put-down move-x move-y reach-lifted"
OF_PLACES = "place spot take put-at note-clear reach-place nowhere park-01 goal-item-01 start-item-01 n1"
OF_RELATIONS = "tray perch origin way from-spot take-off put put-loaded spot-5000-m120"


@pytest.mark.parametrize(
    ("module", "names"),
    [
        (tables, f"{OF_ALL} {OF_CELLS}"),
        (toy_places, f"{OF_ALL} cube leave {OF_PLACES}"),
        (toy_relations, f"{OF_ALL} {OF_PLACES} {OF_RELATIONS}"),
    ],
)
def test_object_named_like_a_part_of_the_domain_is_refused(module, names: str):
    learned = module.grounding()
    category = learned.operators.categories[0]
    (low, _), z = learned.table.x, category.feature_means[2] / 2
    for name in names.split():
        item = SceneObject(name, category.symbol, category.feature_means, (low + 0.2, 0.0, z))
        with pytest.raises(InvalidValue, match=f"No object can be called {name}"):
            problem_text(Problem("named", (item,), {}), learned)
