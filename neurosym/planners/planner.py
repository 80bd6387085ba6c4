"""What a planner is: a value that says what it reads, what it takes, how it solves, and how to install it.

Ours stand in one dict (`registry.PLANNERS`); anybody's own is one more (docs/own-planner.md).
"""

import dataclasses
import math
import sys
import time
from collections.abc import Callable, Collection
from dataclasses import dataclass
from enum import Enum
from typing import Literal, TypeVar, get_args

import msgspec
import numpy as np

from neurosym.checks import Float, check_kind
from neurosym.choices import one_line
from neurosym.errors import InvalidPlanner, InvalidValue, NeurosymError
from neurosym.grounding import Grounding
from neurosym.pddl.syntax import ENCODINGS, SAS, STRIPS, EncodingName
from neurosym.problems import LEGAL_NAME, Problem
from neurosym.tasks.transition import PlanStep

# What every planner returns

LONGEST_REASON = 400
"""How many characters of a reason that somebody else's planner gives are kept."""


class PlanStatus(Enum):
    """How a search for a plan ended.

    `NEAREST` is a plan that comes as near to the goal as was found. `UNSOLVABLE` means proved: there is no
    plan. `NOT_FOUND` is a search that came to its own end, in depth or work, and proves nothing; `TIMEOUT`
    is one that the user's limit of time ended.
    """

    SOLVED = "solved"
    NEAREST = "nearest"
    UNSOLVABLE = "unsolvable"
    NOT_FOUND = "not found"
    TIMEOUT = "timeout"
    FAILED = "failed"


@dataclass(frozen=True, slots=True)
class PlanResult:
    """The outcome of planning; finding no plan is an outcome, not an error."""

    status: PlanStatus  #: How the search ended
    steps: tuple[PlanStep, ...]  #: The plan; empty unless solved or nearest
    seconds: float  #: How long it took [s]
    reason: str = ""  #: Why there is no plan, or what is to be said about the one found
    depth: int | None = None  #: How many primitives were looked ahead, by a search that ended there
    work: int = 0  #: How much was looked at for it [states, see `Effort`]; 0 if that is not known

    @property
    def has_plan(self) -> bool:
        """Whether there is a plan, be it to the goal or only as near to it as can be."""
        return self.status in (PlanStatus.SOLVED, PlanStatus.NEAREST)


MET_AT_START = PlanResult(PlanStatus.SOLVED, (), 0.0, "the goal is met at the start")


@dataclass(frozen=True, slots=True)
class PlannerAnswer:
    """What a PDDL planner says: the text of a plan if it found one."""

    status: PlanStatus  #: How the search ended
    text: str = ""  #: The plan in IPC form; empty unless solved
    seconds: float = 0.0  #: How long it took [s]
    reason: str = ""  #: The planner's last words if there is no plan
    work: int | None = None  #: How much it looked at [states, see `Effort`]; None if that is not known


Option = Literal["encoding", "whole", "unit-costs"]
PddlCall = Callable[..., PlannerAnswer]
"""Takes the files of a domain and a problem, and `time_limit` [s], and returns what a program answers."""
PredictEffects = Callable[[Float[np.ndarray, "M F"]], Float[np.ndarray, "M P 3"]]
"""Says what the network predicts each primitive to do to objects of these features [m]."""
Tell = Callable[[str], None]
"""Is told in a few words what a planner goes on with."""
CEILING = 60.0
"""When planners give up that count no work, if the user sets no limit [s]."""
ON_PAGE: tuple[EncodingName, ...] = (STRIPS,)


_Given = TypeVar("_Given", PlanResult, PlannerAnswer)


def checked(name: str, given: object, kind: type[_Given], source: str) -> _Given:
    """Return what somebody's own planner gives, its reason in one line, or refuse another kind."""
    if not isinstance(given, kind):
        found, valid = type(given).__name__, kind.__name__
        raise InvalidPlanner(name, f"gives a {found} from {source}; valid: a {valid}")
    parts = {part.name: getattr(given, part.name) for part in dataclasses.fields(kind)}
    try:
        msgspec.convert(parts, kind, from_attributes=True)
    except msgspec.ValidationError as error:
        raise InvalidPlanner(name, f"gives a {kind.__name__} with a wrong part: {error}") from error
    return dataclasses.replace(given, reason=one_line(given.reason, LONGEST_REASON))


def say_nothing(text: str) -> None:
    """Tell nobody."""
    del text


class PlannerMissing(NeurosymError):
    """A planner, or something that it needs, is not installed."""

    def __init__(self, planner: str, remedy: str):
        super().__init__(f"{planner} is not installed; {remedy}.")


@dataclass(frozen=True, slots=True, eq=False)
class Query:
    """What a planner is asked."""

    problem: Problem  #: The problem
    grounding: Grounding  #: The learned domain; it says whether every step costs the same
    #: What the network predicts; None for planners that do not read it, or where there is none
    predict: PredictEffects | None = None
    time_limit: float = CEILING  #: The user's ceiling, which may be infinite [s]
    #: The encoding to plan in; None for the one that the planner does best with
    encoding: EncodingName | None = None
    whole: bool = False  #: Whether to plan for all objects at once instead of one by one
    #: How much may be looked at in all [states, see `Effort`], for planners that count that
    work: int = sys.maxsize
    tell: Tell = say_nothing  #: Told what is tried, by planners that try one thing after another

    def __post_init__(self) -> None:
        check_kind("problem", self.problem, Problem, "a Problem")
        check_kind("grounding", self.grounding, Grounding, "a Grounding")


