"""The domain that pages are about: a folder that is only read, with what its networks say."""

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeVar

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.contract import Part, Posed
from neurosym.data.interactions import Interactions
from neurosym.errors import NeurosymError, harmless
from neurosym.execution.record import Run
from neurosym.files import read_json
from neurosym.grounding import Grounding
from neurosym.operators import Symbol
from neurosym.problems import Problem, SceneObject
from neurosym.report.symbol_map import Atlas, atlas_of
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING, INTERACTIONS, RECORD, RUNS, WORLD
from neurosym.stages.planning import load_problem
from neurosym.stages.problem_making import sight_of_pairs
from neurosym.studio.words import nameless
from neurosym.tasks.supports import PairSight, with_pairs
from neurosym.world import World
from neurosym.worlds.world_file import read_world

if TYPE_CHECKING:
    from neurosym.learning.network import EffectModel

_HOLLOW = 0.5  # the least type of an object that has a hole, where a world does not say what it looks like
_WALL = 0.006
_T = TypeVar("_T")


class Library:
    """A domain folder that is only read.

    Args:
        folder: The folder.
        name: What the page calls it.
        is_shipped: Whether it came with neurosym, so that nothing may be written into it.

    Raises:
        NeurosymError: If it has no world or no grounding, without which there is nothing to show.
    """

    def __init__(self, folder: DomainFolder, name: str, *, is_shipped: bool = False):
        self.folder, self.name, self.is_shipped = folder, name, is_shipped
        self.damage: list[str] = []  # of each file that cannot be read why not; a page does without it
        self.world: World = read_world(folder.require(WORLD))()  # which simulates nothing here
        self.grounding = Grounding.load(folder.require(GROUNDING))

    def _read(self, read: Callable[..., _T], *given: Any) -> _T | None:
        """Read something; if that fails, remember why."""
        try:
            return read(*given)
        except NeurosymError as error:
            if (said := nameless(harmless(str(error)), self.folder.path)) not in self.damage:
                self.damage.append(said)
            return None

    @cached_property
    def _model(self) -> "EffectModel | None":
        """The network that gives objects their bits."""
        return self._read(self.folder.network)

    @cached_property
    def _sight_of_pairs(self) -> PairSight | None:
        """What networks say of pairs of objects."""
        return self._read(sight_of_pairs, self.folder)

    @cached_property
    def interactions(self) -> Interactions | None:
        """What was explored; None if it cannot be read, and `damage` says why if there is a file."""
        path = self.folder / INTERACTIONS
        return self._read(Interactions.load, path) if path.is_file() else None

    @cached_property
    def atlas(self) -> Atlas:
        """Which objects have which symbols."""
        return atlas_of(self.world, self.categorise)

    @property
    def middle(self) -> tuple[float, float]:
        """The middle of the table [m]."""
        table = self.world.table
        return sum(table.x) / 2, sum(table.y) / 2

    def categorise(self, features: Float[np.ndarray, "N F"]) -> tuple[Symbol, ...]:
        """Give objects their symbols; without a network, that of the category that they are most like."""
        if self._model is not None:
            return self._model.object_symbols(features)
        categories = self.grounding.objects.categories
        known = [one for one in categories if one.feature_means]
        if not known:
            return (categories[0].symbol,) * len(features)
        means = np.array([one.feature_means for one in known])
        nearest = np.linalg.norm(features[:, None] - means, axis=-1).argmin(1)
        return tuple(known[number].symbol for number in nearest.tolist())

    def paired(self, problem: Problem) -> Problem:
        """Return a problem that knows the kinds of its pairs, if the domain has any."""
        relations = self.grounding.relations
        return with_pairs(problem, relations, self._sight_of_pairs if relations else None)

    def margins(self, features: Sequence[float]) -> tuple[float, ...]:
        """Return what each bit of an object is the sign of, before it is squashed; () without a network."""
        if self._model is None:
            return ()
        return tuple(self._model.object_margins(np.array([features], dtype=float))[0].tolist())

    def expect(
        self, features: Sequence[float], action: Float[np.ndarray, "A"]
    ) -> tuple[Symbol, list[float], list[float]] | None:
        """Say which symbol an action has, and where an object is expected by its bits, and before [m]."""
        if self._model is None:
            return None
        row = np.array([features], dtype=float), action[None]
        by_bits, before = self._model.predict_from_codes(*row)[0][0], self._model.predict(*row)[0][0]
        return self._model.action_symbols(row[1])[0], by_bits.tolist(), before.tolist()

    def load_problem(self, name: str) -> Problem:
        """Read a problem of the folder.

        Raises:
            NeurosymError: If it cannot be read.
        """
        return load_problem(self.folder, name, self.world)

    @cached_property
    def first_problem(self) -> Problem | None:
        """The problem to begin with, if there is one that can be read.

        Where relations are known it asks for a tower. It has about three objects, and one that was run with
        success in about two steps is best.
        """
        found = [self._read(self.load_problem, name) for name in self.folder.problem_names()]
        return min(filter(None, found), key=self._strangeness, default=None)

    def _strangeness(self, problem: Problem) -> tuple[bool, bool, int, int]:
        """Say how little a problem is what a newcomer should see first."""
        related = problem.relations if self.grounding.relations else ()
        is_tower = bool({target for target, *_ in related} & {on for _, on, _ in related})
        paths = (self.folder / RUNS).glob(f"{problem.name}.*{RECORD}")
        runs = (self._read(read_json, path, Run) for path in paths)
        steps = [abs(len(run.steps) - 2) for run in runs if run and run.reached]
        return not is_tower, not related, abs(len(problem.objects) - 3), min(steps, default=99)

    def run_names(self) -> tuple[str, ...]:
        """List the records of runs that lie in the folder, without their ending."""
        records = (self.folder / RUNS).glob(f"*{RECORD}")
        return tuple(sorted(path.name.removesuffix(RECORD) for path in records))

    def object_parts(self, item: SceneObject) -> tuple[Part, ...]:
        """Return what an object is drawn with; by its sizes a box, maybe open, if the world does not say."""
        features = item.features
        if isinstance(self.world, Posed):
            unseen = () if item.unseen is msgspec.UNSET else (item.unseen,)
            return self.world.object_parts(np.array(features, dtype=float), *unseen)
        x, y, z = (float(size) for size in features[:3])
        if len(features) < 4 or features[3] < _HOLLOW:
            return (Part("box", (x, y, z)),)
        walls = [((x, _WALL, z), (0.0, side * (y - _WALL) / 2, 0.0)) for side in (-1, 1)]
        walls += [((_WALL, y, z), (side * (x - _WALL) / 2, 0.0, 0.0)) for side in (-1, 1)]
        return tuple(Part("box", size, centre) for size, centre in walls)
