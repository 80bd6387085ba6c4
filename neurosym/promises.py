"""Promises: what operators do to the object at hand, by what their rehearsals say about objects like it.

Within a category the effect of a primitive still depends on the size of the object. A Gaussian process over
the rehearsals of an operator, from features to displacement, refines the category's mean (Rasmussen and
Williams, 2006, algorithm 2.1). How far it misses rehearsals that are left out, near objects of these
features, says how sure the promise is (section 5.4.2). Where rehearsals are not kept, or are few, operators
promise what they promise to the category.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from types import MappingProxyType

import msgspec
import numpy as np
from jaxtyping import Bool, Float

from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE, Category, Mode, Operator
from neurosym.problems import SceneObject

LEAST_REHEARSALS = 8
"""With fewer rehearsals that ended as promised, nothing is refined."""
_LENGTHS = (0.7, 1.5, 3.0, 6.0)  # over which outcomes change, in spreads of the features
_NOISES = (
    0.001,
    0.01,
    0.1,
    0.3,
    1.0,
    10.0,
)  # variance that features do not explain, of that they do
_LIKE = 1.0  # how far objects are whose rehearsals count most, in spreads of the features
_PRIOR = 2.0  # as how many rehearsals of such an object those of the whole category count
_BEYOND = 0.5  # how far outside of what was rehearsed an object may be, in spreads of the features
_LEAST_SPREAD = 1e-3


def promised(grounding: Grounding, item: SceneObject, tolerance: float = TOLERANCE) -> Mapping[str, Operator]:
    """Return the operators of an object's category as they promise for this object, by name.

    Each has the name, the category and the primitive of the operator that was learned, and no rehearsals.
    Objects that are unlike all that were rehearsed are promised what their category is.

    Args:
        grounding: The learned domain.
        item: The object.
        tolerance: How near an outcome must come to the promise to have kept it [m].
    """
    return _promised(grounding, item.category, item.features, tolerance)


def usable(grounding: Grounding, item: SceneObject, tolerance: float = TOLERANCE) -> tuple[Operator, ...]:
    """Return the operators of the PDDL domain that do something to this object, as they promise for it.

    Args:
        grounding: The learned domain.
        item: The object.
        tolerance: How near an outcome must come to the promise to have kept it [m].
    """
    return _usable(grounding, item.category, item.features, tolerance)


def is_rehearsed(category: Category, features: Sequence[float]) -> bool:
    """Say whether objects like this one were rehearsed, as far as that is known.

    Args:
        category: The object's category.
        features: Its features.
    """
    if not category.objects:
        return True
    objects, scale = np.array(category.objects), _scale(category)
    low, high = objects.min(0) - _BEYOND * scale, objects.max(0) + _BEYOND * scale
    return bool(np.all((low <= features) & (features <= high)))


@lru_cache(maxsize=256)
def _promised(
    grounding: Grounding, category: str, features: tuple[float, ...], tolerance: float
) -> Mapping[str, Operator]:
    learned = grounding.category(category)
    is_known = is_rehearsed(learned, features)
    return MappingProxyType(
        {
            operator.name: _refined(operator, learned, features, tolerance) if is_known else _plain(operator)
            for operator in grounding.operators.operators
            if operator.category == category
        }
    )


@lru_cache(maxsize=256)
def _usable(
    grounding: Grounding, category: str, features: tuple[float, ...], tolerance: float
) -> tuple[Operator, ...]:
    live = {operator.name for operator in grounding.live}
    usual = _promised(grounding, category, features, TOLERANCE)
    names = [name for name, op in usual.items() if name in live and grounding.why_left_out(op) is None]
    found = _promised(grounding, category, features, tolerance)
    return tuple(found[name] for name in names)


def _plain(operator: Operator) -> Operator:
    return msgspec.structs.replace(operator, rehearsals=()) if operator.rehearsals else operator


@lru_cache(maxsize=16384)
def _refined(
    operator: Operator, category: Category, features: tuple[float, ...], tolerance: float
) -> Operator:
    """Return an operator as it promises for an object of some features."""
    regression = _regression(operator, category)
    promise = operator.promise
    if regression is None or promise is None:
        return _plain(operator)
    at = (np.array(features) - regression.centre) / regression.scale
    values, spreads = regression.predict(at), regression.spreads(at)
    so, kept = (round(regression.chance(at, within) * operator.trials) for within in (np.inf, tolerance))
    counted = msgspec.structs.replace(promise, count=so, share=so / operator.trials, near_mean=kept)
    mode = _refined_mode(counted, values, spreads)
    modes = tuple(mode if other is promise else other for other in operator.modes)
    return msgspec.structs.replace(operator, modes=modes, rehearsals=())


def _refined_mode(mode: Mode, values: Float[np.ndarray, "D"], spreads: Float[np.ndarray, "D"]) -> Mode:
    """Put what was predicted in the place of the means; see `_outcomes` for what the columns are."""
    x, y, *more = values.tolist()
    spread_x, spread_y, *spread_more = spreads.tolist()
    resting = (x, y, mode.resting_effect[2])
    resting_spread = (spread_x, spread_y, mode.resting_spread[2])
    effect, spread = (x, y, mode.effect[2]), (spread_x, spread_y, mode.spread[2])
    if more:
        effect, spread = (more[0], more[1], more[2]), (spread_more[0], spread_more[1], spread_more[2])
    return msgspec.structs.replace(
        mode,
        effect=effect,
        spread=spread,
        resting_effect=resting,
        resting_spread=resting_spread,
    )


@dataclass(frozen=True, slots=True, eq=False)
class _Regression:
    """A Gaussian process from features to outcomes, fitted to the rehearsals that ended as promised.

    Attributes:
        centre: What features are counted from.
        scale: What they are divided by.
        objects: Scaled features of all objects.
        is_kind: Which of them ended as promised: those that it is fitted to.
        misses: By how much the others' prediction missed each of these, each column [m].
        ends: The columns that say where the object ends.
        mean: Mean outcome [m].
        deviation: Standard deviation of each column of the outcomes [m].
        low: The least outcomes.
        high: The greatest.
        length: Over what distance outcomes change.
        weights: What each object counts in a prediction.
    """

    centre: Float[np.ndarray, "F"]
    scale: Float[np.ndarray, "F"]
    objects: Float[np.ndarray, "N F"]
    is_kind: Bool[np.ndarray, "N"]
    misses: Float[np.ndarray, "n D"]
    ends: slice
    mean: Float[np.ndarray, "D"]
    deviation: Float[np.ndarray, "D"]
    low: Float[np.ndarray, "D"]
    high: Float[np.ndarray, "D"]
    length: float
    weights: Float[np.ndarray, "n D"]

    def predict(self, at: Float[np.ndarray, "F"]) -> Float[np.ndarray, "D"]:
        """Predict the outcome for scaled features, within what was seen [m]."""
        near = _likeness(self.objects[self.is_kind], at[None], self.length)[:, 0]
        value = self.mean + self.deviation * (near @ self.weights)
        return np.asarray(np.clip(value, self.low, self.high))

    def chance(self, at: Float[np.ndarray, "F"], tolerance: float) -> float:
        """Estimate how often an object of such features ends as promised, within a tolerance of it [m]."""
        kept = np.zeros(len(self.objects))
        kept[self.is_kind] = self._keeps(tolerance)
        near = _likeness(self.objects, at[None], _LIKE)[:, 0]
        return float((near @ kept + _PRIOR * kept.mean()) / (near.sum() + _PRIOR))

    def spreads(self, at: Float[np.ndarray, "F"]) -> Float[np.ndarray, "D"]:
        """Estimate by how much predictions for such objects miss where the promise is kept, RMS [m]."""
        kept = self._keeps(TOLERANCE).astype(float)
        near = _likeness(self.objects[self.is_kind], at[None], _LIKE)[:, 0]
        weights = near * kept + _PRIOR * kept / max(kept.sum(), 1.0) + 1e-12
        return np.asarray(np.sqrt(weights @ self.misses**2 / weights.sum()))

    def _keeps(self, tolerance: float) -> Bool[np.ndarray, "n"]:
        return np.asarray(np.linalg.norm(self.misses[:, self.ends], axis=1) <= tolerance)


@lru_cache(maxsize=2048)
def _regression(operator: Operator, category: Category) -> _Regression | None:
    """Fit an operator's rehearsals; None if there are too few to learn from."""
    promise = operator.promise
    if promise is None or len(operator.rehearsals) != len(category.objects):
        return None
    is_kind = np.array([one.kind == promise.kind for one in operator.rehearsals], dtype=bool)
    if is_kind.sum() < LEAST_REHEARSALS:
        return None
    outcomes = _outcomes(operator, promise.kind == "held")[is_kind]
    features = np.array(category.objects)
    centre, scale = features.mean(0), _scale(category)
    objects = (features - centre) / scale
    mean, deviation = outcomes.mean(0), np.maximum(outcomes.std(0), _LEAST_SPREAD)
    scaled = (outcomes - mean) / deviation
    length, vectors, values = _most_likely(objects[is_kind], scaled)
    weights = vectors @ (vectors.T @ scaled / values[:, None])
    left_out = weights / (vectors**2 / values).sum(1)[:, None] * deviation  # eq. 5.12
    return _Regression(
        centre=centre,
        scale=scale,
        objects=objects,
        is_kind=is_kind,
        misses=left_out,
        ends=slice(2, 5) if outcomes.shape[1] > 2 else slice(0, 2),
        mean=mean,
        deviation=deviation,
        low=outcomes.min(0),
        high=outcomes.max(0),
        length=length,
        weights=weights,
    )


