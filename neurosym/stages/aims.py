"""What actions are aimed at, as values: nothing but their object, a place, or another object.

Exploring, training and distilling go the same way for each (`exploring.py`, `training.py`, `distilling.py`),
in the world as an aim has it shown, with data and networks of its own.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from neurosym.console import progress_bar
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.learning.model_config import PAIR_BITS, PLACE_BITS, STATE_BITS
from neurosym.learning.training_config import Regime
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import (
    CHANCES,
    DIRECT_MODEL,
    MODEL,
    PLACE_OPERATORS,
    PLACES,
    PRIMITIVES,
    RELATION_INTERACTIONS,
    RELATION_MODEL,
    RELATION_OPERATORS,
    RELATION_STATES,
    RELATIONS,
    STATES,
    WORLD,
)
from neurosym.world import World, WorldFactory, references_of
from neurosym.worlds.aimed import PLACE_AXES, AimedFactory
from neurosym.worlds.related import PAIR_AXES, REFERENCE, TARGET, RelatedFactory
from neurosym.worlds.world_file import read_world

if TYPE_CHECKING:  # importing torch takes seconds
    from neurosym.primitives.search import Method

FRESH = 600
"""Pairs that nobody touched, to learn states from."""
_STREAM = 0x6672  # keeps their draws apart from others


def _nothing_besides(folder: DomainFolder, interactions: Interactions, regime: Regime, seed: int) -> dict:  # type: ignore[type-arg]
    del folder, interactions, regime, seed
    return {}


@dataclass(frozen=True)
class Aim:
    """What actions are aimed at.

    Attributes:
        method: How operators are found, with the choice that the user made.
        table: File of the operators.
        folder: Where the other files are in the domain folder, which is also what users call it.
        reference: What a world must take as a reference; empty for none.
        axes: How many axes effects have; None for as many as there are.
        bits: Of the symbols of objects, or pairs, and of actions; None for those of the regime.
        builds_on: Files that exploring reads besides the world's.
        network: Which of its files has the network that shortlists.
        besides: Which other files of its own training writes and distilling reads.
        categories: The network that gives objects, or pairs, their symbols: a file of any aim.
        adapt: Has a world explored with such actions.
        origin: What the data say of it.
        learn: Learns what else there is to learn of the data; gives what goes into which file.
    """

    method: Callable[[DomainFolder, str], "Method"]
    table: str
    folder: str = ""
    reference: str = ""
    axes: int | None = None
    bits: tuple[int, int] | None = None
    builds_on: tuple[str, ...] = ()
    network: str = DIRECT_MODEL
    besides: tuple[str, ...] = ()
    categories: str = MODEL
    adapt: Callable[[DomainFolder, WorldFactory], WorldFactory] = lambda _, factory: factory
    origin: Mapping[str, Any] = field(default_factory=dict)
    learn: Callable[[DomainFolder, Interactions, Regime, int], dict[str, Any]] = _nothing_besides

    def file(self, name: str) -> str:
        """Return where one of its files is in the domain folder."""
        return f"{self.folder}/{name}" if self.folder else name

    def stage(self, verb: str) -> str:
        """Return the name of one of its stages."""
        return f"{verb}-{self.folder}" if self.folder else verb

    def check_takes(self, world: World) -> None:
        """Raise `InvalidValue` unless actions in a world can be aimed so."""
        if self.reference and self.reference not in references_of(world):
            raise InvalidValue(
                f"The world {world.name} takes no {self.reference} as a reference, so nothing can be learned "
                f"of {self.folder}; leave out --{self.folder}."
            )


def _displacing(_: DomainFolder, choice: str) -> "Method":
    from neurosym.primitives.table import displacing

    return displacing(choice)


def _carrying(_: DomainFolder, __: str) -> "Method":
    from neurosym.primitives.table import CARRYING

    return CARRYING


def _relating(folder: DomainFolder, _: str) -> "Method":
    from neurosym.primitives.table import relating
    from neurosym.relation_operators import PairStates

    return relating(PairStates.load(folder.require(RELATION_STATES)))


def _with_known_motions(folder: DomainFolder, factory: WorldFactory) -> WorldFactory:
    """Have pairs explored from what carries objects to places."""
    from neurosym.learning.effect_model import EffectModel
    from neurosym.place_operators import PlaceOperators
    from neurosym.worlds.known_motions import KnownMotions

    categorise = EffectModel.load(folder.require(MODEL)).object_symbols
    places = PlaceOperators.load(folder.require(PLACE_OPERATORS))
    return RelatedFactory(factory, KnownMotions(places, categorise, factory().action_box))


def _learn_states(
    folder: DomainFolder, interactions: Interactions, regime: Regime, seed: int
) -> dict[str, Any]:
    """Find the states of pairs, and learn to foresee them."""
    from neurosym.learning.state_chances import fit_chances
    from neurosym.learning.state_codes import ends_in, learn_states
    from neurosym.pair_states import describe_pair

    path = folder / RELATION_INTERACTIONS
    if not np.any(interactions.effects[:, -1]):
        raise InvalidFile(path, "nothing was carried to another object; explore more")
    rng = np.random.default_rng([seed, _STREAM])
    world = RelatedFactory(read_world(folder.require(WORLD)))()
    scenes = (world.sample_scene(rng, 1).whole for _ in range(FRESH))  # type: ignore[attr-defined]
    fresh = np.array([describe_pair(scene, TARGET, REFERENCE, ()) for scene in scenes])
    states = learn_states(fresh, *ends_in(interactions), STATE_BITS, rng)
    if not states.bearing:
        raise InvalidFile(path, "no object came to bear another one; explore more")
    with progress_bar("learning what is foreseen of pairs") as advance:
        chances = fit_chances(
            interactions,
            states,
            regime.training,
            seed=seed,
            progress=lambda stage, share: advance(round(100 * share), 100, stage),
        )
    return {STATES: states, CHANCES: chances}


OBJECTS = Aim(_displacing, PRIMITIVES)
TO_PLACES = Aim(
    _carrying,
    PLACE_OPERATORS,
    PLACES,
    reference="place",
    axes=PLACE_AXES,
    bits=PLACE_BITS,
    adapt=lambda _, factory: AimedFactory(factory),
    origin={"reference": "place"},
)
TO_OBJECTS = Aim(
    _relating,
    RELATION_OPERATORS,
    RELATIONS,
    reference="object",
    axes=PAIR_AXES,
    bits=PAIR_BITS,
    builds_on=(MODEL, PLACE_OPERATORS),
    network=CHANCES,
    besides=(STATES,),
    categories=RELATION_MODEL,
    adapt=_with_known_motions,
    origin={"reference": "object", "proposed": True},
    learn=_learn_states,
)
