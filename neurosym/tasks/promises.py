"""Promises: what operators do to the object at hand, by what their rehearsals say about objects like it.

Within a category the effect of a primitive still depends on the size of the object. A Gaussian process over
the rehearsals of an operator, from features to displacement, refines the category's mean (Rasmussen and
Williams, 2006, algorithm 2.1). How far it misses rehearsals that are left out, near objects of these
features, says how sure the promise is (section 5.4.2). Where rehearsals are not kept, or are few, operators
promise what they promise to the category.
"""

from collections.abc import Mapping, Sequence
from functools import lru_cache
from types import MappingProxyType
from typing import Any

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE, Category, Mode, Operator, OperatorTable, vector
from neurosym.problems import SceneObject, Trial
from neurosym.regression import Choice, Regression, fit, found_for
from neurosym.tasks.pasts import LEAST_CHANCE, as_it_lies, promised_after
from neurosym.world import heading, turned_by

_LEAST_REHEARSALS = 8  # with fewer that ended as promised, nothing is refined
OUTSIDE = 0.9
"""How much rarer a promise is kept for each feature of an object that no rehearsed one has so great or small.

Chosen on 810 motions with 150 objects of which one, two or three sizes were at an edge of what the world may
draw, and 900 with objects of its own with one there. Brier scores are .146 and .070, and .156 and .068
without it.
"""
LAST_WAYPOINT = 4
"""So many numbers of an action are its last waypoint, which is relative to what it is aimed at."""
_BEYOND = 0.5  # how far outside of what was rehearsed an object may be, in spreads of the features
_LEAST_SPREAD = 1e-3


def promised(grounding: Grounding, item: SceneObject, tolerance: float = TOLERANCE) -> Mapping[str, Operator]:
    """Return the operators of an object's category as they promise for this object, by name.

    Each has the name, the category and the primitive of the operator that was learned, and no rehearsals.
    Objects that are unlike all that were rehearsed are promised what their category is. Those with a past are
    promised what that tells; if they were tried, also to be handled as other categories are. An outcome that
    comes within the tolerance of the promise has kept it [m]. Where motions are turned as objects lie, so are
    promises.
    """
    turn = heading(np.array(item.orientation)) if grounding.turned else 0.0
    past = as_it_lies(item, grounding.turned)
    return _promised(grounding, item.category, item.features, tolerance, turn, past)


def usable(grounding: Grounding, item: SceneObject, tolerance: float = TOLERANCE) -> tuple[Operator, ...]:
    """Return the operators of the PDDL domain that do something to this object; see `promised`."""
    live = {operator.name for operator in grounding.live}
    usual, found = promised(grounding, item), promised(grounding, item, tolerance)
    names = (name for name in usual if name in live and why_unfit(usual[name], grounding) is None)
    return tuple(found[name] for name in names)


def why_unfit(operator: Operator, grounding: Grounding) -> str | None:
    """Say why an operator, as it promises for an object, is not planned with; None if it is."""
    if reason := grounding.why_left_out(operator):
        return reason
    if grounding.is_refined and operator.successes < LEAST_CHANCE * operator.trials:
        return f"keeps its promise with such objects in about {operator.successes} of {operator.trials} only"
    return None


def performed_with(grounding: Grounding, operator: Operator, item: SceneObject) -> Float[np.ndarray, "A"]:
    """Return the action that an operator is performed with on an object; see `set_over`."""
    action = grounding.primitive_of(operator).action
    if operator.frame != "pair" or grounding.places is None:
        return np.array(action)
    return set_over(grounding.places, action, item.category, item.features)


def set_over(
    places: OperatorTable, action: Sequence[float], category: str, features: tuple[float, ...]
) -> Float[np.ndarray, "A"]:
    """Return an action that carries to places as it is aimed at another object, to end over its middle.

    Its end makes up for where an object of these features will hang from the hand, as it does at places. An
    action that is not known to carry to places stays what it is. It is of the object's category, if it
    carries these, and else of whichever it carries most surely.
    """
    aimed = np.array(action, dtype=np.float64)
    if known := [one for one in carrying_with(places, tuple(action)) if _carries(one)]:
        surest = max(known, key=lambda one: (one.subject == category, one.successes, one.name))
        learned = next(one for one in places.categories if one.symbol == surest.subject)
        promise = refined(surest, learned, features, TOLERANCE).promise
        assert promise is not None, "it carries"
        aimed[-LAST_WAYPOINT:][:2] -= promise.resting_effect[:2]
    return aimed


@lru_cache(maxsize=256)
def carrying_with(places: OperatorTable, action: tuple[float, ...]) -> tuple[Operator, ...]:
    """Return the operators that carry to places with an action; none if it is not known to."""
    labels = {one.label for one in places.primitives if one.action == action}
    return tuple(one for one in places.operators if one.label in labels)


def _carries(operator: Operator) -> bool:
    return operator.promise is not None and operator.promise.kind == "carried"


def rehearsed_objects(operator: Operator, category: Category) -> tuple[tuple[float, ...], ...]:
    """Return the features of the objects that an operator was rehearsed on, in that order."""
    return operator.objects or category.objects


def fits_of(grounding: Grounding) -> dict[str, Choice]:
    """Fit the rehearsals of all operators of a domain, and return what that came to, by name."""
    every = (one for one in grounding.operators if one.frame != "pair")
    fitted = {one.name: _regression(one, grounding.category(one.subject)) for one in every}
    return {name: regression.choice for name, regression in fitted.items() if regression}


