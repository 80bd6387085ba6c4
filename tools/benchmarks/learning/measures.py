"""What `evaluate.py` measures: one function for each kind of job, from files to plain JSON values.

A job reads data that was explored before, and no two jobs write the same file, so that any number can run at
once.
"""

import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.data.interactions import Interactions
from neurosym.data.origin import has_high_effect
from neurosym.learning.coclustering import cocluster
from neurosym.learning.network import DirectModel, EffectModel
from neurosym.learning.training import TEST_ROWS, Trained, r_squared, share_of, train, trivial_predictions
from neurosym.learning.training_config import ModelConfig, TrainingConfig
from neurosym.operators import CARRIED, all_symbols
from neurosym.primitives.audition import choose
from neurosym.primitives.distillation import distill
from neurosym.primitives.rehearsal import Rehearsals, rehearse
from neurosym.worlds.world_file import read_world
from tools.benchmarks.paper_tables import kind_of, kinds_found

REHEARSED = 60  # objects that each primitive is rehearsed on
ROWS, COLUMNS = 2000, 64  # actions and objects whose predicted effects are co-clustered
NINETY = 1.6449  # half the width of the interval that holds 90 % of a Gaussian, in standard deviations


@dataclass(frozen=True, slots=True)
class Data:
    """Where the data of one strategy and seed lies."""

    folder: Path  # domain folder that was explored; `active` acts at random, so its data is that of `random`
    test: Path  # domain folder of the test set
    strategy: str  # who shall have made the data
    seed: int  # of exploration, and of all that follows
    steps: int  # how many of the interactions are used

    def load(self) -> Interactions:
        """Read the data."""
        data = Interactions.load(self.folder / "interactions.npz")[: self.steps]
        return replace(data, origin={**data.origin, "strategy": self.strategy})

    def kept(self, which: str) -> Path:
        """Say where a network that learned from the data is kept."""
        return self.folder / f"{self.strategy}.{self.steps}.{which}.safetensors"


def where_it_went(data: Data) -> dict[str, Any]:
    """Say what became of the objects, and how evenly the patterns of an open or closed hand were tried."""
    seen = data.load()
    grippers = list(seen.origin["gripper_columns"])
    _, patterns = np.unique(seen.actions[:, grippers] >= 0.5, axis=0, return_counts=True)
    tried = np.zeros(2 ** len(grippers))
    tried[: len(patterns)] = patterns / len(seen)
    return {
        "held": float(seen.held.mean()),
        "carried and put down": float((~seen.held & (seen.peak_heights > CARRIED)).mean()),
        "toppled": float(seen.toppled.mean()),
        "moved less than 1 cm": float((np.abs(seen.effects).sum(1) < 0.01).mean()),
        "hand: rarest pattern": float(tried.min()),
        "hand: commonest pattern": float(tried.max()),
    }


def learn(
    data: Data,
    config: TrainingConfig | None = None,
    model_config: ModelConfig | None = None,
    direct: DirectModel | None = None,
) -> tuple[Trained, dict[str, Any]]:
    """Train on the data, and measure on the test set."""
    begin = time.process_time()
    interactions = data.load()
    trained = train(interactions, config=config, model_config=model_config, seed=data.seed, direct=direct)
    test = Interactions.load(data.test / "interactions.npz")
    figures = {"cpu_seconds": time.process_time() - begin, "interactions": len(interactions)}
    return trained, figures | assess_on_test(trained, interactions, test)


def assess_on_test(trained: Trained, seen: Interactions, test: Interactions) -> dict[str, Any]:
    """Measure what a model predicts of random interactions that it has never seen."""
    model = trained.model
    effects = np.asarray(test.effects, dtype=np.float64)
    mean, variance = model.predict_from_codes(test.features, test.actions)
    r2 = r_squared(mean, effects)
    direct = trained.direct.predict(test.features, test.actions)
    r2_direct = r_squared(direct, effects)
    high = np.flatnonzero(has_high_effect(effects))[:TEST_ROWS]
    guesses = {"model": mean, "without a bottleneck": direct}
    guesses |= trivial_predictions(seen.effects, len(effects))
    errors = {name: np.abs(guess - effects) for name, guess in guesses.items()}
    return {
        "r2_through_codes": float(r2.mean()),
        "r2_through_codes_by_axis": r2.tolist(),
        "r2_direct": float(r2_direct.mean()),
        "r2_direct_by_axis": r2_direct.tolist(),
        "share": share_of(float(r2.mean()), float(r2_direct.mean())),
        "mae": {name: off[high].mean(0).tolist() for name, off in errors.items()},
        "mae_unfiltered": {name: off.mean(0).tolist() for name, off in errors.items()},
        "test_rows": len(high),
        "test_rows_unfiltered": len(test),
        "action_codes": _shares(model.action_symbols(test.actions), model.config.action_bits),
        "action_codes_in_training": _shares(model.action_symbols(seen.actions), model.config.action_bits),
        "object_codes": _shares(model.object_symbols(test.features), model.config.object_bits),
        "object_contrast": _object_contrast(model, test),
        **(_calibration(mean, variance, effects, seen.effects) if model.config.head == "gaussian" else {}),
    }


