"""What actions do to values is told from rows, in cells, and planned with as PDDL that others judge."""

from functools import partial

import msgspec
import numpy as np
import pytest
from msgspec.structs import replace

from neurosym.data.axes import Axis
from neurosym.data.cells import Cells, Step
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.operators import TABLE_FORMAT, Category, OperatorTable, Primitive
from neurosym.pddl.syntax import Course
from neurosym.planners.planner import PlanStatus
from neurosym.planners.registry import planner_named
from neurosym.planners.unified_planning import validate_pddl
from neurosym.tasks.transition import PlanStep
from neurosym.values.domain import Outcome, ValueDomain
from neurosym.values.outcomes import Rows, compile_values, completed, name_of
from neurosym.values.problem import FORMAT, Thing, ValueProblem, ValueTask, known_to
from neurosym.values.value_execution import execute_values
from neurosym.values.value_page import value_page, value_problem, written
from neurosym.values.value_planning import plan_values

NAMES = ("angle", "level", "open")
TURN, LEVEL, OPEN = Axis("angle", "angle", period=12.0), Axis("level", unit="cm"), Axis("open", "flag")
MOVES = ("turn", "climb", "open", "shut")


def step(state: np.ndarray, move: int) -> np.ndarray:
    """A dial that turns by an hour, and a level that climbs where it is open."""
    angle, level, is_open = state
    if move == 0:
        angle = (angle + 1) % 12
    elif move == 1:
        level += 2.0 * is_open
    else:
        is_open = 1.0 * (move == 2)
    return np.array([angle, level, is_open])


def categorise(features: np.ndarray) -> tuple[str, ...]:
    return tuple("1" if row[2] >= 0.5 else "0" for row in features)


def moves_of(actions: np.ndarray) -> tuple[str, ...]:
    return tuple(f"{number:02b}" for number in actions.argmax(axis=1))


@pytest.fixture(scope="module")
def domain() -> ValueDomain:
    rng = np.random.default_rng(0)
    states = np.stack(
        [rng.integers(0, 12, 600), 2 * rng.integers(0, 6, 600), rng.integers(0, 2, 600)], axis=1
    )
    states = states.astype(float)
    moves = rng.integers(0, 4, 600)
    after = np.array([step(*pair) for pair in zip(states, moves, strict=True)])
    effects = np.stack([
        axis.difference(after[:, n], states[:, n]) for n, axis in enumerate((TURN, LEVEL, OPEN))
    ], axis=1)  # fmt: skip
    none = np.zeros(600, dtype=bool)
    data = Interactions(
        states.astype(np.float32), np.eye(4, dtype=np.float32)[moves], effects.astype(np.float32),
        effects.astype(np.float32), none, none, none, np.zeros(600, dtype=np.float32),
        {"feature_names": [*NAMES]},
    )  # fmt: skip
    table = OperatorTable(
        tuple(Category(symbol, f"kind-{symbol}", 0.5, (), ()) for symbol in "01"),
        tuple(Primitive(f"{n:02b}", tuple(np.eye(4)[n].tolist()), 0.0) for n in range(4)),
        (), "data", TABLE_FORMAT,
    )  # fmt: skip
    return compile_values(
        data, table, name="dial", object_symbols=categorise, action_symbols=moves_of,
        axes=(TURN, LEVEL, OPEN),
    )  # fmt: skip


def task(domain: ValueDomain, start: tuple[float, ...], goals: dict) -> ValueTask:
    thing = known_to(Thing("dial-1", start), domain, categorise)
    return ValueTask(ValueProblem(FORMAT, "task", (thing,), {"dial-1": goals}), domain)


def test_cells_and_bounds_are_measured(domain):
    turn, level, is_open = domain.axes
    assert (turn.cell, turn.period, turn.low) == (1.0, 12.0, None)
    assert (level.cell, level.low, level.high) == (2.0, 0.0, 12.0)
    assert is_open == OPEN
    assert [str(cells) for cells in domain.cells] == ["0 to 11 by 1", "0 to 12 cm by 2", "no and yes"]


