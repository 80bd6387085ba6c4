"""Drawing the tasks that a domain can be asked for: of goals on the table, or of relations."""

from typing import cast, get_args

import numpy as np

from neurosym.choices import AnyTask, TaskKind
from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE
from neurosym.pair_sight import PairSight, with_pairs
from neurosym.problems import Problem
from neurosym.related import known_bearers
from neurosym.relation_operators import PairStates, RelationOperators
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import RELATION_CHANCES, RELATION_MODEL, RELATION_STATES
from neurosym.symbols import Categorise
from neurosym.tasks.puts import LEAST_SHARE, left_out, puts_for
from neurosym.world import World
from neurosym.worlds.relation_tasks import HEIGHT, RELATION_TASKS, Way, Ways, draw_relation_task
from neurosym.worlds.tasks import Fits, draw_task


def draw_any_task(
    world: World,
    categorise: Categorise,
    grounding: Grounding,
    kind: AnyTask,
    *,
    name: str,
    objects: int,
    seed: int,
    height: int = HEIGHT,
    state: str = "",
    like: Problem | None = None,
    tolerance: float = TOLERANCE,
    fits: Fits | None = None,
    sight: PairSight | None = None,
) -> Problem:
    """Draw a task of any kind.

    Args:
        world: The world that the objects are drawn from.
        categorise: Gives objects their symbols.
        grounding: The learned domain, which says what relations there are.
        kind: What is asked for; see `draw_task` and `draw_relation_task`.
        name: Name of the problem.
        objects: How many objects.
        seed: Same seed, same task.
        height: How many objects a tower or a stack has.
        state: The state that pairs shall come to, by name, its beginning, or symbol; any, if not given.
        like: The other scene, for `like`.
        tolerance: How near each object must come to its goal [m].
        fits: Says of the features of an object whether it may be drawn; for goals on the table.
        sight: What networks say of pairs; by default a pair is of the kind whose mean features are nearest.

    Raises:
        InvalidValue: If no such task is found, or one of relations is asked for and none are known.
    """
    if kind not in RELATION_TASKS:
        plain = cast(TaskKind, kind)
        return draw_task(
            world, categorise, plain, name=name, objects=objects, seed=seed, tolerance=tolerance, fits=fits
        )
    relations = grounding.relations
    if relations is None:
        raise InvalidValue(
            f"This domain has learned no relations, which the task {kind!r} is made of; "
            f"valid: {', '.join(get_args(TaskKind))}."
        )
    bearers = known_bearers(like, relations) if like else {}
    problem = draw_relation_task(
        world,
        categorise,
        relations,
        lambda drawn: ways_of(drawn, grounding, sight),
        kind,
        name=name,
        objects=objects,
        seed=seed,
        height=height,
        state=_state_asked(state, relations) if state else "",
        like=like,
        likened=tuple((target, borne.by, borne.state.name) for target, borne in bearers.items()),
        tolerance=tolerance,
    )
    return with_pairs(problem, relations, sight)


def _state_asked(asked: str, relations: RelationOperators) -> str:
    """Return the name of a state that is asked for, if operators of the domain bring pairs there."""
    state, left = relations.state_meant(asked), left_out(relations)
    promised = {one.promise.state for one in relations.operators if one.promise and one.name not in left}
    if state.symbol not in promised:
        valid = [one.name for one in relations.states if one.symbol in promised]
        raise InvalidValue(
            f"No operator brings pairs to the state {state.name}, so no task asks for it; valid: "
            f"{', '.join(valid) or 'none'}."
        )
    return state.name


def sight_of_pairs(folder: DomainFolder) -> PairSight | None:
    """Return what the networks of a domain folder say of pairs; None if none were learned.

    Args:
        folder: The domain folder.
    """
    if not (folder / RELATION_MODEL).exists():
        return None
    from neurosym.learning.direct_model import DirectModel
    from neurosym.learning.effect_model import EffectModel
    from neurosym.learning.state_chances import foreseen_by

    kinds = EffectModel.load(folder / RELATION_MODEL).object_symbols
    if not (folder / RELATION_CHANCES).exists():
        return PairSight(kinds)
    chances = foreseen_by(DirectModel.load(folder / RELATION_CHANCES))
    return PairSight(kinds, chances, PairStates.load(folder.require(RELATION_STATES)).bearing_order)


def networks_of_pairs(folder: DomainFolder) -> tuple[str, ...]:
    """Name the files of a domain folder that `sight_of_pairs` reads.

    Args:
        folder: The domain folder.
    """
    files = RELATION_MODEL, RELATION_CHANCES, RELATION_STATES
    return tuple(name for name in files if (folder / name).exists())


def ways_of(problem: Problem, grounding: Grounding, sight: PairSight | None = None) -> Ways:
    """Say what can be done with each pair of objects of a problem, by operators for pairs of its kind.

    Args:
        problem: The problem.
        grounding: The learned domain.
        sight: What networks say of pairs; by default a pair is of the kind whose mean features are nearest.
    """
    relations = grounding.relations
    if relations is None:
        return {}
    problem, names = with_pairs(problem, relations, sight), problem.object_names
    return {
        (target, other): tuple(
            Way(put.state.name, put.takes_occupied, np.array(relations.primitive_of(put.operator).action))
            for put in puts_for(problem, grounding, target, other)
            if put.kind and put.share >= LEAST_SHARE
        )
        for target in names
        for other in names
        if target != other
    }