def _most_likely(
    objects: Float[np.ndarray, "n F"], outcomes: Float[np.ndarray, "n D"]
) -> tuple[float, Float[np.ndarray, "n n"], Float[np.ndarray, "n"]]:
    """Choose length and noise by the marginal likelihood (eq. 5.8), the variances in closed form.

    Returns:
        The length, and eigenvectors and eigenvalues of the kernel's matrix with the noise.
    """
    best, found = -np.inf, None
    for length in _LENGTHS:
        bare, vectors = np.linalg.eigh(_likeness(objects, objects, length))
        squares = (vectors.T @ outcomes) ** 2
        for noise in _NOISES:
            values = np.maximum(bare, 0) + noise
            variance = (squares / values[:, None]).mean(0) + 1e-9
            columns = outcomes.shape[1]
            likelihood = -0.5 * (len(objects) * np.log(variance).sum() + columns * np.log(values).sum())
            if likelihood > best:
                best, found = float(likelihood), (length, vectors, values)
    assert found is not None, "outcomes are finite"
    return found


def _outcomes(operator: Operator, is_held: bool) -> Float[np.ndarray, "N D"]:
    """List what is predicted [m]: where the object rests, x and y, and if held, where it is in the air."""
    rows = operator.rehearsals
    resting = np.array([row.resting_effect[:2] for row in rows])
    return np.column_stack([resting, [row.effect for row in rows]]) if is_held else resting


def _likeness(
    ones: Float[np.ndarray, "n F"], others: Float[np.ndarray, "m F"], length: float
) -> Float[np.ndarray, "n m"]:
    """Compute the squared-exponential kernel."""
    apart = ((ones[:, None] - others[None]) ** 2).sum(-1)
    return np.asarray(np.exp(-apart / (2 * length**2)))


def _scale(category: Category) -> Float[np.ndarray, "F"]:
    return np.asarray(np.maximum(np.array(category.objects).std(0), _LEAST_SPREAD))
