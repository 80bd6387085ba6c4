"""How surely operators are foreseen to keep their promises with the pairs at hand, in a few grades.

Chances go into a problem as one of these words. So what an operator costs is a number for each word, however
many pairs there are.
"""

from collections.abc import Mapping

USUAL = "usual"
"""The grade of pairs of which nothing is foreseen: they do as others of their kind."""
GRADES: Mapping[str, float] = {"hardly": 0.1, "seldom": 0.3, "often": 0.5, "mostly": 0.7, "surely": 0.9}
"""In which share of the cases a promise is kept with pairs of the other grades; plans tell no finer."""


def grade_of(share: float) -> str:
    """Return the grade that is nearest.

    Args:
        share: In which share of the cases a promise is foreseen to be kept.
    """
    return min(GRADES, key=lambda grade: abs(GRADES[grade] - share))
