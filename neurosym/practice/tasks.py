"""Tasks to practise on: drawn, planned, executed; and which operators broke which plans."""

from collections import Counter
from dataclasses import dataclass

from neurosym.errors import InvalidValue, InvalidWorld
from neurosym.execution.executor import execute
from neurosym.execution.record import StepRecord
from neurosym.grounding import Grounding
from neurosym.planners import PlanStatus, plan
from neurosym.practice.competence import NEAR
from neurosym.symbols import Categorise
from neurosym.tasks.steps import PlanStep
from neurosym.world import World
from neurosym.worlds.problem_drawing import draw_problem

MOST_OBJECTS, MOST_ACTIONS = 2, 3
_FIRST_SEED = 1 << 40  # above those that people give, and that evaluations use


@dataclass(frozen=True, slots=True)
class Tried:
    """What became of some tasks.

    Attributes:
        planned: How many had a plan.
        reached: How many plans came true, without a new plan on the way.
        interactions: How many steps were performed.
        uses: How often each operator was performed, by its name.
        broke: In how many tasks each was the first that did not do as promised.
    """

    planned: int
    reached: int
    interactions: int
    uses: Counter[str]
    broke: Counter[str]


def try_tasks(world: World, grounding: Grounding, categorise: Categorise, numbers: range, seed: int) -> Tried:
    """Draw tasks, plan them with Fast Downward, and follow the plans blindly.

    One or two objects, and goals that one to three random actions lead to, within `NEAR`.

    Args:
        world: Where plans are executed.
        grounding: The learned domain.
        categorise: Gives objects their symbols.
        numbers: Which tasks.
        seed: Where all draws start.
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
        if broken := next((step.operator for step in run.steps if breaks(step)), None):
            broke[broken] += 1
    return Tried(planned, reached, interactions, uses, broke)


def breaks(step: StepRecord) -> bool:
    """Say whether a step did something else than it promised.

    Args:
        step: The step.
    """
    return step.happened != step.promised or step.deviation is None or step.deviation > NEAR
