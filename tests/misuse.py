"""Plausible mistakes with everything that `neurosym` exports: what is called, the error, and words of it.

As a program it makes all of them, without the checks of types that tests have, and prints what came of each.
"""

import json
import math
import os
import sys
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import msgspec
import numpy as np

import neurosym as ns
from neurosym.exploration.loop import ExplorationConfig
from neurosym.learning.training_config import ModelConfig, TrainingConfig
from neurosym.operators import Mode
from neurosym.world import check_action
from neurosym.worlds.task_drawing import set_problem
from neurosym.worlds.toy import ToyConfig, make_world

NAN, INF = math.nan, math.inf
TOY = make_world()
SCENE = TOY.sample_scene(np.random.default_rng(0), 2)
_PLACE = TemporaryDirectory()  # removed at the end of the process
FOLDER = Path(_PLACE.name)


def categorise(features):
    return ("0",) * len(features)


def columns(**changes):
    rows = 3
    given = {
        "features": np.zeros((rows, 4)),
        "actions": np.zeros((rows, 12)),
        "effects": np.zeros((rows, 3)),
        "resting_effects": np.zeros((rows, 3)),
        **{flag: np.zeros(rows, dtype=bool) for flag in ("held", "toppled", "lost")},
        "peak_heights": np.zeros(rows),
    }
    return ns.Interactions(**(given | changes))


def mode(**changes):
    given = {
        "kind": "resting",
        "count": 9,
        "share": 1.0,
        "effect": (0.08, 0.0, 0.0),
        "spread": (0.0, 0.0, 0.0),
        "resting_effect": (0.08, 0.0, 0.0),
        "resting_spread": (0.0, 0.0, 0.0),
        "peak_height": 0.0,
        "near_mean": 9,
    }
    return Mode(**(given | changes))


def operator(**changes):
    given = {"name": "push-0-any-0", "category": "0", "primitive": "0", "trials": 9, "modes": (mode(),)}
    return ns.Operator(**(given | changes))


PRIMITIVE = ns.Primitive("0", (0.0,) * 12, 0.0)
CATEGORY = ns.Category("0", "any-0", 1.0, (0.05,) * 4, (0.0,) * 4)
TABLE = ns.OperatorTable((CATEGORY,), (PRIMITIVE,), (operator(),))
BOUNDS = ns.Table((0.0, 1.0), (0.0, 1.0))
GROUNDING = ns.compile_domain(TABLE, name="toy", table_bounds=BOUNDS, lift_height=0.2)
ITEM = ns.SceneObject("item-01", "0", (0.05, 0.05, 0.05, 0.0), (0.5, 0.5, 0.025))
PROBLEM = ns.Problem("one", (ITEM,), {"item-01": (0.58, 0.5, 0.025)})
STEP = ns.PlanStep("push-0-any-0", "item-01")
DATA = ns.explore(make_world, steps=4, strategy="random", seed=0)


def item(**changes):
    return msgspec.structs.replace(ITEM, **changes)


def problem(**changes):
    given = {"name": "one", "objects": (ITEM,), "goals": {"item-01": (0.58, 0.5, 0.025)}}
    return ns.Problem(**(given | changes))


def box(**changes):
    given = {"low": -np.ones(2), "high": np.ones(2), "gripper": np.zeros(2, dtype=bool)}
    return ns.ActionBox(**(given | changes))


def mirrored(*arguments):
    return box(mirrors=(ns.Mirror(*arguments),))


def explore(*arguments, **changes):
    given = {"steps": 2, "strategy": "random", "seed": 0}
    return ns.explore(*(arguments or (make_world,)), **(given | changes))


def train(data=DATA, **changes):
    return ns.train(data, **({"seed": 0} | changes))


def compile_domain(table=TABLE, **changes):
    given = {"name": "toy", "table_bounds": BOUNDS, "lift_height": 0.2}
    return ns.compile_domain(table, **(given | changes))


