"""Gaussian process regression: from features of objects to what an operator does to them.

After Rasmussen and Williams, *Gaussian Processes for Machine Learning*, 2006, algorithm 2.1. How far the
prediction misses objects that are left out (section 5.4.2) says how sure it is for others like them.
"""

from dataclasses import dataclass
from functools import cache
from itertools import combinations

import numpy as np
from jaxtyping import Bool, Float

from neurosym.operators import TOLERANCE

_LENGTHS = (0.7, 1.5, 3.0, 6.0)  # over which outcomes change, in spreads of the features
_NOISES = (0.001, 0.01, 0.1, 0.3, 1.0, 10.0)  # variance that features do not explain, of that they do
_LIKE = 1.0  # how far objects are whose rehearsals count most, in spreads of the features
_NEAR = (0.25, 0.5, 1.0)  # the same, where few features decide whether a promise is kept
_DECIDING = 2  # how many features these can be
_CLEARLY = 2.0  # how much likelier what was rehearsed must be if they decide [nats]
_PRIOR = 2.0  # as how many rehearsals of such an object those of the whole category count
_LEAST_SPREAD = 1e-3


@dataclass(frozen=True, slots=True, eq=False)
class Regression:
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
        deciding: By what features are multiplied, to tell for which objects promises are kept.
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
    deciding: Float[np.ndarray, "F"]
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
        kept[self.is_kind] = self.keeps(tolerance)
        near = _likeness(self.objects * self.deciding, at[None] * self.deciding, 1.0)[:, 0]
        return float((near @ kept + _PRIOR * kept.mean()) / (near.sum() + _PRIOR))

    def spreads(self, at: Float[np.ndarray, "F"]) -> Float[np.ndarray, "D"]:
        """Estimate by how much predictions for such objects miss where the promise is kept, RMS [m]."""
        kept = self.keeps(TOLERANCE).astype(float)
        near = _likeness(self.objects[self.is_kind], at[None], _LIKE)[:, 0]
        weights = near * kept + _PRIOR * kept / max(kept.sum(), 1.0) + 1e-12
        return np.asarray(np.sqrt(weights @ self.misses**2 / weights.sum()))

    def keeps(self, tolerance: float) -> Bool[np.ndarray, "n"]:
        """Say which of those that it is fitted to the others predict within a tolerance [m]."""
        return np.asarray(np.linalg.norm(self.misses[:, self.ends], axis=1) <= tolerance)


def fit(
    features: Float[np.ndarray, "N F"],
    is_kind: Bool[np.ndarray, "N"],
    outcomes: Float[np.ndarray, "n D"],
    *,
    scale: Float[np.ndarray, "F"],
) -> Regression:
    """Fit a Gaussian process to the outcomes of those that ended as promised.

    Args:
        features: Features of all objects.
        is_kind: Which of them ended as promised.
        outcomes: Their outcomes [m]: where the object rests, x and y, and if held, where it is in the air.
        scale: What features are divided by.
    """
    centre = features.mean(0)
    objects = (features - centre) / scale
    mean, deviation = outcomes.mean(0), np.maximum(outcomes.std(0), _LEAST_SPREAD)
    scaled = (outcomes - mean) / deviation
    length, vectors, values = _most_likely(objects[is_kind], scaled)
    weights = vectors @ (vectors.T @ scaled / values[:, None])
    left_out = weights / (vectors**2 / values).sum(1)[:, None] * deviation  # eq. 5.12
    ends = slice(2, 5) if outcomes.shape[1] > 2 else slice(0, 2)
    kept = np.zeros(len(objects))
    kept[is_kind] = np.linalg.norm(left_out[:, ends], axis=1) <= TOLERANCE
    return Regression(
        centre=centre,
        scale=scale,
        objects=objects,
        is_kind=is_kind,
        misses=left_out,
        ends=ends,
        mean=mean,
        deviation=deviation,
        low=outcomes.min(0),
        high=outcomes.max(0),
        deciding=_deciding(objects, kept),
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


def _deciding(objects: Float[np.ndarray, "N F"], kept: Float[np.ndarray, "N"]) -> Float[np.ndarray, "F"]:
    """Find the features that decide whether a promise is kept, by how likely that makes those left out.

    A hand closes over what is narrow, however long it is. All features count alike, or none if they say
    nothing, unless few of them say clearly more.

    Args:
        objects: Scaled features of all objects.
        kept: For which of them the promise was kept.
    """
    metrics, rate = _metrics(objects.shape[1]), kept.mean()
    likelihoods = []
    for metric in metrics:
        near = _likeness(objects * metric, objects * metric, 1.0)
        np.fill_diagonal(near, 0.0)
        chances = np.clip((near @ kept + _PRIOR * rate) / (near.sum(1) + _PRIOR), 1e-3, 1 - 1e-3)
        likelihoods.append(float(np.log(np.where(kept == 1, chances, 1 - chances)).sum()))
    likelihoods[:2] = [usual + _CLEARLY for usual in likelihoods[:2]]
    return metrics[int(np.argmax(likelihoods))]


@cache
def _metrics(features: int) -> tuple[Float[np.ndarray, "F"], ...]:
    """List by what features can be multiplied: all alike, none, and then few of them, the others by 0."""
    few = [
        np.isin(np.arange(features), chosen) / near
        for count in range(1, _DECIDING + 1)
        for chosen in combinations(range(features), count)
        for near in _NEAR
    ]
    return (np.full(features, 1 / _LIKE), np.zeros(features), *few)


def _likeness(
    ones: Float[np.ndarray, "n F"], others: Float[np.ndarray, "m F"], length: float
) -> Float[np.ndarray, "n m"]:
    """Compute the squared-exponential kernel."""
    apart = ((ones[:, None] - others[None]) ** 2).sum(-1)
    return np.asarray(np.exp(-apart / (2 * length**2)))