@dataclass(frozen=True, slots=True)
class PddlProgram:
    """What takes files of PDDL, or what PDDL is translated to; `pddl_planner` says what each part is."""

    call: PddlCall
    encodings: tuple[EncodingName, ...] = ON_PAGE
    cell: float = 0.0
    aims: bool = False
    costs: bool = True

    def encoding_for(self, planner: str, asked: EncodingName | None) -> EncodingName:
        """Return the encoding asked for, or the one that the planner of a name does best with."""
        if asked is not None and asked not in self.encodings:
            valid = ", ".join(sorted(self.encodings))
            raise InvalidValue(f"{planner} does not take the encoding {asked!r}; valid: {valid}.")
        return asked or self.encodings[0]


@dataclass(frozen=True, slots=True)
class Planner:
    """A planner; `InvalidPlanner` is raised if something of it cannot be."""

    name: str  #: What it is called on the command line and in the names of files
    about: str  #: What it is, in a sentence without a full stop
    solve: Callable[[Query], PlanResult]  #: Solves a problem; finding no plan is a result
    #: Whether it plans over what the operators promise, or over what the network predicts
    reads: Literal["operators", "network"] = "operators"
    takes: frozenset[Option] = frozenset()  #: The options that it takes
    depth: int | None = None  #: How many primitives it looks ahead; None if there is no limit
    is_exact: bool = False  #: Whether counting finds no plan where it finds none
    #: When it gives up if the user sets no limit [s]; infinite if its budget counts work instead, so that
    #: what it finds does not depend on the machine
    ceiling: float = CEILING
    program: PddlProgram | None = None  #: What it gives files of PDDL to, if it does
    #: Says what to do about what is not installed, or nothing if everything is
    missing: Callable[[], str] = str

    def __post_init__(self) -> None:
        if not isinstance(self.name, str) or not LEGAL_NAME.fullmatch(self.name):
            raise InvalidPlanner(repr(self.name), "is no name; valid: a lower-case letter, a-z, 0-9, hyphens")
        known, encodings = {SAS, *ENCODINGS}, self.encodings
        is_time = isinstance(self.ceiling, int | float) and not isinstance(self.ceiling, bool)
        takes = isinstance(self.takes, Collection) and {*self.takes} <= {*get_args(Option)}
        is_known = not self.program or (encodings and {*encodings} <= known)
        for part, given, is_right, valid in (
            ("solve", self.solve, callable(self.solve), "a function of a Query"),
            ("missing", self.missing, callable(self.missing), "a function that returns text"),
            ("about", self.about, isinstance(self.about, str), "text"),
            ("takes", self.takes, takes, "encoding, whole, unit-costs"),
            ("ceiling", self.ceiling, is_time and self.ceiling > 0, "a time above 0 s"),
            ("reads", self.reads, self.reads in ("operators", "network"), "operators, network"),
            ("encodings", encodings, is_known, f"one or more of {', '.join(sorted(known))}"),
        ):
            if not is_right:
                raise InvalidPlanner(self.name, f"has {part} = {given!r}; valid: {valid}")

    @property
    def encodings(self) -> tuple[EncodingName, ...]:
        """The encodings of the domain that it takes; none for a planner that reads no PDDL."""
        return self.program.encodings if self.program else ()


# What a search may spend: work, which is counted, and never more time than the user allows.
#
# Plans must not depend on how fast a machine is, or how busy. So every budget of ours counts what is looked
# at, in states: one that A* without a heuristic looks at is 1, and others weigh as many of these as they take
# as long as. A limit of time ends planning as a whole, with no plan instead of another one.

PLACE = 10
"""How many states a place, a candidate or a beginning of a plan counts for that is looked at in Python."""
UNTOLD = 200_000
"""How many states a search counts for that does not tell."""


class TimeIsUp(Exception):
    """The user's ceiling cut in; whoever set the deadline turns this into a result."""


class WorkIsUp(Exception):
    """A budget that several searches share is spent; whoever set it turns this into a result."""


@dataclasses.dataclass(slots=True)
class Effort:
    """What was spent of a budget."""

    #: How much may be looked at: states, or beginnings of plans and ways to join them
    work: int = sys.maxsize
    deadline: float = math.inf  #: When the user's time is up, by `time.perf_counter()` [s]
    spent: int = 0  #: How much was

    def spend(self, amount: int = 1) -> bool:
        """Count some work, and say whether any is left; `TimeIsUp` is raised if the deadline has passed."""
        check_time(self.deadline)
        self.spent += amount
        return not self.is_used_up

    @property
    def left(self) -> float:
        """How much time is left, which may be infinite [s]."""
        return self.deadline - time.perf_counter()

    def check(self) -> None:
        """Raise `TimeIsUp` or `WorkIsUp` if nothing may be spent any longer."""
        check_time(self.deadline)
        if self.is_used_up:
            raise WorkIsUp

    @property
    def is_used_up(self) -> bool:
        """Whether the budget is spent, so that finding nothing means little."""
        return self.spent >= self.work


def check_time(deadline: float) -> None:
    """Raise `TimeIsUp` if a deadline by `time.perf_counter()` has passed."""
    if time.perf_counter() > deadline:
        raise TimeIsUp


def within(time_limit: float, search: Callable[[float], PlanResult]) -> PlanResult:
    """Search until a deadline by `time.perf_counter()`, so many seconds from now, and say how long that took.

    If it passes, that is the result, whatever was found by then.
    """
    begin = time.perf_counter()
    try:
        found = search(begin + time_limit)
    except TimeIsUp:
        reason = f"the time limit of {time_limit:g} s cut in"
        found = PlanResult(PlanStatus.TIMEOUT, (), 0.0, reason)
    return dataclasses.replace(found, seconds=time.perf_counter() - begin)
