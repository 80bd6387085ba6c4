"""What carries objects to places, in sentences for a person: from the table of what was rehearsed."""

from collections.abc import Sequence

from neurosym.explain.action_words import (
    AXES,
    action_in_words,
    displacement_in_words,
    distance_in_words,
    place_in_words,
    spread_in_words,
)
from neurosym.explain.comparison_words import ENDS
from neurosym.explain.explained import EffectRow, SymbolExplanation
from neurosym.operators import TOLERANCE, Mode, Operator, Primitive
from neurosym.place_operators import NEVER_CARRIES, PlaceOperators
from neurosym.symbols import Symbol

_WAYPOINTS = 3


def explain_carrying(places: PlaceOperators, gripper: Sequence[bool] = ()) -> tuple[SymbolExplanation, ...]:
    """Say what each action symbol does that is aimed at a place.

    Args:
        places: What was rehearsed.
        gripper: Which action parameters are gripper values, as the world says; empty if nobody knows.
    """
    table = places.operators
    return tuple(
        SymbolExplanation(
            symbol,
            _title(places, symbol),
            " ".join(_about(places, symbol, gripper)),
            " ".join(_among_others(places, symbol)),
            tuple(_row(one, mode) for one in _of(places, symbol) for mode in one.modes),
        )
        for symbol in table.symbols
    )


def summary_of(carrying: Sequence[SymbolExplanation]) -> str:
    """Say how many symbols carry something.

    Args:
        carrying: What `explain_carrying` found.
    """
    able = sum(any(row.promised for row in one.effects) for one in carrying)
    return (
        f"Of {len(carrying)} symbols of actions aimed at a place, {able} carry objects there; as promised is "
        f"what stands within {distance_in_words(TOLERANCE, AXES)} of the promised spot beside the place."
    )


def end_in_words(mode: Mode) -> str:
    """Say where an object ends that was to be carried to a place.

    Args:
        mode: How it ends.
    """
    if mode.kind != "carried":
        return "elsewhere"
    away = displacement_in_words(mode.outcome)
    return "at the place" if away == "nowhere" else f"{away} of the place"


def aimed_action_in_words(
    primitive: Primitive, gripper: Sequence[bool], reference: str = "the place"
) -> tuple[str, ...]:
    """Say what the hand does: two waypoints are relative to the object, the third to what it is aimed at.

    Args:
        primitive: The action.
        gripper: Which action parameters are gripper values, as the world says; empty if nobody knows.
        reference: What it is aimed at besides the object.
    """
    told = action_in_words(primitive.action, gripper)
    if len(told) <= _WAYPOINTS:  # plain numbers
        return told
    last = primitive.action[-4:-1]
    spot = place_in_words(last, reference)
    return (*told[:2], f"What it grips then it lifts, carries to {spot}, lowers and lets go.")


def _of(places: PlaceOperators, symbol: Symbol) -> tuple[Operator, ...]:
    return tuple(one for one in places.operators.operators if one.primitive == symbol)


def _title(places: PlaceOperators, symbol: Symbol) -> str:
    shares = {one.symbol: one.share for one in places.operators.categories}
    carried = sum(
        shares[one.category] * one.successes / one.trials for one in _of(places, symbol) if one.trials
    )
    return f"carries {carried:.0%} of objects to a place" if carried else "carries nothing"


def _about(places: PlaceOperators, symbol: Symbol, gripper: Sequence[bool]) -> list[str]:
    names = {one.symbol: one.name for one in places.operators.categories}
    of_symbol = [one for one in places.operators.primitives if one.symbol == symbol]
    lines = []
    for primitive in of_symbol:
        if len(of_symbol) > 1:
            on = (names[one.category] for one in _of(places, symbol) if one.label == primitive.label)
            lines.append(f"{primitive.label} is for {', '.join(on) or 'no category'}.")
        lines += aimed_action_in_words(primitive, gripper)
    return lines


def _among_others(places: PlaceOperators, symbol: Symbol) -> list[str]:
    names = {one.name for one in _of(places, symbol)}
    tables = {"others close beside it": places.beside, "another object on the place": places.occupied}
    said = []
    for company, table in tables.items():
        found = [one for one in table if one.name in names]
        if trials := sum(one.trials for one in found):
            kept = sum(one.kept for one in found)
            said.append(f"With {company} it went as promised {kept} of {trials} times.")
    return said


def _row(operator: Operator, mode: Mode) -> EffectRow:
    return EffectRow(
        operator=operator.name,
        trials=operator.trials,
        promised=operator.successes,
        share=mode.share,
        ends=ENDS[mode.kind],
        effect=end_in_words(mode),
        spread=spread_in_words(mode.scatter) if mode.count > 1 else "seen once",
        domain="yes" if operator.successes else f"no: {NEVER_CARRIES}",
    )
