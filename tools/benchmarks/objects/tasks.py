"""Objects that nothing was learned of: shapes never seen, and hidden properties; and what shall be done."""

from dataclasses import replace

import msgspec
import numpy as np
from jaxtyping import Float

from neurosym.errors import InvalidValue
from neurosym.evaluation.comparison import Bench
from neurosym.grounding import Grounding
from neurosym.operators import Symbol, symbols_of
from neurosym.problems import Problem, SceneObject
from neurosym.sim.config import TabletopConfig
from neurosym.sim.shapes import OPEN_TOP, TEST_SHAPES, UNSEEN
from neurosym.sim.simulation import sample_scene
from neurosym.stages.folder import DomainFolder
from neurosym.stages.problem_making import sight_of_pairs
from neurosym.tasks.pasts import GRASPED
from neurosym.tasks.supports import with_pairs
from neurosym.world import Scene
from tools.benchmarks.carrying.tasks import is_graspable

SHAPES = tuple(TEST_SHAPES)
LOOKALIKE = "look-alike"
"""An object as domains are learned with, whose mass, friction, and floor or centre of mass are others."""
MASS, FRICTION, LOPSIDED, FLOOR = (0.02, 3.0), (0.1, 1.2), (0.5, 0.9), (0.4, 0.85)
"""From where to where these are drawn: masses in kg, evenly by their logarithm; floors of open-topped boxes,
and how far off the middle the centre of mass of all else lies, either way, as `UNSEEN` says."""
AWAY, NEAR = 0.15, 0.25
"""How far goals are at least; and at most, where objects are pushed [m]."""
EDGE = 0.01  # objects stand so far inside the table's edge [m]
BASE = (0.13, 0.18), (0.03, 0.06)  # sizes, and heights, of what is to bear something [m]
APART = 0.05  # between the two [m]
_ON = "rests-on"
_TENTH = 0.1


def object_of(kind: str, rng: np.random.Generator) -> Scene:
    """Draw an object of a test shape, or a look-alike."""
    if kind in TEST_SHAPES:
        return sample_scene(TabletopConfig(shapes={kind: 1.0}), rng, 1)
    scene, hidden = sample_scene(TabletopConfig(), rng, 1), dict.fromkeys(UNSEEN, 0.0)
    hidden["mass"] = float(np.exp(rng.uniform(*np.log(MASS))))
    hidden["friction"] = rng.uniform(*FRICTION)
    if scene.features[0, 3] == OPEN_TOP:
        hidden["false_bottom"] = rng.uniform(*FLOOR)
    else:
        hidden["heavy_end"] = float(rng.choice([-1.0, 1.0])) * rng.uniform(*LOPSIDED)
    return replace(scene, unseen=np.array([[*hidden.values()]]))


def pushing(grounding: Grounding) -> Grounding:
    """Return a domain without all that grasps."""
    objects = grounding.objects
    pushes = (one for one in objects.operators if not (one.promise and one.promise.kind in GRASPED))
    table = msgspec.structs.replace(objects, operators=tuple(pushes))
    return msgspec.structs.replace(without_places(grounding), objects=table)


def without_places(grounding: Grounding) -> Grounding:
    """Return a domain without all that is aimed at more than an object."""
    return msgspec.structs.replace(grounding, places=None, relations=None, upright=None)


def to_a_point(bench: Bench, kind: str, seed: int, *, most: float = 1.0, tolerance: float = 0.05) -> Problem:
    """Draw an object anywhere, and a goal on the table at least 15 cm away."""
    rng = np.random.default_rng([seed, *kind.encode()])
    scene = object_of(kind, rng)
    start, goal = _spots(bench, scene.features[0], rng, most)
    item = _item(bench, scene, start, "item-01")
    return Problem(f"point-{seed}", (item,), {"item-01": (*goal, item.position[2])}, tolerance)


def to_a_stack(bench: Bench, folder: DomainFolder, kind: str, seed: int) -> Problem:
    """Draw an object anywhere, and a low wide box that it shall rest on."""
    rng = np.random.default_rng([seed, *kind.encode()])
    scene = object_of(kind, rng)
    (narrow, wide), (low, high) = BASE
    features = np.array([rng.uniform(narrow, wide), rng.uniform(narrow, wide), rng.uniform(low, high), 0.0])
    base = Scene(features[None], np.zeros((1, 3)), np.array([[0.0, 0.0, 0.0, 1.0]]))
    while True:
        start, _ = _spots(bench, scene.features[0], rng, 1.0)
        there, _ = _spots(bench, features, rng, 1.0)
        room = (scene.features[0, :2] + features[:2]) / 2 + APART
        if np.any(np.abs(np.subtract(start, there)) > room):
            break
    items = _item(bench, scene, start, "item-01"), _item(bench, base, there, "item-02")
    relations = bench.setting.grounding.relations
    if relations is None:
        raise InvalidValue("Stacking needs a domain with relations.")
    state = next(one.name for one in relations.states if one.name.startswith(_ON))
    asked = Problem(f"stack-{seed}", items, {}, relations=(("item-01", "item-02", state),))
    return with_pairs(asked, relations, sight_of_pairs(folder))


def pushed_only(bench: Bench, seed: int) -> Problem:
    """Draw an object that no person finds a grasp for, and a goal anywhere, to be met within 20 mm."""
    return bench.draw(1, seed, 0.02, "anywhere", lambda features: not is_graspable(features))


def at_an_edge(feature: int, is_high: bool, seed: int) -> Scene:
    """Draw an object one of whose sizes is in the lowest or highest tenth of what the world draws."""
    config, rng = TabletopConfig(), np.random.default_rng([seed, feature, is_high])
    low, high = config.size if feature < 2 else config.height
    bound = high - _TENTH * (high - low) if is_high else low + _TENTH * (high - low)
    while True:
        scene = sample_scene(config, rng, 1)
        if (scene.features[0, feature] >= bound) if is_high else (scene.features[0, feature] <= bound):
            return scene


def _spots(
    bench: Bench, features: Float[np.ndarray, " F"], rng: np.random.Generator, most: float
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Draw where an object stands, and where it shall stand, so far away at most."""
    table = bench.setting.grounding.table
    low, high = np.array([table.x, table.y]).T
    half = features[:2] / 2 + EDGE
    start = rng.uniform(low + half, high - half)
    while True:
        goal = rng.uniform(low + half, high - half)
        if AWAY <= np.linalg.norm(goal - start) <= most:
            (a, b), (c, d) = start.tolist(), goal.tolist()
            return (a, b), (c, d)


def _item(bench: Bench, scene: Scene, spot: tuple[float, float], name: str) -> SceneObject:
    category: Symbol = symbols_of(bench.categorise, scene.features)[0]
    features, unseen = tuple(scene.features[0].tolist()), tuple(scene.unseen[0].tolist())
    hidden = unseen or msgspec.UNSET
    return SceneObject(name, category, features, (*spot, features[2] / 2), unseen=hidden)
