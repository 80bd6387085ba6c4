"""Practice: rounds of tasks, and of improving the operators that broke most of their plans.

Each round draws tasks, plans and executes them, and then spends most of its interactions on those operators
whose practice is expected to mend most plans: how often they broke one, times how much more practice would
raise their competence. An operator is rehearsed on more objects first; if it is chosen again, other actions
for its symbol are auditioned. After "Practice Makes Perfect" (Kumar et al., 2024), Algorithm 1.
"""

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import msgspec
import numpy as np

from neurosym.checks import check_count
from neurosym.contract import made
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidFile, InvalidValue, InvalidWorld, quoted
from neurosym.execution.executor import execute
from neurosym.files import at_once, digest, write_json
from neurosym.grounding import Grounding
from neurosym.learning.network import DirectModel, EffectModel
from neurosym.operators import (
    Categorise,
    Category,
    Operator,
    OperatorTable,
    Primitive,
    Rehearsal,
    name_operator,
    symbols_of,
)
from neurosym.pddl.compiler import compile_domain
from neurosym.planners.planner import PlanStatus
from neurosym.planners.registry import plan
from neurosym.primitives.audition import DIFFERENT, ROUNDS, moved, shortlist_own
from neurosym.primitives.distillation import distill
from neurosym.primitives.rehearsal import modes_of, rehearsal_of, rounded
from neurosym.primitives.reliability import Judgement, judge, performance
from neurosym.primitives.sampling import MOST_DRAWS, draw_scene, next_variant, perform, tasks_of
from neurosym.stages.compilation import FORMAT, PracticeFile, practice_of
from neurosym.stages.console import progress_bar
from neurosym.stages.folder import Claim, DomainFolder, Stage, load_scene
from neurosym.stages.layout import (
    DIRECT_MODEL,
    INTERACTIONS,
    MODEL,
    PRACTICE,
    PRIMITIVES,
    PROBLEMS,
    SCENE,
    WORLD,
)
from neurosym.stages.rounds import HOPE, NEAR, Lesson, Practised, Round, competence, expected_gain
from neurosym.tasks.promises import rehearsed_objects
from neurosym.tasks.transition import PlanStep
from neurosym.world import Outcome, Scene, World, WorldFactory
from neurosym.worlds.task_drawing import draw_problem
from neurosym.worlds.workers import Task, check_workers
from neurosym.worlds.world_file import read_world

_STREAM = 0x70726163  # keeps the objects of practice apart from those of rehearsal
_Rows = tuple[tuple[float, ...], ...]


@dataclass(frozen=True, slots=True, eq=False)
class Workshop:
    """What operators are improved with.

    Attributes:
        world_factory: Builds the world; must survive pickling if there is more than one worker.
        world: A world that it built.
        model: Whose symbols they are.
        direct: A network without a bottleneck, which shortlists.
        interactions: The data that candidates start from.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
    """

    world_factory: WorldFactory
    world: World
    model: EffectModel
    direct: DirectModel
    interactions: Interactions
    seed: int
    workers: int = 1

    def scenes(self, category: Category, count: int, turn: int) -> tuple[Scene, ...]:
        """Draw so many objects of a category, others each turn; fewer if it is too rare."""
        found: list[Scene] = []
        for number in range(MOST_DRAWS * count):
            scene = draw_scene(self.world, self.seed, _STREAM, turn * MOST_DRAWS * count + number)
            if symbols_of(self.model.object_symbols, scene.features) == (category.symbol,):
                found.append(scene)
            if len(found) == count:
                break
        return tuple(found)

    def rehearse(self, primitive: Primitive, scenes: Sequence[Scene]) -> tuple[Outcome, ...]:
        """Perform a primitive on each of some objects."""
        return self.perform(tasks_of(primitive, scenes))

    def perform(self, tasks: Sequence[Task]) -> tuple[Outcome, ...]:
        """Perform actions, each on the one object of a scene."""
        return tuple(perform(self.world_factory, tasks, self.workers, None))


@dataclass(frozen=True, slots=True)
class Learner:
    """An operator that is practised, the action it is performed with, and the category it is for."""

    operator: Operator
    primitive: Primitive
    category: Category


