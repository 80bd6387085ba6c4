"""Pasts: what an object was seen to do, and what its operators promise of it then.

The same primitive will probably do the same to the same object again, as long as that lies the same way. So
an operator promises the mean of what was promised before and of what was seen, each weighed by how sure it
is; the chance of an outcome counts what came and what did not. After two failures in a row, or one that was
likely, an operator promises what was seen in place of what did not come.
"""

import math
from collections.abc import Mapping, Sequence

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.grounding import Grounding
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
SLIPPERY = 3
"""An object that was missed so often, and never carried, is not tried to be carried by other operators."""
REPEATS = 0.014
"""By how much the same primitive on the same object differs from time to time, RMS of an axis [m]."""
_AS_IT_LAY = math.radians(15)  # an object that is turned by less lies as it did [rad]
_SUREST = 0.005  # no promise is surer than this [m]
_TO = "to-"


def motion_of(operator: Operator) -> str:
    """Return which motion an operator is; those that carry to places have labels of their own."""
    return f"{_TO}{operator.label}" if operator.frame == "place" else operator.label


def trial_of(outcome: Outcome, operator: Operator, grounding: Grounding) -> Trial:
    """Say what became of an object, in the frame in which motions are learned."""
    lay = outcome.start.orientations[outcome.target]
    turn = heading(lay) if grounding.turned else 0.0
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
    )


def with_pasts(problem: Problem, pasts: Mapping[str, Sequence[Trial]]) -> Problem:
    """Return a problem whose objects, by name, have done this, too."""
    objects = (_after(item, (*past_of(item), *pasts.get(item.name, ()))) for item in problem.objects)
    return msgspec.structs.replace(problem, objects=tuple(objects))


def past_of(item: SceneObject) -> tuple[Trial, ...]:
    """Return what an object was seen to do, however it lay."""
    return () if item.past is msgspec.UNSET else item.past


def _after(item: SceneObject, past: tuple[Trial, ...]) -> SceneObject:
    return msgspec.structs.replace(item, past=past or msgspec.UNSET)


def as_it_lies(item: SceneObject, turned: bool) -> tuple[Trial, ...]:
    """Return what an object did while it lay as it does now, but for turns that do not matter."""
    if not (past := past_of(item)):
        return ()
    axes = _axes(item.orientation, turned)
    between = ((one, (float(np.trace(axes.T @ _axes(one.lay, turned))) - 1) / 2) for one in past)
    return tuple(one for one, cosine in between if math.acos(min(1.0, max(-1.0, cosine))) < _AS_IT_LAY)


def laid(item: SceneObject, orientation: tuple[float, float, float, float], turned: bool) -> SceneObject:
    """Return an object that counts as if it lay otherwise, and had lain so whenever it lay as it does."""
    past = (msgspec.structs.replace(one, lay=orientation) for one in as_it_lies(item, turned))
    return _after(msgspec.structs.replace(item, orientation=orientation), tuple(past))


def _axes(orientation: Sequence[float], turned: bool) -> Float[np.ndarray, "3 3"]:
    """Return the axes of an object, as columns, turned back about the vertical as motions are."""
    lies = np.array(orientation)
    return np.asarray(turned_by(-heading(lies) if turned else 0.0, rotation(lies).T).T)


def promised_after(
    operators: Mapping[str, Operator], past: Sequence[Trial], tolerance: float
) -> dict[str, Operator]:
    """Return the operators on an object, by name, as they promise after its past.

    Args:
        operators: As they promise for such an object of which nothing was seen.
        past: What was seen of it while it lay as it does now.
        tolerance: An outcome that comes within this of the promise has kept it [m].
    """
    seen = dict[str, list[Trial]]()
    for one in past:
        seen.setdefault(one.motion, []).append(one)
    carried = [one.kind == "carried" for one in past if one.motion.startswith(_TO) and not one.forgotten]
    is_slippery = len(carried) >= SLIPPERY and not any(carried)
    found = dict[str, Operator]()
    for name, known in operators.items():
        operator = msgspec.structs.replace(known, company=())  # it is this object that was seen
        promise, rows = operator.promise, seen.get(motion_of(operator), [])
        if promise is None:
            found[name] = operator
        elif operator.frame == "place" and is_slippery:
            found[name] = _promising(operator, promise, 0.0)
        elif is_given_up(operator, rows, tolerance):
            found[name] = _given_up(operator, promise, rows)
        elif outcomes := [one for one in rows if not one.forgotten]:
            mode, kept = _weighed_mode(promise, outcomes, tolerance)
            found[name] = _promising(operator, mode, _chance(operator, outcomes, kept))
        else:
            found[name] = operator
    return found


