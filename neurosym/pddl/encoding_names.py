"""The encodings of a domain, by name."""

from typing import Literal

from neurosym.grounding import Grounding

EncodingName = Literal["strips", "numeric", "sas"]

STRIPS: EncodingName = "strips"
"""The page: lifted actions, places, relations, and cells for what can only be pushed."""
NUMERIC: EncodingName = "numeric"
"""Positions are numbers; there are no cells, places and relations."""
SAS: EncodingName = "sas"
"""No PDDL: what Fast Downward's search reads of objects that are led over cells."""
ENCODINGS: tuple[EncodingName, ...] = (STRIPS, NUMERIC)
"""Those that are printed."""
DURATIVE = "durative"
"""Objects are carried by actions that take time; no command plans in it."""
FORMER = ("stepwise", "operators", "places", "relational", "relational-lifted")
"""What earlier versions had in the place of `strips`."""


def domain_name(grounding: Grounding, encoding: str) -> str:
    """Name the domain in an encoding, like `tabletop-numeric`; the page has the name of the domain itself."""
    return grounding.name if encoding in (STRIPS, SAS) else f"{grounding.name}-{encoding}"
