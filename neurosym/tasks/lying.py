"""How objects lie: by which sizes they count, on which side, and what sets them upright again.

What was learned holds for objects that stand straight. One that was turned by a quarter has its sizes along
other axes; one that stands askew is as wide as the box around it. What shall stand upright, and lies on a
side, is set upright before anything else is done with it, so plans count it as it stands then.
"""

import math
from collections.abc import Mapping

import msgspec
import numpy as np

from neurosym.checks import Bool, Float
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE, Category, Operator, Symbol, vector
from neurosym.pair_operators import rotation
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.pasts import LEAST_CHANCE, as_it_lies
from neurosym.tasks.promises import refined
from neurosym.world import Outcome, OutcomeKind, heading, turned_by

STRAIGHT = math.radians(15)
"""An object that is turned by less than this beyond a quarter counts as straight [rad]."""
SIDES: Mapping[Symbol, str] = {"00": "forward", "01": "back", "10": "left", "11": "right"}
"""The sides that an object may lie on, by where its top points as motions are turned."""
UPRIGHT, OVER = "", "1"  # what stands for no side, and for upside down
_STANDS = math.cos(math.radians(30))


def side_of(orientation: Float[np.ndarray, "4"], turned: bool) -> Symbol:
    """Return on which side an object lies, `UPRIGHT` if it stands; motions may be turned as it lies."""
    x, y, z = turned_by(-heading(orientation) if turned else 0.0, rotation(orientation)[:, 2]).tolist()
    if abs(z) > _STANDS:
        return UPRIGHT if z > 0 else OVER
    axis, along = (0, x) if abs(x) >= abs(y) else (1, y)
    return f"{axis}{int(along < 0)}"


def righted(outcome: Outcome) -> OutcomeKind:
    """Return how a target ended that was to be set upright: at rest if it stands, else toppled."""
    if outcome.lost or outcome.held:
        return outcome.kind
    return "toppled" if side_of(outcome.end.orientations[outcome.target], turned=False) else "resting"


def righting(item: SceneObject, grounding: Grounding) -> Operator | None:
    """Return what sets an object upright as it lies, as it promises for this object; None if nothing does."""
    side = side_of(np.array(item.orientation), grounding.turned)
    known = grounding.upright.operators if grounding.upright else ()
    learned = next((one for one in known if one.subject == side), None)
    if learned is None:
        return None
    objects = Category(side, SIDES[side], 1.0, (), (), learned.objects)
    operator = refined(learned, objects, item.features, TOLERANCE)
    if (promise := operator.promise) is None or operator.successes < LEAST_CHANCE * operator.trials:
        return None
    x, y = turned_by(_turn(item, grounding), np.array(promise.resting_effect[:2])).tolist()
    by = (x, y, item.features[2] / 2 - item.position[2])
    return msgspec.structs.replace(operator, outcomes=(msgspec.structs.replace(promise, resting_effect=by),))


def lying(problem: Problem, grounding: Grounding) -> dict[str, Operator | None]:
    """Return what sets each object upright that shall stand and does not, by its name; None if nothing can.

    It must come to stand on the table, and in no other object.
    """
    found = dict[str, Operator | None]()
    for name in problem.upright:
        item = problem.object_named(name)
        if side_of(np.array(item.orientation), turned=False):
            operator = righting(item, grounding)
            has_room = operator and _has_room(_raised(item, operator), problem, grounding)
            found[name] = operator if has_room else None
    return found


def _has_room(item: SceneObject, problem: Problem, grounding: Grounding) -> bool:
    others = [other for other in problem.objects if other.name != item.name]
    away = np.abs([np.subtract(other.position, item.position)[:2] for other in others]).reshape(-1, 2)
    apart = np.array([np.add(other.features[:2], item.features[:2]) / 2 for other in others]).reshape(-1, 2)
    return grounding.table.contains(np.array(item.position)) and bool(np.all((away >= apart).any(1)))


