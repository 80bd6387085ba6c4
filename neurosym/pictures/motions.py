"""Motions worth looking at: explored interactions and rehearsed primitives, to be performed again."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from neurosym.arrays import Float
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE, Operator
from neurosym.primitives.among_others import MARGIN
from neurosym.primitives.rehearsal import rehearsal_sample
from neurosym.symbols import Categorise, Symbol
from neurosym.table import Reference
from neurosym.tasks.carriers import carriers_of
from neurosym.world import Outcome, Scene, World
from neurosym.worlds.aimed import Aimed, AimedScene

TRIES = 5
"""Sampled objects of a category on which a primitive is tried until one does as promised."""


@dataclass(frozen=True, slots=True, eq=False)
class Motion:
    """An action on the only object of a scene, and what to call it.

    Attributes:
        title: What pictures of it are called.
        scene: The object.
        action: The action parameters.
        reference: What the action is relative to besides the object, if anything.
    """

    title: str
    scene: Scene
    action: Float[np.ndarray, "A"]
    reference: Reference | None = None


def recall_interaction(world: World, interactions: Interactions, number: int) -> tuple[Motion, bool]:
    """Return an explored interaction as it can be performed again, and whether its scene is the very same.

    Exploration draws the scene of each interaction from its seed and the interaction's number. If the data
    do not say the seed, or other objects are drawn from it, the object stands in the middle of the table.

    Args:
        world: The world that draws the scene.
        interactions: The data.
        number: Which row, counted from 0.

    Raises:
        InvalidValue: If there is no such row, or it is of another world.
    """
    if not 0 <= number < len(interactions):
        raise InvalidValue(
            f"There is no interaction {number}; the data have {len(interactions)} rows, "
            f"0 to {len(interactions) - 1}."
        )
    features = interactions.features[number]
    sizes = len(world.feature_names), len(world.action_box.low)
    if (found := (len(features), interactions.actions.shape[1])) != sizes:
        raise InvalidValue(
            f"The data have {found[0]} features and {found[1]} action parameters; "
            f"the {world.name} world takes {sizes[0]} and {sizes[1]}."
        )
    drawn = _drawn_scene(world, interactions.origin.get("seed"), number)
    is_same = drawn is not None and drawn.features[0].astype(np.float32).tobytes() == features.tobytes()
    scene = drawn if drawn is not None and is_same else _middle_scene(world, features)
    return Motion(f"interaction {number}", scene, interactions.actions[number]), is_same


def _drawn_scene(world: World, seed: object, number: int) -> Scene | None:
    if not isinstance(seed, int) or seed < 0:
        return None
    return world.sample_scene(np.random.default_rng([seed, number]), 1)


def _middle_scene(world: World, features: Float[np.ndarray, "F"]) -> Scene:
    """Put an object in the middle of the table; its third feature is its height."""
    table = world.table
    return Scene(
        features=features[None].astype(float),
        positions=np.array([[sum(table.x) / 2, sum(table.y) / 2, features[2] / 2]]),
        orientations=np.array([[0.0, 0.0, 0.0, 1.0]]),
    )


def judge(interactions: Interactions, number: int, outcome: Outcome, is_same_scene: bool) -> str:
    """Say whether an interaction that was performed again had the effect that is recorded.

    Args:
        interactions: The data.
        number: Which row was performed.
        outcome: What it did this time.
        is_same_scene: Whether it started from the scene of the record.
    """
    recorded = interactions.effects[number]
    effect = outcome.effect.astype(np.float32)
    where = "" if is_same_scene else "its scene cannot be drawn again, so the object stood in the middle; "
    if effect.tobytes() == recorded.tobytes():
        return f"{where}the effect is the recorded one, byte for byte"
    apart = 1000 * float(np.linalg.norm(effect - recorded))
    why = "; the data come from another CPU, simulator or world.toml" if is_same_scene else ""
    return f"{where}the effect is not the recorded one, but {apart:.3g} mm from it{why}"


def primitive_motions(
    world: World, grounding: Grounding, label: str, categorise: Categorise, *, objects: int, seed: int
) -> tuple[Motion, ...]:
    """Choose a sampled object of each category, for a primitive to do there what the domain promises.

    An action symbol stands for all of its actions, each on the categories that it is for.

    The first object of the category is taken that does as promised, or else the first of the few tried.
    If the domain promises nothing of the primitive, every category is shown.

    Args:
        world: The world to act in.
        grounding: The learned domain.
        label: The primitive's action symbol, or one of its labels.
        categorise: Gives the object symbols of features.
        objects: How many objects rehearsal sampled.
        seed: Where rehearsal's draws started.

    Raises:
        UnknownChoice: If there is no such primitive.
    """
    operators = operators_of(grounding, label)
    return operator_motions(world, grounding, operators, categorise, objects=objects, seed=seed)


def operators_of(grounding: Grounding, label: str) -> tuple[Operator, ...]:
    """Name what a primitive does that the domain promises, or all that it was tried for if that is nothing.

    Args:
        grounding: The learned domain.
        label: The primitive's action symbol, which stands for all of its actions, or one of its labels.

    Raises:
        UnknownChoice: If there is no such primitive.
    """
    symbol = grounding.primitive(label).symbol
    operators = tuple(
        operator
        for operator in grounding.operators.operators
        if operator.primitive == symbol and label in (symbol, operator.label)
    )
    promised = tuple(operator for operator in operators if grounding.why_left_out(operator) is None)
    return promised or operators


def operator_motions(
    world: World,
    grounding: Grounding,
    operators: Sequence[Operator],
    categorise: Categorise,
    *,
    objects: int,
    seed: int,
) -> tuple[Motion, ...]:
    """Choose a sampled object for each of some operators to do there what it promises.

    The first object of the category is taken that does as promised, or else the first of the few tried. What
    carries objects does it to the place that was drawn with the object.

    Args:
        world: The world to act in.
        grounding: The learned domain.
        operators: The operators, all of which carry objects, or none.
        categorise: Gives the object symbols of features.
        objects: How many objects rehearsal sampled.
        seed: Where rehearsal's draws started.
    """
    if any(map(grounding.carries, operators)):
        world = Aimed(world, MARGIN)
    scenes = rehearsal_sample(world, categorise, objects=objects, seed=seed).scenes
    motions = []
    for operator in operators:
        if members := scenes.get(operator.category, ()):
            action = np.array(grounding.primitive_of(operator).action)
            reason = grounding.why_left_out(operator)
            title = operator.name if reason is None else f"{operator.name} (not in the domain: {reason})"
            scene = _as_promised(world, operator, members, action)
            reference = scene.reference if isinstance(scene, AimedScene) else None
            motions.append(Motion(title, scene, action, reference))
    return tuple(motions)


def surest_carriers(grounding: Grounding) -> tuple[Operator, ...]:
    """Name for each category what carries its objects to places most surely, and then most exactly.

    A category of which most cannot be carried has none.

    Args:
        grounding: The learned domain.
    """
    best: dict[Symbol, tuple[float, float, Operator]] = {}
    for operator in carriers_of(grounding):
        if operator.promise is None or 2 * operator.successes < operator.trials:
            continue
        spread = math.hypot(*operator.promise.resting_spread[:2])
        found = (operator.successes / operator.trials, -spread, operator)
        if operator.category not in best or found[:2] > best[operator.category][:2]:
            best[operator.category] = found
    return tuple(best[symbol][2] for symbol in sorted(best))


def _as_promised(
    world: World, operator: Operator, scenes: Sequence[Scene], action: Float[np.ndarray, "A"]
) -> Scene:
    tried = (scene for scene in scenes[:TRIES] if _keeps_promise(operator, world.interact(scene, action, 0)))
    return next(tried, scenes[0])


def _keeps_promise(operator: Operator, outcome: Outcome) -> bool:
    promise = operator.promise or operator.modes[0]
    effect = outcome.effect if outcome.held else outcome.resting_effect
    return promise.kind == outcome.kind and math.dist(effect, promise.outcome) <= TOLERANCE
