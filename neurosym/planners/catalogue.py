"""The planners by name: what each is, which encodings it takes, how it is called, and what brings it."""

import importlib.util
import math
from functools import partial

from neurosym.pddl.encoding_names import SAS, EncodingName
from neurosym.planners.external import (
    ENHSP,
    FORBID_ITERATIVE,
    KAIROS,
    KSTAR,
    LPG,
    SYMK,
    Program,
    plan_program,
)
from neurosym.planners.fast_downward import LAMA_FIRST, Search, plan_fast_downward
from neurosym.planners.planner import ON_PAGE, Planner
from neurosym.planners.refinement import pddl_planner
from neurosym.planners.searches import SEARCHES
from neurosym.planners.unified_planning import plan_unified_planning

COARSE = 0.02
"""Edge of the cells for planners that fine grids are too much for [m]."""


def _missing(*packages: str) -> str:
    """Say what brings the first of some packages that is not there."""
    absent = (package for package in packages if importlib.util.find_spec(package) is None)
    return next((f"`pip install {package.replace('_', '-')}` brings it" for package in absent), "")


def _fast_downward(name: str, about: str, search: str | None = None) -> Planner:
    call = partial(plan_fast_downward, searches=(Search(search),)) if search else plan_fast_downward
    missing = partial(_missing, "up_fast_downward")
    aims = search is None
    return pddl_planner(name, about, call, (SAS, *ON_PAGE), missing=missing, ceiling=math.inf, aims=aims)


def _unified(name: str, about: str, engine: str, package: str, *, costs: bool = True) -> Planner:
    call = partial(plan_unified_planning, engine=engine)
    missing = partial(_missing, package)
    return pddl_planner(name, about, call, cell=COARSE, missing=missing, costs=costs)


def _program(name: str, about: str, program: Program, *encodings: EncodingName, cell: float = 0.0) -> Planner:
    call = partial(plan_program, program=program)
    return pddl_planner(name, about, call, encodings or ON_PAGE, cell, program.missing)


PROGRAMS = (
    _fast_downward(
        "fast-downward", "Fast Downward: the cheapest plan if 256 MB suffice for it, else LAMA's first"
    ),
    _fast_downward("lama-first", "Fast Downward's LAMA, the first plan it finds", LAMA_FIRST),
    _fast_downward("lmcut", "Fast Downward's A* with landmark cuts: the cheapest plan", "astar(lmcut())"),
    _unified(
        "up-fast-downward",
        "Fast Downward through unified-planning, several times slower",
        "fast-downward",
        "up_fast_downward",
    ),
    _unified(
        "up-fast-downward-opt",
        "Fast Downward through unified-planning, A* with landmark cuts",
        "fast-downward-opt",
        "up_fast_downward",
    ),
    _program("kairos", "Kairos, on numbers or on a grid", KAIROS, "numeric", *ON_PAGE),
    _program("enhsp", "ENHSP, on numbers (needs Java)", ENHSP, "numeric", *ON_PAGE),
    _program(
        "lpg", "LPG-td, local search on numbers: soon there, with longer plans", LPG, "numeric", *ON_PAGE
    ),
    _program("symk", "SymK, symbolic search: the cheapest plan on its grid", SYMK, cell=COARSE),
    _program("kstar", "K*, top-k planning: the cheapest plan on its grid", KSTAR, cell=COARSE),
    _program("forbid-iterative", "Forbid-Iterative, top-k planning", FORBID_ITERATIVE, cell=COARSE),
    _unified("pyperplan", "pyperplan, written for teaching", "pyperplan", "up_pyperplan", costs=False),
    _unified("aries", "Aries, by constraint solving", "aries", "up_aries", costs=False),
)
PLANNERS: dict[str, Planner] = {planner.name: planner for planner in (*SEARCHES, *PROGRAMS)}
"""The planners, by the name that the command line knows them by; `register_planner` adds one."""
