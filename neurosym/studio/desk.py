"""The domain and the table of a page: what is on it, and where it shall go. It knows nothing of a browser.

Whoever listens is told by topic what has changed. What cannot be done is said, and never raised.
"""

import math
import threading
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial, wraps
from typing import TYPE_CHECKING, Concatenate, Literal, ParamSpec, TypeVar

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.contract import ObjectLimits, Part, Posed, limits_of
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidValue, NeurosymError, harmless
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import Operator, Symbol, Vector
from neurosym.problems import Problem, RelationGoal, SceneObject
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING, INTERACTIONS, MODEL, RECORD, RUNS, WORLD
from neurosym.stages.planning import load_problem
from neurosym.stages.problem_making import sight_of_pairs
from neurosym.studio import scene_editor
from neurosym.tasks.promises import usable
from neurosym.tasks.supports import Borne, PairSight, carried_along, loads_of, with_pairs
from neurosym.tasks.task import Task, understand
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
        from neurosym.learning.network import EffectModel

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

    def expect(
        self, features: Sequence[float], action: Float[np.ndarray, "A"]
    ) -> tuple[str, list[float], list[float]] | None:
        """Say which symbol an action has, and where the network expects an object to go; None without one.

        That is by the bits alone, and by the network before the bits [m].
        """
        row = np.array([features], dtype=float), action[None]
        with self._lock:
            if (model := self.model) is None:
                return None
            by_bits, before = model.predict_from_codes(*row)[0][0], model.predict(*row)[0][0]
            return model.action_symbols(row[1])[0], by_bits.tolist(), before.tolist()

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

        Sizes along x, y and z come first in its features [m].
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


Topic = Literal["scene", "place", "plan", "run", "step", "pose", "status"]
"""What has changed: which objects there are, where things are, the plan, the run, a pose, what is said."""
MOST_OBJECTS = 8
"""So many objects are simulated at most."""
_GOAL_DISTANCE = 0.12
"""How far from its object a new goal is put, so that the two do not cover each other [m]."""
_D = TypeVar("_D", bound="Desk")
_P = ParamSpec("_P")
_Method = Callable[Concatenate[_D, _P], None]


@dataclass(frozen=True, slots=True)
class Word:
    """What a page says of itself, also in the place of an error.

    Attributes:
        text: A sentence.
        is_bad: Whether something could not be done.
    """

    text: str = ""
    is_bad: bool = False


def told(method: _Method[_D, _P]) -> _Method[_D, _P]:
    """Have a method of a page say what it cannot do, instead of raising it."""

    @wraps(method)
    def safely(self: _D, /, *arguments: _P.args, **options: _P.kwargs) -> None:
        try:
            method(self, *arguments, **options)
        except NeurosymError as error:
            self.say(str(error), is_bad=True)

    return safely


def at_rest(method: _Method[_D, _P]) -> _Method[_D, _P]:
    """Have a method refuse while something runs, and say what else it cannot do."""

    @told
    @wraps(method)
    def still(self: _D, /, *arguments: _P.args, **options: _P.kwargs) -> None:
        self._refuse_while_running()
        method(self, *arguments, **options)

    return still


