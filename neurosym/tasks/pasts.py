"""Pasts: what an object was seen to do, and what its operators promise of it then.

The same primitive will probably do the same to the same object again, as long as that lies the same way. So
an operator promises the mean of what was promised before and of what was seen, each weighed by how sure it
is; the chance of an outcome counts what came and what did not. After two failures in a row, or one that was
likely, an operator promises what was seen in place of what did not come.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.operators import TOLERANCE, Mode, Operator, Vector, vector
from neurosym.pair_operators import rotation
from neurosym.problems import Problem, SceneObject, Trial
from neurosym.world import Outcome, heading, turned_by

KNOWN_BEFORE, KNOWN_IN_A_CROWD = 0.5, 2.0
"""As how many trials what was known before counts beside those that were seen.

Whether an operator keeps its promise is mostly the object's doing, see `docs/planning.md`, "The chance"; but
where others were in the way it may be theirs.
"""
LEAST_CHANCE = 0.25
"""Operators that keep their promise more rarely with such an object are not planned with.

Whether it is kept is mostly the object's doing, so that trying again does not help. Such low chances are said
too high, too: of promises said to be kept in 10 to 25 %, 9 % were (`docs/planning.md`, "The chance").
"""
GIVEN_UP = 2
"""After how many failures in a row what did not come is not hoped for again."""
SLIPPERY = 1.5
"""An object that should have been carried so often by what was tried, and never was, is not tried to be
carried by other operators."""
EXPECTED, UNFAMILIAR = 2.0, 0.9
"""As how many motions of a kind an object counts beside those that were seen, expected to keep their promise,
and which share of these does: it may be unlike all that were learned of.

Chosen on 163 objects of shapes never seen and with properties that no feature shows, on seeds of their own.
After three tries the chances of other motions have a Brier score of .172, and .204 if nothing is learned from
tries; of usual objects .065 and .062.
"""
BORROWED = 0.24
"""How much rarer than with objects of its category an operator keeps its promise with one that was tried.

Of the objects that `EXPECTED` was chosen on, those that nothing of their own category grasps surely were
carried so in 24 % of 465 cases. So it is planned with once it was tried and came true. Pushes count alike,
and what one did is planned with in place of its promise. Objects that were not tried are handled as their
features say: to borrow for these took a fifth more motions in 40 runs.
"""
_STRAIGHT = (0.0, 0.0, 0.0, 1.0)
GRASPED = ("held", "carried")
"""How what is grasped ends; one motion that grasps tells of others, and one that pushes of others."""
REPEATS = 0.005
"""By how much the same primitive on the same object differs from one time to the next, of an axis [m]."""
FADES = 0.3
"""How much an outcome counts beside the one after it: an object that is turned a little does otherwise.

