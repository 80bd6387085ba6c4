"""The domains that come with neurosym. They are never written into: who uses one by its name gets a copy."""

import shutil
import tempfile
from pathlib import Path

from neurosym.errors import CannotWrite

DOMAINS = ("tabletop", "places", "towers", "tabletop-paper")
"""The names of the shipped domains."""
MADE_AGAIN = ("plans", "runs", "pictures")
"""Folders of a domain that hold what a user makes anew."""
_HERE = Path(__file__).parent
_HOMES = (_HERE / "shipped_domains", _HERE.parent / "domains")  # of an installed wheel, and of a checkout


def shipped_domain(name: str) -> Path | None:
    """Return where a shipped domain lies; None if there is none of that name.

    Args:
        name: Its name.
    """
    if name not in DOMAINS:
        return None
    return next((home / name for home in _HOMES if (home / name).is_dir()), None)


def copy_shipped(name: str, folder: Path) -> bool:
    """Copy a shipped domain to a folder that does not exist, whole or not at all; say whether there is one.

    Args:
        name: Its name.
        folder: Where to; a folder that somebody else makes meanwhile stays as it is.

    Raises:
        CannotWrite: If the system does not let it be written.
    """
    if (source := shipped_domain(name)) is None:
        return False
    draft = None
    try:
        draft = Path(tempfile.mkdtemp(prefix=".neurosym-", dir=folder.absolute().parent))
        whole = draft / name
        shutil.copytree(
            source, whole, ignore=shutil.ignore_patterns(*MADE_AGAIN), copy_function=shutil.copyfile
        )
        if not folder.exists():
            whole.rename(folder)
    except OSError as error:  # of which one that copies trees may hold many, each a triple
        first = error.args[0][0][2] if isinstance(error, shutil.Error) else error
        cause = first if isinstance(first, OSError) else OSError(0, str(first).rpartition("] ")[2])
        raise CannotWrite(folder, cause) from error
    finally:
        if draft:
            shutil.rmtree(draft, ignore_errors=True)
    return True
