"""The command line: `neurosym COMMAND DIR ...`.

Exit codes: 0 done; 2 bad input, with one sentence that says what would be valid; 3 the work was done and the
answer is no (no plan, goal missed); 130 interrupted; 128 + the signal, ended by another one; 141 whoever read
the output has closed it (128 + SIGPIPE, as in `neurosym check ... | head -1`).

This module imports next to nothing, so that Ctrl-C is heard while the rest is imported.
"""

import sys
from collections.abc import Sequence


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line and exit.

    Args:
        arguments: What was typed after `neurosym`; the process's own arguments if not given.
    """
    try:
        from neurosym.commands.ending import make_usable

        make_usable()
        from neurosym.commands.ending import perform

        code = perform(sys.argv[1:] if arguments is None else arguments)
    except KeyboardInterrupt:  # while something was imported; nothing has begun
        code = 130
    sys.exit(code)
