"""Exploration (Algorithm 1): a robot tries what it knows least about, and learns from it.

Interactions come in blocks. Within a block nothing is learned, and each interaction draws its scene and its
candidate actions from (seed, its number); so a block is a list of independent tasks, and any number of
workers gives the same bytes. After each block the networks of a curious strategy learn from all interactions
so far, and everything is written down; a run that was killed goes on from there and ends with the same bytes,
too.
"""

import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.checks import as_path, check_count, check_kind, check_seed
from neurosym.contract import made, placed
from neurosym.data.archives import read_tensors, write_tensors
from neurosym.data.interactions import Interactions
from neurosym.data.origin import DEFAULT_STRATEGY, Dimensions, StrategyName, own_name, strategy_named
from neurosym.errors import InvalidFile, InvalidValue, Progress
from neurosym.exploration.curiosity import Curiosity, LearningConfig, make_curiosity
from neurosym.files import at_once
from neurosym.learning.training_config import EXPLORING, ModelConfig, check_positive
from neurosym.world import EFFECT_AXES, Outcome, World, WorldFactory, unshown_of
from neurosym.worlds.workers import Perform, Task, crew
from neurosym.worlds.world_file import changed_option

# What is tried next: candidates are drawn, and a curious strategy picks the one it knows least about


@dataclass(frozen=True, slots=True)
class ExplorationConfig:
    """How exploration goes on."""

    candidates: int = 2000  # how many actions are drawn to choose one from
    block: int = 512  # interactions between two updates of the networks
    # how the networks of a curious strategy learn
    learning: LearningConfig = field(default_factory=LearningConfig)

    def __post_init__(self) -> None:
        check_positive(self)


def choose_action(
    world: World, curiosity: Curiosity | None, config: ExplorationConfig, seed: int, number: int
) -> Task:
    """Draw a scene, or as many as the world says, and candidates for each, and choose among them.

    Candidates come from the box, or as the world says, with the digits that are stored. Without curiosity the
    first is taken: a random action.
    """
    rng = np.random.default_rng([seed, number])
    several = getattr(world, "scenes_to_choose_from", 1) if curiosity is not None else 1
    count, draw = config.candidates // several, getattr(world, "draw_actions", None)
    found: list[tuple[float, Task]] = []
    for _ in range(several):
        scene = world.sample_scene(rng, 1)
        drawn = draw(rng, scene, count) if draw else world.action_box.sample(rng, count)
        candidates = drawn.astype(np.float32)
        if curiosity is None:
            return Task(scene, candidates[0])
        scores = curiosity.uncertainties(scene.features[0], candidates)
        picked = curiosity.pick(scores, rng)
        found.append((float(scores[picked]), Task(scene, candidates[picked])))
    return max(found, key=lambda one: one[0])[1]


FORMAT = "neurosym-exploration-3"
INTERACTIONS_FILE = "interactions.partial.npz"
STATE_FILE = "exploration.safetensors"
_MEMORY = "memory."  # what the names of tensors begin with that the world remembers, not the networks


