"""The table of operators that carry objects to places, beside that of displacements.

What such an operator promises is where its object stands relative to the place.
"""

from pathlib import Path

import msgspec

from neurosym.checks import check_fields
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.operators import Count, LegalName, OperatorTable, unknown_format
from neurosym.reading import read_json

FORMAT = "neurosym-places-1"
NEVER_CARRIES = "never carries"
"""Why an operator is not in the domain."""


class Kept(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How an operator turned out where there were other objects.

    Attributes:
        name: Name of the operator.
        trials: How many rehearsals there were.
        kept: How many ended as promised, on the table, with nothing else moved.
    """

    name: LegalName
    trials: Count
    kept: Count

    def __post_init__(self) -> None:
        check_fields(self)

    @property
    def share(self) -> float:
        """The share that ended so; 1 if there were no rehearsals."""
        return self.kept / self.trials if self.trials else 1.0


class PlaceOperators(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Operators that carry objects to places.

    The last two tables are there where objects bear one another.

    Attributes:
        operators: What each primitive does to each category; effects are relative to the place.
        occupied: How they turned out where another object stood on the place.
        beside: How they turned out where others stood close around the object.
        format: Version of this table.
        borne: How they turned out where the object rested on another one.
        laden: How they turned out where another one rested on the object; kept if that went along.
    """

    operators: OperatorTable
    occupied: tuple[Kept, ...] = ()
    beside: tuple[Kept, ...] = ()
    format: str = FORMAT
    borne: tuple[Kept, ...] | msgspec.UnsetType = msgspec.UNSET
    laden: tuple[Kept, ...] | msgspec.UnsetType = msgspec.UNSET

    def __post_init__(self) -> None:
        check_fields(self)
        if self.format != FORMAT:
            raise InvalidValue(unknown_format(self.format, (FORMAT,)))

    @classmethod
    def load(cls, path: Path) -> "PlaceOperators":
        """Read a table.

        Raises:
            InvalidFile: If the file is none, or of another version.
        """
        found = read_json(path, _Versioned).format
        if found != FORMAT:
            raise InvalidFile(path, unknown_format(found, (FORMAT,)))
        return read_json(path, cls)


class _Versioned(msgspec.Struct, frozen=True):
    format: str
