"""Exploration (Algorithm 1): a robot tries what its model is least certain about, and learns from it.

Interactions come in blocks. Within a block the model does not change, and each interaction draws its scene
and its candidate actions from (seed, its number); so a block is a list of independent tasks, and any number
of workers gives the same bytes. After each block the model trains on all interactions so far, and both are
written down; a run that was killed goes on from there and ends with the same bytes, too.
"""

import json
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import torch

from neurosym.effect_model import EffectModel
from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice
from neurosym.fitting import reproducible, run_epochs, total_loss
from neurosym.interactions import Interactions
from neurosym.model_config import Dimensions, ModelConfig
from neurosym.ray_workers import ray_crew
from neurosym.strategies import STRATEGIES, Strategy
from neurosym.tensor_files import read_tensors, write_tensors
from neurosym.workers import Perform, Task, WorldFactory, crew
from neurosym.world import World

FORMAT = "neurosym-exploration-1"
INTERACTIONS_FILE = "interactions.partial.npz"
STATE_FILE = "exploration.safetensors"

Progress = Callable[[int, int], None]
"""Called with the number of interactions made and of those wanted."""

_LEAST_TO_LEARN_FROM = 32


@dataclass(frozen=True, slots=True)
class ExplorationConfig:
    """How exploration goes on.

    Attributes:
        candidates: How many actions are drawn to choose one from.
        block: Interactions between two updates of the model.
        epochs: How often the model sees every interaction in an update.
        batch: Interactions in a mini-batch.
        learning_rate: Step size of Adam.
        loss_coefficient: The coefficient lambda of eq. 9.
        temperature: The temperature tau of eq. 8.
        clip_norm: Greatest norm of a gradient.
    """

    candidates: int = 2000
    block: int = 512
    epochs: int = 10
    batch: int = 512
    learning_rate: float = 1e-3
    loss_coefficient: float = 1.0
    temperature: float = 0.1
    clip_norm: float = 1.0

    def __post_init__(self) -> None:
        for name in ("candidates", "block", "epochs", "batch"):
            if getattr(self, name) < 1:
                raise InvalidValue(f"{name} = {getattr(self, name)} must be at least 1.")
        for name in ("learning_rate", "loss_coefficient", "temperature", "clip_norm"):
            if not getattr(self, name) > 0:
                raise InvalidValue(f"{name} = {getattr(self, name)} must be positive.")


def explore(
    world_factory: WorldFactory,
    *,
    steps: int = 10_000,
    strategy: str = "curiosity",
    seed: int,
    workers: int = 1,
    ray: str | None = None,
    checkpoint: Path | None = None,
    config: ExplorationConfig | None = None,
    model_config: ModelConfig | None = None,
    origin: dict[str, Any] | None = None,
    progress: Progress | None = None,
) -> tuple[Interactions, EffectModel]:
    """Explore a world; returns the interactions and the model as it was after the last whole block.

    Args:
        world_factory: Builds the world; must survive pickling if there is more than one worker.
        steps: How many interactions.
        strategy: One of `STRATEGIES`.
        seed: Where all draws start.
        workers: How many processes perform the interactions; their number does not change the result.
        ray: A Ray cluster that performs them instead: `auto`, or HOST:PORT; changes no byte, either.
        checkpoint: Folder to write the state to after each block, and to go on from if it is there.
        config: How exploration goes on.
        model_config: How the model is built; the strategy decides its head.
        origin: Plain JSON values that identify the world; stored with the data, and compared on resuming.
        progress: Called after each interaction.

    Raises:
        UnknownChoice: If there is no such strategy.
        InvalidValue: If the checkpoint was made with other options, or already holds more steps.
        InvalidFile: If the checkpoint is damaged.
        RayMissing, NoCluster: If a Ray cluster is asked for and cannot be had.
    """
    if strategy not in STRATEGIES:
        raise UnknownChoice("strategy", strategy, STRATEGIES)
    if steps < 1:
        raise InvalidValue(f"steps = {steps} must be at least 1.")
    world = world_factory()
    built_as = replace(model_config or ModelConfig(), head=STRATEGIES[strategy].head)
    explorer = _Explorer(world, strategy, seed, config or ExplorationConfig(), built_as, origin or {})
    if checkpoint is not None:
        explorer.resume(checkpoint, steps)
    hired = crew(world_factory, workers) if ray is None else ray_crew(world_factory, ray)
    with hired as perform:
        while len(explorer) < steps:
            explorer.advance(perform, steps, progress)
            if checkpoint is not None:
                explorer.save(checkpoint)
    assert explorer.interactions is not None
    return explorer.interactions, explorer.model


def choose_action(
    world: World, strategy: Strategy, model: EffectModel, config: ExplorationConfig, seed: int, number: int
) -> Task:
    """Draw the scene and the candidates of one interaction, and choose among them.

    Args:
        world: Where scenes and actions come from.
        strategy: Chooses.
        model: What the strategy asks.
        config: How many candidates.
        seed: Of the exploration.
        number: Of the interaction.
    """
    rng = np.random.default_rng([seed, number])
    scene = world.sample_scene(rng, 1)
    candidates = world.action_box.sample(rng, config.candidates).astype(np.float32)  # as they are stored
    return Task(scene, candidates[strategy.choose(model, scene.features[0], candidates)])