@dataclass(frozen=True, slots=True)
class Improved:
    """An operator after some practice.

    Attributes:
        operator: The operator, maybe with a new name.
        primitive: The action that it is performed with, if that is another one now; without a variant.
        interactions: How many that took.
    """

    operator: Operator
    primitive: Primitive | None
    interactions: int


def rehearse_more(shop: Workshop, learner: Learner, count: int, turn: int) -> Improved:
    """Rehearse an operator on more objects of its category, which are drawn for a turn."""
    operator = learner.operator
    scenes = shop.scenes(learner.category, count, turn)
    if not scenes:
        return Improved(operator, None, 0)
    outcomes = shop.rehearse(learner.primitive, scenes)
    known, rows = rehearsed_objects(operator, learner.category), operator.rehearsals
    counted = operator.trials
    improved = _tabulated(
        operator,
        (*known[:counted], *_features(scenes), *known[counted:]),
        (*rows[:counted], *map(rehearsal_of, outcomes), *rows[counted:]),
        counted + len(outcomes),
    )
    return Improved(renamed(improved, learner.category, operator.variant), None, len(scenes))


def audition_others(shop: Workshop, learner: Learner, turn: int) -> Improved:
    """Audition other actions of the symbol that do much the same, and take the surest in place of this one.

    They are found as in distillation, from other interactions. Those predicted to do most exactly what this
    one does are performed, moved by a millimetre; the best of them once more. If one is surer than this one,
    it is rehearsed on as many objects as this one was.
    """
    operator, (first, last) = learner.operator, ROUNDS
    scenes = shop.scenes(learner.category, first.objects + last.objects, turn)
    if len(scenes) < first.objects + last.objects:
        return Improved(operator, None, 0)
    rivals = [learner.primitive, *_rivals(shop, learner.primitive, learner.category, turn)]
    seen = _auditioned(shop, rivals, scenes[: first.objects])
    left = sorted({0, *_ranked(seen)[: last.candidates]})
    once_more = _auditioned(shop, [rivals[number] for number in left], scenes[first.objects :])
    for number, outcomes in zip(left, once_more, strict=True):
        seen[number] += outcomes
    spent = sum(map(len, seen))
    winner = next(number for number in _ranked(seen) if number in left)
    if winner == 0:
        return Improved(operator, None, spent)
    rehearsed = shop.scenes(learner.category, len(operator.rehearsals), turn + 1)
    rows = tuple(map(rehearsal_of, shop.rehearse(rivals[winner], rehearsed)))
    improved = _tabulated(operator, _features(rehearsed), rows, len(rows))
    return Improved(improved, rivals[winner], spent + len(rows))


def renamed(operator: Operator, category: Category, variant: str) -> Operator:
    """Return an operator that is performed with another action of its symbol, by the name of what it does."""
    name = name_operator(operator.primitive + variant, category.name, operator.modes)
    return msgspec.structs.replace(operator, name=name, variant=variant)


def _rivals(shop: Workshop, primitive: Primitive, category: Category, turn: int) -> list[Primitive]:
    """Distil actions for a symbol, and keep a few that are predicted to do what one of them does."""
    rows = np.flatnonzero(np.array(shop.model.action_symbols(shop.interactions.actions)) == primitive.symbol)
    box, features = shop.world.action_box, np.array(category.objects)
    found = distill(shop.model, shop.interactions[rows], box, seed=shop.seed + turn + 1)
    predicted = [
        shop.direct.predict_outcomes(features, np.tile(one.action, (len(features), 1)))[:, :3].mean(0)
        for one in (primitive, *found)
    ]
    alike = [
        one
        for one, mean in zip(found, predicted[1:], strict=True)
        if one.symbol == primitive.symbol and np.linalg.norm(mean - predicted[0]) <= DIFFERENT
    ]
    (shortlisted,) = shortlist_own(
        [alike], shop.direct.predict_outcomes, features, box, ROUNDS[0].candidates, shop.seed
    )
    return shortlisted


