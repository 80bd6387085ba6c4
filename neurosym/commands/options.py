"""Options that several commands of the command line share."""

import math
import os
from difflib import get_close_matches
from pathlib import Path
from typing import Annotated, Literal, Optional

from tyro.conf import Positional, arg

from neurosym.choices import DrawnTask, StrategyName
from neurosym.console import say
from neurosym.errors import InvalidValue
from neurosym.files import check_writable
from neurosym.learning.model_config import DEFAULT_BITS, PAPER_BITS
from neurosym.shipped import DOMAINS, copy_shipped
from neurosym.stages.folder import DomainFolder
from neurosym.wording import quoted

Folder = Annotated[Positional[Path], arg(metavar="DIR", help="The domain folder.")]
DataPath = Annotated[
    Positional[Path],
    arg(metavar="DATA", help="A data set: an .npz file, or a folder that holds interactions.npz."),
]
ProblemName = Annotated[
    Positional[str], arg(metavar="PROBLEM", help="A problem in DIR/problems: its name or its file.")
]
Tolerance = Annotated[
    Optional[float],
    arg(
        metavar="METRES",
        help="How near objects must come to their goals, instead of the problem's own tolerance.",
    ),
]
Seed = Annotated[int, arg(help="Where all random draws start: same seed, same bytes.")]
Workers = Annotated[int, arg(help="Processes that simulate; their number does not change the result.")]
StrategyOption = Annotated[
    StrategyName,
    arg(
        help="How actions are chosen: disagreement (of several networks), entropy (the paper's, also called "
        "curiosity), random or active."
    ),
]
TimeLimit = Annotated[
    Optional[float],
    arg(
        metavar="SECONDS",
        help="Your own ceiling: when planning ends without a plan. Ours and Fast Downward need none: their "
        "budgets count work, so that plans are the same on a busy machine. Others give up after 60 s.",
    ),
]
Places = Annotated[
    int, arg(help="Interactions besides that are aimed at a place, to learn what carries objects there.")
]
Relations = Annotated[
    int,
    arg(
        help="Interactions that are aimed at another object, to learn what can be done with pairs, once it "
        "is known what carries objects to places."
    ),
]
Task = Annotated[
    Optional[DrawnTask],
    arg(
        help="What tasks ask for: goals anywhere, a swap, a row, or to clear a crowd; in a domain with "
        "relations also a tower, boxes, unstack or exchange; else as in the paper."
    ),
]
Choice = Annotated[
    Literal["own", "predictable", "lowest-error"],
    arg(
        help="Which candidate stands for a symbol: own (categories of objects have their own), "
        "predictable (the same for all), or lowest-error (the paper)."
    ),
]
RegimeName = Annotated[
    Literal["default", "quick", "paper"],
    arg(help="Network and training: default, quick (a first look), paper (as printed)."),
]


ObjectBits = Annotated[
    Optional[int],
    arg(
        help="Bits of an object symbol, 1 to 6: up to 2^bits categories of objects. By default "
        f"{DEFAULT_BITS[0]}."
    ),
]
ActionBits = Annotated[
    Optional[int],
    arg(
        help="Bits of an action symbol, 1 to 8: up to 2^bits primitives. By default "
        f"{DEFAULT_BITS[1]}, and {PAPER_BITS[1]} with quick and paper."
    ),
]


def check_file(path: Path | None, what: str, *endings: str) -> None:
    """Raise unless a file can be written, if one is asked for: by its ending, its folder, and the system.

    Args:
        path: The file.
        what: What is written there, as a sentence has it.
        endings: Those that it may have; any, if none are given.

    Raises:
        InvalidValue: If it has another ending, or stands in no folder.
        CannotWrite: If the system does not let it be written.
    """
    if path is None:
        return
    is_named = not endings or path.suffix.lower() in endings
    if not is_named or path.is_dir() or not path.absolute().parent.is_dir():
        ending = f" that ends in {' or '.join(endings)}," if endings else ""
        raise InvalidValue(f"No {what} can be written to {path}; name a file{ending} in an existing folder.")
    check_writable(path)


def check_least(least: int, **values: int) -> None:
    """Raise `InvalidValue` unless options, by their names, are at least so much."""
    for name, value in values.items():
        if value < least:
            raise InvalidValue(f"{name} = {value} must be at least {least}.")


def check_time_limit(time_limit: float | None) -> None:
    """Raise `InvalidValue` unless a ceiling is a number of seconds, if there is one."""
    if time_limit is not None and not 0 < time_limit < math.inf:
        raise InvalidValue(f"time-limit = {time_limit:g} must be a number of seconds greater than 0.")


CPUS = os.cpu_count() or 1


def opened(folder: Path) -> DomainFolder:
    """Return a domain folder that prints its notes; a shipped domain that is named is copied there first.

    Raises:
        FolderNotFound: If there is none.
        CannotWrite: If a shipped domain cannot be copied.
    """
    if len(folder.parts) == 1 and not folder.exists() and copy_shipped(folder.name, folder):
        say(f"copied the shipped domain {folder.name} to {folder.absolute()}; all results go there")
    if not folder.exists() and (meant := get_close_matches(str(folder), DOMAINS, n=1)):
        raise InvalidValue(
            f"There is no folder {folder}; the shipped domain is called {meant[0]}, and `neurosym init "
            f"{quoted(folder)}` makes a new one."
        )
    return DomainFolder(folder, notify=lambda remark: say(f"note: {remark}"))