class Desk:
    """One table, with its objects and their goals.

    Args:
        library: The domain.
        problem: What is on it at first; the first problem of the domain, if not given.

    Attributes:
        problem: What is on it; None if there is no object yet.
        word: What was said last.
    """

    def __init__(self, library: Library, problem: Problem | None = None):
        self.library = library
        self.problem = problem or library.first_problem()
        self.word = Word()
        self._complaints: tuple[Problem | None, Mapping[str, str]] = (None, {})
        self._paired: tuple[dict[str, tuple[float, ...]], Problem] | None = None
        self._listeners: list[Callable[[Topic], None]] = []
        self._lock = threading.RLock()

    def listen(self, listener: Callable[[Topic], None]) -> None:
        """Have somebody told what changes."""
        self._listeners.append(listener)

    def tell(self, topic: Topic) -> None:
        """Tell all listeners what has changed."""
        for listener in self._listeners:
            listener(topic)

    def say(self, text: str, *, is_bad: bool = False) -> None:
        """Say a sentence on the page."""
        self.word = Word(text, is_bad)
        self.tell("status")

    def _refuse_while_running(self) -> None:
        """Raise `InvalidValue` while the table cannot be set."""

    def _grab(self, name: str, x: float, y: float) -> bool:  # noqa: ARG002  (for a table on which nothing runs)
        """Take an object of a run elsewhere, and say whether there is a run."""
        return False

    def _changed(self, topic: Topic) -> None:
        """Take note that another problem is on the table."""
        self.tell(topic)

    @told
    def load(self, name: str) -> None:
        """Put a problem of the domain on the table."""
        self.put(self.library.load_problem(name))
        self.say(f"{name} is on the table")

    def put(self, problem: Problem) -> None:
        """Put a problem on the table."""
        self._change(problem, "scene")

    @told
    def move(self, name: str, x: float, y: float) -> None:
        """Put an object elsewhere; while a plan runs, that is done before its next step."""
        if self._grab(name, x, y):
            return
        problem, stacks = self._problem(), self._stacks()
        height = scene_editor.table_height(problem, name) if name in stacks else None
        self._change(scene_editor.moved(problem, name, x, y, height, carried_along(name, stacks)), "place")

    @at_rest
    def aim(self, name: str, x: float, y: float, z: float | None = None) -> None:
        """Put the goal of an object somewhere; it gets one if it has none."""
        self._change_goal(name, scene_editor.with_goal(self._problem(), name, x, y, z))

    @at_rest
    def drop_goal(self, name: str, before: Problem | None = None) -> None:
        """Take note that the ghost of an object was let go: on another one, it is a goal by relation.

        Where nothing puts the one on the other, all is again as it was.
        """
        task = self.task()
        on = scene_editor.under(task, name, self.ghosts()) if task.grounding.relations else ()
        if not on:
            return
        if goal := scene_editor.relation_of_drop(task, name):
            self.relate(*goal)
            return
        if before is not None:
            self.put(before)
        raise InvalidValue(f"{scene_editor.why_no_drop(task, name, on[0])}.")

    @at_rest
    def relate(self, name: str, reference: str, state: str) -> None:
        """Give an object the goal to stand on or in another one, in the place of any other goal of it."""
        goal = (name, reference, state)
        if why := scene_editor.why_no_goal(self.task(), goal):
            raise InvalidValue(f"{why}.")
        self._change_goal(name, scene_editor.with_relation(self._problem(), *goal))
        self.say(f"goal: {name} {state} {reference}")

    @at_rest
    def add_goal(self, name: str) -> None:
        """Give an object a goal beside it, towards the middle of the table, to be dragged from there."""
        x, y, _ = self._problem().object_named(name).position
        self.aim(name, x + math.copysign(_GOAL_DISTANCE, self.library.middle[0] - x), y)

    @at_rest
    def remove_goal(self, name: str) -> None:
        """Take the goal of an object away, on the table or by relation."""
        self._change(scene_editor.without_goal(self._problem(), name), "scene")

    @at_rest
    def resize(self, name: str, features: tuple[float, ...]) -> None:
        """Make an object another one, by its sizes [m] and type; it stands as high as the first one did."""
        self._refuse_laden(name)
        if limits := self.library.limits:
            limits.check(name, features)
        problem, under_it = self._problem(), 0.0
        if name in self._stacks():
            under_it = problem.object_named(name).position[2] - scene_editor.table_height(problem, name)
        self._change(
            scene_editor.resized(problem, name, features, self.library.categorise, under_it), "scene"
        )

    @at_rest
    def add(self, features: tuple[float, ...]) -> None:
        """Add an object where there is room."""
        if self.problem and len(self.problem.objects) >= MOST_OBJECTS:
            raise InvalidValue(f"There are {MOST_OBJECTS} objects already, the most that are simulated.")
        if limits := self.library.limits:
            limits.check("the object", features)
        x, y = scene_editor.free_spot(
            self.problem, features, self.library.grounding.table, self.library.middle
        )
        self._change(scene_editor.with_object(self.problem, features, x, y, self.library.categorise), "scene")

    @at_rest
    def remove(self, name: str) -> None:
        """Take an object away."""
        self._refuse_laden(name)
        self._change(scene_editor.without_object(self._problem(), name), "scene")

    @at_rest
    def rename(self, name: str) -> None:
        """Call the problem otherwise."""
        self._change(msgspec.structs.replace(self._problem(), name=name), "status")

    @at_rest
    def set_tolerance(self, tolerance: float) -> None:
        """Say how near objects must come to their goals [m]."""
        self._change(self._problem().within(tolerance), "scene")

    def complaints(self) -> Mapping[str, str]:
        """Say of each object or goal that cannot be where it is why not, by `object NAME` and `goal NAME`."""
        problem, (known, found) = self.problem, self._complaints
        if problem is not known:
            found = scene_editor.complaints_about(self.task())
            self._complaints = problem, found
        return found

    def paired(self) -> Problem:
        """Return what is on the table with the kinds of its pairs, which are worked out once for the objects.

        Raises:
            InvalidValue: If there is no object yet.
        """
        problem = self._problem()
        if self.library.grounding.relations is None or problem.pairs:
            return problem
        features = {item.name: item.features for item in problem.objects}
        with self._lock:
            if self._paired is None or self._paired[0] != features:
                self._paired = features, self.library.paired(problem)
            _, seen = self._paired
        return msgspec.structs.replace(problem, pairs=seen.pairs, foreseen=seen.foreseen)

    def task(self) -> Task:
        """Return what is on the table, as it is understood with the domain."""
        return understand(self.paired(), self.library.grounding)

    def ghosts(self) -> Mapping[str, Vector]:
        """Return where the ghost of each object with a goal stands [m]."""
        return scene_editor.ghost_spots(self.task()) if self.problem else {}

    def goals_for(self, name: str) -> tuple[RelationGoal, ...]:
        """List the goals by relation that an object can have; none where the domain knows no relations."""
        return scene_editor.goals_for(self.task(), name)

    def _problem(self) -> Problem:
        if self.problem is None:
            raise InvalidValue("There is no object on the table; add one.")
        return self.problem

    def _stacks(self) -> dict[str, Borne]:
        return scene_editor.stacks_of(self.task())

    def _refuse_laden(self, name: str) -> None:
        """Raise `InvalidValue` if an object bears another one."""
        if loads := loads_of(name, self._stacks()):
            raise InvalidValue(f"{name} bears {' and '.join(loads)}; drag that away first.")

    def _change_goal(self, name: str, problem: Problem) -> None:
        """Put a problem on the table in which an object has another goal, or one for the first time."""
        self._change(problem, "place" if name in self.ghosts() else "scene")

    def _change(self, problem: Problem, topic: Topic) -> None:
        with self._lock:
            self.problem = problem
        self._changed(topic)