def test_each_action_does_to_each_category_what_it_does(domain):
    told = {one.name: one.outcome.steps for one in domain.operators}
    stays = Step()
    assert told == {
        "raise-angle-00-kind-0": (Step(1), stays, stays),
        "raise-angle-00-kind-1": (Step(1), stays, stays),
        "raise-level-01-kind-1": (stays, Step(1), stays),
        "set-open-yes-10-kind-0": (stays, stays, Step(to=1)),
        "set-open-no-11-kind-1": (stays, stays, Step(to=0)),
    } | {name: steps for name, steps in told.items() if name.startswith("set-open")}
    assert all(one.chance > 0.9 for one in domain.operators)


@pytest.mark.parametrize("planner", ["fast-downward", "bfs-operators"])
def test_plans_are_valid_by_a_validator_that_is_not_ours(domain, planner):
    asked = task(domain, (11.0, 4.0, 0.0), {"angle": 0.0, "level": (5.0, 7.0)})
    result = plan_values(asked, planner_named(planner), time_limit=60)
    assert result.status is PlanStatus.SOLVED
    assert [one.operator.split("-")[1] for one in result.steps].count("open") == 1
    assert asked.replay(result.steps)[1] == ""
    actions = written(result.steps, asked)
    texts = value_page(domain).text(), value_problem(asked).text()
    assert validate_pddl(*texts, actions).valid
    assert not validate_pddl(*texts, actions[1:]).valid


def test_axes_may_be_called_as_the_page_calls_its_own_words(domain):
    names = ("dx", "x", "c")
    axes = tuple(replace(axis, name=name) for axis, name in zip(domain.axes, names, strict=True))
    called = replace(domain, axes=axes, features=names)
    asked = task(called, (11.0, 4.0, 0.0), {"dx": 0.0, "x": 6.0})
    steps = plan_values(asked, planner_named("fast-downward"), time_limit=60).steps
    texts = value_page(called).text(), value_problem(asked).text()
    assert validate_pddl(*texts, written(steps, asked)).valid


def test_replay_says_what_is_wrong(domain):
    asked = task(domain, (11.0, 4.0, 0.0), {"level": 6.0})
    climb = PlanStep("raise-level-01-kind-1", "dial-1")
    assert "is for 1, and dial-1 is of 0 there" in asked.replay([climb])[1]
    assert "level = 4, not 6" in asked.replay([])[1]
    full = task(domain, (0.0, 12.0, 1.0), {"level": 6.0})
    assert "out of bounds" in full.replay([climb])[1]
    assert plan_values(full, planner_named("fast-downward"), time_limit=60).status is PlanStatus.UNSOLVABLE
    assert plan_values(full, planner_named("bfs-operators"), time_limit=60).status is PlanStatus.NOT_FOUND
    with pytest.raises(InvalidValue, match="does not plan with values"):
        plan_values(full, planner_named("counting"), time_limit=60)


@pytest.mark.parametrize(
    ("start", "goals", "said"),
    [
        ((0.0, 99.0, 0.0), {"level": 6.0}, "level = 99 lies out of bounds; valid: 0 to 12"),
        ((0.0, 4.0, 0.0), {"level": 99.0}, "No cell of level meets the goal 99"),
        ((0.0, 4.0), {"level": 6.0}, "dial-1 has 2 features"),
    ],
)
def test_problems_that_cannot_be_are_refused(domain, start, goals, said):
    thing = Thing("dial-1", start, categories="0 " * 168)
    with pytest.raises(InvalidValue, match=said):
        ValueTask(ValueProblem(FORMAT, "task", (thing,), {"dial-1": goals}), domain)
    with pytest.raises(UnknownChoice, match="no axis 'weight'"):
        task(domain, (0.0, 4.0, 0.0), {"weight": 1.0})
    with pytest.raises(InvalidValue, match="is no thing"):
        ValueProblem(FORMAT, "task", (thing,), {"dial-2": {"level": 6.0}})


def test_the_page_allows_what_the_replay_allows_and_leads_where_it_leads(domain):
    rng = np.random.default_rng(3)
    possible = [0, 0]
    for _ in range(150):
        start = float(rng.integers(0, 12)), 2.0 * rng.integers(0, 7), float(rng.integers(0, 2))
        asked = task(domain, start, {"level": 6.0})
        course = Course(value_page(domain), {*value_problem(asked).atoms})
        here = asked.start["dial-1"]
        for _ in range(4):
            operator = domain.operators[int(rng.integers(len(domain.operators)))]
            refused = asked.refusal("dial-1", here, operator)
            possible[not refused] += 1
            if refused:
                with pytest.raises(InvalidValue):
                    take(course, domain, here, operator)
                break
            take(course, domain, here, operator)
            here = asked.apply(here, operator)
            at = {
                (f"at-{cells.axis.name}", "dial-1", cells.name(n))
                for cells, n in zip(domain.cells, here, strict=True)
            }
            assert at <= course.holds
    assert min(possible) > 50


