"""What practice came to: `practice.json`, and the operators as they are after it."""

import msgspec

from neurosym.errors import InvalidFile
from neurosym.operators import OperatorTable
from neurosym.practice.rounds import Practised
from neurosym.reading import digest, read_json
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import PRACTICE, PRIMITIVES

FORMAT = "neurosym-practice-1"


class PracticeFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What was practised.

    Attributes:
        format: Version of this file.
        of: SHA-256 of the `primitives.json` that practice began with.
        seed: Where its draws started.
        evenly: Whether all operators were rehearsed in turn instead.
        practised: The operators that it came to, and the rounds.
    """

    format: str
    of: str
    seed: int
    evenly: bool
    practised: Practised


def practice_of(folder: DomainFolder) -> PracticeFile | None:
    """Return what was practised with the operators that the folder has; None if nothing was.

    Args:
        folder: The domain folder.

    Raises:
        InvalidFile: If the file is none.
    """
    path = folder / PRACTICE
    if not (path.is_file() and (folder / PRIMITIVES).is_file()):
        return None
    found = read_json(path, PracticeFile, "; remove it to go back to what was distilled")
    if found.format != FORMAT:
        raise InvalidFile(path, f"it is of the format {found.format!r}, and this version reads {FORMAT!r}")
    return found if found.of == digest(folder / PRIMITIVES) else None


def operator_table(folder: DomainFolder) -> OperatorTable:
    """Read the operators as they are now: after practice, those that it came to.

    Args:
        folder: The domain folder.

    Raises:
        StageMissing: If there is no `primitives.json`.
        InvalidFile: If a file is none, or of another version.
    """
    distilled = OperatorTable.load(folder.require(PRIMITIVES))
    found = practice_of(folder)
    return found.practised.table if found else distilled
