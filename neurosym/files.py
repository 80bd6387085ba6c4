"""Writing files whole or not at all.

Every file of ours is written here, so that a write that fails names the file.
"""

import os
from collections.abc import Mapping
from pathlib import Path

import msgspec

from neurosym.drafts import collecting, draft, naming, remove_leftovers
from neurosym.errors import InvalidFile
from neurosym.reading import digest, refuse_other_kinds

_BLOCK = bytes(4096)  # as much as any file system sets aside for a small file


def write_atomically(path: Path, content: bytes | str) -> None:
    """Write a file through a temporary one and a rename, so that a kill leaves the old file or the new.

    Args:
        path: Where the file shall stand; its folder exists.
        content: Bytes, or text that is written as UTF-8.

    Raises:
        CannotWrite: If the system does not let it be written; nothing has changed.
    """
    # A name that is not UTF-8 can only be told by escapes.
    data = content.encode(errors="backslashreplace") if isinstance(content, str) else content
    with naming(path), draft(path, data) as written:
        if drafts := collecting():
            drafts.add(path, written)
        else:
            written.replace(path)


def write_new(path: Path, content: bytes | str) -> bool:
    """Write a file unless one is there, and say whether it was written; of several writers one does it.

    Args:
        path: Where the file shall stand; its folder exists.
        content: Bytes, or text that is written as UTF-8.
    """
    if path.exists():
        return False
    data = content.encode() if isinstance(content, str) else content
    with naming(path), draft(path, data) as written:
        try:
            os.link(written, path)
        except FileExistsError:
            return False
        except OSError:  # a file system without links
            written.replace(path)
        finally:
            written.unlink(missing_ok=True)
    return True


def remove(path: Path) -> None:
    """Remove a file, if it is there; among `Drafts`, when they are put in place."""
    if drafts := collecting():
        drafts.add(path, None)
        return
    with naming(path):
        path.unlink(missing_ok=True)


def make_folder(path: Path) -> None:
    """Make a folder and those above it, unless it is there.

    Raises:
        InvalidFile: If it is a file.
        CannotWrite: If the system does not let it be made.
    """
    with naming(path):
        try:
            path.mkdir(parents=True, exist_ok=True)
        except FileExistsError as error:
            raise InvalidFile(path, "it is a file, and should be a folder; move it away") from error


def check_writable(path: Path) -> None:
    """Raise unless a file can be written, before the work is done whose result it is to hold.

    Args:
        path: The file; folders above it that do not exist yet are made later.

    Raises:
        InvalidFile: If it is a folder or a device, or one of the folders above it is a file.
        CannotWrite: If the folder, or the disk, takes no file.
    """
    with naming(path):
        refuse_other_kinds(path)
        folder = next(place for place in path.absolute().parents if place.exists())
        if not folder.is_dir():
            raise InvalidFile(folder, "it is a file, and should be a folder; move it away")
        remove_leftovers(folder)
        with draft(folder / path.name, _BLOCK) as written:
            written.unlink()


def write_json(path: Path, document: object) -> None:
    """Write a document as indented JSON with a stable order of keys."""
    write_atomically(path, msgspec.json.format(msgspec.json.encode(document), indent=1) + b"\n")


def digests(places: Mapping[str, Path]) -> dict[str, str]:
    """Return the SHA-256 of each file that is there, or will be when `Drafts` are put in place.

    Args:
        places: The files, by name.
    """
    drafts = collecting()
    found = {name: drafts.now_at(path) if drafts else path for name, path in places.items()}
    return {name: digest(path) for name, path in found.items() if path and path.is_file()}
