"""Do contact and force teach better bits? What the hand feels of its target, beside or before displacements.

The authors' next paper predicts touch first and then space. Here bits are learned from displacements alone,
from displacements with contact and force, and from contact and force alone, after which displacements are
learned through the same bits. What bits tell is judged on interactions that were held out.
"""

from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from jaxtyping import Float

from neurosym.data.interactions import Interactions
from neurosym.exploration.loop import origin_of_world
from neurosym.learning.network import EffectModel
from neurosym.learning.training import train
from neurosym.learning.training_config import regime_named
from neurosym.sim.config import Client, pybullet
from neurosym.sim.tabletop import Tabletop
from neurosym.world import Outcome, Scene
from tools.benchmarks.jobs import Jobs

SEEDS, INTERACTIONS, HELD_OUT = 5, 4000, 1000
VARIANTS = ("displacement", "all", "touch first")
TOLD = ("held", "moved", "displacement")
"""What bits are asked of new interactions: whether the object is held, or moved, and where it ended."""
MOVED = 0.01  # what moves farther was moved [m]
_EVERY = 4  # steps of the simulation between two looks
_TARGET, _ROBOT = 1, 2  # bodies of a scene of one object, after the table
_STREAM = 0x746F7563


class _Feeling(Client):
    """A physics client that looks at what the robot and the object do to each other."""

    def __init__(self) -> None:
        super().__init__()
        self.begin()

    def begin(self) -> None:
        self.looks, self.touched, self.force = 0, 0, 0.0

    def stepSimulation(self) -> None:  # noqa: N802  (PyBullet calls it so)
        pybullet.stepSimulation(physicsClientId=self.number)
        self.looks += 1
        if self.looks % _EVERY == 0 and self.getNumBodies() > _ROBOT:
            points = self.getContactPoints(_TARGET, _ROBOT)
            self.touched += bool(points)
            self.force = max(self.force, sum(point[9] for point in points))


class FeelingTabletop(Tabletop):
    """The tabletop, which remembers what the hand felt in its last interaction."""

    def interact(self, scene: Scene, action: Float[np.ndarray, " A"], target: int, **options: Any) -> Outcome:
        """Perform an action; see `World.interact`."""
        self.client().begin()
        return super().interact(scene, action, target, **options)

    @property
    def felt(self) -> tuple[float, float]:
        """Whether the hand touched the target, and the greatest force between the two [N]."""
        felt = self.client()
        return float(felt.touched > 0), felt.force

    def client(self) -> Any:
        """Return this process's physics client, connecting on first use."""
        if self._client is None:
            self._client = _Feeling()
        return self._client


def jobs() -> Jobs:
    """List what is measured, by name."""
    return {f"contact-{seed}": partial(measure, seed) for seed in range(1, SEEDS + 1)}


def measure(seed: int) -> dict[str, Any]:
    """Learn bits in each way from the same interactions, and say what they tell of those held out."""
    plain, felt = _performed(seed)
    learned, new = slice(0, INTERACTIONS), slice(INTERACTIONS, None)
    touch = replace(plain, effects=felt, resting_effects=felt)
    both = np.hstack([plain.effects, felt])
    every = replace(plain, effects=both, resting_effects=both)
    regime = regime_named("default")

    def fit(data: Interactions, **known: Any) -> EffectModel:
        return train(
            data[learned], config=regime.training, model_config=regime.model, seed=seed, **known
        ).model

    models = {
        "displacement": fit(plain),
        "all": fit(every),
        "touch first": fit(_without_mirrors(touch)),
    }
    told = {name: _told(model, plain, learned, new) for name, model in models.items()}
    return told | {"touched": float(felt[:, 0].mean()), "force": float(np.median(felt[felt[:, 0] > 0, 1]))}


def _without_mirrors(data: Interactions) -> Interactions:
    """Return data whose effects are alike in mirrors, which their origin cannot say."""
    return replace(data, origin={**data.origin, "mirrors": []})


def _told(model: EffectModel, data: Interactions, learned: slice, new: slice) -> dict[str, float]:
    """Say what the symbols of object and action tell of new interactions, by means over those learned from.

    `held` and `moved` are shares of the variance of whether the object was held, and moved at all;
    `displacement` is that of where it ended.
    """
    both = zip(model.object_symbols(data.features), model.action_symbols(data.actions), strict=True)
    codes = np.array([*map("".join, both)])
    ended = data.resting_effects[:, :2].astype(float)
    judged = {
        "held": data.held.astype(float)[:, None],
        "moved": (np.linalg.norm(ended, axis=1) > MOVED).astype(float)[:, None],
        "displacement": ended,
    }
    return {name: _explained(codes, judged[name], learned, new) for name in TOLD}


def _explained(codes: np.ndarray, values: Float[np.ndarray, "N D"], learned: slice, new: slice) -> float:
    """Return the share of the variance of new values that means over codes explain."""
    usual = values[learned].mean(0)
    means = {code: values[learned][codes[learned] == code].mean(0) for code in np.unique(codes[learned])}
    said = np.array([means.get(code, usual) for code in codes[new]])
    return float(1 - ((said - values[new]) ** 2).sum() / ((usual - values[new]) ** 2).sum())


def _performed(seed: int) -> tuple[Interactions, Float[np.ndarray, "N 2"]]:
    """Perform random actions on random objects; returned is also what the hand felt: touch, and force [N]."""
    world, rng = FeelingTabletop(), np.random.default_rng([_STREAM, seed])
    actions = world.action_box.sample(rng, INTERACTIONS + HELD_OUT)
    outcomes, felt = [], []
    for action in actions:
        outcomes.append(world.interact(world.sample_scene(rng, 1), action, 0))
        felt.append(world.felt)
    data = Interactions.from_outcomes(outcomes, actions, origin_of_world(world))
    return data, np.array(felt, dtype=np.float32)
