"""A search for operators: what there is to choose from, and what performs."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from neurosym.checks import Float
from neurosym.choices import BUDGET
from neurosym.errors import OpenBar, Progress, part, silent
from neurosym.operators import Categorise, Primitive
from neurosym.primitives.bandit import Perform
from neurosym.primitives.ledger import Ledger
from neurosym.primitives.reliability import PredictOutcomes
from neurosym.primitives.sampling import tasks_of
from neurosym.world import Outcome, Scene, WorldFactory

AUDITIONED, REHEARSED = "auditioned", "rehearsed"
"""What performances are for."""


@dataclass(frozen=True, slots=True, eq=False)
class Search:
    """What operators are chosen from, and measured with."""

    candidates: tuple[Primitive, ...]  # distilled actions
    predict: PredictOutcomes  # a network without a bottleneck on the same data, which shortlists
    features: Float[np.ndarray, "M F"]  # what it can be asked about: of the objects of the data
    categorise: Categorise  # gives the object symbols of features
    world_factory: WorldFactory  # builds the world; must survive pickling if there is more than one worker
    shown: WorldFactory  # builds it as it is shown: every action in it is aimed
    seed: int  # where all draws start
    # how many objects each symbol is rehearsed on, not counting those added for rare categories
    objects: int = 100
    budget: int = BUDGET  # how often actions perform at most
    ledger: Ledger = field(default_factory=Ledger)  # what performs, and keeps what was performed
    former: tuple[Primitive, ...] = ()  # candidates that were chosen before, when less was known
    open_bar: OpenBar = silent  # shows how far each part has come

    @property
    def left(self) -> int:
        """How often actions may still perform."""
        return max(0, self.budget - self.ledger.spent)

    def affordable(self, seen: Sequence[int], most: Sequence[int], share: float = 1.0) -> int:
        """Return in how many scenes each action can be rehearsed, or what is left is spent.

        Args:
            seen: In how many each was already.
            most: In how many at most, for each.
            share: How much of what is left may be spent.
        """

        def cost(enough: int) -> int:
            return sum(max(0, min(enough, limit) - n) for limit, n in zip(most, seen, strict=True))

        counts = range(max(most, default=0), 0, -1)
        return next((enough for enough in counts if cost(enough) <= share * self.left), 0)

    def performer(self, world_factory: WorldFactory, progress: Progress) -> Perform:
        """Return what has candidates perform in a world."""
        begun = self.ledger.spent

        def perform(asked: Sequence[tuple[Primitive, Scene]]) -> list[Outcome]:
            tasks = [task for one, scene in asked for task in tasks_of(one, [scene])]
            done = self.ledger.spent - begun
            return self.ledger.perform(world_factory, tasks, AUDITIONED, part(progress, done))

        return perform
