"""Practice: rounds of tasks, and of improving the operators that broke most of their plans.

Each round draws tasks, plans and executes them, and then spends most of its interactions on those operators
whose practice is expected to mend most plans: how often they broke one, times how much more practice would
raise their competence. An operator is rehearsed on more objects first; if it is chosen again, other actions
for its symbol are auditioned. After "Practice Makes Perfect" (Kumar et al., 2024), Algorithm 1.
"""

from collections import Counter
from collections.abc import Callable

import msgspec

from neurosym.checks import check_count
from neurosym.grounding import Grounding
from neurosym.operators import Category, Operator, OperatorTable
from neurosym.practice.competence import HOPE, competence, expected_gain
from neurosym.practice.improving import Improved, Workshop, audition_others, rehearse_more, renamed
from neurosym.practice.rounds import Lesson, Practised, Round
from neurosym.practice.tasks import try_tasks
from neurosym.primitives.repertoire import next_variant

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
    chosen: list[tuple[Operator, str]]
    if evenly:
        planned = reached = steps = 0
        broke = Counter[str]()
        live = [one for one in table.operators if one.name in {other.name for other in grounding.live}]
        chosen = [(live[(number * LESSONS + n) % len(live)], "rehearsed") for n in range(LESSONS) if live]
    else:
        tasks = range(number * TASKS, (number + 1) * TASKS)
        tried = try_tasks(shop.world, grounding, shop.model.object_symbols, tasks, shop.seed)
        planned, reached, steps = tried.planned, tried.reached, tried.interactions
        uses, broke = (_of_table(counts, grounding, table) for counts in (tried.uses, tried.broke))
        chosen = choose_lessons(table, practised.rounds, uses, broke)
    lessons = []
    for place, (operator, how) in enumerate(chosen):
        lesson, table = _give_lesson(shop, table, operator, how, 2 * (number * LESSONS + place))
        lessons.append(lesson)
    return Round(planned, reached, steps, dict(sorted(broke.items())), tuple(lessons)), table


def _of_table(counts: Counter[str], grounding: Grounding, table: OperatorTable) -> Counter[str]:
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
    weights: dict[str, float] = {name: float(count) for name, count in broke.items()}
    for age, earlier in enumerate(reversed(rounds), 1):
        for name, count in earlier.broke.items():
            weights[name] = weights.get(name, 0.0) + count * FADING**age
    last = {lesson.replaced or lesson.operator: lesson.how for one in rounds for lesson in one.lessons}
    scored = []
    categories = {one.symbol: one for one in table.categories}
    for operator in table.operators:
        if not operator.rehearsals:
            continue
        category = categories[operator.category]
        how = "auditioned" if last.get(operator.name) == "rehearsed" else "rehearsed"
        gain = expected_gain(operator, category, MORE)
        if how == "auditioned":
            gain = HOPE * (1 - competence(operator, category))
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
    before = competence(operator, category)
    if how == "rehearsed":
        improved = rehearse_more(shop, operator, primitive, category, MORE, turn)
    else:
        improved = audition_others(shop, operator, primitive, category, turn)
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
