"""Plausible mistakes with everything that `neurosym` exports: what is called, the error, and words of it.

As a program it makes all of them, without the checks of types that tests have, and prints what came of each.
"""

import inspect
import json
import math
import os
import sys
from functools import partial
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


def usually(function, **usual):
    """Call something with usual arguments, but for those that are given."""
    names = list(inspect.signature(function).parameters)

    def call(*given, **changes):
        return function(**(usual | dict(zip(names, given, strict=False)) | changes))

    return call


STILL, AWAY = (0.0, 0.0, 0.0), (0.08, 0.0, 0.0)
ends = {"effect": AWAY, "spread": STILL, "resting_effect": AWAY, "resting_spread": STILL}
mode = usually(Mode, kind="resting", count=9, share=1.0, peak_height=0.0, near_mean=9, **ends)
columns = usually(
    ns.Interactions,
    features=np.zeros((3, 4)),
    actions=np.zeros((3, 12)),
    peak_heights=np.zeros(3),
    **{name: np.zeros((3, 3)) for name in ("effects", "resting_effects")},
    **{flag: np.zeros(3, dtype=bool) for flag in ("held", "toppled", "lost")},
)
operator = usually(ns.Operator, name="push-0-any-0", subject="0", primitive="0", trials=9, outcomes=(mode(),))
PRIMITIVE = ns.Primitive("0", (0.0,) * 12, 0.0)
CATEGORY = ns.Category("0", "any-0", 1.0, (0.05,) * 4, (0.0,) * 4)
TABLE = ns.OperatorTable((CATEGORY,), (PRIMITIVE,), (operator(),))
BOUNDS = ns.Table((0.0, 1.0), (0.0, 1.0))
compile_domain = usually(ns.compile_domain, table=TABLE, name="toy", table_bounds=BOUNDS, lift_height=0.2)
GROUNDING = compile_domain()
ITEM = ns.SceneObject("item-01", "0", (0.05, 0.05, 0.05, 0.0), (0.5, 0.5, 0.025))
problem = usually(ns.Problem, name="one", objects=(ITEM,), goals={"item-01": (0.58, 0.5, 0.025)})
PROBLEM = problem()
STEP = ns.PlanStep("push-0-any-0", "item-01")
explore = usually(ns.explore, world_factory=make_world, steps=2, strategy="random", seed=0)
DATA = explore(steps=4)
item, replaced = (partial(msgspec.structs.replace, one) for one in (ITEM, GROUNDING))
box = usually(ns.ActionBox, low=-np.ones(2), high=np.ones(2), gripper=np.zeros(2, dtype=bool))
train = usually(ns.train, interactions=DATA, seed=0)
drawing = {"world": TOY, "categorise": categorise, "name": "p", "objects": 1, "seed": 0}
draw, draw_task = usually(ns.draw_problem, **drawing), usually(ns.draw_task, **drawing, kind="anywhere")
put = usually(set_problem, **drawing)
execute = usually(ns.execute, world=TOY, problem=PROBLEM, grounding=GROUNDING, plan=(STEP,))
plan = usually(ns.plan, problem=PROBLEM, grounding=GROUNDING, planner="counting")
trying = {"categorise": categorise, "world_factory": make_world, "seed": 0}
seen = {"predict": lambda features, _: np.zeros((len(features), 4)), "features": SCENE.features}
choose = usually(ns.choose, candidates=(PRIMITIVE,), choice="predictable", **seen, **trying)
rehearse = usually(ns.rehearse, primitives=(PRIMITIVE,), objects=2, **trying)
act = usually(check_action, world=TOY, scene=SCENE, action=np.zeros(12), target=0)
planner = usually(ns.Planner, name="mine", about="mine", solve=print)


def mirrored(*arguments):
    return box(mirrors=(ns.Mirror(*arguments),))


def model():
    """Make a small model."""
    from neurosym.data.origin import Dimensions
    from neurosym.learning.network import EffectModel

    return EffectModel(Dimensions(4, 12, 3, (3, 7, 11)), ModelConfig(hidden=8))


def distilled(**changes):
    given = {"model": model(), "interactions": DATA, "box": TOY.action_box, "seed": 0}
    return ns.distill(**(given | changes))


