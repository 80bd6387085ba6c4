"""Regression: how effects depend on features, by a Gaussian process, and what was found for a grounding."""

import hashlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import combinations
from pathlib import Path

import msgspec
import numpy as np

from neurosym.checks import Bool, Float
from neurosym.choices import one_thread
from neurosym.errors import InvalidFile
from neurosym.files import MEGABYTE, decode_json, digests, read_bytes, write_json
from neurosym.operators import TOLERANCE, Category, LegalName, Operator

# Gaussian process regression: from features of objects to what an operator does to them.
#
# After Rasmussen and Williams, *Gaussian Processes for Machine Learning*, 2006, algorithm 2.1. How far the
# prediction misses objects that are left out (section 5.4.2) says how sure it is for others like them.

_LENGTHS = (0.7, 1.5, 3.0, 6.0)  # over which outcomes change, in spreads of the features
_NOISES = (0.001, 0.01, 0.1, 0.3, 1.0, 10.0)  # variance that features do not explain, of that they do
_LIKE = 1.0  # how far objects are whose rehearsals count most, in spreads of the features
_PRIOR = 2.0  # as how many rehearsals of such an object those of the whole category count
_NEIGHBOURS = (5, 8, 16)  # how many of the nearest objects tell whether a promise is kept
_DECIDING = 2  # how many features can decide that
_CLEARLY = 2.0  # how much likelier what was rehearsed must be if few of them decide [nats]
_WITHIN = 0.7  # how far objects are that count most, as a share of how far the last neighbour is
_RATE = 0.5  # as how many neighbours all rehearsals count, where it is told whether a promise is kept
_LEAST_SPREAD = 1e-3


class Choice(msgspec.Struct, frozen=True, array_like=True, forbid_unknown_fields=True):
    """What a fit chooses, each among few."""

    length: float  # over what distance outcomes change, in spreads of the features
    noise: float  # variance that features do not explain, of that they do
    # by what features are multiplied, to tell for which objects promises are kept
    deciding: tuple[float, ...]
    neighbours: int  # how many objects near by tell that

    def is_one_of_ours(self, features: int) -> bool:
        """Say whether a fit to objects of so many features can come to this."""
        is_known = self.length in _LENGTHS and self.noise in _NOISES and self.neighbours in _NEIGHBOURS
        return is_known and self.deciding in {tuple(metric.tolist()) for metric in _metrics(features)}


@dataclass(frozen=True, slots=True, eq=False)
class Regression:
    """A Gaussian process from features to outcomes, fitted to the rehearsals that ended as promised."""

    centre: Float[np.ndarray, "F"]  # what features are counted from
    scale: Float[np.ndarray, "F"]  # what they are divided by
    objects: Float[np.ndarray, "N F"]  # scaled features of all objects
    is_kind: Bool[np.ndarray, "N"]  # which of them ended as promised: those that it is fitted to
    outcomes: Float[np.ndarray, "n D"]  # outcomes of these [m]
    # by how much the others' prediction missed each of these, each column [m]
    misses: Float[np.ndarray, "n D"]
    choice: Choice  # what was chosen by what is likeliest
    weights: Float[np.ndarray, "n D"]  # what each object counts in a prediction

    def predict(self, at: Float[np.ndarray, "F"]) -> Float[np.ndarray, "D"]:
        """Predict the outcome for scaled features, within what was seen [m]."""
        near = _alike(_apart(self.objects[self.is_kind], at[None]), self.choice.length)[:, 0]
        mean, deviation = _mean_and_deviation(self.outcomes)
        value = mean + deviation * (near @ self.weights)
        return np.asarray(np.clip(value, self.outcomes.min(0), self.outcomes.max(0)))

    def chance(self, at: Float[np.ndarray, "F"], tolerance: float) -> float:
        """Estimate how often an object of such features ends as promised, within a tolerance of it [m]."""
        return float(self.chances(at[None], tolerance)[0])

    def chances(self, at: Float[np.ndarray, "M F"], tolerance: float) -> Float[np.ndarray, "M"]:
        """Estimate the same for several objects; see `chance`."""
        kept = np.zeros(len(self.objects))
        kept[self.is_kind] = _keeps(self.misses, tolerance)
        deciding = np.array(self.choice.deciding)
        apart = _apart(self.objects * deciding, at * deciding)
        (last,) = _nearest(apart, (self.choice.neighbours,))
        return _chances(apart, kept, last)

    def spreads(self, at: Float[np.ndarray, "F"]) -> Float[np.ndarray, "D"]:
        """Estimate by how much predictions for such objects miss where the promise is kept, RMS [m]."""
        kept = _keeps(self.misses, TOLERANCE).astype(float)
        near = _alike(_apart(self.objects[self.is_kind], at[None]), _LIKE)[:, 0]
        weights = near * kept + _PRIOR * kept / max(kept.sum(), 1.0) + 1e-12
        return np.asarray(np.sqrt(weights @ self.misses**2 / weights.sum()))