def chances_of(
    operator: Operator, category: Category, features: Float[np.ndarray, "N F"], tolerance: float = TOLERANCE
) -> Float[np.ndarray, "N"] | None:
    """Estimate how often an operator of a category keeps its promise with objects of some features.

    None is returned where the rehearsals that are kept are too few to tell.
    """
    regression = _regression(operator, category)
    if regression is None:
        return None
    return regression.chances((features - regression.centre) / regression.scale, tolerance)


def is_rehearsed(category: Category, features: Sequence[float]) -> bool:
    """Say whether objects of a category that have such features were rehearsed, as far as that is known."""
    if not category.objects:
        return True
    objects, scale = np.array(category.objects), _scale(category)
    low, high = objects.min(0) - _BEYOND * scale, objects.max(0) + _BEYOND * scale
    return len(features) == len(low) and bool(np.all((low <= features) & (features <= high)))


def _outside(objects: Float[np.ndarray, "N F"], features: tuple[float, ...]) -> int:
    """Count the features that are less, or greater, than those of all objects that were rehearsed."""
    return int(np.sum((features < objects.min(0)) | (objects.max(0) < features)))


@lru_cache(maxsize=256)
def _promised(
    grounding: Grounding,
    category: str,
    features: tuple[float, ...],
    tolerance: float,
    turn: float,
    past: tuple[Trial, ...],
) -> Mapping[str, Operator]:
    learned = grounding.category(category)
    own, is_known = grounding.operators_on(category), is_rehearsed(learned, features)
    promises = (
        refined(one, learned, features, tolerance) if is_known else _rarer(one, learned, features)
        for one in own
    )
    found = {one.name: one for one in promises}
    if past:
        found = promised_after(found, grounding.operators, past, tolerance)
    return MappingProxyType({name: _turned(one, turn) for name, one in found.items()})


def _turned(operator: Operator, angle: float) -> Operator:
    """Return an operator that displaces objects as if these lay turned by an angle [rad]."""
    if angle == 0.0 or operator.frame != "object":
        return operator

    def led(mode: Mode) -> Mode:
        effect, resting = turned_by(angle, np.array([mode.effect, mode.resting_effect]))
        return msgspec.structs.replace(mode, effect=vector(effect), resting_effect=vector(resting))

    return msgspec.structs.replace(operator, outcomes=tuple(map(led, operator.outcomes)))


def _rarer(operator: Operator, category: Category, features: tuple[float, ...]) -> Operator:
    """Return an operator as it promises for its category, and more rarely keeps with what is unlike all."""
    if (promise := operator.promise) is None:
        return _plain(operator)
    outside = _outside(np.array(rehearsed_objects(operator, category)), features)
    return _promising(operator, near_mean=round(promise.near_mean * OUTSIDE**outside))


def _plain(operator: Operator) -> Operator:
    return msgspec.structs.replace(operator, rehearsals=(), objects=()) if operator.rehearsals else operator


def _promising(operator: Operator, **told: Any) -> Operator:
    """Return an operator whose promise tells something else."""
    outcomes = (
        msgspec.structs.replace(one, **told) if one is operator.promise else one for one in operator.outcomes
    )
    return msgspec.structs.replace(_plain(operator), outcomes=tuple(outcomes))


@lru_cache(maxsize=16384)
def refined(
    operator: Operator, category: Category, features: tuple[float, ...], tolerance: float
) -> Operator:
    """Return an operator as it promises for an object of some features."""
    regression = _regression(operator, category)
    promise = operator.promise
    if regression is None or promise is None:
        return _plain(operator)
    at = (np.array(features) - regression.centre) / regression.scale
    values, spreads = regression.predict(at), regression.spreads(at)
    outside = _outside(np.array(rehearsed_objects(operator, category)), features)
    sure = operator.trials * OUTSIDE**outside
    so, kept = (round(regression.chance(at, within) * sure) for within in (np.inf, tolerance))
    is_held = promise.kind == "held"
    resting = (*values[:2].tolist(), promise.resting_effect[2])
    resting_spread = (*spreads[:2].tolist(), promise.resting_spread[2])
    return _promising(
        operator,
        count=so,
        share=so / operator.trials,
        near_mean=kept,
        effect=tuple(values[2:].tolist()) if is_held else (*resting[:2], promise.effect[2]),
        spread=tuple(spreads[2:].tolist()) if is_held else (*resting_spread[:2], promise.spread[2]),
        resting_effect=resting,
        resting_spread=resting_spread,
    )


@lru_cache(maxsize=2048)
def _regression(operator: Operator, category: Category) -> Regression | None:
    """Fit an operator's rehearsals; None if there are too few to learn from."""
    promise = operator.promise
    rows = rehearsed_objects(operator, category)
    if promise is None or not category.objects or len(operator.rehearsals) != len(rows):
        return None
    of_kind = [one for one in operator.rehearsals if one.kind == promise.kind]
    if len(of_kind) < _LEAST_REHEARSALS:
        return None
    is_kind = np.array([one.kind == promise.kind for one in operator.rehearsals])
    outcomes = np.array([one.resting_effect[:2] for one in of_kind])
    if promise.kind == "held":
        outcomes = np.column_stack([outcomes, [one.effect for one in of_kind]])
    known = found_for(operator, category)
    return fit(np.array(rows), is_kind, outcomes, scale=_scale(category), known=known)


def _scale(category: Category) -> Float[np.ndarray, "F"]:
    return np.asarray(np.maximum(np.array(category.objects).std(0), _LEAST_SPREAD))