def wrong_world(**changes):
    class Wrong(type(TOY)):
        pass

    made = Wrong(ToyConfig())
    for name, value in changes.items():
        setattr(Wrong, name, value)
    return made


VALUE, WORLD, CHOICE = "InvalidValue", "InvalidWorld", "UnknownChoice"
FILE, PLANNER = "InvalidFile", "InvalidPlanner"


def each(values, words, call, error=VALUE):
    """The same mistake with several values."""
    return [(f"{words}: {value!r:.40}", lambda value=value: call(value), error, words) for value in values]


def named(values, name, *calls, error=VALUE):
    """The same mistake with one argument of several functions."""
    return [row for call in calls for row in each(values, name, lambda v, f=call: f(**{name: v}), error)]


SEEDS = (-1, 1.5, "0", None, True)
COUNTS = (0, -3, 2.5, "many", None)
LENGTHS = (0.0, -0.1, NAN, INF, "5 mm", None)
NOTHING = (3, None)
with_goals = usually(ns.with_goals, problem=PROBLEM, grounding=GROUNDING)
WAYS = (([0], [0]), ((2,), (0,)), ((0,), (3,)), ((), (0,)), ((0, 0), (0,)), ("0", "0"), (0, 0))
SIDES = (((0.0, 1.0), (1.0, 0.0)), ((0.0, NAN), (0.0, 1.0)), (1.0, 2.0), ((0.0, 1.0), None), ("ab", "cd"))
MISSING = ("nowhere.json", Path("nowhere.json"))

