"""A file is written whole or not at all, and nothing else is left."""

import errno
import io
import os
from pathlib import Path

import pytest

from neurosym.errors import CannotWrite, InvalidFile
from neurosym.files import check_writable, make_folder, write_atomically, write_new


def test_a_file_that_cannot_be_put_in_place_leaves_nothing_behind(tmp_path: Path):
    (tmp_path / "taken").mkdir()
    with pytest.raises(OSError, match="taken"):
        write_atomically(tmp_path / "taken", "text")
    assert [path.name for path in tmp_path.iterdir()] == ["taken"]


def test_an_interrupted_write_keeps_the_old_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    path = tmp_path / "a.json"
    write_atomically(path, "old")

    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(Path, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write_atomically(path, "new")
    assert path.read_text() == "old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["a.json"]


FULL = OSError(errno.ENOSPC, "No space left on device")


class Full(io.FileIO):
    """A file into which nothing can be written."""

    def write(self, _: object) -> int:  # noqa: D102
        raise FULL


@pytest.fixture
def full_disk(monkeypatch: pytest.MonkeyPatch) -> None:
    """A disk on which a file can be made, and nothing can be written into it."""
    real = Path.open

    def opened(path: Path, mode: str = "r", *options: object, **named: object) -> object:
        return Full(path, mode) if mode == "xb" else real(path, mode, *options, **named)

    monkeypatch.setattr(Path, "open", opened)


@pytest.mark.usefixtures("full_disk")
def test_full_disk_is_noticed_before_the_work_and_leaves_nothing(tmp_path: Path):
    for act in (check_writable, lambda path: write_atomically(path, "text")):
        with pytest.raises(CannotWrite, match=r"/a\.json cannot be written: No space left on device\.$"):
            act(tmp_path / "a.json")
        assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", ["deep/below/a", "a" * 255, "a" * 256])
def test_file_that_can_be_written_is_found_so_and_nothing_is_made(tmp_path: Path, name: str):
    if len(name) < 256:
        check_writable(tmp_path / name)
    else:
        with pytest.raises(CannotWrite, match="File name too long"):
            check_writable(tmp_path / name)
    assert list(tmp_path.iterdir()) == []


def test_file_in_the_way_of_a_folder_is_noticed(tmp_path: Path):
    (tmp_path / "plans").touch()
    for act, name in ((check_writable, "plans/below"), (make_folder, "plans")):
        with pytest.raises(InvalidFile, match=r"/plans cannot be used: it is a file, and should be a folder"):
            act(tmp_path / name)
    with pytest.raises(InvalidFile, match="it is a folder, and should be a file"):
        check_writable(tmp_path)


@pytest.mark.parametrize(("error", "kept"), [(FileExistsError, "2"), (OSError, "1")])
def test_new_file_is_written_once_and_kept_if_another_writes_it_meanwhile(
    tmp_path: Path, monkeypatch, error, kept
):
    def meanwhile(*_: object) -> None:
        if error is FileExistsError:
            (tmp_path / "a").write_text("2")
        raise error

    with monkeypatch.context() as patched:
        patched.setattr(os, "link", meanwhile)
        assert write_new(tmp_path / "a", "1") is (kept == "1")
    assert not write_new(tmp_path / "a", "3")
    assert [(path.name, path.read_text()) for path in tmp_path.iterdir()] == [("a", kept)]