def _auditioned(shop: Workshop, rivals: Sequence[Primitive], scenes: Sequence[Scene]) -> list[list[Outcome]]:
    """Have each of some rivals perform on objects, their actions moved a little."""
    box, count = shop.world.action_box, len(scenes)
    tasks = [
        Task(scene, action)
        for rival in rivals
        for scene, action in zip(scenes, moved(rival, count, box, shop.seed), strict=True)
    ]
    outcomes = iter(shop.perform(tasks))
    return [[next(outcomes) for _ in scenes] for _ in rivals]


def _ranked(seen: Sequence[Sequence[Outcome]]) -> list[int]:
    """Rank rivals by how sure they are, of those that do much the same as the first."""
    judged = [judge([performance(outcome) for outcome in outcomes]) for outcomes in seen]
    alike = [number for number, one in enumerate(judged) if _is_like(one, judged[0])]
    return sorted(alike, key=lambda number: (-judged[number].sureness, number))


def _is_like(one: Judgement, other: Judgement) -> bool:
    """Say whether two do much the same; whatever ends upright does, beside what never does."""
    if other.kind is None or one is other:
        return True
    return one.kind == other.kind and bool(np.linalg.norm(one.mean[:3] - other.mean[:3]) <= DIFFERENT)


def _features(scenes: Sequence[Scene]) -> _Rows:
    return tuple(rounded(scene.features[0]) for scene in scenes)


def _tabulated(
    operator: Operator, objects: _Rows, rehearsals: tuple[Rehearsal, ...], trials: int
) -> Operator:
    """Give an operator rehearsals on objects, those that are its trials sorted into modes anew."""
    modes = modes_of(rehearsals[:trials])
    return msgspec.structs.replace(
        operator, objects=objects, rehearsals=rehearsals, trials=trials, modes=modes
    )


_TASKS = 8
"""Tasks of a round."""
LESSONS = 4
"""Operators that are practised in a round."""
_MORE = 30
"""Objects that an operator is rehearsed on, each time."""
_USED = 0.01
"""What a use counts beside a broken plan, so that where nothing broke, what is used is practised."""
_FADING = 0.7
"""What a broken plan counts a round later."""
MOST_OBJECTS, MOST_ACTIONS = 2, 3
_FIRST_SEED = 1 << 40  # above those that people give, and that evaluations use


def practise(
    shop: Workshop,
    practised: Practised,
    compiled: Callable[[OperatorTable], Grounding],
    *,
    interactions: int,
    evenly: bool = False,
    on_round: Callable[[Practised], None] | None = None,
) -> Practised:
    """Practise for a number of interactions; the round that comes to it is the last.

    Args:
        shop: What operators are improved with.
        practised: What there is so far.
        compiled: Compiles a table of operators.
        interactions: How many in all, those so far included.
        evenly: Rehearse all operators in turn instead, and try no tasks: what to compare with.
        on_round: Called after each round.
    """
    check_count("interactions", interactions)
    while practised.spent < interactions:
        one, table = _round(shop, practised, compiled(practised.table), evenly)
        if not one.spent:
            break  # there is nothing that could be tried or practised
        practised = Practised(table, (*practised.rounds, one))
        if on_round:
            on_round(practised)
    return practised


def _round(
    shop: Workshop, practised: Practised, grounding: Grounding, evenly: bool
) -> tuple[Round, OperatorTable]:
    number, table = len(practised.rounds), practised.table
    if evenly:
        one, live = Round(0, 0, 0, {}, ()), {other.name for other in grounding.live}
        known = [other for other in table.operators if other.name in live]
        chosen = [(known[(number * LESSONS + n) % len(known)], "rehearsed") for n in range(LESSONS) if known]
    else:
        tasks = range(number * _TASKS, (number + 1) * _TASKS)
        one, every = _try_tasks(shop.world, grounding, shop.model.object_symbols, tasks, shop.seed)
        uses, broke = (_of_table(counts, grounding, table) for counts in (every, one.broke))
        one = msgspec.structs.replace(one, broke=dict(sorted(broke.items())))
        chosen = choose_lessons(table, practised.rounds, uses, broke)
    lessons = []
    for place, (operator, how) in enumerate(chosen):
        lesson, table = _give_lesson(shop, table, operator, how, 2 * (number * LESSONS + place))
        lessons.append(lesson)
    return msgspec.structs.replace(one, lessons=tuple(lessons)), table


