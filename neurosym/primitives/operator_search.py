"""From networks and data to operators: distil, choose, and rehearse, whatever actions are aimed at.

* **Objects** alone: each category gets the actions that displace its objects most exactly (`audition.py`).
* **Places**: every category gets of each symbol the action that carries its objects most surely and exactly
  to the place. Auditions are among neighbours, lest an action be chosen that drags the object through them.
  Rehearsals among others say how surely they are left alone, and whether a place must be free.
* **Pairs**: every kind of pair gets what carries its targets to places (`pair_rehearsal.py`), rehearsed among
  bystanders. More rehearsals begin as others ended. They show whether it matters that the target rests on
  something, that something rests on it, or on the reference.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import msgspec
import numpy as np

from neurosym.choices import BUDGET
from neurosym.contract import made
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidValue, OpenBar, silent
from neurosym.learning.network import EffectModel
from neurosym.operators import (
    TABLE_FORMAT,
    Categorise,
    Operator,
    OperatorTable,
    Primitive,
    name_operator,
    names_of_features,
)
from neurosym.pair_operators import PairStates, RelationOperators
from neurosym.primitives.audition import choose, choose_among, choose_own
from neurosym.primitives.distillation import distill
from neurosym.primitives.ledger import Ledger
from neurosym.primitives.pair_rehearsal import Carriers, carriers_for_pairs, rehearse_among, tabulate_pairs
from neurosym.primitives.rehearsal import (
    MARGIN,
    Rehearsals,
    describe_categories,
    rehearse,
    rehearse_among_others,
    rehearse_unsure,
    sort_into_modes,
    tabulate,
)
from neurosym.primitives.reliability import PredictOutcomes, foresee_carrying
from neurosym.primitives.sampling import Repertoire
from neurosym.primitives.search import Search
from neurosym.world import ActionBox, OutcomeKind, WorldFactory
from neurosym.worlds.aims import AimedFactory, CrowdedFactory, RelatedFactory
from neurosym.worlds.workers import kept_workers


@dataclass(frozen=True, slots=True)
class Method:
    """How operators are found for what actions are aimed at."""

    adapt: Callable[[WorldFactory], WorldFactory]  # has every action in a world aimed so
    choose: Callable[[Search], Repertoire]  # chooses among the candidates
    # tells from the rehearsals of what was chosen what each operator does; rehearses it further
    measure: Callable[[Search, Rehearsals], Any]
    distils: bool = True  # whether candidates are distilled, or known from elsewhere


class NothingDistilled(InvalidValue):
    """A model whose symbols no action encodes to."""


@kept_workers()
def find_operators(
    model: EffectModel,
    predict: PredictOutcomes,
    interactions: Interactions,
    box: ActionBox,
    method: Method,
    *,
    categorise: Categorise | None = None,
    world_factory: WorldFactory,
    objects: int = 100,
    budget: int = BUDGET,
    seed: int,
    ledger: Ledger | None = None,
    former: Sequence[Primitive] = (),
    open_bar: OpenBar = silent,
) -> Any:
    """Distil each action symbol, choose among the candidates, and measure what each operator does.

    Args:
        model: Whose action symbols are distilled.
        predict: A network without a bottleneck on the same data, which shortlists.
        interactions: The data.
        box: What parameters must stay inside.
        method: How it is done for what the actions are aimed at.
        categorise: Gives the object symbols of features; the model's, if not given.
        world_factory: Builds the world to audition and rehearse in.
        objects: How many objects each symbol is rehearsed on, not counting those added for rare categories.
        budget: How often actions perform at most.
        seed: Where all draws start.
        ledger: What performs, and keeps what was performed.
        former: Candidates that were chosen before, when less was known.
        open_bar: Shows how far each part has come.

    Raises:
        NothingDistilled: If no action encodes to its symbol.
        UnknownChoice: If the method has a choice that there is not.
    """
    chosen_before = tuple(msgspec.structs.replace(one, variant="") for one in former)
    candidates = _candidates(model, interactions, box, seed, open_bar) if method.distils else ()
    search = Search(
        tuple(dict.fromkeys((*chosen_before, *candidates))),
        predict,
        interactions.features,
        categorise or model.object_symbols,
        world_factory,
        method.adapt(world_factory),
        seed,
        objects,
        budget,
        Ledger() if ledger is None else ledger,
        chosen_before,
        open_bar,
    )
    chosen = method.choose(search)
    options: dict[str, Any] = {"objects": objects, "seed": seed, "ledger": search.ledger}
    with open_bar("rehearsing") as advance:
        found = rehearse(search.shown, chosen, search.categorise, **options, progress=advance)
    return method.measure(search, found)


def average_operators(
    model: EffectModel,
    predict: PredictOutcomes,
    interactions: Interactions,
    box: ActionBox,
    choice: str,
    *,
    seed: int,
    open_bar: OpenBar = silent,
) -> OperatorTable:
    """Distil and choose where there is no world, and average the data; see `find_operators` and `choose`.

    With "own", what stands for a symbol is what does most nearly what all actions of the symbol do.
    """
    candidates = _candidates(model, interactions, box, seed, open_bar)
    if choice == "own":
        primitives = most_typical(candidates, predict, interactions, model.action_symbols)
    else:
        primitives = choose(
            candidates,
            choice,
            predict=predict,
            features=interactions.features,
            categorise=model.object_symbols,
            world_factory=None,
            seed=seed,
        ).primitives
    return average(interactions, primitives, model.object_symbols, model.action_symbols)


_ROWS_SHOWN = 64
"""On so many things it is predicted what actions do, and so many actions of a symbol are looked at."""


def most_typical(
    candidates: Sequence[Primitive],
    predict: PredictOutcomes,
    interactions: Interactions,
    action_symbols: Categorise,
) -> tuple[Primitive, ...]:
    """Choose for each symbol what is predicted to do most nearly what its rows do on average."""
    features, symbols = interactions.features[:_ROWS_SHOWN], np.array(action_symbols(interactions.actions))
    scale = np.maximum(interactions.effects.std(0), 1e-9)

    def done(actions: np.ndarray) -> np.ndarray:
        pairs = np.tile(features, (len(actions), 1)), np.repeat(actions, len(features), axis=0)
        effects: np.ndarray = predict(*pairs)[:, : len(scale)] / scale
        return effects.reshape(len(actions), len(features), -1)

    found = dict[str, Primitive]()
    for symbol in sorted({one.symbol for one in candidates}):
        known = [one for one in candidates if one.symbol == symbol]
        usual = done(interactions.actions[symbols == symbol][:_ROWS_SHOWN]).mean(0)
        off = ((done(np.array([one.action for one in known], dtype=np.float32)) - usual) ** 2).mean((1, 2))
        found[symbol] = known[int(off.argmin())]
    return tuple(found.values())


def _candidates(
    model: EffectModel, interactions: Interactions, box: ActionBox, seed: int, open_bar: OpenBar
) -> tuple[Primitive, ...]:
    with open_bar("distilling") as advance:
        candidates = distill(model, interactions, box, seed=seed, progress=advance)
    if not candidates:
        raise NothingDistilled("No action encodes to its symbol; train again.")
    return candidates


def displacing(choice: str = "own") -> Method:
    """Return how operators are found that displace objects, aimed at nothing else.

    Args:
        choice: Which candidate stands for a symbol; one of `CHOICES`.
    """
    return Method(lambda factory: factory, partial(choose_among, choice=choice), measured)


def measured(search: Search, found: Rehearsals, share: float = 1.0) -> OperatorTable:
    """Tell what each primitive does to each category, and rehearse where that is unsure.

    Args:
        search: What the primitives were found with.
        found: What they did.
        share: Of what is left of the budget, that these rehearsals take at most.
    """
    with search.open_bar("telling the outcomes apart") as advance:
        table = tabulate(found, made(search.shown).feature_names, progress=advance)
    return rehearse_unsure(search, table, share)


def choose_carriers(search: Search) -> Repertoire:
    """Choose for each category and symbol the action that carries its objects most surely, among others."""
    return choose_own(search, CrowdedFactory(search.world_factory, MARGIN), foresee=foresee_carrying)


CARRYING = Method(
    lambda factory: AimedFactory(factory, MARGIN),
    choose_carriers,
    lambda search, found: rehearse_among_others(search, measured(search, found, 0.5)),
)
"""How operators are found that carry objects to places. What predicts says where objects end relative to the
place [m], the chance that they are carried, and greatest heights [m]."""


def relating(states: PairStates, carriers: Carriers) -> Method:
    """Return how operators are found that bring pairs into states.

    Args:
        states: The states of pairs.
        carriers: What carries objects.
    """

    def measure(search: Search, found: Rehearsals) -> RelationOperators:
        names = made(search.world_factory).feature_names
        return rehearse_among(search, tabulate_pairs(found, names, states), found, carriers)

    choose = partial(carriers_for_pairs, carriers=carriers)
    return Method(partial(RelatedFactory, aim=carriers), choose, measure, distils=False)


def average(
    interactions: Interactions,
    primitives: Sequence[Primitive],
    object_symbols: Categorise,
    action_symbols: Categorise,
) -> OperatorTable:
    """Average effects over the rows of the data, where there is no world to rehearse in.

    The rows whose action and object have the symbols of a primitive and a category stand in for rehearsals.
    They were made with other parameters than the distilled ones, so that such a table says what a symbol
    means and not what its distilled action does. Feature names are read from the origin of the data.

    Raises:
        InvalidValue: If there is no primitive.
    """
    if not primitives:
        raise InvalidValue("Nothing can be averaged without primitives: no action symbol was distilled.")
    objects = np.array(object_symbols(interactions.features))
    actions = np.array(action_symbols(interactions.actions))
    names = names_of_features(interactions.features.shape[1], interactions.origin.get("feature_names", ()))
    categories = describe_categories(interactions.features.astype(np.float64), objects, names)
    kinds, operators = np.array(kinds_of(interactions)), []
    outcomes = [
        column.astype(np.float64)
        for column in (interactions.effects, interactions.resting_effects, interactions.peak_heights)
    ]
    ordered = sorted(primitives, key=lambda primitive: primitive.symbol)
    for primitive in ordered:
        for category in categories:
            rows = (actions == primitive.symbol) & (objects == category.symbol)
            if not rows.any():
                continue
            modes = sort_into_modes(kinds[rows].tolist(), *(column[rows] for column in outcomes))
            name = name_operator(primitive.symbol, category.name, modes)
            count = int(rows.sum())
            operators.append(Operator(name, category.symbol, primitive.symbol, trials=count, outcomes=modes))
    return OperatorTable(categories, tuple(ordered), tuple(operators), measured="data", format=TABLE_FORMAT)


def kinds_of(interactions: Interactions) -> list[OutcomeKind]:
    """Tell for each row how the target ended, as `Outcome.kind` does."""
    flags = (interactions.lost, interactions.held, interactions.toppled)
    kinds: list[OutcomeKind] = ["lost", "held", "toppled", "resting"]
    return [kinds[number] for number in np.argmax([*flags, np.ones(len(interactions))], axis=0)]
