"""Whom a page asks for plans."""

from neurosym.planners import PLANNERS

USUAL = "fast-downward"
"""Who is asked if it is there."""


def planners_here() -> tuple[str, ...]:
    """Name the planners of which nothing is missing."""
    return tuple(name for name, planner in PLANNERS.items() if not planner.missing())


def usual_planner() -> str:
    """Name whom to ask if nobody says whom: `USUAL`, or else the first planner that is there."""
    names = planners_here()
    return USUAL if USUAL in names else names[0]
