"""The toy world's true table of operators, written down by hand from its rules, and problems for it."""

from neurosym.grounding import Grounding
from neurosym.operators import Category, Mode, Operator, OperatorTable, Primitive, Vector
from neurosym.pddl import compile_domain
from neurosym.problems import Problem, SceneObject
from neurosym.world import World
from neurosym.worlds.toy import ToyConfig, ToyWorld

WORLD = ToyWorld(ToyConfig())
LIFT = (0.0, 0.0, 0.0, 0.9, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1)
LEFT = (0.0, -0.05, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.05, 0.0, 0.1)
FORWARD = (-0.05, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.05, 0.0, 0.0, 0.1)


def grounding() -> Grounding:
    """Return the compiled domain of small solid cubes: lift, push left, push forward."""
    cube = Category("00", "cube", 1.0, (0.05, 0.05, 0.05, 0.0), (0.0, 0.0, 0.0, 0.0))
    primitives = (Primitive("000", LIFT, 0.0), Primitive("001", LEFT, 0.0), Primitive("010", FORWARD, 0.0))
    operators = (
        operator("lift-000-cube", "000", (0.0, 0.0, 0.2), held=True),
        operator("push-left-001-cube", "001", (0.0, 0.08, 0.0)),
        operator("push-forward-010-cube", "010", (0.08, 0.0, 0.0)),
    )
    return compiled(OperatorTable((cube,), primitives, operators))


def compiled(table: OperatorTable, cell: float = 0.005, world: World = WORLD, **options: object) -> Grounding:
    """Return the domain of the toy world, or of another, that a table of operators makes."""
    bounds = {"table_bounds": world.table, "lift_height": world.lift_height}
    return compile_domain(table, name=world.name, cell=cell, **bounds, **options)


def operator(
    name: str, primitive: str, effect: Vector, *, held: bool = False, category: str = "00"
) -> Operator:
    """Return an operator that always keeps its promise."""
    nothing = (0.0, 0.0, 0.0)
    resting = nothing if held else effect
    kind = "held" if held else "resting"
    mode = Mode(kind, 20, 1.0, effect, nothing, resting, nothing, effect[2], 20)
    return Operator(name, category, primitive, 20, (mode,))


def problem(goals: dict[str, Vector]) -> Problem:
    """Return a problem with two small cubes at (0.6, 0) and (0.8, 0.1)."""
    features = (0.05, 0.05, 0.05, 0.0)
    objects = (
        SceneObject("item-01", "00", features, (0.6, 0.0, 0.025)),
        SceneObject("item-02", "00", features, (0.8, 0.1, 0.025)),
    )
    return Problem("errand", objects, goals)
