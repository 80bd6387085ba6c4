"""How long work reports how far it has come."""

from collections.abc import Callable
from contextlib import AbstractContextManager

Progress = Callable[[int, int], None]
"""Called with how many parts are done, and how many there are."""
OpenBar = Callable[[str], AbstractContextManager[Progress]]
"""Called with what is being done; gives what reports how far that has come."""
