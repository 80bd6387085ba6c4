"""The stages that make a problem: drawn from the world, with goals given by hand, or a scene taken over."""

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import permutations
from pathlib import Path
from typing import Any, cast, get_args

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.choices import AnyTask, TaskKind
from neurosym.errors import InvalidValue, UnknownChoice, blaming
from neurosym.files import digest
from neurosym.formats import PlaceFile
from neurosym.grounding import Grounding
from neurosym.operators import LEAST_SHARE, TOLERANCE, Categorise, symbols_of
from neurosym.pair_operators import PairStates, RelationOperators
from neurosym.pddl.problem_check import check_relations, relations_meant
from neurosym.problems import Problem, RelationGoal, check_on_table
from neurosym.stages import layout
from neurosym.stages.compilation import put_problem
from neurosym.stages.folder import DomainFolder, Stage
from neurosym.stages.planning import check_scene, remarks_on_number, tell_remarks
from neurosym.tasks.conditions import as_conditions, conditions_in
from neurosym.tasks.goal_choice import with_goals
from neurosym.tasks.options import puts_for
from neurosym.tasks.promises import performed_with, set_over
from neurosym.tasks.supports import PairSight, with_pairs
from neurosym.world import World
from neurosym.worlds.relation_tasks import HEIGHT, RELATION_TASKS, Way, Ways, draw_relation_task
from neurosym.worlds.task_drawing import Fits, draw_task
from neurosym.worlds.world_file import read_world, sees


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
        tolerance: How near each object must come to its goal [m].
        fits: Says of the features of an object whether it may be drawn; for goals on the table.
        sight: What networks say of pairs; by default a pair is of the kind whose mean features are nearest.

    Raises:
        UnknownChoice: If there is no such kind.
        InvalidValue: If no such task is found, or one of relations is asked for and none are known.
    """
    if kind not in (known := get_args(TaskKind) + RELATION_TASKS):
        raise UnknownChoice("kind of task", str(kind), known)
    asked: dict[str, Any] = {"name": name, "objects": objects, "seed": seed, "tolerance": tolerance}
    if kind not in RELATION_TASKS:
        return draw_task(world, categorise, cast(TaskKind, kind), fits=fits, **asked)
    relations = grounding.relations
    if relations is None:
        raise InvalidValue(
            f"This domain has learned no relations, which the task {kind!r} is made of; "
            f"valid: {', '.join(get_args(TaskKind))}."
        )
    problem = draw_relation_task(
        world,
        categorise,
        relations,
        lambda drawn: ways_of(drawn, grounding, sight),
        kind,
        height=height,
        state=_state_asked(state, relations) if state else "",
        **asked,
    )
    return with_pairs(problem, relations, sight)


def _state_asked(asked: str, relations: RelationOperators) -> str:
    """Return the name of a state that is asked for, if operators of the domain bring pairs there."""
    state, left = relations.state_meant(asked), relations.left_out
    promised = {one.promise.kind for one in relations.operators if one.promise and one.name not in left}
    if state.symbol not in promised:
        valid = [one.name for one in relations.states if one.symbol in promised]
        raise InvalidValue(
            f"No operator brings pairs to the state {state.name}, so no task asks for it; valid: "
            f"{', '.join(valid) or 'none'}."
        )
    return state.name


_OF_PAIRS = (layout.RELATION_MODEL, layout.RELATION_CHANCES, layout.RELATION_STATES)
"""What `sight_of_pairs` reads."""


def sight_of_pairs(folder: DomainFolder) -> PairSight | None:
    """Return what the networks of a domain folder say of pairs; None if none were learned."""
    if not (folder / layout.RELATION_MODEL).exists():
        return None
    from neurosym.learning.network import DirectModel, EffectModel
    from neurosym.learning.state_codes import foreseen_by

    kinds = EffectModel.load(folder / layout.RELATION_MODEL).object_symbols
    if not (folder / layout.RELATION_CHANCES).exists():
        return PairSight(kinds)
    foresee = foreseen_by(DirectModel.load(folder / layout.RELATION_CHANCES))
    bearing = PairStates.load(folder.require(layout.RELATION_STATES)).bearing
    if not (folder / layout.PLACE_OPERATORS).exists():
        return PairSight(kinds, foresee, bearing)
    places = PlaceFile.load(folder / layout.PLACE_OPERATORS).table()
    categorise = folder.network().object_symbols

    def chances(features: Float[np.ndarray, "N F"], actions: Float[np.ndarray, "N A"]) -> np.ndarray:
        """Foresee what comes of actions as these are performed with such targets; see `set_over`."""
        targets = features[:, : features.shape[1] // 2]
        rows = zip(actions.tolist(), symbols_of(categorise, targets), targets.tolist(), strict=True)
        aimed = [set_over(places, tuple(action), one, tuple(target)) for action, one, target in rows]
        return foresee(features, np.array(aimed))

    return PairSight(kinds, chances, bearing)


def ways_of(problem: Problem, grounding: Grounding, sight: PairSight | None = None) -> Ways:
    """Say what can be done with each pair of objects of a problem, by operators for pairs of its kind."""
    if (relations := grounding.relations) is None:
        return {}
    problem = with_pairs(problem, relations, sight)
    ways = dict[tuple[str, str], tuple[Way, ...]]()
    for target, other in permutations(problem.object_names, 2):
        puts = [put for put in puts_for(problem, grounding, target, other) if put.operator.subject]
        ways[target, other] = tuple(
            Way(
                put.state.name,
                put.operator.takes("occupied"),
                performed_with(grounding, put.operator, problem.object_named(target)),
            )
            for put in puts
            if put.share >= LEAST_SHARE
        )
    return ways


@dataclass(frozen=True, slots=True)
class Asked:
    """What a problem shall be: drawn as the paper draws tasks, unless there is more than `objects`."""

    objects: int = 1  # how many objects there are
    actions: int = 1  # how many random actions lead to the goal
    seed: int = 0  # same seed, same problem
    goals: Mapping[str, tuple[float, ...]] | None = None  # goals by hand [m], by object
    # how near objects must come to their goals [m]; scene and goals do not depend on it
    tolerance: float | None = None
    task: AnyTask | None = None  # a kind of task
    relations: tuple[RelationGoal, ...] = ()  # goals by relation
    height: int = HEIGHT  # how many objects a tower or a stack has
    state: str = ""  # the state that a drawn task of relations asks for; any, if not given
    # what shall hold, in words; goals and relations by hand are such, too, then
    conditions: tuple[str, ...] = ()
    turned: bool = False  # whether objects lie turned by any angle, and not straight
    # the features of objects in a scene that the conditions were taken from, by name
    like: Mapping[str, tuple[float, ...]] = field(default_factory=dict)

    def options(self) -> dict[str, Any]:
        """Return it as a manifest keeps it; what is as usual was not always there, and is left out."""
        always, usual = ("objects", "actions", "seed", "goals"), Asked()
        every = {name: getattr(self, name) for name in self.__slots__}
        kept = {name: one for name, one in every.items() if name in always or one != getattr(usual, name)}
        encoded = msgspec.json.encode(kept, enc_hook=lambda one: one.item())
        return cast(dict[str, Any], msgspec.json.decode(encoded))


def problem_stage(folder: DomainFolder, name: str, asked: Asked) -> Stage:
    """Make a problem: world, model and grounding -> `problems/NAME.pddl`, `.numeric.pddl`, `.scene.json`.

    What is asked of relations is not printed in numbers.

    Args:
        folder: The domain folder.
        name: Name of the problem.
        asked: What it shall be.
    """

    def work() -> None:
        grounding = Grounding.load(folder.require(layout.GROUNDING))
        problem = _made(folder, name, asked, grounding)
        for remark in remarks_on_number(folder, problem):
            folder.notify(remark)
        put_problem(folder, problem, grounding)

    is_relational = bool(asked.relations) or asked.task in RELATION_TASKS
    printed_as = layout.problem_files(name)[:1] if is_relational else layout.problem_files(name)
    inputs = (layout.WORLD, layout.MODEL, layout.GROUNDING, *folder.there(layout.EYE, *_OF_PAIRS))
    return Stage(f"new-problem {name}", inputs, (*printed_as, layout.scene_file(name)), work, asked.options())


def _made(folder: DomainFolder, name: str, asked: Asked, grounding: Grounding) -> Problem:
    """Draw a problem, or set it by hand, and check what it asks of relations."""
    from neurosym.worlds.task_drawing import draw_problem, lying_turned, set_problem

    world = read_world(folder.require(layout.WORLD))()
    categorise = folder.network().object_symbols
    sight = sight_of_pairs(folder)
    named: dict[str, Any] = {"name": name, "objects": asked.objects, "seed": asked.seed}
    if asked.task is not None:
        named |= {"height": asked.height, "state": asked.state, "sight": sight}
        problem = draw_any_task(world, categorise, grounding, asked.task, **named)
    elif asked.goals is None and not (asked.relations or asked.conditions):
        problem = draw_problem(world, categorise, actions=asked.actions, **named)
    elif asked.conditions:
        conditions = (*asked.conditions, *as_conditions(asked.goals or {}, asked.relations))
        problem = set_problem(world, categorise, {}, conditions=conditions, **named)
    else:
        meant = relations_meant(asked.relations, grounding)
        problem = set_problem(world, categorise, asked.goals or {}, relations=meant, **named)
    for other, features in asked.like.items():
        if not np.allclose(problem.object_named(other).features, features, atol=1e-6):
            raise InvalidValue(
                f"{other} of the scene in --like is another object than {other} here: its sizes differ. Give "
                "--objects and --seed with which the same are drawn, and --goal in both."
            )
    problem = lying_turned(problem, asked.seed) if asked.turned else problem
    problem = with_pairs(problem.within(asked.tolerance), grounding.relations, sight)
    problem = with_goals(problem, grounding)
    check_relations(problem, grounding)
    return problem


def scene_stage(folder: DomainFolder, file: Path, *, name: str, tolerance: float | None = None) -> Stage:
    """Take over a scene: a file and grounding -> `problems/NAME.pddl`, `.numeric.pddl`, `.scene.json`.

    Args:
        folder: The domain folder.
        file: The scene, as `neurosym.problems.Problem` reads it.
        name: What the problem is called in the folder, whatever it is called in the file.
        tolerance: How near objects must come to their goals [m], if not as the file says.
    """

    def work() -> None:
        grounding = Grounding.load(folder.require(layout.GROUNDING))
        problem = msgspec.structs.replace(_scene_in(file, grounding), name=name).within(tolerance)
        if sees(folder / layout.WORLD):
            world: Any = read_world(folder.require(layout.WORLD))()
            with blaming(file):
                world.beneath(problem.scene())  # refuses what objects cannot be in truth
        problem = with_pairs(problem, grounding.relations, sight_of_pairs(folder))
        with blaming(file):
            for item in problem.objects:  # only what a run saw may be a little off
                check_on_table(item, grounding.table)
            problem = with_goals(problem, grounding)
        check_scene(folder, problem, file)
        tell_remarks(folder, problem, grounding)
        put_problem(folder, problem, grounding)

    options = {"scene": digest(file)} | ({} if tolerance is None else {"tolerance": tolerance})
    outputs = (*layout.problem_files(name), layout.scene_file(name))
    inputs = (layout.WORLD, layout.GROUNDING, *folder.there(*_OF_PAIRS))
    return Stage(f"new-problem {name}", inputs, outputs, work, options)


def _scene_in(file: Path, grounding: Grounding) -> Problem:
    """Read a scene whose goals may be conditions, or written as people write them; see `conditions_in`."""

    def changed(raw: dict[str, Any]) -> dict[str, Any]:
        raw = {"goals": {}} | raw if raw.get("conditions") else raw
        with blaming(file):
            points, said = conditions_in(raw.get("goals") or {})
        lists = [raw.get(name, []) for name in ("relations", "conditions")] + [*points.values()]
        if not all(isinstance(one, list) for one in lists):
            return raw | {"goals": points}  # which is refused, with the field that is wrong
        relations = [one for one in raw.get("relations", ()) if isinstance(one, list) and len(one) == 3]
        is_plain = not any(
            target in points or _bears_nothing(state, grounding) for target, _, state in relations
        )
        if not said and (is_plain or raw.get("conditions")):
            return raw
        told = [*said, *as_conditions(points, relations), *raw.get("conditions", ())]
        return raw | {"goals": {}, "relations": [], "conditions": told}

    problem = Problem.load(file, changed)
    if not problem.conditions or not (problem.goals or problem.relations):
        return problem
    bare = msgspec.structs.replace(problem, goals={}, relations=())
    with suppress(InvalidValue, UnknownChoice):  # goals that were chosen for the conditions are chosen again
        if with_goals(bare, grounding) == problem:
            return bare
    told = (*problem.conditions, *as_conditions(problem.goals, problem.relations))
    return msgspec.structs.replace(bare, conditions=told)


def _bears_nothing(state: object, grounding: Grounding) -> bool:
    """Say whether a state is known in which nothing is borne."""
    with suppress(UnknownChoice, InvalidValue):
        if grounding.relations:
            return not grounding.relations.state_meant(str(state)).bears
    return False
