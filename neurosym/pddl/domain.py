"""Printing a learned domain as PDDL."""

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding
from neurosym.pddl.moves import ENCODINGS, FORMER, NUMERIC, STRIPS, Encoding
from neurosym.pddl.numeric import numeric_domain
from neurosym.pddl.strips import page


def domain_text(grounding: Grounding, encoding: Encoding = STRIPS, *, costs: bool = True) -> str:
    """Print the domain; equal groundings give equal bytes.

    Args:
        grounding: The learned domain.
        encoding: `strips` for the page, or `numeric` for planners that take numbers.
        costs: Whether what steps cost is printed; some planners take no costs.

    Raises:
        UnknownChoice: If there is no such encoding.
    """
    check_encoding(encoding)
    domain = numeric_domain(grounding) if encoding == NUMERIC else page(grounding)
    return domain.text(costs=costs)


def check_encoding(encoding: str) -> None:
    """Raise unless there is such an encoding.

    Args:
        encoding: Its name.

    Raises:
        InvalidValue: If earlier versions had it.
        UnknownChoice: If there is none.
    """
    check_former(encoding)
    if encoding not in ENCODINGS:
        raise UnknownChoice("encoding", encoding, ENCODINGS)


def check_former(encoding: str) -> None:
    """Raise `InvalidValue` if earlier versions had an encoding, and it is gone.

    Args:
        encoding: Its name.
    """
    if encoding in FORMER:
        raise InvalidValue(
            f"The encoding {encoding} is gone: one page, {STRIPS!r}, says what it said; valid: "
            f"{', '.join(ENCODINGS)}."
        )