def explore(
    world_factory: WorldFactory,
    *,
    steps: int = 10_000,
    strategy: StrategyName = DEFAULT_STRATEGY,
    seed: int,
    workers: int = 1,
    checkpoint: Path | None = None,
    config: ExplorationConfig | None = None,
    model_config: ModelConfig | None = None,
    origin: dict[str, Any] | None = None,
    progress: Progress | None = None,
) -> Interactions:
    """Explore a world.

    Args:
        world_factory: Builds the world; must survive pickling if there is more than one worker.
        steps: How many interactions.
        strategy: One of `STRATEGIES` in `neurosym.data.origin`.
        seed: Where all draws start.
        workers: How many processes perform the interactions; their number does not change the result.
        checkpoint: Folder to write the state to after each block, and to go on from if it is there.
        config: How exploration goes on.
        model_config: How the network is built whose entropy is asked for.
        origin: Plain JSON values that identify the world; stored with the data, and compared on resuming.
        progress: Called after each interaction.

    Raises:
        UnknownChoice: If there is no such strategy.
        InvalidValue: If a number is impossible, or the checkpoint was made with other options, or already
            holds more steps.
        InvalidFile: If the checkpoint is damaged.
    """
    check_count("steps", steps)
    check_count("workers", workers)
    check_seed(seed)
    check_kind("strategy", strategy, str, "of type str")
    config = ExplorationConfig() if config is None else config
    model_config = EXPLORING if model_config is None else model_config
    origin = {} if origin is None else origin
    given = {"config": config, "model_config": model_config, "origin": origin}
    for name, kind in (("config", ExplorationConfig), ("model_config", ModelConfig), ("origin", dict)):
        check_kind(name, given[name], kind, f"of type {kind.__name__}")
    if checkpoint is not None and not (checkpoint := as_path(checkpoint, "checkpoint")).is_dir():
        raise InvalidValue(f"checkpoint = {checkpoint} is no folder; make it first.")
    explorer = _Explorer(made(world_factory), strategy, seed, config, model_config, origin)
    if checkpoint is not None:
        explorer.resume(checkpoint, steps)
    with crew(world_factory, workers) as perform:
        while len(explorer) < steps:
            explorer.advance(perform, steps, progress)
            if checkpoint is not None:
                explorer.save(checkpoint)
    assert explorer.interactions is not None
    return explorer.interactions


def origin_of_world(world: World) -> dict[str, Any]:
    """Say of a world what training must know of its actions, in plain JSON values."""
    box, unshown = world.action_box, unshown_of(world)
    return {
        **({"unshown": list(unshown)} if unshown else {}),
        "world": world.name,
        "feature_names": list(world.feature_names),
        "gripper_columns": np.flatnonzero(box.gripper).tolist(),
        "action_low": box.low.tolist(),
        "action_high": box.high.tolist(),
        "mirrors": [{"actions": list(m.actions), "effects": list(m.effects)} for m in box.mirrors],
    }