class _Explorer:
    """What exploration knows at the end of a block."""

    def __init__(
        self,
        world: World,
        strategy: str,
        seed: int,
        config: ExplorationConfig,
        model_config: ModelConfig,
        origin: dict[str, Any],
    ):
        self.world, self.strategy, self.seed, self.config = world, STRATEGIES[strategy], seed, config
        box = world.action_box
        columns = np.flatnonzero(box.gripper).tolist()
        self.origin = {
            "world": world.name,
            "strategy": strategy,
            "seed": seed,
            **asdict(config),
            "model": asdict(model_config),
            "gripper_columns": columns,
            "action_low": box.low.tolist(),
            "action_high": box.high.tolist(),
            **json.loads(json.dumps(origin)),  # as it comes back from a file: lists, not tuples
        }
        dimensions = Dimensions(len(world.feature_names), len(box.low), 3, tuple(columns))
        with reproducible(self._seed_of_block(0)):
            self.model = EffectModel(dimensions, model_config).eval()
        self.model.trained_by = {"exploration": self.origin}
        self.optimiser = torch.optim.Adam(self.model.parameters(), lr=config.learning_rate, fused=True)
        self.interactions: Interactions | None = None
        self.blocks = 0

    def __len__(self) -> int:
        return 0 if self.interactions is None else len(self.interactions)

    def advance(self, perform: Perform, steps: int, progress: Progress | None) -> None:
        """Make one block of interactions, and learn from all so far if it is a whole one."""
        done = len(self)
        actions: list[np.ndarray] = []
        outcomes = []
        for outcome in perform(self._tasks(range(done, min(done + self.config.block, steps)), actions)):
            outcomes.append(outcome)
            if progress is not None:
                progress(done + len(outcomes), steps)
        block = Interactions.from_outcomes(outcomes, np.stack(actions), self.origin)
        self.interactions = block if self.interactions is None else self.interactions.join(block)
        if len(block) == self.config.block:
            self.blocks += 1
            self._learn(self.interactions)

    def _tasks(self, numbers: range, actions: list[np.ndarray]) -> Iterator[Task]:
        for number in numbers:
            task = choose_action(self.world, self.strategy, self.model, self.config, self.seed, number)
            actions.append(task.action)
            yield task

    def _learn(self, interactions: Interactions) -> None:
        rows = self.strategy.learns_from(interactions.effects)
        if rows.sum() < _LEAST_TO_LEARN_FROM:
            return
        features, actions, effects = (
            torch.from_numpy(column[rows])
            for column in (interactions.features, interactions.actions, interactions.effects)
        )
        config = self.config

        def loss_of(batch: torch.Tensor) -> torch.Tensor:
            return total_loss(
                self.model,
                features[batch],
                actions[batch],
                effects[batch],
                coefficient=config.loss_coefficient,
                temperature=config.temperature,
            )

        self.model.set_scale(effects)
        with reproducible(self._seed_of_block(self.blocks)) as generator:
            self.model.train()
            run_epochs(
                loss_of,
                len(effects),
                self.optimiser,
                generator,
                epochs=config.epochs,
                batch=config.batch,
                clip_norm=config.clip_norm,
            )
            self.model.eval()

    def _seed_of_block(self, block: int) -> int:
        return int(np.random.default_rng([self.seed, 0x626C, block]).integers(2**62))

    def save(self, folder: Path) -> None:
        """Write the interactions first and then the state, so that the state is never ahead of them."""
        assert self.interactions is not None
        self.interactions.save(folder / INTERACTIONS_FILE)
        tensors = {f"model.{name}": array for name, array in self.model.weights().items()}
        for number, moments in self.optimiser.state_dict()["state"].items():
            tensors |= {f"adam.{number}.{name}": moment.numpy() for name, moment in moments.items()}
        description = {"blocks": self.blocks, "options": self.origin, "model": self.model.description()}
        write_tensors(folder / STATE_FILE, FORMAT, tensors, description)

    def resume(self, folder: Path, steps: int) -> None:
        """Go on from the whole blocks that are written in a folder, if any."""
        path = folder / STATE_FILE
        if not path.exists():
            return
        tensors, description = read_tensors(path, FORMAT)
        _check_options(path, description.get("options", {}), self.origin)
        rows = description.get("blocks", 0) * self.config.block
        if rows > steps:
            raise InvalidValue(
                f"{folder} already holds {rows} interactions; ask for at least as many steps, not {steps}."
            )
        if rows == 0:
            return
        interactions = Interactions.load(folder / INTERACTIONS_FILE)
        if len(interactions) < rows:
            raise InvalidFile(
                folder / INTERACTIONS_FILE, f"it holds fewer than the {rows} interactions of {path}"
            )
        self.interactions, self.blocks = interactions[:rows], description["blocks"]
        weights = {name[6:]: array for name, array in tensors.items() if name.startswith("model.")}
        self.model = EffectModel.rebuild(path, weights, description["model"])
        self.optimiser = torch.optim.Adam(self.model.parameters(), lr=self.config.learning_rate, fused=True)
        self._load_moments(tensors)

    def _load_moments(self, tensors: dict[str, np.ndarray]) -> None:
        moments: dict[int, dict[str, torch.Tensor]] = {}
        for key, array in tensors.items():
            if key.startswith("adam."):
                _, number, name = key.split(".")
                moments.setdefault(int(number), {})[name] = torch.from_numpy(array.copy())
        groups = self.optimiser.state_dict()["param_groups"]
        self.optimiser.load_state_dict({"state": moments, "param_groups": groups})


def _check_options(path: Path, stored: dict[str, Any], wanted: dict[str, Any]) -> None:
    telling = ("strategy", "seed")
    for name in (*telling, *sorted(stored.keys() | wanted.keys())):
        if stored.get(name) != wanted.get(name):
            raise InvalidValue(
                f"{path} was made with {name} = {stored.get(name)!r}, not {wanted.get(name)!r}; "
                f"use that again, or remove {STATE_FILE} and {INTERACTIONS_FILE} to begin anew."
            )
