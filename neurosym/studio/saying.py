"""What a page says of itself: a sentence at its head, also in the place of an error."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import update_wrapper
from typing import Concatenate, ParamSpec, Protocol, TypeVar

from neurosym.errors import NeurosymError


class Speaker(Protocol):
    """Somebody who says sentences."""

    def say(self, text: str, *, is_bad: bool = False) -> None:
        """Say a sentence."""
        ...


_P = ParamSpec("_P")
_S = TypeVar("_S", bound=Speaker)


@dataclass(frozen=True, slots=True)
class Word:
    """What a page says of itself.

    Attributes:
        text: A sentence.
        is_bad: Whether something could not be done.
    """

    text: str = ""
    is_bad: bool = False


def told(method: Callable[Concatenate[_S, _P], None]) -> Callable[Concatenate[_S, _P], None]:
    """Have a method of a page say what it cannot do, instead of raising it."""

    def safely(self: _S, /, *arguments: _P.args, **options: _P.kwargs) -> None:
        try:
            method(self, *arguments, **options)
        except NeurosymError as error:
            self.say(str(error), is_bad=True)

    update_wrapper(safely, method)
    return safely
