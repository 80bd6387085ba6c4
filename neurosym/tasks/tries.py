"""Tries: which motion to try next with an object, so that what comes of it tells most.

Worth is what can be planned with: the surest way to carry the object anywhere, and where that fails the
surest push in each direction. A try is worth how much better the best choice will be once its outcome is
known, on average over both outcomes: the knowledge gradient (Frazier, Powell and Dayanik, 2008).
"""

import math
from collections.abc import Mapping

import msgspec
import numpy as np

from neurosym.grounding import Grounding
from neurosym.operators import PROMISING, Mode, Operator, vector
from neurosym.problems import SceneObject, Trial
from neurosym.tasks.pasts import GRASPED, Belief, motion_of, past_of
from neurosym.tasks.promises import believed, promised
from neurosym.world import OutcomeKind

_WAYS = 8  # directions that are asked for
_ACROSS = math.pi / 6  # how far off a direction a push still leads that way [rad]
_LEAST_PUSH = 0.01  # what moves less far leads nowhere [m]
_OF_PUSHES = 0.5  # what pushes are worth beside carrying: they come there in several steps


def next_try(item: SceneObject, grounding: Grounding) -> tuple[Operator, Mode] | None:
    """Choose what to try with an object of some past, and say what is promised; None if there is nothing.

    The same motion mostly does the same again, so others come first.
    """
    now, tried = believed(grounding, item), {one.motion for one in past_of(item)}
    untried = [name for name, one in sorted(now.items()) if motion_of(one.operator) not in tried]
    gains = {name: _gain(name, now, item, grounding) for name in untried or sorted(now)}
    if not gains:
        return None
    best = max(gains, key=lambda name: (gains[name], now[name].share))
    return grounding.operator_named(best), now[best].promise


def _gain(name: str, now: Mapping[str, Belief], item: SceneObject, grounding: Grounding) -> float:
    """Return by how much more can be planned once an operator was tried, on average."""
    share, promise, motion = now[name].share, now[name].promise, motion_of(now[name].operator)
    comes, fails = (_worth(believed(grounding, _after(item, motion, promise, is_kept))) for is_kept in (1, 0))
    return share * comes + (1 - share) * fails - _worth(now)


def _after(item: SceneObject, motion: str, promise: Mode, is_kept: int) -> SceneObject:
    """Return an object once a motion did with it what is promised, or let it be."""
    effect, resting = map(vector, is_kept * np.array([promise.effect, promise.resting_effect]))
    kind: OutcomeKind = "missed" if promise.kind == "carried" else "resting"
    if is_kept:
        kind = next(known for known in PROMISING if known == promise.kind)
    trial = Trial(motion, kind, effect, resting, item.orientation)
    return msgspec.structs.replace(item, past=(*past_of(item), trial))


def _worth(beliefs: Mapping[str, Belief]) -> float:
    """Say what can be planned with what is believed: from 0 to 1."""
    grasps, pushes = [0.0], [[0.0] for _ in range(_WAYS)]
    for _, promise, share in beliefs.values():
        x, y = promise.resting_effect[:2]
        if promise.kind in GRASPED:
            grasps.append(share)
        elif math.hypot(x, y) > _LEAST_PUSH:
            for way, found in enumerate(pushes):
                away = (math.atan2(y, x) - 2 * math.pi * way / _WAYS + math.pi) % (2 * math.pi) - math.pi
                if abs(away) <= _ACROSS:
                    found.append(share)
    surest = max(grasps)
    return surest + (1 - surest) * _OF_PUSHES * math.fsum(map(max, pushes)) / _WAYS


def said_of(item: SceneObject, grounding: Grounding) -> str:
    """Say in a sentence what an object of some past looks like, and how it is best handled."""
    known = promised(grounding, msgspec.structs.replace(item, past=past_of(item)))
    grasping = [one for one in known.values() if one.promise and one.promise.kind in GRASPED]
    said = f"{item.name} looks like {grounding.category(item.category).name}"
    if not grasping:
        return f"{said}; nothing grasps such objects"
    surest = max(grasping, key=lambda one: (one.chance, one.name))
    handled = "so" if surest.subject == item.category else f"like {grounding.category(surest.subject).name}"
    return f"{said}, and is best grasped {handled}: {surest.name}, {surest.chance:.0%} likely"
