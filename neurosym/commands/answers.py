"""How commands answer programs: one JSON value on standard output, and nothing else there."""

from collections.abc import Callable
from typing import Annotated, Any

import msgspec
from tyro.conf import arg

from neurosym.console import be_quiet, is_quiet, print_raw

Json = Annotated[bool, arg(help="Print the answer as JSON and nothing else, for programs.")]

Answer = Callable[..., None]
"""Prints a struct or dictionary as JSON, if that was asked for; more fields, given by name, come first."""


def answer_in(json: bool) -> Answer:
    """Return how a command gives its answer; from now on nothing else is printed if that is JSON.

    Args:
        json: Whether a program asked.
    """
    was_quiet = is_quiet()
    be_quiet(was_quiet or json)

    def answer(value: Any, **besides: Any) -> None:
        if json:
            be_quiet(was_quiet)
            found = msgspec.to_builtins(value)
            text = msgspec.json.encode({**besides, **found} if besides else found)
            print_raw(msgspec.json.format(text, indent=2).decode())

    return answer
