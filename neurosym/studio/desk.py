"""The table of a page: what is on it, and where it shall go. It knows nothing of a browser.

Whoever listens is told by topic what has changed. What cannot be done is said, and never raised.
"""

import math
import threading
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import wraps
from typing import Concatenate, Literal, ParamSpec, TypeVar

import msgspec

from neurosym.contract import limits_of
from neurosym.errors import InvalidValue, NeurosymError
from neurosym.operators import Vector
from neurosym.problems import Problem, RelationGoal
from neurosym.report.symbol_map import WORDS
from neurosym.studio import scene_editor, words
from neurosym.studio.library import Library
from neurosym.studio.messages import Word
from neurosym.tasks.goal_choice import with_goals
from neurosym.tasks.supports import Borne, carried_along, loads_of
from neurosym.tasks.task import Task, understand

Topic = Literal["scene", "place", "plan", "run", "step", "pose", "status"]
"""What has changed: which objects there are, where things are, the plan, the run, a pose, what is said."""
MOST_OBJECTS = 8
"""So many objects are simulated at most."""
_GOAL_DISTANCE = 0.12
"""How far from its object a new goal is put, so that the two do not cover each other [m]."""
_D = TypeVar("_D", bound="Desk")
_P = ParamSpec("_P")
_Method = Callable[Concatenate[_D, _P], None]


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

    @wraps(method)
    def still(self: _D, /, *arguments: _P.args, **options: _P.kwargs) -> None:
        if self.is_running:
            raise InvalidValue(
                "A plan is running; stop it first. Meanwhile objects can be dragged, and goals stay."
            )
        method(self, *arguments, **options)

    return told(still)


class Desk:
    """One table, with its objects and their goals: at first a given problem, or the first of the domain."""

    def __init__(self, library: Library, problem: Problem | None = None):
        self.library = library
        self.problem = problem or library.first_problem  # None while there is no object
        self.word = Word()  # what was said last
        self._complaints: tuple[Problem | None, Mapping[str, str]] = (None, {})
        self._paired: tuple[dict[str, tuple[float, ...]], Problem] | None = None
        self._listeners: list[Callable[[Topic], None]] = []
        self._lock = threading.RLock()

    @property
    def is_running(self) -> bool:
        """Whether something moves, so that the table cannot be set."""
        return False

    def listen(self, listener: Callable[[Topic], None]) -> None:
        """Have somebody told what changes."""
        self._listeners.append(listener)

    def tell(self, topic: Topic) -> None:
        """Tell all listeners what has changed."""
        for listener in self._listeners:
            listener(topic)

    def say(self, text: str, is_bad: bool = False) -> None:
        """Say a sentence on the page."""
        self.word = Word(words.nameless(text, self.library.folder.path), is_bad)
        self.tell("status")

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
        """Put an object elsewhere, with what it bears, and down from what bears it [m]."""
        problem, stacks = self._problem(), self._stacks()
        height = scene_editor.table_height(problem, name) if name in stacks else None
        self._change(scene_editor.moved(problem, name, x, y, height, carried_along(name, stacks)), "place")

    @at_rest
    def aim(self, name: str, x: float, y: float, z: float | None = None) -> None:
        """Put the goal of an object somewhere [m]; it gets one if it has none."""
        self._change_goal(name, scene_editor.with_goal(self._problem(), name, x, y, z))

    @at_rest
    def drop_goal(self, name: str, before: Problem | None = None) -> None:
        """Take note that a ghost was let go: on an object, it is a goal by relation, or all is as before."""
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
        self._change_goal(name, scene_editor.with_relation(self._problem(), goal))
        self.say(f"goal: {name} {words.relation_in_words(state)[0]} {reference}")

    @at_rest
    def ask(self, text: str) -> None:
        """Ask for something in words, as `item-01 next-to item-02`; goals for that replace all others."""
        problem = self._problem()
        asked = msgspec.structs.replace(self.paired(), conditions=(text.strip(),) if text.strip() else ())
        chosen = with_goals(asked, self.library.grounding)
        self._change(msgspec.structs.replace(chosen, pairs=problem.pairs, foreseen=problem.foreseen), "scene")
        self.say(f"goals for: {text.strip()}" if chosen.conditions else "nothing is asked for in words")

    @at_rest
    def add_goal(self, name: str) -> None:
        """Give an object a goal beside it, towards the middle of the table, to be dragged from there."""
        x, y, _ = self._problem().object_named(name).position
        self.aim(name, x + math.copysign(_GOAL_DISTANCE, self.library.middle[0] - x), y)

    @at_rest
    def remove_goal(self, name: str) -> None:
        """Take the goal of an object away, on the table or by relation."""
        self._change(_by_hand(scene_editor.without_goal(self._problem(), name)), "scene")

    @at_rest
    def resize(self, name: str, features: tuple[float, ...]) -> None:
        """Make an object another one, by its sizes [m] and type; it stands as high as the first one did."""
        self._refuse_laden(name)
        self._check_limits(name, features)
        problem, under_it = self._problem(), 0.0
        if name in self._stacks():
            under_it = problem.object_named(name).position[2] - scene_editor.table_height(problem, name)
        changed = scene_editor.resized(problem, name, features, self.library.categorise, under_it)
        was, now = (one.object_named(name).category for one in (problem, changed))
        self._change(changed, "scene")
        if was != now:
            self.say(f"{name} turns from {was} to {now}")

    @at_rest
    def add(self, features: tuple[float, ...]) -> None:
        """Add an object where there is room."""
        if self.problem and len(self.problem.objects) >= MOST_OBJECTS:
            raise InvalidValue(f"There are {MOST_OBJECTS} objects already, the most that are simulated.")
        self._check_limits("the object", features)
        table, middle = self.library.grounding.table, self.library.middle
        x, y = scene_editor.free_spot(self.problem, features, table, middle)
        self._change(scene_editor.with_object(self.problem, features, x, y, self.library.categorise), "scene")

    @at_rest
    def remove(self, name: str) -> None:
        """Take an object away."""
        self._refuse_laden(name)
        self._change(_by_hand(scene_editor.without_object(self._problem(), name)), "scene")

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
        """Return what is on the table with the kinds of its pairs, worked out once for the objects."""
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

    def _check_limits(self, name: str, features: tuple[float, ...]) -> None:
        if limits := limits_of(self.library.world):
            named = tuple(WORDS.get(one, one) for one in limits.feature_names)
            replace(limits, feature_names=named).check(name, features)

    def _refuse_laden(self, name: str) -> None:
        if loads := loads_of(name, self._stacks()):
            raise InvalidValue(f"{name} bears {' and '.join(loads)}; drag that away first.")

    def _change_goal(self, name: str, problem: Problem) -> None:
        """Put a problem on the table in which an object has another goal, or one for the first time."""
        self._change(_by_hand(problem), "place" if name in self.ghosts() else "scene")

    def _change(self, problem: Problem, topic: Topic) -> None:
        self.problem = problem
        self.tell(topic)


def _by_hand(problem: Problem) -> Problem:
    """Return a problem whose goals are by hand, so that no condition is asked for any longer."""
    return msgspec.structs.replace(problem, conditions=(), headings={}, asked_within=None)