def draw(world=TOY, of=categorise, **changes):
    return ns.draw_problem(world, of, **({"name": "p", "objects": 1, "seed": 0} | changes))


def draw_task(kind="anywhere", world=TOY, **changes):
    return ns.draw_task(world, categorise, kind, **({"name": "p", "objects": 1, "seed": 0} | changes))


def put(goals, **changes):
    return set_problem(TOY, categorise, goals, **({"name": "p", "objects": 1, "seed": 0} | changes))


def execute(world=TOY, task=PROBLEM, grounding=GROUNDING, steps=(STEP,), **changes):
    return ns.execute(world, task, grounding, steps, **changes)


def plan(task=PROBLEM, grounding=GROUNDING, planner="counting", **changes):
    return ns.plan(task, grounding, planner, **changes)


def choose(candidates=(PRIMITIVE,), choice="predictable", **changes):
    given = {
        "predict": lambda features, _: np.zeros((len(features), 4)),
        "features": SCENE.features,
        "categorise": categorise,
        "world_factory": make_world,
        "seed": 0,
    }
    return ns.choose(candidates, choice, **(given | changes))


def rehearse(factory=make_world, primitives=(PRIMITIVE,), of=categorise, **changes):
    return ns.rehearse(factory, primitives, of, **({"seed": 0, "objects": 2} | changes))


def distill(model, data=DATA, action_box=TOY.action_box, **changes):
    return ns.distill(model, data, action_box, **({"seed": 0} | changes))


def act(scene=SCENE, action=None, target=0):
    return check_action(TOY, scene, np.zeros(12) if action is None else action, target)


class Model:
    """Makes a small model when it is first needed."""

    def __call__(self):  # noqa: D102
        from neurosym.data.origin import Dimensions
        from neurosym.learning.network import EffectModel

        return EffectModel(Dimensions(4, 12, 3, (3, 7, 11)), ModelConfig(hidden=8))


def planner(**changes):
    return ns.Planner(**({"name": "mine", "about": "mine", "solve": print} | changes))


def wrong_world(**changes):
    class Wrong(type(TOY)):
        pass

    made = Wrong(ToyConfig())
    for name, value in changes.items():
        setattr(Wrong, name, value)
    return made


VALUE, WORLD, CHOICE, FILE, PLANNER = (
    "InvalidValue",
    "InvalidWorld",
    "UnknownChoice",
    "InvalidFile",
    "InvalidPlanner",
)


def each(values, words, call, error=VALUE):
    """The same mistake with several values."""
    return [(f"{words}: {value!r:.40}", lambda value=value: call(value), error, words) for value in values]


def named(values, name, *calls, error=VALUE):
    """The same mistake with one argument of several functions."""
    return [row for call in calls for row in each(values, name, lambda v, f=call: f(**{name: v}), error)]


def distilled(**changes):
    return distill(Model()(), **changes)


def replaced(**changes):
    return msgspec.structs.replace(GROUNDING, **changes)


SEEDS = (-1, 1.5, "0", None, True)
COUNTS = (0, -3, 2.5, "many", None)
LENGTHS = (0.0, -0.1, NAN, INF, "5 mm", None)
NOTHING = (3, None)
WAYS = (([0], [0]), ((2,), (0,)), ((0,), (3,)), ((), (0,)), ((0, 0), (0,)), ("0", "0"), (0, 0))
SIDES = (((0.0, 1.0), (1.0, 0.0)), ((0.0, NAN), (0.0, 1.0)), (1.0, 2.0), ((0.0, 1.0), None), ("ab", "cd"))
MISSING = ("nowhere.json", Path("nowhere.json"))