def take(course: Course, domain: ValueDomain, here: tuple, operator) -> None:
    """Take the ground actions of an operator, wherever it leads."""
    names = [cells.name(number) for cells, number in zip(domain.cells, here, strict=True)]
    steps = [cells.step_name(one) for cells, one in zip(domain.cells, operator.outcome.steps, strict=True)]
    kind = domain.category(operator.category).name
    course.take("act", ["dial-1", operator.name, kind, *names, *steps, f"cost{operator.cost}"])
    for cells, name, said, number, one in zip(
        domain.cells, names, steps, here, operator.outcome.steps, strict=True
    ):
        there = cells.led(number, one)
        course.take(
            f"move-{cells.axis.name}", ["dial-1", said, name, cells.name(number if there is None else there)]
        )


def jammed(failures: int):
    """Make a world in which opening fails at first."""
    left = [failures]

    def perform(state: np.ndarray, action: np.ndarray) -> np.ndarray:
        move = int(action.argmax())
        if move == 2 and left[0]:
            left[0] -= 1
            return state
        return step(state, move)

    return perform


def test_a_run_that_is_given_up_says_where_it_ended(domain):
    asked = task(domain, (11.0, 4.0, 0.0), {"level": (5.5, 6.5)})
    solve = partial(plan_values, planner=planner_named("bfs-operators"), time_limit=60)
    run = execute_values(asked, solve(asked).steps, jammed(99), solve=solve, replans=2)
    assert (run.reached, run.replans) == (False, 2)
    assert run.reason == "dial-1 ends with level = 4, not 5.5 to 6.5"


@pytest.mark.parametrize(("failures", "replans", "reached"), [(0, 0, True), (1, 0, False), (1, 3, True)])
def test_a_plan_is_performed_and_made_anew_where_it_fails(domain, failures, replans, reached):
    asked = task(domain, (11.0, 4.0, 0.0), {"level": 6.0})
    solve = partial(plan_values, planner=planner_named("bfs-operators"), time_limit=60)
    run = execute_values(
        asked, solve(asked).steps, jammed(failures), solve=solve if replans else None, replans=replans
    )
    assert (run.reached, run.replans) == (reached, min(failures, replans))
    assert [one.as_promised for one in run.steps].count(False) == failures + (failures > replans)
    if reached:
        assert run.steps[-1].happened == (11.0, 6.0, 1.0)
    else:
        assert "not 6" in run.reason


def test_a_thing_that_leaves_what_is_known_ends_a_run(domain):
    asked = task(domain, (0.0, 4.0, 1.0), {"level": 6.0})
    plan = plan_values(asked, planner_named("bfs-operators"), time_limit=60).steps
    run = execute_values(asked, plan, lambda state, _: state + 1000)
    assert "dial-1 came to where nothing is known: level = 1004 lies out of bounds" in run.reason


def test_rounding_to_cells_that_adds_up_is_told_before_and_after(domain):
    asked = task(domain, (11.0, 2.0, 1.0), {"level": 8.0})
    plan = plan_values(asked, planner_named("bfs-operators"), time_limit=60).steps
    assert not asked.strays(plan)
    short = tuple(
        msgspec.structs.replace(
            one,
            outcome=msgspec.structs.replace(
                one.outcome, means=tuple(0.5 * mean for mean in one.outcome.means)
            ),
        )
        for one in domain.operators
    )
    drifting = ValueTask(asked.problem, msgspec.structs.replace(domain, operators=short))
    assert not drifting.replay(plan)[1]
    assert "dial-1 ends with level = 5, not 8" in drifting.strays(plan)