def is_given_up(operator: Operator, outcomes: Sequence[Trial], tolerance: float) -> bool:
    """Say whether what an operator promises failed the last time, and too often to be hoped for again."""
    if operator.promise is None or not outcomes:
        return False
    _, kept = _weighed_mode(operator.promise, outcomes, tolerance)
    if any(kept[-GIVEN_UP:]):
        return False
    return len(kept) >= GIVEN_UP or _chance(operator, outcomes, kept) < LEAST_CHANCE


def _chance(operator: Operator, outcomes: Sequence[Trial], kept: list[bool]) -> float:
    """Weigh how often a promise is kept against how often it was."""
    known = KNOWN_IN_A_CROWD if any(one.crowded for one in outcomes) else KNOWN_BEFORE
    return (known * operator.successes / operator.trials + sum(kept)) / (known + len(kept))


def _weighed_mode(promise: Mode, outcomes: Sequence[Trial], tolerance: float) -> tuple[Mode, list[bool]]:
    """Weigh a promise against what was seen, and say which outcomes came as is promised then."""
    mode, near = promise, max(tolerance, TOLERANCE)
    if same := [outcome for outcome in outcomes if outcome.kind == promise.kind]:
        effect, spread = _weighed(mode.effect, mode.spread, np.array([one.effect for one in same]))
        seen = np.array([one.resting_effect for one in same])
        resting, resting_spread = _weighed(mode.resting_effect, mode.resting_spread, seen)
        mode = msgspec.structs.replace(
            mode, effect=effect, spread=spread, resting_effect=resting, resting_spread=resting_spread
        )
    ends = [one.effect if mode.kind == "held" else one.resting_effect for one in outcomes]
    misses = [math.dist(mode.outcome, end) for end in ends]
    return mode, [one.kind == mode.kind and miss <= near for one, miss in zip(outcomes, misses, strict=True)]


def _weighed(mean: tuple[float, ...], spread: tuple[float, ...], seen: np.ndarray) -> tuple[Vector, Vector]:
    """Weigh a mean against what was seen; it was less sure than it said if what was seen is far from it."""
    away = np.abs(seen.mean(0) - mean)
    before = 1 / np.maximum(np.maximum(np.array(spread), away), _SUREST) ** 2
    now = len(seen) / REPEATS**2
    value = (before * np.array(mean) + now * seen.mean(0)) / (before + now)
    return vector(value), vector(np.sqrt(1 / (before + now)))


def _given_up(operator: Operator, promise: Mode, outcomes: Sequence[Trial]) -> Operator:
    """Promise what was seen in the place of what did not come, if it can be planned with."""
    kind = outcomes[-1].kind
    if kind not in ("resting", "held"):
        return _promising(operator, promise, 0.0)
    like = [one for one in outcomes if one.kind == kind]
    seen = msgspec.structs.replace(
        promise,
        kind=kind,
        effect=vector(np.mean([one.effect for one in like], axis=0)),
        spread=(REPEATS,) * 3,
        resting_effect=vector(np.mean([one.resting_effect for one in like], axis=0)),
        resting_spread=(REPEATS,) * 3,
    )
    return _promising(operator, seen, len(like) / (len(outcomes) + 1))


def _promising(operator: Operator, mode: Mode, share: float) -> Operator:
    """Return an operator that promises a mode, which it keeps in a share of its trials."""
    kept = round(share * operator.trials)
    count = max(kept, 1)
    mode = msgspec.structs.replace(mode, near_mean=kept, count=count, share=count / operator.trials)
    others = tuple(other for other in operator.outcomes if other.kind != mode.kind)
    return msgspec.structs.replace(operator, outcomes=(mode, *others), promised=mode.kind)
