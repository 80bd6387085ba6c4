"""The table of a page: what is on it, and where it shall go. It knows nothing of a browser.

Whoever listens is told by topic what has changed. What cannot be done is said, and never raised.
"""

import threading
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import update_wrapper
from typing import Concatenate, Literal, ParamSpec, TypeVar

from neurosym.errors import InvalidValue, NeurosymError
from neurosym.problems import Problem, SceneObject
from neurosym.studio import setting
from neurosym.studio.library import Library
from neurosym.studio.placing import Reach, reach_of, relation_of_drop, why_beyond, why_not_there
from neurosym.studio.symbols import Promise, nearest_flip, promises_for

Topic = Literal["scene", "place", "plan", "run", "step", "pose", "status"]
"""What has changed: which objects there are, where things are, the plan, the run, a pose, what is said."""
MOST_OBJECTS = 8
"""So many objects are simulated at most."""
_P = ParamSpec("_P")
_D = TypeVar("_D", bound="Desk")
_SPOTS = 0.02  # how far apart the places are where an object is tried to be added [m]


@dataclass(frozen=True, slots=True)
class Word:
    """What a page says of itself.

    Attributes:
        text: A sentence.
        is_bad: Whether something could not be done.
    """

    text: str = ""
    is_bad: bool = False


def told(method: "Callable[Concatenate[_D, _P], None]") -> "Callable[Concatenate[_D, _P], None]":
    """Have a method of a page say what it cannot do, instead of raising it."""

    def safely(self: _D, /, *arguments: _P.args, **options: _P.kwargs) -> None:
        try:
            method(self, *arguments, **options)
        except NeurosymError as error:
            self.say(str(error), is_bad=True)

    update_wrapper(safely, method)
    return safely


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
        self._reaches: dict[SceneObject, Reach] = {}
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
        self._change(setting.moved(self._problem(), name, x, y), "place")

    @told
    def aim(self, name: str, x: float, y: float, z: float | None = None) -> None:
        """Put the goal of an object somewhere; it gets one if it has none."""
        self._refuse_while_running()
        has_goal = name in self._problem().goals
        self._change(setting.with_goal(self._problem(), name, x, y, z), "place" if has_goal else "scene")

    @told
    def add_goal(self, name: str) -> None:
        """Give an object a goal beside it, to be dragged from there."""
        self._refuse_while_running()
        self._change(setting.with_goal_beside(self._problem(), name, self.library.middle), "scene")

    @told
    def remove_goal(self, name: str) -> None:
        """Take the goal of an object away."""
        self._refuse_while_running()
        self._change(setting.without_goal(self._problem(), name), "scene")

    @told
    def resize(self, name: str, features: tuple[float, ...]) -> None:
        """Make an object another one: its sizes [m], and its type."""
        self._refuse_while_running()
        if limits := self.library.limits:
            limits.check(name, features)
        self._change(setting.resized(self._problem(), name, features, self.library.categorise), "scene")

    @told
    def add(self, features: tuple[float, ...]) -> None:
        """Add an object where there is room."""
        self._refuse_while_running()
        if self.problem and len(self.problem.objects) >= MOST_OBJECTS:
            raise InvalidValue(f"There are {MOST_OBJECTS} objects already, the most that are simulated.")
        if limits := self.library.limits:
            limits.check("the object", features)
        x, y = self._free_spot(features)
        self._change(setting.with_object(self.problem, features, x, y, self.library.categorise), "scene")

    @told
    def remove(self, name: str) -> None:
        """Take an object away."""
        self._refuse_while_running()
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
        problem = self.problem
        if problem is None:
            return {}
        table, found = self.library.grounding.table, {}
        for name in problem.object_names:
            if why := why_not_there(problem, name, "object", table):
                found[f"object {name}"] = why
            if name in problem.goals:
                on = relation_of_drop(problem, name)
                why = why_not_there(problem, name, "goal", table)
                if why and on:
                    why += f"; this domain knows no goals like {name} on {on}"
                if why or (why := why_beyond(problem, name, self.reach(name))):
                    found[f"goal {name}"] = why
        return found

    def promises(self, name: str) -> tuple[Promise, ...]:
        """List what can be done to an object, the surest first."""
        return promises_for(self._problem().object_named(name), self.library)

    @told
    def flip(self, name: str) -> None:
        """Make an object another one that differs in a bit, changing one of its sizes as little as can be."""
        self._refuse_while_running()
        item = self._problem().object_named(name)
        if (flipped := nearest_flip(item.features, self.library)) is None:
            raise InvalidValue(f"No size of {name} alone flips a bit; try another object.")
        axis, features = flipped
        self._change(setting.resized(self._problem(), name, features, self.library.categorise), "scene")
        now, size = self._problem().object_named(name).category, 1000 * features[axis]
        called = self.library.world.feature_names[axis]
        self.say(f"{name} was {item.category}; with {called} = {size:.0f} mm it is {now}")

    def _problem(self) -> Problem:
        if self.problem is None:
            raise InvalidValue("There is no object on the table; add one.")
        return self.problem

    def _change(self, problem: Problem, topic: Topic) -> None:
        with self._lock:
            self.problem = problem
        self._changed(topic)

    def _free_spot(self, features: tuple[float, ...]) -> tuple[float, float]:
        """Find room for an object, nearest to the middle of the table."""
        table, middle = self.library.grounding.table, self.library.middle
        if self.problem is None:
            return middle
        step = _SPOTS
        xs = [table.x[0] + step * i for i in range(1, round((table.x[1] - table.x[0]) / step))]
        ys = [table.y[0] + step * i for i in range(1, round((table.y[1] - table.y[0]) / step))]
        spots = sorted(
            ((x, y) for x in xs for y in ys),
            key=lambda at: (at[0] - middle[0]) ** 2 + (at[1] - middle[1]) ** 2,
        )
        for x, y in spots:
            trial = setting.with_object(self.problem, features, x, y, lambda rows: ("0",) * len(rows))
            if not why_not_there(trial, trial.objects[-1].name, "object", table):
                return x, y
        raise InvalidValue("There is no room for another object; take one away, or make one smaller.")
