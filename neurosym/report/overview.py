"""What the page opens with: the map of object symbols, what each action does to each of them, how surely."""

from collections.abc import Mapping, Sequence
from itertools import product
from typing import Any

import numpy as np

from neurosym.data.interactions import Interactions
from neurosym.grounding import Grounding
from neurosym.learning.network import EffectModel
from neurosym.learning.training_report import TrainingReport
from neurosym.operators import Category, Operator, OperatorTable, Symbol, by_share
from neurosym.report.drawings import chip, effect_drawing, effect_room, is_body, map_drawing, object_drawing
from neurosym.report.symbol_map import Atlas, atlas_of
from neurosym.report.symbols import AXES, displacement_in_words
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder
from neurosym.world import Colour, Palette
from neurosym.worlds.world_file import read_world

_MOST_KINDS, _MOST_ACTIONS = 8, 16
"""How many categories and actions are drawn, the most frequent and the most useful ones."""
_MATTERS = 0.02  # share of the objects that a feature must sort otherwise, to be chosen on the map
_SCALE = 400.0  # of effects [pixels per m]
_WIDE, _LEAST = 104, 54  # width of the drawing of an effect, and its least height [pixels]
_Told = dict[str, Any]


def atlas_of_folder(folder: DomainFolder, interactions: Interactions | None) -> Atlas | None:
    """Say which objects have which code: of a folder's world, or of its data; None if neither can tell."""
    if not (folder / layout.MODEL).is_file():
        return None
    categorise = EffectModel.load(folder / layout.MODEL).object_symbols
    if (folder / layout.WORLD).is_file():
        return atlas_of(read_world(folder / layout.WORLD)(), categorise)
    if interactions is None or not len(interactions):
        return None
    names = tuple(interactions.origin.get("feature_names", ()))
    return Atlas(categorise, interactions.features, names)


def action_codes(folder: DomainFolder, interactions: Interactions) -> tuple[Symbol, ...]:
    """Name the symbol of each action of a folder's data."""
    return EffectModel.load(folder / layout.MODEL).action_symbols(interactions.actions)


def share_kept(report: TrainingReport) -> _Told:
    """Say where R2 through the symbols lies between a guess, 0, and a network without a bottleneck, 100."""
    percent = round(100 * min(1.0, max(0.0, report.r2_through_codes / report.r2_direct)))
    return {"percent": percent, "symbols": report.r2_through_codes, "direct": report.r2_direct}


def kinds_of(table: OperatorTable, atlas: Atlas | None, palette: Palette) -> list[_Told]:
    """Describe the categories, the most frequent first, each with four objects that are drawn to scale."""

    def drawn(symbol: Symbol) -> list[str]:
        if atlas is None:
            return []
        found = atlas.examples(symbol)
        return [object_drawing(values, atlas.features, palette(symbol)) for values in found]

    return [
        {
            "symbol": one.symbol,
            "name": _words(one),
            "share": one.share,
            "chip": chip(one.symbol, palette),
            "objects": drawn(one.symbol),
        }
        for one in by_share(table.categories)
    ]


def _words(category: Category) -> str:
    """Say the name of a category without its symbol, which stands beside it."""
    return category.name.removesuffix(f"-{category.symbol}").replace("-", " ")


def maps_of(atlas: Atlas, palette: Palette) -> _Told:
    """Draw a map for each setting of the two other features that matter most, and name the settings."""
    others = [number for number in atlas.others if atlas.matter[number] > _MATTERS][:2]
    tabs, settings = list[_Told](), [atlas.settings(number) for number in others]
    for number, values in zip(others, settings, strict=True):
        nearest = int(np.abs(np.array(values) - atlas.typical[number]).argmin())
        feature = atlas.features[number]
        tabs.append({"word": feature.word, "values": [*map(feature.told, values)], "first": nearest})
    drawings = []
    for chosen in product(*(range(len(values)) for values in settings)):
        at, told = [*atlas.typical], list[str]()
        for number, values, one in zip(others, settings, chosen, strict=True):
            at[number] = values[one]
            told.append(f"{atlas.features[number].word} {atlas.features[number].told(values[one])}")
        axes = " and ".join(atlas.features[number].word for number in atlas.axes)
        name = "-".join(("map", *map(str, chosen)))
        title = f"Which {axes} have which symbol" + (f", for {' and '.join(told)}" if told else "")
        drawings.append({"at": chosen, "svg": map_drawing(atlas.map(at), palette, title=title, name=name)})
    fixed = [
        f"{feature.word} {feature.told(atlas.typical[number])}"
        for number, feature in enumerate(atlas.features)
        if number not in (*others, *atlas.axes)
    ]
    return {"tabs": tabs, "drawings": drawings, "fixed": fixed}


