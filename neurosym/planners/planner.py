"""What a planner is: a value that says what it reads, what it takes, how it solves, and how to install it.

Ours stand in one dict (`catalogue.PLANNERS`); anybody's own is one more (docs/own-planner.md).
"""

import sys
from collections.abc import Callable, Collection
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, Protocol, get_args

import numpy as np

from neurosym.arrays import Float
from neurosym.checks import check_kind
from neurosym.errors import InvalidPlanner, InvalidValue, NeurosymError
from neurosym.grounding import Grounding
from neurosym.pddl.encoding_names import ENCODINGS, SAS, STRIPS, EncodingName
from neurosym.pddl.encodings import check_former
from neurosym.planners.result import PlannerAnswer, PlanResult
from neurosym.problems import LEGAL_NAME, Problem

Option = Literal["encoding", "whole", "unit-costs"]
PredictEffects = Callable[[Float[np.ndarray, "M F"]], Float[np.ndarray, "M P 3"]]
"""Says what the network predicts each primitive to do to objects of these features [m]."""
Tell = Callable[[str], None]
"""Is told in a few words what a planner goes on with."""
CEILING = 60.0
"""When planners give up that count no work, if the user sets no limit [s]."""
ON_PAGE: tuple[EncodingName, ...] = (STRIPS,)


def _say_nothing(text: str) -> None:
    del text


class PlannerMissing(NeurosymError):
    """A planner, or something that it needs, is not installed."""

    def __init__(self, planner: str, remedy: str):
        super().__init__(f"{planner} is not installed; {remedy}.")


@dataclass(frozen=True, slots=True, eq=False)
class Query:
    """What a planner is asked.

    Attributes:
        problem: The problem.
        grounding: The learned domain; it says whether every step costs the same.
        predict: What the network predicts; None for planners that do not read it, or where there is none.
        time_limit: The user's ceiling, which may be infinite [s].
        encoding: The encoding to plan in; None for the one that the planner does best with.
        whole: Whether to plan for all objects at once instead of one by one.
        work: How much may be looked at in all [states, see `effort`], for planners that count that.
        tell: Told what is tried, by planners that try one thing after another.
    """

    problem: Problem
    grounding: Grounding
    predict: PredictEffects | None = None
    time_limit: float = CEILING
    encoding: EncodingName | None = None
    whole: bool = False
    work: int = sys.maxsize
    tell: Tell = _say_nothing

    def __post_init__(self) -> None:
        check_kind("problem", self.problem, Problem, "a Problem")
        check_kind("grounding", self.grounding, Grounding, "a Grounding")


class PddlCall(Protocol):
    """Has a program read the files of a domain and a problem."""

    def __call__(self, domain: Path, problem: Path, *, time_limit: float) -> PlannerAnswer:
        """Return what the program answers before the time limit [s] is up."""
        ...


@dataclass(frozen=True, slots=True)
class PddlProgram:
    """What takes files of PDDL, or what PDDL is translated to.

    Attributes:
        call: Has it read the files and answer.
        encodings: Those that it takes, the one it does best with first.
        cell: Edge of the smallest cells that it is given at first, 0 for any [m]; a plan that is not true
            when replayed is sought again on a finer grid.
        aims: Whether its plans keep from the edges of the table, and give way to those that cost little more
            and are likelier to come true.
        costs: Whether it is told what steps cost; some programs read no prices.
    """

    call: PddlCall
    encodings: tuple[EncodingName, ...] = ON_PAGE
    cell: float = 0.0
    aims: bool = False
    costs: bool = True

    def encoding_for(self, planner: str, asked: EncodingName | None) -> EncodingName:
        """Return the encoding asked for, or the one that the planner does best with.

        Args:
            planner: Name of the planner.
            asked: The encoding asked for, if any.

        Raises:
            InvalidValue: If the planner does not take it.
        """
        if asked is not None and asked not in self.encodings:
            check_former(asked)
            valid = ", ".join(sorted(self.encodings))
            raise InvalidValue(f"{planner} does not take the encoding {asked!r}; valid: {valid}.")
        return asked or self.encodings[0]


@dataclass(frozen=True, slots=True)
class Planner:
    """A planner.

    Attributes:
        name: What it is called on the command line and in the names of files.
        about: What it is, in a sentence without a full stop.
        solve: Solves a problem; finding no plan is a result.
        reads: Whether it plans over what the operators promise, or over what the network predicts.
        takes: The options that it takes.
        depth: How many primitives it looks ahead; None if there is no limit.
        is_exact: Whether counting finds no plan where it finds none.
        ceiling: When it gives up if the user sets no limit [s]; infinite if its budget counts work instead,
            so that what it finds does not depend on the machine.
        program: What it gives files of PDDL to, if it does.
        missing: Says what to do about what is not installed, or nothing if everything is.

    Raises:
        InvalidPlanner: If something of this cannot be.
    """

    name: str
    about: str
    solve: Callable[[Query], PlanResult]
    reads: Literal["operators", "network"] = "operators"
    takes: frozenset[Option] = frozenset()
    depth: int | None = None
    is_exact: bool = False
    ceiling: float = CEILING
    program: PddlProgram | None = None
    missing: Callable[[], str] = str

    def __post_init__(self) -> None:
        if not isinstance(self.name, str) or not LEGAL_NAME.fullmatch(self.name):
            raise InvalidPlanner(repr(self.name), "is no name; valid: a lower-case letter, a-z, 0-9, hyphens")
        known = {SAS, *ENCODINGS}
        is_time = isinstance(self.ceiling, int | float) and not isinstance(self.ceiling, bool)
        takes = isinstance(self.takes, Collection) and {*self.takes} <= {*get_args(Option)}
        encodings = self.encodings
        for part, given, is_right, valid in (
            ("solve", self.solve, callable(self.solve), "a function of a Query"),
            ("missing", self.missing, callable(self.missing), "a function that returns text"),
            ("about", self.about, isinstance(self.about, str), "text"),
            ("takes", self.takes, takes, "encoding, whole, unit-costs"),
            ("ceiling", self.ceiling, is_time and self.ceiling > 0, "a time above 0 s"),
            ("reads", self.reads, self.reads in ("operators", "network"), "operators, network"),
            (
                "encodings",
                encodings,
                not self.program or (encodings and {*encodings} <= known),
                f"one or more of {', '.join(sorted(known))}",
            ),
        ):
            if not is_right:
                raise InvalidPlanner(self.name, f"has {part} = {given!r}; valid: {valid}")

    @property
    def encodings(self) -> tuple[EncodingName, ...]:
        """The encodings of the domain that it takes; none for a planner that reads no PDDL."""
        return self.program.encodings if self.program else ()
