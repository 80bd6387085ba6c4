"""The PDDL planners by name: what each is, which encodings it takes, and how it is called."""

import importlib.util
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from neurosym.errors import UnknownChoice
from neurosym.pddl.moves import SAS, Encoding
from neurosym.planners.external import (
    ENHSP,
    FORBID_ITERATIVE,
    KAIROS,
    KSTAR,
    LPG,
    SYMK,
    PlannerMissing,
    Program,
    plan_program,
)
from neurosym.planners.fast_downward import LAMA_FIRST, Search, plan_fast_downward
from neurosym.planners.result import PlannerAnswer
from neurosym.planners.unified_planning import plan_unified_planning

Solve = Callable[..., PlannerAnswer]
GRID: tuple[Encoding, ...] = ("stepwise", "operators")
COARSE = 0.02
"""Edge of the cells for planners that fine grids are too much for [m]."""


@dataclass(frozen=True, slots=True)
class PddlPlanner:
    """A planner that takes PDDL, or what PDDL is translated to.

    Attributes:
        about: What it is, in a sentence.
        solve: Takes the files of domain and problem and a limit [s], and answers.
        encodings: Those that it takes, the one it does best with first.
        cell: Edge of the smallest cells that it is given at first, 0 for any [m]; a plan that is not true
            when replayed is sought again on a finer grid.
        missing: Says what to do about what is not installed, or nothing if everything is.
    """

    about: str
    solve: Solve
    encodings: tuple[Encoding, ...] = GRID
    cell: float = 0.0
    missing: Callable[[], str] = str

    def encoding_for(self, planner: str, asked: Encoding | None) -> Encoding:
        """Return the encoding asked for, or the one that the planner does best with.

        Args:
            planner: Name of the planner.
            asked: The encoding asked for, if any.

        Raises:
            UnknownChoice: If the planner does not take it.
        """
        if asked is not None and asked not in self.encodings:
            raise UnknownChoice(f"encoding for {planner}", asked, self.encodings)
        return asked or self.encodings[0]

    def check_installed(self, planner: str) -> None:
        """Raise `PlannerMissing`, which says what to do, unless the planner is installed."""
        if remedy := self.missing():
            raise PlannerMissing(planner, remedy)


def _missing(*packages: str) -> str:
    """Say what brings the first of some packages that is not there."""
    absent = (package for package in packages if importlib.util.find_spec(package) is None)
    return next((f"`pip install {package.replace('_', '-')}` brings it" for package in absent), "")


def _fast_downward(about: str, search: str | None = None) -> PddlPlanner:
    solve = partial(plan_fast_downward, searches=(Search(search),)) if search else plan_fast_downward
    return PddlPlanner(about, solve, (SAS, *GRID), missing=partial(_missing, "up_fast_downward"))


def _unified(about: str, engine: str, package: str, cell: float = 0.0) -> PddlPlanner:
    solve = partial(plan_unified_planning, engine=engine)
    return PddlPlanner(about, solve, cell=cell, missing=partial(_missing, package))


def _program(about: str, program: Program, *encodings: Encoding, cell: float = 0.0) -> PddlPlanner:
    solve = partial(plan_program, program=program)
    return PddlPlanner(about, solve, encodings or GRID, cell, program.missing)


PDDL_PLANNERS: dict[str, PddlPlanner] = {
    "fast-downward": _fast_downward("Fast Downward: the cheapest plan if it can be had soon"),
    "lama-first": _fast_downward("Fast Downward's LAMA, the first plan it finds", LAMA_FIRST),
    "lmcut": _fast_downward("Fast Downward's A* with landmark cuts: the cheapest plan", "astar(lmcut())"),
    "up-fast-downward": _unified(
        "Fast Downward through unified-planning, several times slower",
        "fast-downward",
        "up_fast_downward",
        COARSE,
    ),
    "up-fast-downward-opt": _unified(
        "Fast Downward through unified-planning, A* with landmark cuts",
        "fast-downward-opt",
        "up_fast_downward",
        COARSE,
    ),
    "kairos": _program("Kairos, on numbers or on a grid", KAIROS, "numeric", *GRID),
    "enhsp": _program("ENHSP, on numbers (needs Java)", ENHSP, "numeric", *GRID),
    "lpg": _program("LPG-td, local search on numbers: soon there, with longer plans", LPG, "numeric", *GRID),
    "symk": _program("SymK, symbolic search: the cheapest plan on its grid", SYMK, cell=COARSE),
    "kstar": _program("K*, top-k planning: the cheapest plan on its grid", KSTAR, cell=COARSE),
    "forbid-iterative": _program("Forbid-Iterative, top-k planning", FORBID_ITERATIVE, cell=COARSE),
    "pyperplan": _unified("pyperplan, written for teaching", "pyperplan", "up_pyperplan", COARSE),
    "aries": _unified("Aries, by constraint solving", "aries", "up_aries", COARSE),
}
"""Planners that take our PDDL, by the name that the command line knows them by."""