def test_outcomes_that_differ_are_operators_of_their_own():
    rng = np.random.default_rng(1)
    moved = np.where(rng.uniform(size=200) < 0.7, 1.0, 3.0) + rng.normal(0, 0.02, 200)
    none = np.zeros(200, dtype=bool)
    data = Interactions(
        rng.uniform(size=(200, 1)).astype(np.float32), np.ones((200, 1), dtype=np.float32),
        moved[:, None].astype(np.float32), moved[:, None].astype(np.float32), none, none, none,
        np.zeros(200, dtype=np.float32),
    )  # fmt: skip
    table = OperatorTable(
        (Category("0", "kind-0", 1.0, (), ()),), (Primitive("1", (1.0,), 0.0),), (), "data", TABLE_FORMAT
    )
    found = compile_values(
        data, table, name="two-ways", object_symbols=lambda rows: ("0",) * len(rows),
        action_symbols=lambda rows: ("1",) * len(rows), axes=(Axis("far", cell=0.5),),
    )  # fmt: skip
    assert [(one.name, one.outcome.steps[0].by) for one in found.operators] == [
        ("raise-far-1-kind-0", 2),
        ("raise-far-1-kind-0-or-a", 6),
    ]
    first, second = (one.outcome.share for one in found.operators)
    assert first == pytest.approx(0.7, abs=0.08)
    assert first + second == pytest.approx(1.0, abs=0.02)
    assert Cells(found.axes[0]).count > 20


def test_an_angle_begins_where_the_data_begin_so_that_the_network_is_asked_what_it_knows():
    rng, none = np.random.default_rng(0), np.zeros(400, dtype=bool)
    angle = rng.uniform(-np.pi, np.pi, 400)
    turn = Axis("angle", "angle", period=2 * np.pi)
    moved = np.full((400, 1), 0.5, dtype=np.float32)
    data = Interactions(
        angle[:, None].astype(np.float32), np.ones((400, 1), dtype=np.float32), moved, moved,
        none, none, none, np.zeros(400, dtype=np.float32), {"feature_names": ["angle"]},
    )  # fmt: skip
    table = OperatorTable(
        (Category("0", "kind-0", 1.0, (), ()),), (Primitive("1", (1.0,), 0.0),), (), "data", TABLE_FORMAT
    )
    found = compile_values(
        data, table, name="turning", object_symbols=lambda rows: ("0",) * len(rows),
        action_symbols=lambda rows: ("1",) * len(rows), axes=(turn,),
    )  # fmt: skip
    shown = found.features_at([0.0], [*found.states()])[:, 0]
    (cells,) = found.cells
    assert angle.min() - cells.size <= shown.min() < shown.max() <= angle.max() + cells.size
    assert {cells.index(value) for value in (3.1, 3.1 - 2 * np.pi)} == {cells.index(3.1)}
    assert cells.near((-0.6, 0.6)) == cells.near((2 * np.pi - 0.6, 2 * np.pi + 0.6))


@pytest.mark.parametrize(
    ("steps", "said"),
    [((3, -11, 0), "raise-far"), ((0, -11, 0), "lower-deep"), ((0, -11, None), "set-open-no")],
)
def test_operators_are_named_after_what_not_all_of_them_do(steps, said):
    *by, to = steps
    told = (*(Step(one) for one in by), Step() if to == 0 else Step(to=0))
    axes = (Axis("far", cell=1.0), Axis("deep", cell=1.0), Axis("open", "flag"))
    assert name_of(Outcome(told, 9, 0.9, (0.0, 0.0, 0.0)), axes, (0, -11, 0)) == said


def test_an_axis_that_no_feature_shows_has_finer_cells_as_no_state_is_in_one_of_them():
    rng = np.random.default_rng(0)
    moved = [change + rng.normal(0, 1e-3, (40, 1)) for change in (0.3, -0.5)]
    start, hidden = np.linspace(-3, 3, 40)[:, None], np.full((40, 1), np.nan)
    sizes = [
        completed([Axis("x")], [Rows(before, one) for one in moved], shown=[by])[0].cell
        for before, by in ((start, 0), (hidden, None))
    ]
    assert sizes == [0.15, 0.025]


def test_what_is_in_a_cell_that_meets_bounds_is_between_them_if_there_is_room_for_cells():
    cells = Cells(Axis("level", cell=1.0, low=0.0, high=10.0))
    assert cells.near((2.0, 5.0)) == (3, 4)
    assert cells.near((2.8, 3.4)) == (3,)
    with pytest.raises(InvalidValue, match="meets the goal"):
        cells.near((2.1, 2.9))