def fit(
    features: Float[np.ndarray, "N F"],
    is_kind: Bool[np.ndarray, "N"],
    outcomes: Float[np.ndarray, "n D"],
    *,
    scale: Float[np.ndarray, "F"],
    known: Choice | None = None,
) -> Regression:
    """Fit a Gaussian process to the outcomes of those that ended as promised.

    Args:
        features: Features of all objects.
        is_kind: Which of them ended as promised.
        outcomes: Their outcomes [m]: where the object rests, x and y, and if held, where it is in the air.
        scale: What features are divided by.
        known: What a former fit to the same came to, if that is known; it is not sought again then.
    """
    if known and not known.is_one_of_ours(features.shape[1]):
        known = None
    centre = features.mean(0)
    objects = (features - centre) / scale
    mean, deviation = _mean_and_deviation(outcomes)
    scaled = (outcomes - mean) / deviation
    lengths, noises = ((known.length,), (known.noise,)) if known else (_LENGTHS, _NOISES)
    length, noise, vectors, values = _most_likely(objects[is_kind], scaled, lengths, noises)
    weights = vectors @ (vectors.T @ scaled / values[:, None])
    misses = weights / (vectors**2 / values).sum(1)[:, None] * deviation  # eq. 5.12
    kept = np.zeros(len(objects))
    kept[is_kind] = _keeps(misses, TOLERANCE)
    deciding, neighbours = (known.deciding, known.neighbours) if known else _deciding(objects, kept)
    choice = Choice(length, noise, deciding, neighbours)
    return Regression(centre, scale, objects, is_kind, outcomes, misses, choice, weights)


def _mean_and_deviation(
    outcomes: Float[np.ndarray, "n D"],
) -> tuple[Float[np.ndarray, "D"], Float[np.ndarray, "D"]]:
    return outcomes.mean(0), np.maximum(outcomes.std(0), _LEAST_SPREAD)


def _keeps(misses: Float[np.ndarray, "n D"], tolerance: float) -> Bool[np.ndarray, "n"]:
    """Say which predictions of where an object ends, in the air if held, miss by a tolerance at most."""
    ends = misses[:, 2:5] if misses.shape[1] > 2 else misses
    return np.asarray(np.linalg.norm(ends, axis=1) <= tolerance)


@one_thread()
def _most_likely(
    objects: Float[np.ndarray, "n F"],
    outcomes: Float[np.ndarray, "n D"],
    lengths: Sequence[float],
    noises: Sequence[float],
) -> tuple[float, float, Float[np.ndarray, "n n"], Float[np.ndarray, "n"]]:
    """Choose length and noise by the marginal likelihood (eq. 5.8), the variances in closed form.

    Returns:
        The length, the noise, and eigenvectors and eigenvalues of the kernel's matrix with the noise.
    """
    best, found = -np.inf, None
    apart = _apart(objects, objects)
    for length in lengths:
        bare, vectors = np.linalg.eigh(_alike(apart, length))
        squares = (vectors.T @ outcomes) ** 2
        every = np.maximum(bare, 0) + np.array(noises)[:, None]  # (noises, n)
        variance = (squares / every[..., None]).mean(1) + 1e-9
        columns = outcomes.shape[1]
        likelihoods = -0.5 * (len(objects) * np.log(variance).sum(1) + columns * np.log(every).sum(1))
        likeliest = int(likelihoods.argmax())
        if likelihoods[likeliest] > best:
            best = float(likelihoods[likeliest])
            found = length, noises[likeliest], vectors, every[likeliest]
    assert found is not None, "outcomes are finite"
    return found