CALLS = [
    *named(SEEDS, "seed", explore, train, distilled, choose, rehearse, draw, draw_task),
    *named(SEEDS[:3], "nudge_seed", execute),
    *named(COUNTS, "steps", explore),
    *named(COUNTS, "workers", explore, rehearse, choose),
    *named(COUNTS, "objects", rehearse, draw_task),
    *each(COUNTS, "object", lambda objects: draw(objects=objects)),
    *each(COUNTS, "action", lambda actions: draw(actions=actions)),
    *each((99,), "", lambda objects: draw(objects=objects)),
    *named((-1, 2.5, "ten"), "replans", execute),
    *named(LENGTHS, "tolerance", draw, draw_task, problem),
    *named(LENGTHS, "lift_height", compile_domain),
    *named((NAN, 0.0), "lift_height", replaced),
    *named((*LENGTHS, 1e-9, 99.0), "cell", compile_domain),
    *named((0.0, NAN, -1.0), "cell", replaced),
    *named((0, -1.0, NAN, "soon"), "time_limit", plan),
    *named(NOTHING, "name", draw, draw_task, compile_domain, item),
    *named(("Task 1", "", "x" * 200), "name", draw),
    *each(("Toy", "", "thing", "9"), "", lambda name: compile_domain(name=name)),
    *named((3, "yes"), "fits", draw_task),
    *each(("heap", 3, None, ["row"]), "kind of task", draw_task, "UnknownChoice"),
    # worlds
    *each((3, "toy", TOY), "factory of worlds", explore),
    *each((3, TOY), "factory of worlds", rehearse),
    *each((3, TOY), "factory of worlds", lambda world: choose(world_factory=world)),
    *each((dict, lambda: None, lambda: ITEM), "is no World", explore, WORLD),
    *each((lambda: 1 / 0,), "ZeroDivisionError", explore, WORLD),
    *each((3, "toy", None, type(TOY), PROBLEM), "is", draw, WORLD),
    *each((3, "toy", None), "is no World", execute, WORLD),
    *each((3, "toy", None, dict), "is no World", ns.check_world, WORLD),
    *each((NAN, 0.0, "high"), "lift_height", lambda h: ns.check_world(wrong_world(lift_height=h)), WORLD),
    *each(("Toy World", "", 3), "has the name", lambda name: ns.check_world(wrong_world(name=name)), WORLD),
    # learning
    *named(("quick", {}, 3, ModelConfig()), "config", train),
    *named(("quick", 3), "config", explore),
    *named(("quick", 3, TrainingConfig(), ExplorationConfig()), "model_config", train, explore),
    *each((None, "interactions.npz", DATA.actions), "interactions", train),
    *each((DATA,), "too few", train),
    *named(NOTHING, "strategy", explore),
    *named(("luck", ""), "strategy", explore, error=CHOICE),
    *named((3, FOLDER / "missing", str(FOLDER / "missing")), "checkpoint", explore),
    *each((None, "effect_model.safetensors"), "model", distill),
    *each((None, "data.npz"), "interactions", lambda data: distill(Model()(), data)),
    *each((None, (-1, 1)), "box", lambda found: distilled(action_box=found)),
    *each((box(),), "action parameters", lambda found: distilled(action_box=found)),
    *each((np.zeros((2, 3)), "text", None), "features", lambda found: Model()().object_symbols(found)),
    *each((np.zeros((2, 3)), "text", None), "actions", lambda found: Model()().action_symbols(found)),
    *each(("0", None, (3,)), "candidates", choose),
    *each(((),), "no candidates", choose),
    *named(("best", ""), "choice", choose, error=CHOICE),
    *named(NOTHING, "choice", choose),
    *named((None, np.zeros((4, 3))), "predict", choose),
    *named((None, [[0.1]], np.zeros(4), np.full((2, 4), NAN)), "features", choose),
    *each((None, "0", ("0",)), "categorise", lambda of: rehearse(of=of)),
    *each((None, "0", lambda _: (), lambda _: 3, lambda _: (1,)), "categorise", lambda of: draw(of=of)),
    *each((lambda _: ("a",),), "symbol", lambda of: draw(of=of)),
    *named((None, "0", 3, (3,)), "primitives", rehearse),
    *each(((),), "Nothing can be rehearsed", lambda primitives: rehearse(primitives=primitives)),
    *each((ns.Primitive("0", (0.0,), 0.0),), "action parameters", lambda one: rehearse(primitives=(one,))),
    *each((None, 3, ()), "rehearsals", lambda found: ns.tabulate(found, TOY.feature_names)),
    *each((("a",), (), ("a",) * 5, "abcd", None), "feature_names", lambda n: ns.tabulate(rehearse(), n)),
    # planning and execution
    *each((None, "toy", 3), "table", compile_domain),
    *named((None, (0, 1)), "table_bounds", compile_domain),
    *each((None, 3, "one"), "problem", plan),
    *named((None, 3, "grounding.json"), "grounding", plan, execute),
    *each(("magic", ""), "planner", lambda name: plan(planner=name), CHOICE),
    *each((None, 3, plan), "Planner", lambda found: plan(planner=found), PLANNER),
    *named((3, "network"), "predict", plan),
    *each((item(category="7"),), "category", lambda one: plan(problem(objects=(one,))), CHOICE),
    *each((item(position=(9.0, 0.5, 0.02)),), "item-01", lambda one: plan(problem(objects=(one,)))),
    *each((None, 3, "one"), "problem", lambda task: execute(task=task)),
    *each((None, 3, "text", ("a", "b"), STEP, [("push", "item-01")]), "plan", lambda s: execute(steps=s)),
    *each((ns.PlanStep("fly", "item-01"),), "operator", lambda step: execute(steps=[step]), CHOICE),
    *each((ns.PlanStep("push-0-any-0", "cup"),), "object", lambda step: execute(steps=[step]), CHOICE),
    *each(NOTHING, "operator", lambda name: ns.PlanStep(name, "item-01")),
    *named(("fast-downward", 3), "replanner", execute),
    *each(
        (-0.05, 0.0, 9.0),
        "s_x",
        lambda size: execute(task=problem(objects=(item(features=(size, 0.05, 0.05, 0.0)),))),
    ),
    *each((np.zeros(3), np.full(12, NAN), np.array(["x"] * 12)), "action", lambda action: act(action=action)),
    *each((-1, 2, 1.0, True, "item-01"), "", lambda target: act(target=target)),
    *each((None, SCENE.features), "scene", lambda scene: act(scene=scene)),
    *each((np.zeros((2, 2)), np.full((2, 3), NAN)), "positions", lambda p: act(replace(SCENE, positions=p))),
    # what is made by hand
    *each((np.array([2.0, 1.0]), np.array([NAN, 0])), "low <= high", lambda low: box(low=low)),
    *each((np.zeros(3), np.zeros((1, 2)), np.zeros(0)), "shape", lambda low: box(low=low)),
    *each(([0, 0], None, np.array(["a", "b"])), "low of", lambda low: box(low=low)),
    *named((np.zeros(2), np.zeros(2, int)), "gripper", box),
    *named((([ns.Mirror((0,), (0,))]), "x", (3,), None), "mirrors", box),
    *each(WAYS, "Mirror", lambda given: mirrored(*given)),
    *each(SIDES, "table.", lambda sides: ns.Table(*sides)),
    *each((NAN, INF, None, "0.5", True), "Place.", lambda x: ns.Place(x, 0.0)),
    *each((NAN, None, "0", True), "OtherObject.index", ns.OtherObject),
    *named((np.zeros(3), np.full((3, 4), NAN), None, [[0.1] * 4]), "features", columns),
    *named((np.zeros((2, 12)), np.zeros(12), np.full((3, 12), INF)), "actions", columns),
    *named((np.zeros((3, 2)), np.zeros(3)), "resting_effects", columns),
    *named((np.zeros(3), np.zeros((3, 1), bool), None), "held", columns),
    *named((np.full(3, NAN), np.zeros(2)), "peak_heights", columns),
    *named((None, "robot"), "origin", columns),
    *each((NAN, "wide"), "SceneObject.features", lambda size: item(features=(size, 0.05, 0.05, 0.0))),
    *named(((0.5, 0.5), (0.5, 0.5, NAN), None, "here"), "position", item),
    *named(((0.0, 0.0, 1.0), (NAN,) * 4), "orientation", item),
    *each(((), (ITEM, ITEM), None, ("item-01",)), "", lambda objects: problem(objects=objects)),
    *each(((NAN, 0.5, 0.0), (0.5, 0.5), None), "goals", lambda goal: problem(goals={"item-01": goal})),
    *each(("cup",), "goal for cup", lambda name: problem(goals={name: (0.5, 0.5, 0.0)})),
    *each(((0.5,), (0.5, NAN), "ab", None, ("a", "b"), (9.0, 9.0)), "", lambda goal: put({"item-01": goal})),
    *each(NOTHING, "Primitive.symbol", lambda symbol: ns.Primitive(symbol, (0.0,), 0.0)),
    *each(((NAN,), "abc", None), "Primitive.action", lambda action: ns.Primitive("0", action, 0.0)),
    *each((NAN, "half"), "Category.share", lambda share: ns.Category("0", "a", share, (), ())),
    *named((None, (3,), "modes"), "modes", operator),
    *each(((0.0,), (NAN, 0.0, 0.0)), "", lambda effect: mode(effect=effect)),
    *each(("flying", None), "Mode.kind", lambda kind: mode(kind=kind)),
    *each((None, (3,)), "OperatorTable.operators", lambda found: ns.OperatorTable((), (), found)),
    # files, and planners of one's own
    *each(NOTHING, "path", ns.Grounding.load),
    *each(NOTHING, "path", PROBLEM.save),
    *each(NOTHING, "path", DATA.save),
    *each(MISSING, "nowhere.json", ns.Grounding.load, FILE),
    *each(MISSING, "nowhere.json", ns.Problem.load, FILE),
    *each(MISSING, "nowhere.json", ns.Interactions.load, FILE),
    *each(NOTHING, "problem", lambda task: ns.Query(task, GROUNDING)),
    *each((None, 3, "My Planner"), "is no name", lambda name: planner(name=name), PLANNER),
    *named(NOTHING, "solve", planner, error=PLANNER),
    *named((-1, 0.0, NAN, "60", None, True), "ceiling", planner, error=PLANNER),
    *named((("speed",), None, 3), "takes", planner, error=PLANNER),
    *named(("cards",), "reads", planner, error=PLANNER),
    *each((None, 3, "counting"), "Planner", ns.register_planner, PLANNER),
    *each(NOTHING, "problem", lambda task: ns.to_unified_planning(task, GROUNDING)),
    *each(("runes",), "encoding", lambda found: ns.to_unified_planning(PROBLEM, GROUNDING, found), CHOICE),
    *each((None, "plan", 3), "no plan", lambda found: ns.from_unified_planning(found, PROBLEM, GROUNDING)),
    *each(NOTHING, "call", lambda call: ns.pddl_planner("mine", "mine", call), PLANNER),
    *each((NAN, -1.0), "cell", lambda cell: ns.pddl_planner("mine", "mine", print, cell=cell), PLANNER),
    *each((("html",), 3), "encodings", lambda found: ns.pddl_planner("mine", "mine", print, found), PLANNER),
]


def outcome(call):
    """Say what came of a call: the kinds of its error from the most special on, and what it says."""
    try:
        call()
    except BaseException as error:
        return [kind.__name__ for kind in type(error).__mro__], str(error)
    return ["nothing"], ""


if __name__ == "__main__":
    os.chdir(FOLDER)
    sys.stdout.write(json.dumps([outcome(call) for _, call, _, _ in CALLS]))
