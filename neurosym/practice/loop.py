"""Practice: rounds of tasks, and of improving the operators that broke most of their plans.

Each round draws tasks, plans and executes them, and then spends most of its interactions on those operators
whose practice is expected to mend most plans: how often they broke one, times how much more practice would
raise their competence. An operator is rehearsed on more objects first; if it is chosen again, other actions
for its symbol are auditioned. After "Practice Makes Perfect" (Kumar et al., 2024), Algorithm 1.
"""

from collections import Counter
from collections.abc import Callable, Mapping

import msgspec

from neurosym.checks import check_count
from neurosym.errors import InvalidValue, InvalidWorld
from neurosym.execution.executor import execute
from neurosym.execution.record import StepRecord
from neurosym.grounding import Grounding
from neurosym.operators import Category, Operator, OperatorTable
from neurosym.planners.registry import plan
from neurosym.planners.result import PlanStatus
from neurosym.practice.competence import HOPE, NEAR, competence, expected_gain
from neurosym.practice.improving import Improved, Learner, Workshop, audition_others, rehearse_more, renamed
from neurosym.practice.rounds import Lesson, Practised, Round
from neurosym.primitives.repertoire import next_variant
from neurosym.symbols import Categorise
from neurosym.tasks.steps import PlanStep
from neurosym.world import World
from neurosym.worlds.problem_drawing import draw_problem

TASKS = 8
"""Tasks of a round."""
LESSONS = 4
"""Operators that are practised in a round."""
MORE = 30
"""Objects that an operator is rehearsed on, each time."""
USED = 0.01
"""What a use counts beside a broken plan, so that where nothing broke, what is used is practised."""
FADING = 0.7
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
        tasks = range(number * TASKS, (number + 1) * TASKS)
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
        if broken := next((step.operator for step in run.steps if _breaks(step)), None):
            broke[broken] += 1
    return Round(planned, reached, interactions, broke, ()), uses


def _breaks(step: StepRecord) -> bool:
    """Say whether a step did something else than it promised."""
    return step.happened != step.promised or step.deviation is None or step.deviation > NEAR


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

    Args:
        table: The operators as they are now.
        rounds: The rounds before.
        uses: How often each operator was performed in this one.
        broke: In how many plans of this round each was the first that did not do as promised.
    """
    weights = {name: float(count) for name, count in broke.items()}
    for age, earlier in enumerate(reversed(rounds), 1):
        for name, count in earlier.broke.items():
            weights[name] = weights.get(name, 0.0) + count * FADING**age
    last = {lesson.replaced or lesson.operator: lesson.how for one in rounds for lesson in one.lessons}
    scored, categories = [], {one.symbol: one for one in table.categories}
    for operator in table.operators:
        if not operator.rehearsals:
            continue
        category = categories[operator.category]
        how = "auditioned" if last.get(operator.name) == "rehearsed" else "rehearsed"
        hope = HOPE * (1 - competence(operator, category))
        gain = hope if how == "auditioned" else expected_gain(operator, category, MORE)
        weight = weights.get(operator.name, 0.0) + USED * uses[operator.name]
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
        improved = rehearse_more(shop, learner, MORE, turn)
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
