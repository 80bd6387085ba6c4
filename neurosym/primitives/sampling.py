"""Sampling by category: objects as the world draws them, and enough of each category, rare ones included."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from string import ascii_lowercase
from types import MappingProxyType

import msgspec
import numpy as np

from neurosym.errors import Progress
from neurosym.operators import Categorise, Primitive, Symbol, all_symbols, symbols_of
from neurosym.primitives.ledger import Ledger
from neurosym.world import Outcome, Scene, World, WorldFactory
from neurosym.worlds.workers import Task

MOST_DRAWS = 60
"""How many objects are drawn at most for each one that a category shall have."""


@dataclass(frozen=True, slots=True, eq=False)
class Sample:
    """Scenes of one object of each category that was met, and its share among all objects that were drawn."""

    scenes: Mapping[Symbol, tuple[Scene, ...]]
    shares: Mapping[Symbol, float]


def draw_scene(world: World, seed: int, stream: int, number: int) -> Scene:
    """Draw one of the objects of a stream.

    Args:
        world: Where it comes from.
        seed: Where all draws start.
        stream: Keeps the draws of one purpose apart from those of another.
        number: Of the object, counted from 0.
    """
    return world.sample_scene(np.random.default_rng([seed, stream, number]), 1)


def sample_by_category(
    world: World, categorise: Categorise, *, least: int, typical: int = 0, seed: int, stream: int
) -> Sample:
    """Draw objects one after the other, and keep of each category the first that fall into it.

    A category so rare that `MOST_DRAWS` times as many draws hold fewer of it has those that were found.

    It has at least `least` if it can, and as many as there are of it among the first `typical` draws.
    """
    drawn: list[Scene] = []
    symbols: list[Symbol] = []
    lacking = True
    while lacking and (not drawn or len(drawn) < MOST_DRAWS * least):
        more = least if drawn else max(least, typical)
        scenes = [draw_scene(world, seed, stream, len(drawn) + number) for number in range(more)]
        symbols += symbols_of(categorise, np.concatenate([scene.features for scene in scenes]))
        drawn += scenes
        lacking = any(symbols.count(code) < least for code in all_symbols(len(symbols[0])))
    kept = {}
    for symbol in sorted(set(symbols)):
        members = [scene for scene, found in zip(drawn, symbols, strict=True) if found == symbol]
        kept[symbol] = tuple(members[: max(least, symbols[:typical].count(symbol))])
    return Sample(kept, {symbol: symbols.count(symbol) / len(symbols) for symbol in kept})


# Performing actions


def perform_each(
    ledger: Ledger,
    world_factory: WorldFactory,
    tasks: Sequence[Sequence[Task]],
    purpose: str,
    progress: Progress | None = None,
) -> list[list[Outcome]]:
    """Perform several lists of actions, and give the outcomes of each; see `Ledger.perform`."""
    performed = iter(
        ledger.perform(world_factory, [one for some in tasks for one in some], purpose, progress)
    )
    return [[next(performed) for _ in some] for some in tasks]


def tasks_of(primitive: Primitive, scenes: Iterable[Scene]) -> list[Task]:
    """Return what it takes to perform an action in each of some scenes."""
    return [Task(scene, np.array(primitive.action, dtype=np.float64)) for scene in scenes]


# The repertoire: distilled actions, and on which categories of objects each of them is performed


@dataclass(frozen=True, slots=True)
class Repertoire:
    """Actions, and which of them are performed on which category."""

    # in the order of their symbols; the one that a symbol shares among categories comes first
    primitives: tuple[Primitive, ...]
    # labels of those that are performed on a category, for categories with actions of their own. On others
    # the shared ones are performed; None if every action is performed on every category
    own: Mapping[Symbol, tuple[str, ...]] | None = None
    # on how many objects of a category an action is performed, by the category and its label; on all where it
    # is not said
    times: Mapping[tuple[Symbol, str], int] = field(default_factory=dict)
    # says whether an action is for what a scene shows, where the category does not
    fits: Callable[[Primitive, Scene], bool] = field(default=lambda *_: True, compare=False)

    def serves(self, primitive: Primitive, category: Symbol) -> bool:
        """Say whether an action is performed on the objects of a category."""
        if self.own is None:
            return True
        if category not in self.own:
            return not primitive.variant
        return primitive.label in self.own[category]


def shared_by_all(primitives: Sequence[Primitive]) -> Repertoire:
    """Return the repertoire in which every action is performed on every category."""
    return Repertoire(tuple(sorted(primitives, key=lambda one: (one.symbol, one.variant))))


def with_own(
    shared: Sequence[Primitive],
    chosen: Mapping[Symbol, Sequence[Primitive]],
    times: Mapping[tuple[Symbol, Primitive], int] = MappingProxyType({}),
) -> Repertoire:
    """Return the repertoire in which categories have actions of their own, a letter for each.

    The same action has the same letter on every category that it is chosen for. Without one it is shared.

    Args:
        shared: What serves where nothing was chosen.
        chosen: For each category.
        times: On how many objects of it the chosen are performed, if not on all.
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
    labelled = {(kind, labels[one.symbol, one.action]): count for (kind, one), count in times.items()}
    return Repertoire(shared_by_all(primitives).primitives, own, labelled)


def next_variant(primitives: Sequence[Primitive], symbol: Symbol) -> str:
    """Return the letter of the next action that a symbol has beside its shared one: a to z, aa, ab and so on.

    Args:
        primitives: Those that there are, the shared one among them.
        symbol: The symbol.
    """
    taken = {one.variant for one in primitives if one.symbol == symbol}
    letters = (f"{first}{second}" for first in ("", *ascii_lowercase) for second in ascii_lowercase)
    return next(letter for letter in letters if letter not in taken)