class _Explorer:
    """What exploration knows at the end of a block."""

    def __init__(
        self,
        world: World,
        strategy: StrategyName,
        seed: int,
        config: ExplorationConfig,
        model_config: ModelConfig,
        origin: dict[str, Any],
    ):
        self.world, self.seed, self.config = world, seed, config
        self.origin = {
            "strategy": own_name(strategy),
            "seed": seed,
            "min_predicted_effect": 0.0,  # which earlier versions let be chosen [m]
            **asdict(config),
            "model": asdict(model_config),
            **origin_of_world(world),
            **json.loads(json.dumps(origin)),  # as it comes back from a file: lists, not tuples
        }
        self.curiosity = None
        if about := strategy_named(strategy).curious_about:
            box, axes = world.action_box, getattr(world, "effect_axes", EFFECT_AXES)
            columns = tuple(np.flatnonzero(box.gripper).tolist())
            dimensions = Dimensions(len(world.feature_names), len(box.low), axes, columns, unshown_of(world))
            self.curiosity = make_curiosity(about, dimensions, model_config, config.learning, seed)
        self.interactions: Interactions | None = None
        self.blocks = self.kept = 0

    def __len__(self) -> int:
        return 0 if self.interactions is None else len(self.interactions)

    def advance(self, perform: Perform, steps: int, progress: Progress | None) -> None:
        """Make one block of interactions, and learn from all so far if it is a whole one."""
        done = len(self)
        actions: list[np.ndarray] = []
        outcomes: list[Outcome] = []
        performed = perform(self._tasks(range(done, min(done + self.config.block, steps)), actions))
        while True:
            with placed(self._place(done + len(outcomes))):
                outcome = next(performed, None)
            if outcome is None:
                break
            outcomes.append(outcome)
            if progress is not None:
                progress(done + len(outcomes), steps)
        block = Interactions.from_outcomes(outcomes, np.stack(actions), self.origin)
        self.interactions = block if self.interactions is None else self.interactions.join(block)
        if remember := getattr(self.world, "remember", None):
            remember(outcomes)
        if len(block) == self.config.block:
            self.blocks += 1
            if self.curiosity is not None:
                self.curiosity.learn(self.interactions, self.blocks)

    def _tasks(self, numbers: range, actions: list[np.ndarray]) -> Iterator[Task]:
        for number in numbers:
            with placed(self._place(number)):
                task = choose_action(self.world, self.curiosity, self.config, self.seed, number)
            actions.append(task.action)
            yield task

    def _place(self, number: int) -> str:
        """Say which interaction that is, and what is kept of those before it."""
        kept = f"; the first {self.kept} are kept, and the same call goes on from them" if self.kept else ""
        return f"interaction {number + 1}{kept}"

    def save(self, folder: Path) -> None:
        """Write the interactions first and then the state, so that the state is never ahead of them."""
        assert self.interactions is not None
        tensors = {} if self.curiosity is None else self.curiosity.state()
        if memory := getattr(self.world, "memory", None):
            tensors |= {f"{_MEMORY}{name}": rows for name, rows in memory().items()}
        description = {"blocks": self.blocks, "options": self.origin}
        with at_once():
            self.interactions.save(folder / INTERACTIONS_FILE)
            write_tensors(folder / STATE_FILE, FORMAT, tensors, description)
        self.kept = self.blocks * self.config.block

    def resume(self, folder: Path, steps: int) -> None:
        """Go on from the whole blocks that are written in a folder, if any."""
        path = folder / STATE_FILE
        if not path.exists():
            return
        tensors, description = read_tensors(path, FORMAT)
        options, blocks = description.get("options"), description.get("blocks")
        if not isinstance(options, dict) or type(blocks) is not int or blocks < 0:
            raise InvalidFile(path, "it does not say how many blocks there are, or with which options")
        for name in ("strategy", "seed", *sorted(options.keys() | self.origin.keys())):
            if (stored := options.get(name)) != (wanted := self.origin.get(name)):
                if name == "world_options" and isinstance(stored, dict):
                    name, stored, wanted = changed_option(options, self.origin) or (name, stored, wanted)
                raise InvalidValue(
                    f"{path} was made with {name} = {stored!r}, not {wanted!r}; "
                    f"use that again, or remove {STATE_FILE} and {INTERACTIONS_FILE} to begin anew."
                )
        rows = blocks * self.config.block
        if rows > steps:
            raise InvalidValue(
                f"{folder} already holds {rows} interactions; ask for at least as many steps, not {steps}."
            )
        if rows == 0:
            return
        self.interactions, self.blocks, self.kept = self._interactions_of(path, rows), blocks, rows
        memory = {
            name.removeprefix(_MEMORY): tensors.pop(name) for name in [*tensors] if name.startswith(_MEMORY)
        }
        try:
            if recall := getattr(self.world, "recall", None):
                recall(memory)
            if self.curiosity is not None:
                self.curiosity.restore(tensors)
        except (KeyError, ValueError, RuntimeError) as error:
            raise InvalidFile(path, "its weights do not fit the options stored beside them") from error

    def _interactions_of(self, state: Path, rows: int) -> Interactions:
        """Read the interactions that a state was learned from."""
        path, begin_anew = state.with_name(INTERACTIONS_FILE), f"remove {STATE_FILE} to begin anew"
        if not path.exists():
            raise InvalidFile(state, f"{path} is missing, which goes with it; {begin_anew}")
        found = Interactions.load(path)
        if found.origin != self.origin:
            raise InvalidFile(path, f"it is of another exploration than {state}; {begin_anew}")
        if len(found) < rows:
            raise InvalidFile(path, f"it holds fewer than the {rows} interactions of {state}; {begin_anew}")
        return found[:rows]
