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


BAD_SEEDS = (-1, 1.5, "0", None, True)
BAD_COUNTS = (0, -3, 2.5, "many", None)
BAD_LENGTHS = (0.0, -0.1, NAN, INF, "5 mm", None)

CALLS = [
    *each(BAD_SEEDS, "seed", lambda seed: explore(seed=seed)),
    *each(BAD_SEEDS, "seed", lambda seed: train(seed=seed)),
    *each(BAD_SEEDS, "seed", lambda seed: distill(Model()(), seed=seed)),
    *each(BAD_SEEDS, "seed", lambda seed: choose(seed=seed)),
    *each(BAD_SEEDS, "seed", lambda seed: rehearse(seed=seed)),
    *each(BAD_SEEDS, "seed", lambda seed: draw(seed=seed)),
    *each(BAD_SEEDS[:3], "nudge_seed", lambda seed: execute(nudge_seed=seed)),
    *each(BAD_COUNTS, "steps", lambda steps: explore(steps=steps)),
    *each(BAD_COUNTS, "workers", lambda workers: explore(workers=workers)),
    *each(BAD_COUNTS, "workers", lambda workers: rehearse(workers=workers)),
    *each(BAD_COUNTS, "workers", lambda workers: choose(workers=workers)),
    *each(BAD_COUNTS, "objects", lambda objects: rehearse(objects=objects)),
    *each(BAD_COUNTS, "object", lambda objects: draw(objects=objects)),
    *each(BAD_SEEDS, "seed", lambda seed: draw_task(seed=seed)),
    *each(BAD_COUNTS, "objects", lambda objects: draw_task(objects=objects)),
    *each(BAD_LENGTHS, "tolerance", lambda tolerance: draw_task(tolerance=tolerance)),
    *each((3, None), "name", lambda name: draw_task(name=name)),
    *each((3, "yes"), "fits", lambda fits: draw_task(fits=fits)),
    *each(("heap", 3, None, ["row"]), "kind of task", lambda kind: draw_task(kind), "UnknownChoice"),
    *each(BAD_COUNTS, "action", lambda actions: draw(actions=actions)),
    *each((-1, 2.5, "ten"), "replans", lambda replans: execute(replans=replans)),
    *each(BAD_LENGTHS, "tolerance", lambda tolerance: draw(tolerance=tolerance)),
    *each(BAD_LENGTHS, "tolerance", lambda tolerance: problem(tolerance=tolerance)),
    *each(BAD_LENGTHS, "lift_height", lambda height: compile_domain(lift_height=height)),
    *each(BAD_LENGTHS, "cell", lambda cell: compile_domain(cell=cell)),
    *each((0, -1.0, NAN, "soon"), "time_limit", lambda limit: plan(time_limit=limit)),
    *each((3, "toy", TOY), "factory of worlds", lambda world: explore(world)),
    *each((3, TOY), "factory of worlds", lambda world: rehearse(world)),
    *each((3, TOY), "factory of worlds", lambda world: choose(world_factory=world)),
    *each((dict, lambda: None, lambda: ITEM), "is no World", explore, WORLD),
    *each((lambda: 1 / 0,), "ZeroDivisionError", explore, WORLD),
    *each((3, "toy", None, type(TOY), PROBLEM), "is", lambda world: draw(world), WORLD),
    *each((3, "toy", None), "is no World", lambda world: execute(world), WORLD),
    *each((3, "toy", None, dict), "is no World", ns.check_world, WORLD),
    *each(
        (NAN, 0.0, -1.0, "high"), "lift_height", lambda h: ns.check_world(wrong_world(lift_height=h)), WORLD
    ),
    *each(("Toy World", "", 3), "has the name", lambda name: ns.check_world(wrong_world(name=name)), WORLD),
    *each(("quick", {}, 3, ModelConfig()), "config", lambda config: train(config=config)),
    *each(("quick", 3, TrainingConfig()), "model_config", lambda config: train(model_config=config)),
    *each(("quick", 3), "config", lambda config: explore(config=config)),
    *each(("quick", 3, ExplorationConfig()), "model_config", lambda config: explore(model_config=config)),
    *each((None, "interactions.npz", DATA.actions), "interactions", lambda data: train(data)),
    *each((DATA,), "too few", train),
    *each((3, None), "strategy", lambda strategy: explore(strategy=strategy)),
    *each(("luck", ""), "strategy", lambda strategy: explore(strategy=strategy), CHOICE),
    *each(
        (3, FOLDER / "missing", str(FOLDER / "missing")), "checkpoint", lambda path: explore(checkpoint=path)
    ),
    *each((None, "effect_model.safetensors"), "model", distill),
    *each((None, "data.npz"), "interactions", lambda data: distill(Model()(), data)),
    *each((None, (-1, 1)), "box", lambda found: distill(Model()(), action_box=found)),
    *each((box(),), "action parameters", lambda found: distill(Model()(), action_box=found)),
    *each(("0", None, (3,)), "candidates", choose),
    *each(((),), "no candidates", choose),
    *each(("best", ""), "choice", lambda choice: choose(choice=choice), CHOICE),
    *each((None, 3), "choice", lambda choice: choose(choice=choice)),
    *each((None, np.zeros((4, 3))), "predict", lambda predict: choose(predict=predict)),
    *each((None, [[0.1]], np.zeros(4), np.full((2, 4), NAN)), "features", lambda f: choose(features=f)),
    *each((None, "0", ("0",)), "categorise", lambda of: rehearse(of=of)),
    *each((None, "0", lambda _: (), lambda _: 3, lambda _: (1,)), "categorise", lambda of: draw(of=of)),
    *each((None, "0", 3, (3,)), "primitives", lambda primitives: rehearse(primitives=primitives)),
    *each(((),), "Nothing can be rehearsed", lambda primitives: rehearse(primitives=primitives)),
    *each((ns.Primitive("0", (0.0,), 0.0),), "action parameters", lambda one: rehearse(primitives=(one,))),
    *each((None, 3, ()), "rehearsals", lambda found: ns.tabulate(found, TOY.feature_names)),
    *each((("a",), (), ("a",) * 5, "abcd", None), "feature_names", lambda n: ns.tabulate(rehearse(), n)),
    *each((None, "toy", 3), "table", compile_domain),
    *each((None, 3), "name", lambda name: compile_domain(name=name)),
    *each(("Toy", "", "thing", "9"), "", lambda name: compile_domain(name=name)),
    *each((None, (0, 1)), "table_bounds", lambda bounds: compile_domain(table_bounds=bounds)),
    *each((1e-9, 99.0), "cell", lambda cell: compile_domain(cell=cell)),
    *each((None, 3, "one"), "problem", plan),
    *each((None, 3, "grounding.json"), "grounding", lambda grounding: plan(grounding=grounding)),
    *each(("magic", ""), "planner", lambda name: plan(planner=name), CHOICE),
    *each((None, 3, plan), "Planner", lambda found: plan(planner=found), PLANNER),
    *each((3, "network"), "predict", lambda predict: plan(predict=predict)),
    *each((item(category="7"),), "category", lambda one: plan(problem(objects=(one,))), CHOICE),
    *each((item(position=(9.0, 0.5, 0.02)),), "item-01", lambda one: plan(problem(objects=(one,)))),
    *each((None, 3, "one"), "problem", lambda task: execute(task=task)),
    *each((None, 3, "grounding.json"), "grounding", lambda grounding: execute(grounding=grounding)),
    *each(
        (None, 3, "text", ("a", "b"), STEP, [("push", "item-01")]), "plan", lambda steps: execute(steps=steps)
    ),
    *each((ns.PlanStep("fly", "item-01"),), "operator", lambda step: execute(steps=[step]), CHOICE),
    *each((ns.PlanStep("push-0-any-0", "cup"),), "object", lambda step: execute(steps=[step]), CHOICE),
    *each((None, 3), "operator", lambda name: ns.PlanStep(name, "item-01")),
    *each((None, 3), "object", lambda name: ns.PlanStep("push", name)),
    *each(
        (np.array([2.0, 1.0]), np.array([NAN, 0]), np.array([INF, 0])),
        "low <= high",
        lambda low: box(low=low),
    ),
    *each((np.zeros(3), np.zeros((1, 2)), np.zeros(0)), "shape", lambda low: box(low=low)),
    *each(([0, 0], None, 3), "low of type", lambda low: box(low=low)),
    *each((np.array(["a", "b"]),), "low of", lambda low: box(low=low)),
    *each((np.zeros(2), np.zeros(2, int)), "gripper", lambda gripper: box(gripper=gripper)),
    *each((([ns.Mirror((0,), (0,))]), "x", (3,), None), "mirrors", lambda found: box(mirrors=found)),
    *each(
        (((2,), (0,)), ((0,), (3,)), ((), (0,)), ((0, 0), (0,)), ("0", "0"), (0, 0), ([0], [0])),
        "Mirror",
        lambda given: mirrored(*given),
    ),
    *each(
        (
            ((0.0, 1.0), (1.0, 0.0)),
            ((0.0, NAN), (0.0, 1.0)),
            ((0.0, INF), (0.0, 1.0)),
            (1.0, 2.0),
            ((0.0, 1.0), None),
            ("ab", "cd"),
            ((0.0, 1.0, 2.0), (0.0, 1.0)),
        ),
        "table.",
        lambda sides: ns.Table(*sides),
    ),
    *each((NAN, INF, None, "0.5", True), "Place.", lambda x: ns.Place(x, 0.0)),
    *each((NAN, None, "0", True), "OtherObject.index", ns.OtherObject),
    *each((np.zeros(3), np.full((3, 4), NAN), None, [[0.1] * 4]), "features", lambda f: columns(features=f)),
    *each(
        (np.zeros((2, 12)), np.zeros(12), np.full((3, 12), INF)),
        "actions",
        lambda found: columns(actions=found),
    ),
    *each((np.zeros((3, 2)), np.zeros(3)), "resting_effects", lambda found: columns(resting_effects=found)),
    *each((np.zeros(3), np.zeros((3, 1), bool), None), "held", lambda found: columns(held=found)),
    *each((np.full(3, NAN), np.zeros(2)), "peak_heights", lambda found: columns(peak_heights=found)),
    *each((None, "robot"), "origin", lambda origin: columns(origin=origin)),
    *each(
        (-0.05, 0.0, 9.0),
        "s_x",
        lambda size: execute(task=problem(objects=(item(features=(size, 0.05, 0.05, 0.0)),))),
    ),
    *each((NAN, "wide"), "SceneObject.features", lambda size: item(features=(size, 0.05, 0.05, 0.0))),
    *each(((0.5, 0.5), (0.5, 0.5, NAN), None, "here"), "position", lambda place: item(position=place)),
    *each(((0.0, 0.0, 1.0), (NAN,) * 4), "orientation", lambda turned: item(orientation=turned)),
    *each((3, None), "name", lambda name: item(name=name)),
    *each(("Item 1", ""), "", lambda name: problem(objects=(item(name=name),), goals={})),
    *each(((), (ITEM, ITEM), None, ("item-01",)), "", lambda objects: problem(objects=objects)),
    *each(
        ((NAN, 0.5, 0.0), (0.5, 0.5), None, "there", (0.5, 0.5, INF)),
        "goals",
        lambda goal: problem(goals={"item-01": goal}),
    ),
    *each(("cup",), "goal for cup", lambda name: problem(goals={name: (0.5, 0.5, 0.0)})),
    *each(("Task 1", "", "x" * 200), "name", lambda name: draw(name=name)),
    *each(((0.5,), (0.5, NAN), "ab", None, ("a", "b"), (9.0, 9.0)), "", lambda goal: put({"item-01": goal})),
    *each((99,), "", lambda objects: draw(objects=objects)),
    *each((3, None), "name", lambda name: draw(name=name)),
    *each((lambda _: ("a",),), "symbol", lambda of: draw(of=of)),
    *each(("fast-downward", 3), "replanner", lambda replanner: execute(replanner=replanner)),
    *each((np.zeros((2, 3)), "text", None), "features", lambda found: Model()().object_symbols(found)),
    *each((np.zeros((2, 3)), "text", None), "actions", lambda found: Model()().action_symbols(found)),
    *each((None, 3), "Primitive.symbol", lambda symbol: ns.Primitive(symbol, (0.0,), 0.0)),
    *each(((NAN,), "abc", None), "Primitive.action", lambda action: ns.Primitive("0", action, 0.0)),
    *each((None, 3), "Category.name", lambda name: ns.Category("0", name, 1.0, (), ())),
    *each((NAN, "half"), "Category.share", lambda share: ns.Category("0", "a", share, (), ())),
    *each((None, (3,), "modes"), "Operator.modes", lambda modes: operator(modes=modes)),
    *each(("flying",), "Operator.promised", lambda promised: operator(promised=promised)),
    *each(
        (((0.0,), (0.0,)), ((NAN, 0.0, 0.0), (0.0, 0.0, 0.0))),
        "",
        lambda given: mode(effect=given[0], spread=given[1]),
    ),
    *each(("flying", None), "Mode.kind", lambda kind: mode(kind=kind)),
    *each((None, (3,)), "OperatorTable.operators", lambda found: ns.OperatorTable((), (), found)),
    *each((0.0, NAN, -1.0), "cell", lambda cell: msgspec.structs.replace(GROUNDING, cell=cell)),
    *each((NAN, 0.0), "lift_height", lambda height: msgspec.structs.replace(GROUNDING, lift_height=height)),
    *each((3, None, b"bytes"), "path", ns.Grounding.load),
    *each((3, None), "path", ns.Problem.load),
    *each((3, None), "path", ns.Interactions.load),
    *each((3, None), "path", GROUNDING.save),
    *each((3, None), "path", PROBLEM.save),
    *each((3, None), "path", DATA.save),
    *each(("nowhere.json", Path("nowhere.json")), "nowhere.json", ns.Grounding.load, FILE),
    *each(("nowhere.json", Path("nowhere.json")), "nowhere.json", ns.Problem.load, FILE),
    *each(("nowhere.npz", Path("nowhere.npz")), "nowhere.npz", ns.Interactions.load, FILE),
    *each((None, 3, "problem"), "problem", lambda task: ns.Query(task, GROUNDING)),
    *each((None, 3), "grounding", lambda grounding: ns.Query(PROBLEM, grounding)),
    *each((None, 3, "My Planner"), "is no name", lambda name: planner(name=name), PLANNER),
    *each((None, 3), "solve", lambda solve: planner(solve=solve), PLANNER),
    *each((-1, 0.0, NAN, "60", None, True), "ceiling", lambda found: planner(ceiling=found), PLANNER),
    *each((3, None), "about", lambda about: planner(about=about), PLANNER),
    *each((("speed",), None, 3), "takes", lambda takes: planner(takes=takes), PLANNER),
    *each(("cards",), "reads", lambda reads: planner(reads=reads), PLANNER),
    *each((None, 3, "counting"), "Planner", ns.register_planner, PLANNER),
    *each((None, 3), "problem", lambda task: ns.to_unified_planning(task, GROUNDING)),
    *each((None, 3), "grounding", lambda found: ns.to_unified_planning(PROBLEM, found)),
    *each(("runes",), "encoding", lambda found: ns.to_unified_planning(PROBLEM, GROUNDING, found), CHOICE),
    *each((None, "plan", 3), "no plan", lambda found: ns.from_unified_planning(found, PROBLEM, GROUNDING)),
    *each((None, 3), "call", lambda call: ns.pddl_planner("mine", "mine", call), PLANNER),
    *each(
        (NAN, -1.0, "fine"), "cell", lambda cell: ns.pddl_planner("mine", "mine", print, cell=cell), PLANNER
    ),
    *each(
        (("html",), (), 3), "encodings", lambda found: ns.pddl_planner("mine", "mine", print, found), PLANNER
    ),
    *each((np.zeros(3), np.full(12, NAN), np.array(["x"] * 12)), "action", lambda action: act(action=action)),
    *each((-1, 2, 1.0, True, "item-01"), "", lambda target: act(target=target)),
    *each((None, SCENE.features), "scene", lambda scene: act(scene=scene)),
    *each(
        (np.zeros((2, 2)), np.full((2, 3), NAN)),
        "positions",
        lambda p: act(scene=replace(SCENE, positions=p)),
    ),
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
