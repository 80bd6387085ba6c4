"""What fitting the rehearsals of a grounding came to, kept beside it so that it is not sought at each call.

A fit seeks how far outcomes reach, how noisy they are, and which features decide, each among few; the rest
follows in no time. So that is what the file holds, with the digest of the grounding that it was found for.
Where it is missing, damaged, or of another grounding, it is sought anew.
"""

import hashlib
from collections.abc import Iterable, Mapping
from pathlib import Path

import msgspec

from neurosym.errors import InvalidFile
from neurosym.files import digests, write_json
from neurosym.operators import Category, LegalName, Operator
from neurosym.reading import MEGABYTE, decode_json, read_bytes
from neurosym.regression import Choice

NAME = "fits.json"
"""What the file is called, beside the grounding."""
FORMAT = "neurosym-fits-1"
_MOST = 64 * MEGABYTE
_found: dict[str, tuple[Operator, Category | None, Choice]] = {}  # for the grounding that was read last


class _Fits(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    format: str
    grounding: str
    choices: dict[LegalName, Choice]


def save_fits(grounding_file: Path, choices: Mapping[str, Choice]) -> None:
    """Write what was found beside a grounding.

    Args:
        grounding_file: The grounding; it is there, or will be when `Drafts` are put in place.
        choices: What was found for its operators, by name.
    """
    (digest,) = digests({NAME: grounding_file}).values()
    write_json(grounding_file.with_name(NAME), _Fits(FORMAT, digest, dict(sorted(choices.items()))))


def remember_fits(
    grounding_file: Path, content: bytes, operators: Iterable[Operator], categories: Iterable[Category]
) -> None:
    """Read what was found for a grounding, if that is known.

    Args:
        grounding_file: Where the grounding was read.
        content: What it was read from.
        operators: Its operators.
        categories: Its categories.
    """
    _found.clear()
    path = grounding_file.with_name(NAME)
    try:
        fits = decode_json(path, read_bytes(path, _MOST), _Fits)
    except InvalidFile:
        return
    if fits.format != FORMAT or fits.grounding != hashlib.sha256(content).hexdigest():
        return
    by_symbol = {category.symbol: category for category in categories}
    for operator in operators:
        if choice := fits.choices.get(operator.name):
            _found[operator.name] = (operator, by_symbol.get(operator.category), choice)


def found_for(operator: Operator, category: Category) -> Choice | None:
    """Return what fitting an operator's rehearsals came to, if it is known.

    Args:
        operator: The operator; what is known is of one that is the same in everything.
        category: Its category; likewise.
    """
    *known, choice = _found.get(operator.name, (None, None, None))
    return choice if known == [operator, category] else None