def _try_tasks(
    world: World, grounding: Grounding, categorise: Categorise, numbers: range, seed: int
) -> tuple[Round, Counter[str]]:
    """Draw tasks, plan them with Fast Downward, and follow the plans blindly.

    One or two objects, and goals that one to three random actions lead to, within `NEAR`. Returned are the
    round, with no lesson yet, and how often each operator was performed.
    """
    planned = reached = interactions = 0
    uses, broke = Counter[str](), Counter[str]()
    for number in numbers:
        try:
            task = draw_problem(
                world,
                categorise,
                name="practice",
                objects=1 + number % MOST_OBJECTS,
                actions=1 + number % MOST_ACTIONS,
                seed=_FIRST_SEED * (seed + 1) + number,
                tolerance=NEAR,
            )
        except InvalidWorld:
            raise
        except InvalidValue:  # a world where so many objects do not fit, or nothing moves
            continue
        found = plan(task, grounding)
        if found.status is not PlanStatus.SOLVED:
            continue
        planned += 1
        run = execute(world, task, grounding, found.steps)
        reached += run.reached
        interactions += len(run.steps)
        uses.update(PlanStep(step.operator, step.object).base for step in run.steps)
        for step in run.steps:
            if step.happened != step.promised or step.deviation is None or step.deviation > NEAR:
                broke[step.operator] += 1  # the first that did something else than it promised
                break
    return Round(planned, reached, interactions, broke, ()), uses


def _of_table(counts: Mapping[str, int], grounding: Grounding, table: OperatorTable) -> Counter[str]:
    """Count for the operators of a table what was counted for those that promise other outcomes, too."""
    names = {(one.category, one.label): one.name for one in table.operators}
    found = Counter[str]()
    for name, count in counts.items():
        operator = grounding.operator_named(name)
        found[names[operator.category, operator.label]] += count
    return found


def choose_lessons(
    table: OperatorTable, rounds: tuple[Round, ...], uses: Counter[str], broke: Counter[str]
) -> list[tuple[Operator, str]]:
    """Choose the operators whose practice is expected to mend most plans, and how each is practised.

    `uses` counts how often each was performed in this round, and `broke` in how many plans it was the
    first that did not do as promised.
    """
    weights = {name: float(count) for name, count in broke.items()}
    for age, earlier in enumerate(reversed(rounds), 1):
        for name, count in earlier.broke.items():
            weights[name] = weights.get(name, 0.0) + count * _FADING**age
    last = {lesson.replaced or lesson.operator: lesson.how for one in rounds for lesson in one.lessons}
    scored, categories = [], {one.symbol: one for one in table.categories}
    for operator in table.operators:
        if not operator.rehearsals:
            continue
        category = categories[operator.category]
        how = "auditioned" if last.get(operator.name) == "rehearsed" else "rehearsed"
        hope = HOPE * (1 - competence(operator, category))
        gain = hope if how == "auditioned" else expected_gain(operator, category, _MORE)
        weight = weights.get(operator.name, 0.0) + _USED * uses[operator.name]
        if weight * gain > 0:
            scored.append((-weight * gain, operator.name, (operator, how)))
    return [choice for _, _, choice in sorted(scored, key=lambda entry: entry[:2])[:LESSONS]]


def _give_lesson(
    shop: Workshop, table: OperatorTable, operator: Operator, how: str, turn: int
) -> tuple[Lesson, OperatorTable]:
    """Practise an operator, and put it into the table as it is then."""
    category = next(one for one in table.categories if one.symbol == operator.category)
    primitive = next(one for one in table.primitives if one.label == operator.label)
    before, learner = competence(operator, category), Learner(operator, primitive, category)
    if how == "rehearsed":
        improved = rehearse_more(shop, learner, _MORE, turn)
    else:
        improved = audition_others(shop, learner, turn)
    table, now = _with_improved(table, operator, category, improved)
    replaced = now.name if now.name != operator.name else ""
    after = competence(now, category)
    lesson = Lesson(operator.name, how, improved.interactions, round(before, 4), round(after, 4), replaced)
    return lesson, table


