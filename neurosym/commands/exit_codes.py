"""How a command ends: its exit codes."""

DONE = 0
"""The work was done."""
BAD_INPUT = 2
"""Something cannot be done as it was asked for; one sentence says what would be valid."""
NO_RESULT = 3
"""The work was done and the answer is no: no plan, or the goal was not reached."""
INTERRUPTED = 130
"""Interrupted; the same command goes on from what is written. Other signals: 128 + their number."""
NOBODY_READS = 141
"""Whoever read the output has closed it, as `head` does: 128 + SIGPIPE."""
