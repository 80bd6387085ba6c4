"""Rounds of practice: what was tried, what broke plans, and what was practised."""

import msgspec

from neurosym.operators import Count, OperatorTable


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