CALLS = [
    *named(SEEDS, "seed", explore, train, distilled, choose, rehearse, draw, draw_task),
    *named(COUNTS, "steps", explore),
    *named(COUNTS, "workers", explore, rehearse, choose),
    *named(COUNTS, "objects", rehearse, draw_task),
    *each(COUNTS, "object", lambda objects: draw(objects=objects)),
    *each(COUNTS, "action", lambda actions: draw(actions=actions)),
    *named(LENGTHS, "tolerance", draw, draw_task, problem),
    *named((*LENGTHS, 1e-9, 99.0), "cell", compile_domain),
    *named((0, -1.0, NAN, "soon"), "time_limit", plan),
    *named(NOTHING, "name", draw, draw_task, compile_domain, item),
    *each(("heap", 3, None, ["row"]), "kind of task", lambda kind: draw_task(kind=kind), CHOICE),
    *named(NOTHING, "problem", with_goals),
    *named(NOTHING, "grounding", with_goals),
    *each(
        ("", "item-01", "item-01 x=5", "2 of item-01 x=0.5"),
        "valid",
        lambda text: with_goals(problem(conditions=(text,))),
    ),
    # worlds
    *each((3, "toy", TOY), "factory of worlds", explore),
    *each((dict, lambda: None, lambda: ITEM), "is no World", explore, WORLD),
    *each((3, "toy", None, type(TOY), PROBLEM), "is", draw, WORLD),
    *each((3, "toy", None, dict), "is no World", ns.check_world, WORLD),
    *each((NAN, 0.0, "high"), "lift_height", lambda h: ns.check_world(wrong_world(lift_height=h)), WORLD),
    # learning
    *named(("quick", {}, 3, ModelConfig()), "config", train),
    *named(("quick", 3, TrainingConfig(), ExplorationConfig()), "model_config", train, explore),
    *each((None, "interactions.npz", DATA.actions), "interactions", train),
    *each((DATA,), "too few", train),
    *named(NOTHING, "strategy", explore),
    *named((None, "effect_model.safetensors"), "model", distilled),
    *each((box(),), "action parameters", lambda found: distilled(box=found)),
    *each(((),), "no candidates", choose),
    *named(("best", ""), "choice", choose, error=CHOICE),
    *named((None, np.zeros((4, 3))), "predict", choose),
    *each(
        (None, "0", lambda _: (), lambda _: 3, lambda _: (1,)), "categorise", lambda of: draw(categorise=of)
    ),
    *each(((),), "Nothing can be rehearsed", lambda primitives: rehearse(primitives=primitives)),
    *each((None, 3, ()), "rehearsals", lambda found: ns.tabulate(found, TOY.feature_names)),
    *each((("a",), (), ("a",) * 5, "abcd", None), "feature_names", lambda n: ns.tabulate(rehearse(), n)),
    # planning and execution
    *named((None, 3, "grounding.json"), "grounding", plan, execute),
    *each(("magic", ""), "planner", lambda name: plan(planner=name), CHOICE),
    *each((None, 3, plan), "Planner", lambda found: plan(planner=found), PLANNER),
    *each((None, 3, "one"), "problem", lambda task: execute(problem=task)),
    *each((None, 3, "text", ("a", "b"), STEP, [("push", "item-01")]), "plan", lambda s: execute(plan=s)),
    *each((ns.PlanStep("fly", "item-01"),), "operator", lambda step: execute(plan=[step]), CHOICE),
    *each((ns.PlanStep("push-0-any-0", "cup"),), "object", lambda step: execute(plan=[step]), CHOICE),
    *named(("fast-downward", 3), "replanner", execute),
    *each((np.zeros(3), np.full(12, NAN), np.array(["x"] * 12)), "action", lambda action: act(action=action)),
    *each((-1, 2, 1.0, True, "item-01"), "", lambda target: act(target=target)),
    # what is made by hand
    *each((np.array([2.0, 1.0]), np.array([NAN, 0])), "low <= high", lambda low: box(low=low)),
    *each((np.zeros(3), np.zeros((1, 2)), np.zeros(0)), "shape", lambda low: box(low=low)),
    *named((([ns.Mirror((0,), (0,))]), "x", (3,), None), "mirrors", box),
    *each(WAYS, "Mirror", lambda given: mirrored(*given)),
    *each(SIDES, "table.", lambda sides: ns.Table(*sides)),
    *each((NAN, INF, None, "0.5", True), "Place.", lambda x: ns.Place(x, 0.0)),
    *each((NAN, None, "0", True), "OtherObject.index", ns.OtherObject),
    *named((np.zeros(3), np.full((3, 4), NAN), None, [[0.1] * 4]), "features", columns),
    *named((np.zeros((3, 2)), np.zeros(3)), "resting_effects", columns),
    *named((np.zeros(3), np.zeros((3, 1), bool), None), "held", columns),
    *named(((0.0, 0.0, 1.0), (NAN,) * 4), "orientation", item),
    *each(((), (ITEM, ITEM), None, ("item-01",)), "", lambda objects: problem(objects=objects)),
    *each(((NAN, 0.5, 0.0), (0.5, 0.5), None), "goals", lambda goal: problem(goals={"item-01": goal})),
    *each(("cup",), "goal for cup", lambda name: problem(goals={name: (0.5, 0.5, 0.0)})),
    *each(NOTHING, "Primitive.symbol", lambda symbol: ns.Primitive(symbol, (0.0,), 0.0)),
    *each((NAN, "half"), "Category.share", lambda share: ns.Category("0", "a", share, (), ())),
    *each(((0.0,), (NAN, 0.0, 0.0)), "", lambda effect: mode(effect=effect)),
    *each(("flying", None), "Mode.kind", lambda kind: mode(kind=kind)),
    # files, and planners of one's own
    *each(NOTHING, "path", ns.Grounding.load),
    *each(MISSING, "nowhere.json", ns.Grounding.load, FILE),
    *each(MISSING, "nowhere.json", ns.Problem.load, FILE),
    *each(NOTHING, "problem", lambda task: ns.Query(task, GROUNDING)),
    *each((None, 3, "My Planner"), "is no name", lambda name: planner(name=name), PLANNER),
    *named(NOTHING, "solve", planner, error=PLANNER),
    *named((("speed",), None, 3), "takes", planner, error=PLANNER),
    *each((None, 3, "counting"), "Planner", ns.register_planner, PLANNER),
    *each(NOTHING, "problem", lambda task: ns.to_unified_planning(task, GROUNDING)),
    *each(("runes",), "encoding", lambda found: ns.to_unified_planning(PROBLEM, GROUNDING, found), CHOICE),
    *each((None, "plan", 3), "no plan", lambda found: ns.from_unified_planning(found, PROBLEM, GROUNDING)),
    *each(NOTHING, "call", lambda call: ns.pddl_planner("mine", "mine", call), PLANNER),
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
