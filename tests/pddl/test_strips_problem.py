"""The problem that goes with the page: what it says of objects, places, pairs and cells, and of names."""

import pytest
import rehearsed
import tables
import toy_places
import toy_relations
from msgspec.structs import replace
from toy_relations import PUT_IN, relearned

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding
from neurosym.pddl import problem_text
from neurosym.pddl.compiler import ground_plan
from neurosym.pddl.grid import goal_region
from neurosym.pddl.strips_problem import StripsProblem, motion_name, price_name, printed_cell
from neurosym.pddl.syntax import Atom
from neurosym.planners import plan
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.options import cost, moves_for
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


def test_each_motion_is_told_with_its_way_and_what_it_costs():
    learned, task = tables.grounding(0.02), tables.problem()
    moves = [(item.name, move) for item in task.objects for move in moves_for(item, learned, task.tolerance)]
    wanted = set[Atom]()
    for name, move in moves:
        words = (name, motion_name(move), f"dx{move.cells[0]}", f"dy{move.cells[1]}")
        if move.kind == "put-down":
            wanted.add(("lowers", *words))
        else:
            verb = "lifts" if move.kind == "lift" else "pushes"
            wanted.add((verb, *words, price_name(cost(move.operator))))
    assert facts(task, learned, "lifts", "pushes", "lowers") == wanted
    unit = replace(learned, unit_costs=True)
    for domain, costs in ((learned, (16, 33, 54)), (unit, (1,))):
        told = {name: cost for (_, name), cost in printed(task, domain).data().costs.items()}
        assert told == {price_name(one): one for one in costs}


def test_sums_say_where_every_step_leads_and_none_leads_off_the_table():
    learned, task = tables.grounding(0.02), tables.problem()
    data = printed(task, learned).data()
    for letter in "xy":
        steps = [name for name, kind in data.objects if kind == f"{letter}-shift"]
        told = {atom[1:] for atom in data.atoms if atom[0] == f"{letter}-sum"}
        number = {name: int(name.removeprefix(f"d{letter}")) for name in steps}
        wanted = {
            (step, f"{letter}{here:02}", f"{letter}{here + number[step]:02}")
            for step in steps
            for here in range(31)
            if 0 <= here + number[step] <= 30
        }
        assert told == wanted
    inner = printed(task, learned, margin=2).data().atoms
    ends = {atom[3] for atom in inner if atom[0] == "x-sum" and atom[1] != "dx0"}
    assert {"x02", "x28"} <= ends
    assert not ends & {"x00", "x01", "x29", "x30"}


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


def test_goal_cells_are_those_of_the_region_and_steps_take_off_of_it():
    learned, task = tables.grounding(0.005), replace(tables.problem(), tolerance=0.02)
    sizes = []
    for steps in (0, 1, 2):
        found = facts(task, learned, "goal-cell", steps=steps)
        for item in task.objects:
            region = goal_region(item, task.goals[item.name], task.tolerance, learned, steps=steps)
            cells = {(f"x{x:03}", f"y{y:03}") for x, y in region.xy}
            assert {atom[2:] for atom in found if atom[1] == item.name} == cells
        sizes.append(len(found))
    assert sizes[0] > sizes[1] > sizes[2]
    assert facts(task, learned, "goal-on-table", "goal-lifted") == {
        ("goal-on-table", "item-02"),
        ("goal-lifted", "item-01", "m-010"),
    }


# Places


def test_what_can_be_carried_needs_no_cells_and_the_rest_does():
    learned = toy_places.grounding()
    found = printed(toy_places.mixed(), learned)
    assert (found.task.carried, found.led) == (("item-01",), ("item-02",))
    assert {atom[1] for atom in found.data().atoms if atom[0] in ("at-x", "by-cells")} == {"item-02"}
    assert {atom[1] for atom in found.data().atoms if atom[0] in ("can-take", "can-carry")} == {"item-01"}
    assert "x-cell" not in problem_text(toy_places.swap(), learned)
    assert len(problem_text(toy_places.swap(), learned)) < 3000


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


def test_what_rehearsals_showed_to_fail_is_not_asked_for_and_the_rest_at_its_price():
    learned, task = toy_relations.grounding(), toy_relations.sorting()
    found = facts(task, learned, "can-put", "can-put-loaded", "fee")
    ways = {atom[1:3]: atom[3] for atom in found if atom[0] == "can-put"}
    asked = {atom[1:4]: atom[4] for atom in found if atom[0] == "fee"}
    on, lying = ways["item-02", "rests-on-item-01"], ways["item-02", "lies-in-item-04"]
    assert {words[1:] for words in asked if words[0] == on} == {("from-spot", "n0"), ("from-perch", "n0")}
    both = {(origin, count) for origin in ("from-spot", "from-perch") for count in ("n0", "n1")}
    assert {words[1:] for words in asked if words[0] == lying} == both
    assert asked[lying, "from-spot", "n0"] == "cost6"
    assert asked[lying, "from-spot", "n1"] == "cost30", "8 of 10 went so with a third object"
    assert not any(atom[1] in ("item-04", "item-05") for atom in found if atom[0].startswith("can-put"))
    tower = printed(toy_relations.tower(), learned)
    perches = {name for name, kind in tower.data().objects if kind == "perch"}
    assert perches == {f"rests-on-{name}" for name in tower.task.names}, "there is no tray"


def test_what_fails_from_another_object_or_with_a_load_has_no_way():
    task = toy_relations.sorting()
    learned = relearned(PUT_IN, borne=0, laden=0)
    found = facts(task, learned, "can-put", "can-put-loaded", "fee")
    way = next(atom[3] for atom in found if atom[:3] == ("can-put", "item-01", "lies-in-item-04"))
    assert {atom[2] for atom in found if atom[:2] == ("fee", way)} == {"from-spot"}
    assert not any(atom[2].startswith("lies-in") for atom in found if atom[0] == "can-put-loaded")


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


def test_object_of_an_unknown_category_is_refused():
    task = replace(tables.problem(), objects=(tables.item("a", 0.5, 0.0, category="01"),), goals={})
    with pytest.raises(UnknownChoice, match="valid: 00, 11"):
        problem_text(task, tables.grounding())
