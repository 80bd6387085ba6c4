"""Rounds of practice: what was tried, what broke plans, and what was practised."""

import math

import msgspec

from neurosym.operators import Category, Count, Operator, OperatorTable, smoothed
from neurosym.tasks.promises import keeps_promises, rehearsed_objects


class Lesson(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """An operator that was practised.

    Attributes:
        operator: Its name.
        how: Whether it was rehearsed on more objects, or other actions were auditioned.
        interactions: How many that took.
        before: Its competence before.
        after: And after.
        replaced: Its name now, if it does something else, or is performed with another action.
    """

    operator: str
    how: str
    interactions: Count
    before: float
    after: float
    replaced: str = ""


class Round(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What happened in a round.

    Attributes:
        planned: How many of its tasks had a plan.
        reached: How many of these plans came true, followed blindly.
        interactions: How many steps they took.
        broke: In how many of them each operator was the first that did not do as promised.
        lessons: What was practised.
    """

    planned: Count
    reached: Count
    interactions: Count
    broke: dict[str, Count]
    lessons: tuple[Lesson, ...]

    @property
    def spent(self) -> int:
        """How many interactions it took in all."""
        return self.interactions + sum(lesson.interactions for lesson in self.lessons)


class Practised(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A table of operators, and the rounds of practice that it went through.

    Attributes:
        table: The table now.
        rounds: The rounds.
    """

    table: OperatorTable
    rounds: tuple[Round, ...] = ()

    @property
    def spent(self) -> int:
        """How many interactions the rounds took."""
        return sum(one.spent for one in self.rounds)


# Competence: how often an operator keeps its promise, and by how much more practice would raise that.
#
# After "Practice Makes Perfect" (Kumar et al., 2024), which extrapolates the competence of each skill, and
# practises what is expected to help most. There a skill's parameters are refitted; here its promise is,
# too: an operator is competent where it does to an object what it promised for that object. How fast that
# rises with rehearsals is read off the rehearsals there are: half of them against all.

NEAR = 0.02
"""How near an outcome must come to its promise to count as competent [m]."""
HOPE = 0.1
"""Which share of what is missing could be gained by doubling the rehearsals, before anything is known."""
_SURE = 40  # as many rehearsals as make what was measured count as much as that hope


def competence(operator: Operator, category: Category) -> float:
    """Estimate how often an operator does to an object of its category what it promises for it: 0 to 1.

    Each rehearsal, which are kept of it, is compared with what the others promise.
    """
    kept = keeps_promises(operator, category, NEAR)
    return smoothed(sum(kept), len(kept))


def expected_gain(operator: Operator, category: Category, more: int) -> float:
    """Extrapolate by how much so many more rehearsals would raise the competence of an operator.

    What is missing falls with the root of the number of rehearsals, as errors of regression do.
    """
    count = len(operator.rehearsals)
    if count < 2 or more < 1:
        return 0.0
    now = competence(operator, category)
    objects = rehearsed_objects(operator, category)
    half = msgspec.structs.replace(operator, rehearsals=operator.rehearsals[::2], objects=objects[::2])
    rise = now - competence(half, category)
    weight = count / (count + _SURE)
    doubling = weight * max(rise, 0.0) / math.sqrt(2) + (1 - weight) * HOPE * (1 - now)
    return min(1 - now, doubling * (1 - math.sqrt(count / (count + more))) / (1 - math.sqrt(0.5)))
