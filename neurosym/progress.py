"""How long work reports how far it has come."""

from collections.abc import Callable

Progress = Callable[[int, int], None]
"""Called with how many parts are done, and how many there are."""
