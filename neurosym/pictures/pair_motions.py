"""Motions of operators on pairs of objects, to be performed and looked at."""

import numpy as np

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pair_sight import PairSight, nearest_kinds
from neurosym.pair_states import describe_pair
from neurosym.pictures.motions import Motion
from neurosym.relation_operators import RelationOperator, RelationOperators
from neurosym.table import OtherObject
from neurosym.world import Outcome, World

DRAWS, TRIES = 300, 5
"""How many scenes of two objects are drawn, and how many pairs of the kind an operator is tried on."""


def pair_motion(
    world: World,
    grounding: Grounding,
    operator: RelationOperator,
    sight: PairSight | None = None,
    *,
    seed: int = 0,
) -> Motion:
    """Draw a pair of an operator's kind, for it to do there what it promises.

    The first pair is taken on which it does so, or else the first of the few that are tried.

    Args:
        world: The world to act in.
        grounding: The learned domain.
        operator: The operator.
        sight: What networks say of pairs; by default a pair is of the kind whose mean features are nearest.
        seed: Same seed, same pair.

    Raises:
        InvalidValue: If no such pair is drawn.
    """
    relations = grounding.relations
    assert relations is not None, "the operator is one of its own"
    give = sight.kinds if sight else (lambda features: nearest_kinds(features, relations.pairs))
    action, reference = np.array(relations.primitive_of(operator).action), OtherObject(1)
    found = list[Motion]()
    for draw in range(DRAWS):
        scene = world.sample_scene(np.random.default_rng([seed, draw]), 2)
        if not operator.is_for(give(scene.features.reshape(1, -1))[0]):
            continue
        found.append(Motion(operator.name, scene, action, reference))
        if _keeps_promise(operator, relations, world.interact(scene, action, 0, reference=reference)):
            return found[-1]
        if len(found) == TRIES:
            break
    if not found:
        raise InvalidValue(
            f"None of {DRAWS} scenes of two objects has a pair of the kind {operator.pair}, which "
            f"{operator.name} is for."
        )
    return found[0]


def _keeps_promise(operator: RelationOperator, relations: RelationOperators, outcome: Outcome) -> bool:
    promise = operator.promise
    if promise is None or outcome.kind != "carried":
        return promise is None
    described = describe_pair(outcome.end, 0, 1, outcome.contacts)
    return relations.state_of(described.tolist()).symbol == promise.state
