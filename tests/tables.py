"""A table of operators written by hand: two categories, four primitives, one lift, one null."""

from msgspec.structs import replace

from neurosym.grounding import Grounding
from neurosym.operators import Category, Mode, Operator, OperatorTable, Primitive, Vector
from neurosym.pddl import compile_domain
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.options import cost
from neurosym.tasks.transition import PlanStep
from neurosym.world import OutcomeKind, Table

BOUNDS = Table(x=(0.3, 0.9), y=(-0.3, 0.3))


def mode(
    effect: Vector,
    *,
    kind: OutcomeKind = "resting",
    count: int = 20,
    near: int = 18,
    resting: Vector | None = None,
) -> Mode:
    resting = resting or effect
    spread = (0.004, 0.003, 0.001)
    return Mode(kind, count, count / 20, effect, spread, resting, spread, max(effect[2], 0.0), near)


def table() -> OperatorTable:
    block = Category("00", "block", 0.6, (0.05, 0.05, 0.05, 0.0), (0.01, 0.01, 0.01, 0.0))
    tray = Category("11", "tray", 0.4, (0.12, 0.12, 0.04, 1.0), (0.02, 0.02, 0.01, 0.0))
    primitives = tuple(
        Primitive(symbol, tuple(round(0.01 * (number - k), 3) for k in range(12)), 0.02)
        for number, symbol in enumerate(("000", "001", "010", "111"))
    )
    away = mode((0.001, -0.002, 0.0))
    lift = mode((0.012, -0.021, 0.203), kind="held", count=16, near=15, resting=(0.0141, -0.0228, 0.0004))
    topples = mode((0.09, 0.0, -0.02), kind="toppled", count=15, near=0)
    operators = (
        Operator("push-left-000-block", "00", "000", 20, (mode((0.0021, 0.0832, 0.0003)),)),
        Operator("push-left-000-tray", "11", "000", 20, (mode((0.0, 0.0611, 0.0), near=12),)),
        Operator("push-away-001-block", "00", "001", 20, (mode((0.0713, -0.0124, 0.0)),)),
        Operator("push-away-001-tray", "11", "001", 20, (topples, mode((0.05, 0.0, 0.0), count=5, near=1))),
        Operator("lift-010-block", "00", "010", 20, (lift, away)),
        Operator("pull-010-tray", "11", "010", 20, (mode((-0.0532, -0.0473, 0.0)),)),
        Operator("stay-111-block", "00", "111", 20, (away,)),
        Operator("push-right-111-tray", "11", "111", 3, (mode((0.0, -0.06, 0.0), count=3, near=3),)),
    )
    return OperatorTable((block, tray), primitives, operators)


def grounding(cell: float = 0.005) -> Grounding:
    return compile_domain(table(), name="tabletop", cell=cell, table_bounds=BOUNDS, lift_height=0.2)


def with_modes(name: str, *modes: Mode, learned: Grounding | None = None) -> Grounding:
    """A domain, this one if none is given, in which one operator turned out so."""
    learned = learned or grounding()
    table = learned.objects
    changed = (replace(one, outcomes=modes) if one.name == name else one for one in table.operators)
    return replace(learned, objects=replace(table, operators=tuple(changed)))


def item(name: str, x: float, y: float, *, category: str = "00", height: float = 0.05) -> SceneObject:
    size = 0.05 if category == "00" else 0.12
    return SceneObject(name, category, (size, size, height, 0.0), (x, y, height / 2))


def problem() -> Problem:
    """A block to be pushed and then lifted, beside a tray to be pushed."""
    objects = (item("item-01", 0.4512, 0.0133), item("item-02", 0.6, -0.1, category="11", height=0.04))
    goals = {"item-01": (0.535, -0.02, 0.228), "item-02": (0.545, -0.087, 0.02)}
    return Problem("errand", objects, goals, provenance="seed 7")


def total_cost(steps: tuple[PlanStep, ...]) -> int:
    return sum(cost(grounding().operator_named(step.operator)) for step in steps if not step.puts_down)


PUSH, LEFT = PlanStep("push-away-001-block", "item-01"), PlanStep("push-left-000-block", "item-01")
LIFT, DOWN = PlanStep("lift-010-block", "item-01"), PlanStep("put-down-lift-010-block", "item-01")
PULL, TRAY_LEFT = PlanStep("pull-010-tray", "item-02"), PlanStep("push-left-000-tray", "item-02")


def crossing() -> Problem:
    """Two blocks in a column: the one in front must leave before the one behind may follow."""
    objects = (item("item-01", 0.5, 0.0), item("item-02", 0.5, 0.0832))
    return Problem("crossing", objects, {"item-01": (0.5, 0.0832, 0.025), "item-02": (0.5, 0.1664, 0.025)})