def as_raised(problem: Problem, grounding: Grounding) -> Problem:
    """Return a problem with what is to be set upright as it will stand then."""
    raised = {name: operator for name, operator in lying(problem, grounding).items() if operator}
    objects = (_raised(item, raised[item.name]) if item.name in raised else item for item in problem.objects)
    return msgspec.structs.replace(problem, objects=tuple(objects)) if raised else problem


def as_planned(problem: Problem, grounding: Grounding) -> Problem:
    """Return a problem with its objects as plans count them: as they show, or will once they are upright.

    What stands askew counts as it was drawn, unless it is given as it shows.
    """
    raised = as_raised(problem, grounding)
    objects = tuple(
        as_it_shows(item, grounding) if _faces(item, grounding).any(0).all() else item
        for item in raised.objects
    )
    return raised if objects == raised.objects else msgspec.structs.replace(raised, objects=objects)


def _raised(item: SceneObject, operator: Operator) -> SceneObject:
    """Return an object as it will stand once an operator has set it upright: turned the shortest way."""
    assert operator.promise is not None, "only what promises something is chosen"
    position = vector(np.add(item.position, operator.promise.resting_effect))
    lies = np.array(item.orientation) / np.linalg.norm(item.orientation)
    x, y, z = rotation(lies)[:, 2]  # where its top points
    tip = np.array([y, -x, 0.0, 1 + z])  # the quaternion that turns it up
    tip /= np.linalg.norm(tip)
    axis = tip[3] * lies[:3] + lies[3] * tip[:3] + np.cross(tip[:3], lies[:3])
    stands = (*vector(axis), float(tip[3] * lies[3] - tip[:3] @ lies[:3]))
    return msgspec.structs.replace(item, position=position, orientation=stands)


def as_it_shows(item: SceneObject, grounding: Grounding) -> SceneObject:
    """Return an object with the sizes that it has along the axes, and the category of objects like that.

    Its first three features are these sizes [m]; unless it stands askew, it lies as if it had been drawn so.
    Where no rehearsals are kept, the category stays.
    """
    faces = _faces(item, grounding)
    is_askew = not faces.any(0).all()
    turned = _along(item, grounding) if is_askew else faces.astype(float)
    if np.array_equal(turned, np.eye(3)):
        return item
    shown = tuple(round(size, 6) for size in (turned @ np.array(item.features[:3])).tolist())
    features, category = (*shown, *item.features[3:]), item.category
    categories = grounding.objects.categories
    if rehearsed := [(row, one.symbol) for one in categories for row in one.objects]:
        objects = np.array([row for row, _ in rehearsed])
        apart = (objects - features) / np.maximum(objects.std(0), 1e-9)
        category = rehearsed[int(np.argmin((apart**2).sum(1)))][1]
    lies = item.orientation if is_askew else _about(_turn(item, grounding))
    past = item.past
    if past is not msgspec.UNSET:  # what it did as it lies, it did as it counts
        past = tuple(msgspec.structs.replace(one, lay=lies) for one in as_it_lies(item, grounding.turned))
    return msgspec.structs.replace(item, features=features, category=category, orientation=lies, past=past)


def _along(item: SceneObject, grounding: Grounding) -> Float[np.ndarray, "3 3"]:
    """Return how far each axis of an object, a column each, points along those that motions are turned to."""
    return np.asarray(np.abs(turned_by(-_turn(item, grounding), rotation(np.array(item.orientation)).T).T))


def _faces(item: SceneObject, grounding: Grounding) -> Bool[np.ndarray, "3 3"]:
    """Say along which axis each axis of an object points, if it lies straight on a face."""
    return np.asarray(_along(item, grounding) > math.cos(STRAIGHT))


def _turn(item: SceneObject, grounding: Grounding) -> float:
    """Return by what angle motions are turned for an object [rad]."""
    return heading(np.array(item.orientation)) if grounding.turned else 0.0


def _about(turn: float) -> tuple[float, float, float, float]:
    return (0.0, 0.0, math.sin(turn / 2), math.cos(turn / 2))
