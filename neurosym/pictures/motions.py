"""Motions worth looking at: explored interactions and rehearsed primitives, to be performed again."""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import islice

import numpy as np

from neurosym.checks import Float
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE, Categorise, Operator, Symbol, labelled
from neurosym.pair_operators import RelationOperators, describe_pair
from neurosym.primitives.rehearsal import MARGIN, rehearsal_sample
from neurosym.tasks.supports import PairSight, nearest_kinds
from neurosym.world import FrameSink, OtherObject, Outcome, Reference, Scene, World, relative_to
from neurosym.worlds.aims import Aimed, AimedScene

_TRIES = 5  # sampled objects of a category, or pairs of a kind, that are tried until one does as promised
_DRAWS = 300  # how many scenes of two objects are drawn to find such pairs


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

    def perform(self, world: World, on_frame: FrameSink | None = None) -> Outcome:
        """Perform it in a world."""
        aim = relative_to(world, self.reference)
        return world.interact(self.scene, self.action, 0, on_frame=on_frame, **aim)


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
    count = len(interactions)
    if not 0 <= number < count:
        raise InvalidValue(f"There is no interaction {number}; the data have {count} rows, 0 to {count - 1}.")
    features, action = interactions.features[number], interactions.actions[number]
    sizes = len(world.feature_names), len(world.action_box.low)
    if (found := (len(features), len(action))) != sizes:
        raise InvalidValue(
            f"The data have {found[0]} features and {found[1]} action parameters; "
            f"the {world.name} world takes {sizes[0]} and {sizes[1]}."
        )
    seed, title = interactions.origin.get("seed"), f"interaction {number}"
    if isinstance(seed, int) and seed >= 0:
        drawn = world.sample_scene(np.random.default_rng([seed, number]), 1)
        if drawn.features[0].astype(np.float32).tobytes() == features.tobytes():
            return Motion(title, drawn, action), True
    x, y = (sum(ends) / 2 for ends in (world.table.x, world.table.y))
    middle = np.array([[x, y, features[2] / 2]])  # its third feature is its height
    upright = np.array([[0.0, 0.0, 0.0, 1.0]])
    return Motion(title, Scene(features[None].astype(float), middle, upright), action), False


def judge(interactions: Interactions, number: int, outcome: Outcome, is_same_scene: bool) -> str:
    """Say whether a row of the data that was performed again had the effect that is recorded."""
    recorded = interactions.effects[number]
    effect = outcome.effect.astype(np.float32)
    where = "" if is_same_scene else "its scene cannot be drawn again, so the object stood in the middle; "
    if effect.tobytes() == recorded.tobytes():
        return f"{where}the effect is the recorded one, byte for byte"
    apart = 1000 * float(np.linalg.norm(effect - recorded))
    why = "; the data come from another CPU, simulator or world.toml" if is_same_scene else ""
    return f"{where}the effect is not the recorded one, but {apart:.3g} mm from it{why}"


def operators_of(grounding: Grounding, label: str) -> tuple[Operator, ...]:
    """Name what a symbol, or one action of it, does that the domain promises, or all it was tried for."""
    symbol = labelled(grounding.objects.primitives, label).symbol
    every = grounding.objects.operators
    tried = tuple(one for one in every if one.primitive == symbol and label in (symbol, one.label))
    return tuple(one for one in tried if grounding.why_left_out(one) is None) or tried


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
    drawing = Aimed(world, MARGIN) if any(one.frame == "place" for one in operators) else world
    scenes = rehearsal_sample(drawing, categorise, objects=objects, seed=seed).scenes
    motions = []
    for operator in operators:
        action, reason = np.array(grounding.primitive_of(operator).action), grounding.why_left_out(operator)
        title = operator.name if reason is None else f"{operator.name} (not in the domain: {reason})"
        found = (
            Motion(title, scene, action, scene.reference if isinstance(scene, AimedScene) else None)
            for scene in scenes.get(operator.subject, ())
        )
        motions += _as_promised(world, found, partial(_keeps_promise, operator))
    return tuple(motions)


def pair_motion(
    world: World, grounding: Grounding, operator: Operator, sight: PairSight | None = None
) -> Motion:
    """Draw a pair of an operator's kind, for it to do there what it promises.

    The first pair is taken on which it does so, or else the first of the few that are tried.

    Args:
        world: The world to act in.
        grounding: The learned domain.
        operator: The operator.
        sight: What networks say of pairs; by default a pair is of the kind whose mean features are nearest.

    Raises:
        InvalidValue: If no such pair is drawn.
    """
    relations = grounding.relations
    assert relations is not None, "the operator is one of its own"
    give = sight.kinds if sight else (lambda features: nearest_kinds(features, relations.pairs))
    action = np.array(grounding.primitive_of(operator).action)
    scenes = (world.sample_scene(np.random.default_rng([0, draw]), 2) for draw in range(_DRAWS))
    motions = (
        Motion(operator.name, scene, action, OtherObject(1))
        for scene in scenes
        if operator.is_for(give(scene.features.reshape(1, -1))[0])
    )
    if found := _as_promised(world, motions, partial(_keeps_pair_promise, operator, relations)):
        return found[0]
    raise InvalidValue(
        f"None of {_DRAWS} scenes of two objects has a pair of the kind {operator.subject}, which "
        f"{operator.name} is for."
    )


def surest_carriers(grounding: Grounding) -> tuple[Operator, ...]:
    """Name for each category what carries most of it to places, most surely and then most exactly."""

    def rank(operator: Operator) -> tuple[Symbol, float, float]:
        spread = math.hypot(*operator.promise.resting_spread[:2]) if operator.promise else math.inf
        return operator.subject, -operator.successes / operator.trials, spread

    best: dict[Symbol, Operator] = {}
    for operator in sorted(grounding.live_on("place"), key=rank):
        if 2 * operator.successes >= operator.trials:
            best.setdefault(operator.subject, operator)
    return tuple(best.values())


def _as_promised(world: World, motions: Iterable[Motion], keeps: Callable[[Outcome], bool]) -> list[Motion]:
    """Return the first motion that does as promised, or else the first of the few tried, if there is any."""
    tried = list[Motion]()
    for motion in islice(motions, _TRIES):
        if keeps(motion.perform(world)):
            return [motion]
        tried.append(motion)
    return tried[:1]


def _keeps_promise(operator: Operator, outcome: Outcome) -> bool:
    promise = operator.promise or operator.outcomes[0]
    effect = outcome.effect if outcome.held else outcome.resting_effect
    return promise.kind == outcome.kind and math.dist(effect, promise.outcome) <= TOLERANCE


def _keeps_pair_promise(operator: Operator, relations: RelationOperators, outcome: Outcome) -> bool:
    promise = operator.promise
    if promise is None or outcome.kind != "carried":
        return promise is None
    described = describe_pair(outcome.end, 0, 1, outcome.contacts)
    return relations.of(described.tolist()).symbol == promise.kind
