"""Calling the command line from tests."""

from pathlib import Path

import pytest

from neurosym.commands.cli import main


def neurosym(*arguments: object) -> int:
    """Run a command and return its exit code."""
    with pytest.raises(SystemExit) as ended:
        main([str(argument) for argument in arguments])
    return int(ended.value.code or 0)


def refusal(capsys, *arguments: object) -> str:
    """The one sentence that a command refuses bad input with."""
    assert neurosym(*arguments) == 2
    captured = capsys.readouterr()
    assert "Traceback" not in captured.err
    assert len(captured.err.strip().splitlines()) == 1
    return str(captured.err)


def contents(folder: Path) -> dict[str, bytes]:
    """What each file below a folder holds."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