def act_upon(data: Data, choice: str) -> dict[str, Any]:
    """Distil by the networks that were kept, choose and rehearse, and say which primitives there are."""
    model, direct = EffectModel.load(data.kept("model")), DirectModel.load(data.kept("direct"))
    factory = read_world(data.folder / "world.toml")
    world, interactions = factory(), data.load()
    begin = time.process_time()
    candidates = distill(model, interactions, world.action_box, seed=data.seed)
    seconds = time.process_time() - begin
    repertoire = choose(
        candidates,
        choice,
        predict=direct.predict_outcomes,
        features=interactions.features,
        categorise=model.object_symbols,
        world_factory=factory,
        seed=data.seed,
    )
    rehearsals = rehearse(factory, repertoire, model.object_symbols, objects=REHEARSED, seed=data.seed)
    found = kinds_found(rehearsals, world.lift_height)
    return {
        "distillation_seconds": seconds,
        "code_errors": {primitive.label: primitive.code_error for primitive in repertoire.primitives},
        "in_the_box": all(world.action_box.contains(np.array(p.action)) for p in repertoire.primitives),
        "objects": REHEARSED,
        "kinds": {kind: [list(pair) for pair in pairs] for kind, pairs in found.items()},
        "operators": _operators(rehearsals, world.lift_height),
    }


def learn_and_keep(data: Data) -> dict[str, Any]:
    """Learn, and keep the networks for the jobs that act upon them."""
    trained, figures = learn(data)
    trained.model.save(data.kept("model"))
    trained.direct.save(data.kept("direct"))
    return figures


def variant(data: Data, config: TrainingConfig, model_config: ModelConfig) -> dict[str, Any]:
    """Learn in another way, without acting; what teaches is the network that was kept, if it is the same."""
    ours, taught_by = TrainingConfig(), ("teacher", "clip_norm", "mirrors", "validation_share")
    same = all(getattr(config, name) == getattr(ours, name) for name in taught_by)
    direct = DirectModel.load(data.kept("direct")) if same else None
    return learn(data, config, model_config, direct)[1]


def clustered(data: Data, bits: Sequence[tuple[int, int]]) -> dict[str, Any]:
    """Co-cluster what the network that was kept predicts of test actions on test objects into so many kinds.

    Returns the share of the variance that is between kinds, mean of the axes. It is no bound for codes, whose
    R2 is that of what really happened.
    """
    test = Interactions.load(data.test / "interactions.npz")
    rng = np.random.default_rng(data.seed)
    actions, features = test.actions[rng.permutation(len(test))[:ROWS]], test.features[:COLUMNS]
    direct = DirectModel.load(data.kept("direct"))
    by_object = [direct.predict(np.tile(item, (len(actions), 1)), actions) for item in features]
    table = np.stack(by_object, axis=1)  # (actions, objects, axes)
    table = (table - table.mean((0, 1))) / table.std((0, 1))
    axes = table.shape[2]  # each of variance 1
    return {f"{o}+{a}": 1 - cocluster(table, 2**a, 2**o, rng).error / axes for o, a in bits}


def _operators(rehearsals: Rehearsals, lift_height: float) -> list[dict[str, Any]]:
    """Say of each primitive and object symbol what mostly happened, how often, and how widely spread."""
    rows = []
    for number, primitive in enumerate(rehearsals.primitives):
        for symbol in np.unique(rehearsals.symbols):
            members = rehearsals.on(str(symbol), number)
            if not members:
                continue
            kinds = [kind_of(outcome, lift_height) or "none" for outcome in members]
            kind = max(sorted(set(kinds)), key=kinds.count)
            of_kind = [o for o, k in zip(members, kinds, strict=True) if k == kind]
            ended = np.array([o.effect if o.held else o.resting_effect for o in of_kind])
            row = {
                "primitive": primitive.label,
                "category": str(symbol),
                "objects": len(members),
                "kind": kind,
            }
            means = {"mean": ended.mean(0).tolist(), "spread": ended.std(0).tolist()}
            rows.append({**row, "share": len(of_kind) / len(members), **means})
    return rows


def _calibration(
    mean: np.ndarray, variance: np.ndarray, effects: np.ndarray, seen: np.ndarray
) -> dict[str, Any]:
    """Compare the NLL (eq. 7) with that of one Gaussian for all, and count the effects within 90 %."""

    def nll(centre: np.ndarray, spread: np.ndarray) -> float:
        return float(0.5 * (np.log(2 * np.pi * spread) + (effects - centre) ** 2 / spread).mean())

    inside = np.abs(effects - mean) <= NINETY * np.sqrt(variance)
    return {
        "nll": nll(mean, variance),
        "nll_of_constant_gaussian": nll(seen.mean(0), seen.var(0)),
        "within_90": float(inside.mean()),
        "within_90_by_axis": inside.mean(0).tolist(),
    }


def _object_contrast(model: EffectModel, test: Interactions) -> dict[str, Any]:
    """Say what the object's bits add to those of the action: R2 of the means of codes without and with."""
    actions = np.array(model.action_symbols(test.actions))
    objects = np.array(model.object_symbols(test.features))
    effects = np.asarray(test.effects, dtype=np.float64)

    def explained(codes: np.ndarray) -> float:
        means = np.empty_like(effects)
        for code in np.unique(codes):
            means[codes == code] = effects[codes == code].mean(0)
        return float(r_squared(means, effects).mean())

    held = {str(code): float(test.held[objects == code].mean()) for code in np.unique(objects)}
    both = np.char.add(actions, objects)
    return {"action_only": explained(actions), "action_and_object": explained(both), "held": held}


def _shares(codes: tuple[str, ...], bits: int) -> dict[str, float]:
    counted = np.array(codes)
    return {symbol: float(np.mean(counted == symbol)) for symbol in all_symbols(bits)}