def _with_improved(
    table: OperatorTable, old: Operator, category: Category, improved: Improved
) -> tuple[OperatorTable, Operator]:
    """Put an operator in the place of another, and its action beside those of its symbol."""
    now, primitives = improved.operator, list(table.primitives)
    if improved.primitive:
        variant = next_variant(primitives, old.primitive)
        primitives.append(msgspec.structs.replace(improved.primitive, variant=variant))
        now = renamed(now, category, variant)
    operators = tuple(now if one.name == old.name else one for one in table.operators)
    used = {one.label for one in operators}
    kept = [one for one in primitives if not one.variant or one.label in used]
    kept.sort(key=lambda one: (one.symbol, one.variant))
    return msgspec.structs.replace(table, primitives=tuple(kept), operators=operators), now


def practise_stage(
    folder: DomainFolder, *, interactions: int, seed: int, workers: int, evenly: bool = False
) -> Stage:
    """Practise: networks, data, world and operators -> `practice.json`.

    What was practised before counts, so that an interrupted call goes on.

    Args:
        folder: The domain folder.
        interactions: How many in all.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        evenly: Rehearse all operators in turn instead.
    """
    check_count("interactions", interactions)
    check_workers(workers)

    def work() -> None:
        for scene in sorted((folder / PROBLEMS).glob(f"*{SCENE}")):
            load_scene(scene)  # it is printed anew afterwards: what cannot be used is refused now
        begun = _begun(folder, seed, evenly=evenly)
        shop = _workshop(folder, seed, workers)
        world, of = shop.world, digest(folder / PRIMITIVES)
        compiled = partial(
            compile_domain, name=world.name, table_bounds=world.table, lift_height=world.lift_height
        )

        def save(practised: Practised) -> None:
            write_json(folder / PRACTICE, PracticeFile(FORMAT, of, seed, evenly, practised))

        with progress_bar("practising") as advance:

            def on_round(practised: Practised) -> None:
                with at_once():  # a kill loses no more than the round that it comes in
                    save(practised)
                advance(min(practised.spent, interactions), interactions)

            advance(min(begun.spent, interactions), interactions)
            save(practise(shop, begun, compiled, interactions=interactions, evenly=evenly, on_round=on_round))

    options: dict[str, Any] = {"interactions": interactions, "seed": seed}
    if evenly:
        options["evenly"] = True
    inputs = (WORLD, INTERACTIONS, MODEL, DIRECT_MODEL, PRIMITIVES)
    return Stage("practise", inputs, (PRACTICE,), work, options, Claim.ALONE)


def _workshop(folder: DomainFolder, seed: int, workers: int) -> Workshop:
    factory = read_world(folder.require(WORLD))
    return Workshop(
        factory,
        made(factory),
        EffectModel.load(folder.require(MODEL)),
        DirectModel.load(folder.require(DIRECT_MODEL)),
        Interactions.load(folder.require(INTERACTIONS)),
        seed,
        workers,
    )


def _begun(folder: DomainFolder, seed: int, *, evenly: bool) -> Practised:
    """Return what was practised so far, or the distilled operators without any practice."""
    distilled = OperatorTable.load(folder.require(PRIMITIVES))
    if not any(operator.rehearsals for operator in distilled.operators):
        raise InvalidFile(
            folder / PRIMITIVES,
            f"its rehearsals are not kept; `neurosym distill {quoted(folder.path)}` makes it anew",
        )
    found = practice_of(folder)
    if found is None:
        return Practised(distilled)
    if (found.seed, found.evenly) != (seed, evenly):
        how = "evenly, " if found.evenly else ""
        raise InvalidValue(
            f"{folder / PRACTICE} was practised {how}with seed = {found.seed}; go on so, or remove it to "
            "begin anew."
        )
    return found.practised
