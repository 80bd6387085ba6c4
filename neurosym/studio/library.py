"""The domain that a page shows: what was learned, read once and shared by all who look at it."""

import threading
from collections.abc import Callable, Sequence
from functools import cached_property, partial
from typing import TYPE_CHECKING, NamedTuple, TypeVar

import numpy as np

from neurosym.arrays import Float
from neurosym.data.interactions import Interactions
from neurosym.errors import NeurosymError
from neurosym.grounding import Grounding
from neurosym.object_limits import ObjectLimits, limits_of
from neurosym.pair_sight import PairSight, with_pairs
from neurosym.poses import Part, Posed
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING, INTERACTIONS, MODEL, RECORD, RUNS, WORLD
from neurosym.stages.planning import load_problem
from neurosym.stages.task_drawing import sight_of_pairs
from neurosym.symbols import Symbol
from neurosym.wording import harmless
from neurosym.world import World
from neurosym.worlds.world_file import read_world

if TYPE_CHECKING:
    from neurosym.learning.effect_model import EffectModel

_HOLLOW = 0.5  # the least type of an object that has a hole, where a world does not say what it looks like
_WALL = 0.006
_T = TypeVar("_T")


class Motion(NamedTuple):
    """What the network says of an action on an object.

    Attributes:
        symbol: The symbol that the action has.
        expected: Where the object goes by the bits alone [m].
        direct: Where it goes by the network before the bits [m].
    """

    symbol: str
    expected: tuple[float, ...]
    direct: tuple[float, ...]


class Library:
    """A domain folder that is only read.

    Args:
        folder: The folder.
        name: What the page calls it.
        is_shipped: Whether it came with neurosym, so that nothing may be written into it.

    Attributes:
        grounding: What was learned.
        world: The world, for its table and its objects; simulations run elsewhere.
        damage: What could not be read: a sentence for each file. The page says it and goes on with the rest.

    Raises:
        NeurosymError: If it has no world or no grounding, without which there is nothing to show.
    """

    def __init__(self, folder: DomainFolder, name: str, *, is_shipped: bool = False):
        self.folder, self.name, self.is_shipped = folder, name, is_shipped
        self.damage: list[str] = []
        self.world: World = read_world(folder.require(WORLD))()
        self.grounding = Grounding.load(folder.require(GROUNDING))
        self._lock = threading.Lock()

    @cached_property
    def model(self) -> "EffectModel | None":
        """The network that gives objects their bits; None if it cannot be read, and `damage` says why."""
        from neurosym.learning.effect_model import EffectModel

        return self._read(lambda: EffectModel.load(self.folder.require(MODEL)))

    @cached_property
    def sight_of_pairs(self) -> PairSight | None:
        """What networks say of pairs of objects; None if they cannot be read, and `damage` says why."""
        return self._read(lambda: sight_of_pairs(self.folder))

    @cached_property
    def interactions(self) -> Interactions | None:
        """What was explored; None if it cannot be read, and `damage` says why if there is a file."""
        path = self.folder / INTERACTIONS
        return self._read(lambda: Interactions.load(path)) if path.is_file() else None

    def _read(self, read: Callable[[], _T]) -> _T | None:
        """Read something; if that fails, remember why."""
        try:
            return read()
        except NeurosymError as error:
            if (said := harmless(str(error))) not in self.damage:
                self.damage.append(said)
            return None

    @property
    def middle(self) -> tuple[float, float]:
        """The middle of the table [m]."""
        table = self.world.table
        return sum(table.x) / 2, sum(table.y) / 2

    @property
    def limits(self) -> ObjectLimits | None:
        """Which objects the world makes, if it says so."""
        return limits_of(self.world)

    def categorise(self, features: Float[np.ndarray, "N F"]) -> tuple[Symbol, ...]:
        """Give objects their symbols; without a network, that of the category that they are most like."""
        with self._lock:
            if (model := self.model) is not None:
                return model.object_symbols(features)
        return tuple(self._likest(row) for row in features)

    def paired(self, problem: Problem) -> Problem:
        """Return a problem that knows the kinds of its pairs, if the domain has any."""
        relations = self.grounding.relations
        with self._lock:
            return with_pairs(problem, relations, self.sight_of_pairs if relations else None)

    def margins(self, features: Sequence[float]) -> tuple[float, ...]:
        """Return what each bit of an object is the sign of, before it is squashed; () without a network."""
        with self._lock:
            if (model := self.model) is None:
                return ()
            return tuple(model.object_margins(np.array([features], dtype=float))[0].tolist())

    def expect(self, features: Sequence[float], action: Float[np.ndarray, "A"]) -> Motion | None:
        """Say which symbol an action has, and what the network expects of it; None without a network.

        Args:
            features: What the object is.
            action: The action parameters.
        """
        row = np.array([features], dtype=float), action[None]
        with self._lock:
            if (model := self.model) is None:
                return None
            through, before = (
                tuple(predict(*row)[0][0].tolist()) for predict in (model.predict_from_codes, model.predict)
            )
            return Motion(model.action_symbols(row[1])[0], through, before)

    def problem_names(self) -> tuple[str, ...]:
        """List the problems of the folder."""
        return self.folder.problem_names()

    def load_problem(self, name: str) -> Problem:
        """Read a problem of the folder.

        Raises:
            NeurosymError: If it cannot be read.
        """
        return load_problem(self.folder, name, self.world)

    def run_names(self) -> tuple[str, ...]:
        """List the records of runs that lie in the folder."""
        return tuple(
            sorted(path.name.removesuffix(RECORD) for path in (self.folder / RUNS).glob(f"*{RECORD}"))
        )

    def first_problem(self) -> Problem | None:
        """Return the first problem of the folder that can be read, if there is one."""
        read = (self._read(partial(self.load_problem, name)) for name in self.problem_names())
        return next(filter(None, read), None)

    def robot_parts(self) -> tuple[Part, ...]:
        """Return what the robot is drawn with; nothing if the world does not say."""
        return self.world.robot_parts() if isinstance(self.world, Posed) else ()

    def object_parts(self, features: Sequence[float]) -> tuple[Part, ...]:
        """Return what an object is drawn with; a box, which may be open, if the world does not say.

        Args:
            features: What it is: sizes along x, y and z first [m].
        """
        if isinstance(self.world, Posed):
            return self.world.object_parts(np.array(features, dtype=float))
        x, y, z = (float(size) for size in features[:3])
        if len(features) < 4 or features[3] < _HOLLOW:
            return (Part("box", (x, y, z)),)
        walls = [((x, _WALL, z), (0.0, side * (y - _WALL) / 2, 0.0)) for side in (-1, 1)]
        walls += [((_WALL, y, z), (side * (x - _WALL) / 2, 0.0, 0.0)) for side in (-1, 1)]
        return tuple(Part("box", size, centre) for size, centre in walls)

    def _likest(self, features: Float[np.ndarray, "F"]) -> Symbol:
        known = [one for one in self.grounding.operators.categories if one.feature_means]
        if not known:
            return self.grounding.operators.categories[0].symbol
        apart = [float(np.linalg.norm(np.array(one.feature_means) - features)) for one in known]
        return known[int(np.argmin(apart))].symbol