SAFE, OTHERWISE = (42, 157, 92), (217, 83, 79)
"""Colours of rehearsals that ended as promised, and otherwise."""


@dataclass(frozen=True, slots=True)
class Promise:
    """What an operator does to the object at hand.

    Attributes:
        operator: The operator, as it promises for this object.
        effect: Where it takes the object, at the end of the rise if it lifts [m].
        lifts: Whether it ends with the object in the air.
        chance: How likely it goes as promised.
    """

    operator: Operator
    effect: Vector
    lifts: bool
    chance: float


def promises_for(item: SceneObject, library: Library) -> tuple[Promise, ...]:
    """List what the operators of the domain do to an object, the surest first."""
    grounding = library.grounding
    found = [
        Promise(one, one.promise.outcome, is_lift(one), one.chance)
        for one in usable(grounding, item)
        if one.promise is not None and len(one.promise.outcome) == 3
    ]
    return tuple(sorted(found, key=lambda one: (-one.chance, one.operator.name)))


def rehearsal_dots(
    operator: Operator, start: Sequence[float], library: Library
) -> tuple[Float[np.ndarray, "N 3"], Float[np.ndarray, "N 3"]]:
    """Return where rehearsals of an operator ended, as if all had begun at one point, and their colours.

    `start` is where they begin [m].
    """
    learned = library.grounding.operator_named(operator.name)
    promise = learned.promise
    rows = [(one.outcome, promise is not None and one.kind == promise.kind) for one in learned.rehearsals]
    points = np.array([np.add(start, outcome) for outcome, _ in rows], dtype=float).reshape(-1, 3)
    colours = np.array([SAFE if kept else OTHERWISE for _, kept in rows], dtype=float).reshape(-1, 3)
    return points, colours
