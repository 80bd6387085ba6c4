"""How a command ends: its exit code, and the one sentence if it could not be done."""

import os
import sys
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from neurosym.commands.catalogue import overview
from neurosym.commands.exit_codes import BAD_INPUT, DONE, NOBODY_READS
from neurosym.commands.signals import raised_signals, say_interrupted
from neurosym.commands.surroundings import leave_no_folders
from neurosym.console import OutputClosed, be_quiet, complain, naming_output, say, width
from neurosym.distribution import NAME, refuse_other_library, version_of
from neurosym.errors import InvalidValue, NeurosymError
from neurosym.threads import compute_in_one_thread

QUIET = "--quiet"
"""What any command may be given to print nothing but what goes wrong."""
_HELP = {"-h", "--help"}
_NO_MEMORY = "There is not enough memory; ask for less (workers, objects, rows), or end other programs."
_WANTS_MEMORY = (  # how torch says it, and what loads libraries
    "allocate memory",
    "not enough memory",
    "bad allocation",
    "std::bad_alloc",
    "failed to map segment",
)


def perform(typed: Sequence[str]) -> int:
    """Perform what was typed, say what went wrong if anything did, and return the exit code.

    Args:
        typed: What was typed after `neurosym`.
    """
    try:
        with raised_signals():
            try:
                refuse_other_library()
                _refuse_bytes(typed)
                code = _perform(typed)
            finally:
                with naming_output():
                    sys.stdout.flush()
    except (OutputClosed, BrokenPipeError):
        code = NOBODY_READS
    except NeurosymError as error:
        code = _refuse(str(error))
    except OSError as error:
        code = _refuse(_told(error))
    except MemoryError:
        code = _refuse(_NO_MEMORY)
    except (RuntimeError, ImportError) as error:
        if not any(words in str(error) for words in _WANTS_MEMORY):
            raise
        code = _refuse(_NO_MEMORY)
    except KeyboardInterrupt as error:
        code = say_interrupted(error)
    return code


def _perform(typed: Sequence[str]) -> int:
    """Perform what was typed; to say only which this is, or what there is, next to nothing is imported."""
    be_quiet(False)
    if [*typed] == ["--version"]:
        say(f"{NAME} {version_of('neurosym')} (Python {sys.version.split()[0]})")
        return DONE
    words = [word for word in typed if word != QUIET]
    if words and words[0].startswith("-") and not _HELP.isdisjoint(words):
        say(overview(width()))
        return DONE
    be_quiet(QUIET in typed)
    leave_no_folders()
    compute_in_one_thread()
    from neurosym.commands.arguments import read_arguments

    return read_arguments(words)()


def _refuse(sentence: str) -> int:
    complain(sentence, style="red")
    return BAD_INPUT


def _refuse_bytes(typed: Sequence[str]) -> None:
    """Raise unless every argument is text that can be written down, in a record for instance."""
    for word in typed:
        try:
            word.encode()
        except UnicodeEncodeError as error:
            encoding = sys.getfilesystemencoding()
            said = f"{word!r} is no text in {encoding}; rename the file such that its name is."
            raise InvalidValue(said) from error


def _told(error: OSError) -> str:
    """Say what the system did not do, by the name of the file if it tells it."""
    try:
        Path.cwd()
    except OSError:
        return "The current folder is no longer there; go to another one."
    reason = error.strerror or str(error) or type(error).__name__
    if error.filename is None:
        return f"Something could not be read or written: {reason}."
    with suppress(ValueError):
        return f"{os.fsdecode(error.filename)}: {reason}"
    return reason