def matrix_of(table: OperatorTable, atlas: Atlas | None, palette: Palette, uses: Mapping[str, int]) -> _Told:
    """Draw what each action symbol promises to do to each category, the surest way that there is.

    Args:
        table: The operators.
        atlas: Where objects to draw come from.
        palette: The colours of the categories.
        uses: How often the domain uses each action symbol: the most useful are drawn.
    """
    kinds = by_share([one for one in table.categories if one.share])[:_MOST_KINDS]
    surest = dict[tuple[str, str], Operator]()
    for operator in table.operators:
        surest.setdefault((operator.primitive, operator.subject), operator)
    shown = sorted(table.symbols, key=lambda symbol: -uses.get(symbol, 0))[:_MOST_ACTIONS]
    promises = [one.promise for one in surest.values() if one.promise]
    longest = max((abs(part) for one in promises for part in one.outcome), default=1.0) or 1.0
    scale = _SCALE if table.axes == AXES else _LEAST / longest
    items = {one.symbol: _typical(atlas, one.symbol) for one in kinds}
    rows = []
    for symbol in (one for one in table.symbols if one in shown):
        done = [(kind, surest.get((symbol, kind.symbol))) for kind in kinds]
        drawn = [(one.promise, items[kind.symbol]) for kind, one in done if one and one.promise]
        rooms = [effect_room(end.outcome, item, scale) for end, item in drawn if table.axes == AXES]
        height = max(_LEAST, *rooms, 0)
        cells = [
            _cell(one, kind, items[kind.symbol], palette(kind.symbol), scale, height) for kind, one in done
        ]
        rows.append({"symbol": symbol, "cells": cells})
    columns = [{"chip": chip(one.symbol, palette), "name": _words(one)} for one in kinds]
    return {"columns": columns, "rows": rows, "left": len(table.symbols) - len(rows)}


def _typical(atlas: Atlas | None, symbol: Symbol) -> tuple[float, ...]:
    """Choose an object of a category to draw effects on: a small one, so that the effects are seen."""
    found = atlas.examples(symbol, 2) if atlas and is_body(atlas.features) else ()
    return found[0] if found else ()


def _cell(
    operator: Operator | None,
    kind: Category,
    item: Sequence[float],
    colour: Colour,
    scale: float,
    height: int,
) -> _Told:
    """Draw what an operator promises a category, at a scale [pixels per m] and in a height [pixels]."""
    if operator is None or operator.promise is None:
        return {"told": "never tried" if operator is None else "promises nothing", "svg": ""}
    promise, is_held = operator.promise, operator.promise.kind == "held"
    told = (
        f"{operator.primitive} on {kind.name}: {displacement_in_words(promise.outcome)}, "
        f"{'ends in the hand' if is_held else 'comes to rest'}; "
        f"as promised {operator.successes} of {operator.trials} times"
    )
    svg = effect_drawing(
        promise.outcome,
        told=told,
        chance=operator.chance,
        is_held=is_held,
        item=item,
        colour=colour,
        scale=scale,
        width=_WIDE,
        height=height,
    )
    return {"told": told, "svg": svg}


def promises_of(table: OperatorTable, grounding: Grounding | None) -> _Told | None:
    """Rank the operators by how often what they promise comes true; None if none was ever tried.

    Those of the domain, with what carries to places and puts on other objects, if it was compiled.
    """
    every = grounding.operators if grounding else table.operators
    left = grounding.left_out if grounding else {}
    tried = [one for one in every if one.trials and one.subject and one.name not in left]
    kept = [(one.successes / one.trials, one.name, one.successes, one.trials) for one in tried]
    kept.sort(key=lambda one: (-one[0], one[1]))
    bars = [{"share": share, "name": name, "kept": k, "trials": n} for share, name, k, n in kept]
    return (
        {"bars": bars, "best": bars[0], "typical": bars[len(bars) // 2], "worst": bars[-1]} if bars else None
    )