Chosen with `REPEATS` on pushes that came after the same one, in runs on seeds of their own. Of 639 with 73
objects the next is foreseen within 2.2 mm in the median, and within 4.8 by an even mean and 14 mm.
"""
_AS_IT_LAY = math.radians(15)  # an object that is turned by less lies as it did [rad]
_SUREST = 0.005  # no promise is surer than this [m]
_TO = "to-"


def motion_of(operator: Operator) -> str:
    """Return which motion an operator is; those that carry to places have labels of their own."""
    return f"{_TO}{operator.label}" if operator.frame == "place" else operator.label


def trial_of(outcome: Outcome, operator: Operator, turned: bool, run: str = "") -> Trial:
    """Say what became of an object, in the frame in which motions are learned; these may turn as it lies.

    It was seen in a run, or tried.
    """
    lay = outcome.start.orientations[outcome.target]
    turn = heading(lay) if turned else 0.0
    effects = outcome.effect, outcome.resting_effect
    if operator.frame == "object":
        effects = turned_by(-turn, effects[0]), turned_by(-turn, effects[1])
    return Trial(
        motion=motion_of(operator),
        kind=outcome.kind,
        effect=vector(effects[0]),
        resting_effect=vector(effects[1]),
        lay=tuple(lay.tolist()),
        crowded=bool(outcome.touched or outcome.disturbed),
        run=run,
    )


def with_pasts(problem: Problem, pasts: Mapping[str, Sequence[Trial]]) -> Problem:
    """Return a problem whose objects, by name, have done this, too."""
    objects = (
        msgspec.structs.replace(item, past=(*past_of(item), *pasts[item.name]))
        if item.name in pasts
        else item
        for item in problem.objects
    )
    return msgspec.structs.replace(problem, objects=tuple(objects))


def forgetting(problem: Problem) -> Problem:
    """Return a problem in which what its objects did counts only against hoping for what it shows to fail."""
    objects = []
    for item in problem.objects:
        past = tuple(msgspec.structs.replace(one, forgotten=True) for one in past_of(item))
        objects.append(msgspec.structs.replace(item, past=past) if past else item)
    return msgspec.structs.replace(problem, objects=tuple(objects))


def past_of(item: SceneObject) -> tuple[Trial, ...]:
    """Return what an object was seen to do, however it lay."""
    return () if item.past is msgspec.UNSET else item.past


def never_seen(item: SceneObject) -> SceneObject:
    """Return an object as those are that operators were learned of: straight, and with no past."""
    return msgspec.structs.replace(item, past=msgspec.UNSET, orientation=_STRAIGHT)


def as_it_lies(item: SceneObject, turned: bool) -> tuple[Trial, ...]:
    """Return what an object did while it lay as it does now, but for turns that do not matter."""
    past = past_of(item)
    return _while_it_lay(item.orientation, past, turned) if past else ()


@lru_cache(maxsize=1024)
def _while_it_lay(
    orientation: tuple[float, float, float, float], past: tuple[Trial, ...], turned: bool
) -> tuple[Trial, ...]:
    axes = _axes(orientation, turned)
    between = ((one, (float(np.trace(axes.T @ _axes(one.lay, turned))) - 1) / 2) for one in past)
    return tuple(one for one, cosine in between if math.acos(min(1.0, max(-1.0, cosine))) < _AS_IT_LAY)


def _axes(orientation: Sequence[float], turned: bool) -> Float[np.ndarray, "3 3"]:
    """Return the axes of an object, as columns, turned back about the vertical as motions are."""
    lies = np.array(orientation)
    return np.asarray(turned_by(-heading(lies) if turned else 0.0, rotation(lies).T).T)


def promised_after(
    own: Mapping[str, Operator], known: Iterable[Operator], past: Sequence[Trial], tolerance: float
) -> dict[str, Operator]:
    """Return the operators on an object, by name, as they promise after its past.

    What was done by other motions of its kind tells how reliable the object is: how much was kept beside what
    had been expected, and beside what is so of an object of which nothing was seen; see `EXPECTED`.

    Args:
        own: What is learned of its category, as it promises for such an object of which nothing was seen.
        known: All that is learned; what other categories are handled with may handle it, if it was tried.
        past: What was seen of it while it lay as it does now.
        tolerance: An outcome that comes within this of the promise has kept it [m].
    """
    seen = dict[str, list[Trial]]()
    for one in past:
        seen.setdefault(one.motion, []).append(one)
    usual = {one.name: msgspec.structs.replace(one, company=()) for one in own.values()}
    if any(not one.run for one in past):  # it was met, and may be unlike what its features say
        usual |= _borrowed(known, own.values())
    evidence = _evidence(usual, seen, tolerance)
    carrying = [shown for motion, shown in evidence.items() if motion.startswith(_TO)]
    missed = math.fsum(shown.expected for shown in carrying)
    is_slippery = missed >= SLIPPERY and not any(shown.kept for shown in carrying)
    found = dict[str, Operator]()
    for name, operator in usual.items():
        promise, rows = operator.promise, seen.get(motion_of(operator), [])
        if promise is None:
            found[name] = operator
        elif operator.frame == "place" and is_slippery:
            found[name] = _promising(operator, promise, 0.0)
        elif is_given_up(operator, rows, tolerance):
            found[name] = _promising(operator, *_instead(promise, rows, tolerance))
        elif (outcomes := [one for one in rows if not one.forgotten]) or evidence:
            mode, kept = _weighed_mode(promise, outcomes, tolerance)
            prior = min(1.0, _share(operator) * _reliability(operator, evidence))
            found[name] = _promising(operator, mode, _chance(prior, outcomes, kept))
        else:
            found[name] = operator
    return found


def _share(operator: Operator) -> float:
    return operator.successes / operator.trials


class _Shown(NamedTuple):
    """What one motion showed of an object."""

    grasps: bool  # whether it is to grasp
    kept: float  # in which share of the trials it kept its promise
    expected: float  # the chance that it would


def _evidence(
    operators: Mapping[str, Operator], seen: Mapping[str, Sequence[Trial]], tolerance: float
) -> dict[str, _Shown]:
    """Say what each motion showed that was tried with nothing in its way."""
    found = dict[str, _Shown]()
    for operator in operators.values():
        motion, promise = motion_of(operator), operator.promise
        rows = [one for one in seen.get(motion, ()) if not (one.forgotten or one.crowded)]
        if promise and rows and motion not in found:
            kept = [keeps(promise, one, max(tolerance, TOLERANCE)) for one in rows]
            found[motion] = _Shown(promise.kind in GRASPED, float(np.mean(kept)), operator.chance)
    return found


def _reliability(operator: Operator, evidence: Mapping[str, _Shown]) -> float:
    """Return by what factor an operator's chance is another one, by what other motions showed."""
    grasps = operator.promise is not None and operator.promise.kind in GRASPED
    others = [
        one for motion, one in evidence.items() if motion != motion_of(operator) and one.grasps == grasps
    ]
    if not others:
        return 1.0
    kept, expected = math.fsum(one.kept for one in others), math.fsum(one.expected for one in others)
    return (UNFAMILIAR * EXPECTED + kept) / (EXPECTED + expected)


