"""Tries: which motion to try next with an object, and what is said of it then."""

from collections.abc import Sequence

import msgspec

from neurosym.grounding import Grounding
from neurosym.operators import Mode, Operator
from neurosym.problems import SceneObject
from neurosym.tasks.pasts import GRASPED, motion_of, past_of
from neurosym.tasks.promises import believed, promised


def next_try(
    item: SceneObject, grounding: Grounding, planned: Sequence[str] = ()
) -> tuple[Operator, Mode] | None:
    """Choose what to try with an object of some past, and say what is promised; None if there is nothing.

    That is the first motion of a plan that was not tried; then what carries, and then the surest. The same
    motion mostly does the same again, so that others tell more.

    Args:
        item: The object.
        grounding: What can be done with it.
        planned: Names of the operators that a plan would use, in order.
    """
    now, tried = believed(grounding, item), {one.motion for one in past_of(item)}
    untried = [name for name, one in sorted(now.items()) if motion_of(one.operator) not in tried]
    if not now:
        return None
    ranked = sorted(untried or now, key=lambda name: (now[name].promise.kind != "carried", -now[name].share))
    best = next((name for name in planned if name in untried), ranked[0])
    return grounding.operator_named(best), now[best].promise


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
