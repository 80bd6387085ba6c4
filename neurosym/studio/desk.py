"""The table of a page: what is on it, and where it shall go. It knows nothing of a browser.

Whoever listens is told by topic what has changed. What cannot be done is said, and never raised.
"""

import threading
from collections.abc import Callable, Mapping
from typing import Literal

import msgspec

from neurosym.errors import InvalidValue
from neurosym.operators import Vector
from neurosym.problems import Problem, SceneObject
from neurosym.relation_goals import RelationGoal
from neurosym.studio import setting
from neurosym.studio.library import Library
from neurosym.studio.placing import Reach, complaints_about, free_spot, reach_of
from neurosym.studio.relating import (
    above,
    ghost_spots,
    goals_for,
    relation_of_drop,
    stacks_of,
    table_height,
    under,
    why_no_drop,
    why_no_goal,
)
from neurosym.studio.saying import Word, told
from neurosym.studio.symbols import Promise, nearest_flip, promises_for

Topic = Literal["scene", "place", "plan", "run", "step", "pose", "status"]
"""What has changed: which objects there are, where things are, the plan, the run, a pose, what is said."""
MOST_OBJECTS = 8
"""So many objects are simulated at most."""
NO_OBJECT = "There is no object on the table; add one."


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
        self._reaches: dict[SceneObject, Reach] = {}
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
        self._change(self.library.load_problem(name), "scene")
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
        height = table_height(problem, name) if name in stacks else None
        self._change(setting.moved(problem, name, x, y, height, above(name, stacks)), "place")

    @told
    def aim(self, name: str, x: float, y: float, z: float | None = None) -> None:
        """Put the goal of an object somewhere; it gets one if it has none."""
        self._refuse_while_running()
        problem, has_goal = self._problem(), name in self.ghosts()
        z = self._goal_height(name) if z is None and name not in problem.goals else z
        self._change(setting.with_goal(problem, name, x, y, z), "place" if has_goal else "scene")

    @told
    def drop_goal(self, name: str, before: Problem | None = None) -> None:
        """Take note that the ghost of an object was let go: on another one, it is a goal by relation.

        Where nothing puts the one on the other, the goal is again what it was.

        Args:
            name: Name of the object.
            before: What was on the table when the ghost was taken.
        """
        self._refuse_while_running()
        problem, grounding = self.paired(), self.library.grounding
        on = under(problem, name, self.ghosts()) if grounding.relations else ()
        if not on:
            return
        if goal := relation_of_drop(problem, grounding, name):
            self.relate(*goal)
            return
        if before is not None and name in before.object_names:
            self._change(setting.with_goal_of(self._problem(), name, before), "place")
        raise InvalidValue(f"{why_no_drop(problem, grounding, name, on[0])}.")

    @told
    def relate(self, name: str, reference: str, state: str) -> None:
        """Give an object the goal to stand on or in another one, in the place of any other goal of it."""
        self._refuse_while_running()
        has_goal, goal = name in self.ghosts(), (name, reference, state)
        if why := why_no_goal(self.paired(), self.library.grounding, goal):
            raise InvalidValue(f"{why}.")
        self._change(setting.with_relation(self._problem(), *goal), "place" if has_goal else "scene")
        self.say(f"goal: {name} {state} {reference}")

    @told
    def add_goal(self, name: str) -> None:
        """Give an object a goal beside it, to be dragged from there."""
        self._refuse_while_running()
        height = self._goal_height(name)
        self._change(setting.with_goal_beside(self._problem(), name, self.library.middle, height), "scene")

    @told
    def remove_goal(self, name: str) -> None:
        """Take the goal of an object away, on the table or by relation."""
        self._refuse_while_running()
        self._change(setting.without_goal(self._problem(), name), "scene")

    @told
    def resize(self, name: str, features: tuple[float, ...]) -> None:
        """Make an object another one: its sizes [m], and its type."""
        self._refuse_while_running()
        self._refuse_laden(name)
        if limits := self.library.limits:
            limits.check(name, features)
        self._become(name, features)

    @told
    def add(self, features: tuple[float, ...]) -> None:
        """Add an object where there is room."""
        self._refuse_while_running()
        if self.problem and len(self.problem.objects) >= MOST_OBJECTS:
            raise InvalidValue(f"There are {MOST_OBJECTS} objects already, the most that are simulated.")
        if limits := self.library.limits:
            limits.check("the object", features)
        table = self.library.grounding.table
        x, y = free_spot(self.problem, features, table, self.library.middle)
        self._change(setting.with_object(self.problem, features, x, y, self.library.categorise), "scene")

    @told
    def remove(self, name: str) -> None:
        """Take an object away."""
        self._refuse_while_running()
        self._refuse_laden(name)
        self._change(setting.without_object(self._problem(), name), "scene")

    @told
    def rename(self, name: str) -> None:
        """Call the problem otherwise."""
        self._refuse_while_running()
        self._change(setting.renamed(self._problem(), name), "status")

    @told
    def set_tolerance(self, tolerance: float) -> None:
        """Say how near objects must come to their goals [m]."""
        self._refuse_while_running()
        self._change(self._problem().within(tolerance), "scene")

    def reach(self, name: str) -> Reach:
        """Return where an object can be brought to; worked out once for each place."""
        item = self._problem().object_named(name)
        with self._lock:
            if item not in self._reaches:
                self._reaches = {one: self._reaches[one] for one in list(self._reaches)[-64:]}
                self._reaches[item] = reach_of(item, self.library.grounding)
            return self._reaches[item]

    def complaints(self) -> Mapping[str, str]:
        """Say of each object or goal that cannot be where it is why not, by `object NAME` and `goal NAME`."""
        problem, (known, found) = self.problem, self._complaints
        if problem is None:
            return {}
        if problem is not known:
            found = complaints_about(self.paired(), self.library.grounding, self.reach)
            self._complaints = problem, found
        return found

    def paired(self) -> Problem:
        """Return what is on the table with the kinds of its pairs, which are worked out once for the objects.

        Raises:
            InvalidValue: If there is no object yet.
        """
        problem = self._problem()
        if self.library.grounding.relations is None or problem.pairs is not msgspec.UNSET:
            return problem
        features = {item.name: item.features for item in problem.objects}
        with self._lock:
            if self._paired is None or self._paired[0] != features:
                self._paired = features, self.library.paired(problem)
            _, seen = self._paired
        return msgspec.structs.replace(problem, pairs=seen.pairs, foreseen=seen.foreseen)

    def ghosts(self) -> Mapping[str, Vector]:
        """Return where the ghost of each object with a goal stands [m]."""
        return ghost_spots(self.paired(), self.library.grounding) if self.problem else {}

    def goals_for(self, name: str) -> tuple[RelationGoal, ...]:
        """List the goals by relation that an object can have; none where the domain knows no relations."""
        return goals_for(self.paired(), self.library.grounding, name)

    def promises(self, name: str) -> tuple[Promise, ...]:
        """List what can be done to an object, the surest first."""
        return promises_for(self._problem().object_named(name), self.library)

    @told
    def flip(self, name: str) -> None:
        """Make an object another one that differs in a bit, changing one of its sizes as little as can be."""
        self._refuse_while_running()
        self._refuse_laden(name)
        item = self._problem().object_named(name)
        if (flipped := nearest_flip(item.features, self.library)) is None:
            raise InvalidValue(f"No size of {name} alone flips a bit; try another object.")
        axis, features = flipped
        self._become(name, features)
        now, size = self._problem().object_named(name).category, 1000 * features[axis]
        called = self.library.world.feature_names[axis]
        self.say(f"{name} was {item.category}; with {called} = {size:.0f} mm it is {now}")

    def _problem(self) -> Problem:
        if self.problem is None:
            raise InvalidValue(NO_OBJECT)
        return self.problem

    def _become(self, name: str, features: tuple[float, ...]) -> None:
        """Make an object another one, which stands as high as the first one did."""
        problem, under_it = self._problem(), 0.0
        if name in self._stacks():
            under_it = problem.object_named(name).position[2] - table_height(problem, name)
        self._change(setting.resized(problem, name, features, self.library.categorise, under_it), "scene")

    def _stacks(self) -> dict[str, str]:
        """Name what bears each object that another one bears."""
        return {name: borne.by for name, borne in stacks_of(self.paired(), self.library.grounding).items()}

    def _refuse_laden(self, name: str) -> None:
        """Raise `InvalidValue` if an object bears another one."""
        if loads := [one for one, by in self._stacks().items() if by == name]:
            raise InvalidValue(f"{name} bears {' and '.join(loads)}; drag that away first.")

    def _goal_height(self, name: str) -> float | None:
        """Return how high a new goal is where objects may be borne by others: as on the table [m]."""
        return table_height(self._problem(), name) if self.library.grounding.relations else None

    def _change(self, problem: Problem, topic: Topic) -> None:
        with self._lock:
            self.problem = problem
        self._changed(topic)