def _borrowed(known: Iterable[Operator], own: Iterable[Operator]) -> dict[str, Operator]:
    """Return what is done to objects of other categories, by name, as it promises of one that is of none.

    The motions of its own category are left out.
    """
    motions, found = {motion_of(one) for one in own}, dict[str, Operator]()
    for operator in known:
        motion, promise = motion_of(operator), operator.promise
        if operator.frame in ("object", "place") and promise and motion not in motions:
            plain = msgspec.structs.replace(operator, rehearsals=(), objects=(), company=())
            one = _promising(plain, promise, BORROWED * _share(operator))
            if motion not in found or one.successes > found[motion].successes:
                found[motion] = one
    return {one.name: one for one in found.values()}


def is_given_up(operator: Operator, outcomes: Sequence[Trial], tolerance: float) -> bool:
    """Say whether what an operator promises failed the last time, and too often to be hoped for again."""
    if operator.promise is None or not outcomes:
        return False
    _, kept = _weighed_mode(operator.promise, outcomes, tolerance)
    if any(kept[-GIVEN_UP:]):
        return False
    return len(kept) >= GIVEN_UP or _chance(_share(operator), outcomes, kept) < LEAST_CHANCE


def _chance(prior: float, outcomes: Sequence[Trial], kept: list[bool]) -> float:
    """Weigh how often a promise is kept, as far as was known before, against how often it was."""
    known = KNOWN_IN_A_CROWD if any(one.crowded for one in outcomes) else KNOWN_BEFORE
    return (known * prior + sum(kept)) / (known + len(kept))


def keeps(promise: Mode, trial: Trial, near: float = TOLERANCE) -> bool:
    """Say whether what came is what was promised, within a tolerance [m]."""
    end = trial.effect if promise.kind == "held" else trial.resting_effect
    return trial.kind == promise.kind and math.dist(promise.outcome, end) <= near


def _weighed_mode(promise: Mode, outcomes: Sequence[Trial], tolerance: float) -> tuple[Mode, list[bool]]:
    """Weigh a promise against what was seen, and say which outcomes came as was promised before them."""
    near, mode, kept = max(tolerance, TOLERANCE), promise, list[bool]()
    for number, outcome in enumerate(outcomes, 1):
        kept.append(keeps(mode, outcome, near))
        mode = _after(promise, [one for one in outcomes[:number] if one.kind == promise.kind])
    return mode, kept


def _after(promise: Mode, outcomes: Sequence[Trial]) -> Mode:
    """Weigh a promise against outcomes of its kind."""
    if not outcomes:
        return promise
    effect, spread = _weighed(promise.effect, promise.spread, [one.effect for one in outcomes])
    ends = [one.resting_effect for one in outcomes]
    resting, resting_spread = _weighed(promise.resting_effect, promise.resting_spread, ends)
    return msgspec.structs.replace(
        promise, effect=effect, spread=spread, resting_effect=resting, resting_spread=resting_spread
    )


def _weighed(
    mean: tuple[float, ...], spread: tuple[float, ...], seen: Sequence[Vector]
) -> tuple[Vector, Vector]:
    """Weigh a mean against what was seen; it was less sure than it said if what was seen is far from it.

    What is seen to scatter is as unsure as that.
    """
    came, scatter, weight = _faded(seen)
    before = 1 / np.maximum(np.maximum(np.array(spread), np.abs(came - mean)), _SUREST) ** 2
    now = weight / (REPEATS**2 + scatter)
    value = (before * np.array(mean) + now * came) / (before + now)
    return vector(value), vector(np.sqrt(1 / (before + now) + scatter))


def _faded(seen: Sequence[Vector]) -> tuple[np.ndarray, np.ndarray, float]:
    """Return mean and variance of what was seen, the last of it weighed most, and the sum of weights."""
    weights = FADES ** np.arange(len(seen))[::-1]
    came = np.average(seen, axis=0, weights=weights)
    return came, np.average((np.array(seen) - came) ** 2, axis=0, weights=weights), float(weights.sum())


def _instead(promise: Mode, outcomes: Sequence[Trial], tolerance: float) -> tuple[Mode, float]:
    """Return what came in the place of what did not, and how often, if it can be planned with."""
    kind = outcomes[-1].kind
    if kind not in ("resting", "held"):
        return promise, 0.0
    like = [one for one in outcomes if one.kind == kind]
    (effect, scatter, _), (resting, resting_scatter, _) = (
        _faded(rows) for rows in ([one.effect for one in like], [one.resting_effect for one in like])
    )
    seen = msgspec.structs.replace(
        promise,
        kind=kind,
        effect=vector(effect),
        spread=vector(np.sqrt(REPEATS**2 + scatter)),
        resting_effect=vector(resting),
        resting_spread=vector(np.sqrt(REPEATS**2 + resting_scatter)),
    )
    return seen, sum(keeps(seen, one, max(tolerance, TOLERANCE)) for one in like) / (len(outcomes) + 1)


def _promising(operator: Operator, mode: Mode, share: float) -> Operator:
    """Return an operator that promises a mode, which it keeps in a share of its trials."""
    kept = round(share * operator.trials)
    count = max(kept, 1)
    mode = msgspec.structs.replace(mode, near_mean=kept, count=count, share=count / operator.trials)
    others = tuple(other for other in operator.outcomes if other.kind != mode.kind)
    return msgspec.structs.replace(operator, outcomes=(mode, *others), promised=mode.kind)
