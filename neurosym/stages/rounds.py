"""The rounds in which a budget of interactions is spent: how much each aim gets, and what it had."""

import math
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Annotated, NamedTuple

import msgspec

from neurosym.errors import InvalidValue
from neurosym.files import read_json
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder

_SEEN = 5
"""So often an operator is to be seen at least, on average."""
_FIRST = 2000
"""Interactions of the first round, for each aim."""
_WORTH_A_ROUND = 1.6
"""A round is worth it if the budget is so many times as large as it, at least."""
_WEIGHTS = {layout.OBJECTS: 6, layout.PLACES: 4, layout.RELATIONS: 5}
"""How the budget is shared by objects, places and other objects, if all are asked for."""
_EACH = 1000
"""So many interactions of a share there are at most, if the user does not say how many."""
_EXPLORED = 0.4
"""Share of the interactions of each round that explore."""
_MOST_EXPLORED = 4096
"""More are not explored for one aim: what is known then is better asked of operators."""
_BLOCK = 512
"""So many interactions are explored between two updates of the networks."""
HELD = 1024
"""Bits that were learned from so many explored interactions stay what they are."""
_IDLE = 0.9
"""A round that finds worthwhile performances for less than this share of its budget is the last."""


Count = Annotated[int, msgspec.Meta(ge=0)]


class Spent(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What one aim had of a round.

    Attributes:
        explored: Interactions explored so far.
        performed: Interactions performed so far to choose and measure operators.
        budget: How many these might be.
    """

    explored: Count
    performed: Count
    budget: Count


class Budget(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What the rounds that are done were spent on, by what was aimed at."""

    rounds: tuple[dict[str, Spent], ...] = ()

    @property
    def total(self) -> int:
        """All interactions that were performed, whatever for."""
        last = self.rounds[-1] if self.rounds else {}
        return sum(one.explored + one.performed for one in last.values())

    @property
    def is_idle(self) -> bool:
        """Whether the last round found too little that was worth performing."""
        last = [*self.rounds[-1].values()] if self.rounds else []
        return bool(last) and all(one.performed < _IDLE * one.budget for one in last)


class Share(NamedTuple):
    """What an aim gets of a round: interactions to explore, and to choose and measure operators, so far."""

    explored: int
    budget: int


Round = dict[str, Share]
"""Shares by the folder of the aim."""


def rounds(
    ceiling: int | None,
    aims: Sequence[str],
    *,
    operators: Mapping[str, int],
    most: Mapping[str, int | None] = MappingProxyType({}),
) -> list[Round]:
    """Say how much each aim gets in each round, all rounds before it included.

    Args:
        ceiling: How many interactions there may be in all; as many as are usual for these aims if None.
        aims: Their folders.
        operators: How many operators there are, where it is known.
        most: How many interactions explore at most, where it is said.

    Raises:
        InvalidValue: If so few interactions are of no use.
    """
    weights = {name: _WEIGHTS[name] for name in aims}
    every, first = sum(weights.values()), _FIRST * len(weights)
    ceiling = _EACH * every if ceiling is None else ceiling
    for name in operators.keys() & weights.keys():
        least = math.ceil(_SEEN * operators[name] * every / weights[name] / (1 - _EXPLORED))
        if ceiling < least:
            of = f" of {name}" if name else ""
            raise InvalidValue(
                f"--interactions {ceiling} are too few for {operators[name]} operators{of}, which are to be "
                f"seen {_SEEN} times each; give at least {least}, or fewer bits."
            )
    doubled = (first << number for number in range(ceiling.bit_length()))
    plan = list[Round]()
    for total in [*(total for total in doubled if _WORTH_A_ROUND * total <= ceiling), ceiling]:
        last = plan[-1] if plan else dict.fromkeys(weights, Share(0, 0))
        split = {name: total * weight // every for name, weight in weights.items()}
        limits = {name: most.get(name) or _MOST_EXPLORED for name in weights}
        plan.append({name: _share(count, limits[name], last[name]) for name, count in split.items()})
    return plan


def _share(count: int, most: int, last: Share) -> Share:
    """Split what an aim gets; whole blocks are explored if there are enough, since only these are kept."""
    explored = _EXPLORED * count
    if count > 2 * _BLOCK:
        explored = round(explored / _BLOCK) * _BLOCK
    explored = max(last.explored, min(int(explored), most, count - last.budget))
    return Share(explored, count - explored)


def at_least(share: Share, spent: Spent | None) -> Share:
    """Return a share that is not smaller than what was spent already.

    Args:
        share: The share.
        spent: What was spent, if anything was.
    """
    if spent is None:
        return share
    return Share(max(share.explored, spent.explored), max(share.budget, spent.budget))


def budget_of(folder: DomainFolder) -> Budget:
    """Read what the rounds that are done were spent on."""
    path = folder / layout.BUDGET
    return read_json(path, Budget) if path.is_file() else Budget()
