"""The repertoire: distilled actions, and on which categories of objects each of them is performed."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import count
from string import ascii_lowercase

import msgspec

from neurosym.operators import OperatorTable, Primitive
from neurosym.symbols import Symbol


@dataclass(frozen=True, slots=True)
class Repertoire:
    """Actions, and which of them are performed on which category.

    Attributes:
        primitives: In the order of their symbols; the one that a symbol shares among categories comes first.
        own: Labels of those that are performed on a category, for categories with actions of their own. On
            others the shared ones are performed; None if every action is performed on every category.
    """

    primitives: tuple[Primitive, ...]
    own: Mapping[Symbol, tuple[str, ...]] | None = None

    def serves(self, primitive: Primitive, category: Symbol) -> bool:
        """Say whether an action is performed on the objects of a category.

        Args:
            primitive: One of the actions.
            category: An object symbol.
        """
        if self.own is None:
            return True
        if category not in self.own:
            return not primitive.variant
        return primitive.label in self.own[category]


def shared_by_all(primitives: Sequence[Primitive]) -> Repertoire:
    """Return the repertoire in which every action is performed on every category."""
    return Repertoire(tuple(sorted(primitives, key=lambda one: (one.symbol, one.variant))))


def with_own(shared: Sequence[Primitive], chosen: Mapping[Symbol, Sequence[Primitive]]) -> Repertoire:
    """Return the repertoire in which categories have actions of their own, a letter for each.

    The same action has the same letter on every category that it is chosen for. Without one it is shared.

    Args:
        shared: The action that each symbol shares among categories.
        chosen: What is performed on the objects of each category.
    """
    primitives, labels = [*shared], {(one.symbol, one.action): one.label for one in shared}
    own: dict[Symbol, tuple[str, ...]] = {}
    for category, actions in sorted(chosen.items()):
        for action in actions:
            if (action.symbol, action.action) not in labels:
                primitives.append(
                    msgspec.structs.replace(action, variant=next_variant(primitives, action.symbol))
                )
                labels[action.symbol, action.action] = primitives[-1].label
        own[category] = tuple(labels[action.symbol, action.action] for action in actions)
    return Repertoire(shared_by_all(primitives).primitives, own)


def repertoire_of(table: OperatorTable) -> Repertoire:
    """Return the repertoire that a table of operators was made with."""
    if not any(primitive.variant for primitive in table.primitives):
        return shared_by_all(table.primitives)
    own = {
        category.symbol: tuple(op.label for op in table.operators if op.category == category.symbol)
        for category in table.categories
        if category.share
    }
    return Repertoire(table.primitives, own)


def next_variant(primitives: Sequence[Primitive], symbol: Symbol) -> str:
    """Return the letter of the next action that a symbol has beside its shared one.

    Args:
        primitives: Those that there are, the shared one among them.
        symbol: The symbol.
    """
    taken = {one.variant for one in primitives if one.symbol == symbol}
    return next(letters for number in count() if (letters := _letters(number)) not in taken)


def _letters(number: int) -> str:
    """Return "a" to "z" for 0 to 25, and "aa", "ab" and so on thereafter."""
    rounds, letter = divmod(number, len(ascii_lowercase))
    return (ascii_lowercase[rounds - 1] if rounds else "") + ascii_lowercase[letter]