def _deciding(
    objects: Float[np.ndarray, "N F"], kept: Float[np.ndarray, "N"]
) -> tuple[tuple[float, ...], int]:
    """Find which features decide whether a promise is kept, by how likely that makes those left out.

    A hand closes over what is narrow, however long it is. All features count alike, or none if they say
    nothing, unless few of them say clearly more.

    Returns:
        By what features are multiplied, and how many of the nearest objects tell.
    """
    found, best = (np.ones(objects.shape[1]), _NEIGHBOURS[0]), -np.inf
    squares = (objects.T[:, :, None] - objects.T[:, None]) ** 2  # (F, N, N)
    for metric in _metrics(objects.shape[1]):
        apart = np.sqrt(squares[metric > 0].sum(0))
        np.fill_diagonal(apart, np.inf)
        nearest = _nearest(apart, _NEIGHBOURS)
        for neighbours, last in zip(_NEIGHBOURS, nearest, strict=True):
            chances = np.clip(_chances(apart, kept, last), 0.01, 0.99)
            likelihood = float(np.log(np.where(kept == 1, chances, 1 - chances)).sum())
            likelihood += _CLEARLY if metric.all() or not metric.any() else 0.0
            if likelihood > best:
                found, best = (metric, neighbours), likelihood
    return tuple(found[0].tolist()), found[1]


@cache
def _metrics(features: int) -> tuple[Float[np.ndarray, "F"], ...]:
    """List by what features can be multiplied: all by 1, none, and then few of them, the others by 0."""
    few = [
        np.isin(np.arange(features), chosen).astype(float)
        for count in range(1, min(_DECIDING, features - 1) + 1)
        for chosen in combinations(range(features), count)
    ]
    return (np.ones(features), np.zeros(features), *few)


def _nearest(apart: Float[np.ndarray, "N M"], neighbours: Sequence[int]) -> Float[np.ndarray, "K M"]:
    """Return how far the last of so many nearest objects is, of those at a finite distance."""
    counting = int(np.isfinite(apart).sum(0).min(initial=len(apart)))
    last = [min(number, counting) - 1 for number in neighbours]
    return np.asarray(np.partition(apart, last, axis=0)[last])


def _chances(
    apart: Float[np.ndarray, "N M"], kept: Float[np.ndarray, "N"], last: Float[np.ndarray, "M"]
) -> Float[np.ndarray, "M"]:
    """Estimate how often a promise is kept, by objects about as far `apart` as the `last` that tells."""
    within = _WITHIN * np.maximum(last, 1e-6)
    near = np.exp(-(apart**2) / (2 * within**2))
    return np.asarray((kept @ near + _RATE * kept.mean()) / (near.sum(0) + _RATE))


def _alike(apart: Float[np.ndarray, "n m"], length: float) -> Float[np.ndarray, "n m"]:
    """Compute the squared-exponential kernel."""
    return np.asarray(np.exp(-(apart**2) / (2 * length**2)))


def _apart(ones: Float[np.ndarray, "n F"], others: Float[np.ndarray, "m F"]) -> Float[np.ndarray, "n m"]:
    """Compute how far objects are apart."""
    return np.asarray(np.sqrt(((ones[:, None] - others[None]) ** 2).sum(-1)))


# What fitting the rehearsals of a grounding came to, kept beside it so that it is not sought at each call.
#
# A fit seeks how far outcomes reach, how noisy they are, and which features decide, each among few; the
# rest follows in no time. So that is what the file holds, with the digest of the grounding that it was
# found for. Where it is missing, damaged, or of another grounding, it is sought anew.

NAME = "fits.json"  # what the file is called, beside the grounding
FORMAT = "neurosym-fits-1"
_MOST = 64 * MEGABYTE
_found: dict[str, tuple[Operator, Category | None, Choice]] = {}  # for the grounding that was read last


class _Fits(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    format: str
    grounding: str
    choices: dict[LegalName, Choice]


def save_fits(grounding_file: Path, choices: Mapping[str, Choice]) -> None:
    """Write what was found for operators, by name, beside a grounding that is there or a draft."""
    (digest,) = digests({NAME: grounding_file}).values()
    write_json(grounding_file.with_name(NAME), _Fits(FORMAT, digest, dict(sorted(choices.items()))))


def remember_fits(
    grounding_file: Path, content: bytes, operators: Iterable[Operator], categories: Iterable[Category]
) -> None:
    """Read what was found for the operators of a grounding, which was read from a file of such content."""
    _found.clear()
    path = grounding_file.with_name(NAME)
    try:
        fits = decode_json(path, read_bytes(path, _MOST), _Fits)
    except InvalidFile:
        return
    if fits.format != FORMAT or fits.grounding != hashlib.sha256(content).hexdigest():
        return
    by_symbol = {category.symbol: category for category in categories}
    for operator in operators:
        if choice := fits.choices.get(operator.name):
            _found[operator.name] = (operator, by_symbol.get(operator.subject), choice)


def found_for(operator: Operator, category: Category) -> Choice | None:
    """Return what fitting an operator's rehearsals came to, if it is known of one that is wholly the same."""
    *known, choice = _found.get(operator.name, (None, None, None))
    return choice if known == [operator, category] else None
