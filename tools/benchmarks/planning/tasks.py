"""Symbolic tasks for `evaluate.py`: goals some steps away, for which a plan is known."""

import msgspec
import numpy as np

from neurosym.errors import InvalidValue
from neurosym.evaluation.comparison import Bench
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import TOLERANCE, Operator, vector
from neurosym.planners import PlanStatus
from neurosym.planners.action_counts import MOST_WORK, candidates, choices_of, plan_counting
from neurosym.planners.planner import Effort
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.transition import PlanStep, validate
from neurosym.worlds.task_drawing import item_names

DIFFICULTIES = {"easy": (1, 3), "hard": (5, 8)}
"""Least and greatest number of primitives in the shortest plan for each object alone."""
CROWD, SMALL = 4, 0.075  # where more objects than this are to find room, none is wider [m]
STRAY = 0.03  # how much chance there is in walking away from the start [m]
KNOWN = 20_000  # how much counting looks at for a plan
_STREAM = 0x73796D62  # keeps this randomness apart from any other
_TRIES, _OBJECT_TRIES = 50, 2000


def fewest_steps(problem: Problem, grounding: Grounding) -> int | None:
    """Return the fewest primitives that can solve a problem, put-downs not counted; None if none are found.

    Each object stays on the table, and at most one ends held. No plan that replays well has fewer; where
    objects stand in each other's way it may need more.

    Args:
        problem: The problem.
        grounding: The learned domain.
    """
    rows = zip(problem.object_names, choices_of(problem, grounding), strict=True)
    total, saved, must_be_held, effort = 0, [0], 0, Effort(MOST_WORK)
    for choices, goal in [(one, problem.goals[name]) for name, one in rows if name in problem.goals]:
        free, resting = (
            next(candidates(choices, goal, problem.tolerance, effort, at_rest=at_rest), None)
            for at_rest in (False, True)
        )
        if free is None:
            return None
        total += len((resting or free).moves)
        must_be_held += resting is None
        saved.append(len(resting.moves) - len(free.moves) if resting else 0)
    return None if must_be_held > 1 else total - (0 if must_be_held else max(saved))


def draw_symbolic(bench: Bench, objects: int, difficulty: str, seed: int) -> Problem:
    """Draw a scene, and goals that live operators lead to without leaving the table or colliding.

    No object is at its goal at the start, and none but the last may end held.

    Raises:
        InvalidValue: If no such task is found.
    """
    steps = DIFFICULTIES[difficulty]
    for attempt in range(_TRIES):
        rng = np.random.default_rng([_STREAM, objects, steps[0], seed, attempt])
        items: list[SceneObject] = []
        ends: list[SceneObject] = []
        for name in item_names(objects):
            found = _draw_object(bench, name, steps, items, ends, objects, rng)
            if found is None:
                break
            items.append(found[0])
            ends.append(found[1])
        else:
            goals = {end.name: end.position for end in ends}
            task = Problem(
                f"{difficulty}-{objects:02d}-{seed:05d}", tuple(items), goals, provenance="live operators"
            )
            known = plan_counting(task, bench.setting.grounding, work=KNOWN)
            if known.status is PlanStatus.SOLVED:
                return task
    raise InvalidValue(f"No task of {objects} objects was found in {_TRIES} draws.")


def _draw_object(
    bench: Bench,
    name: str,
    steps: tuple[int, int],
    items: list[SceneObject],
    ends: list[SceneObject],
    objects: int,
    rng: np.random.Generator,
) -> tuple[SceneObject, SceneObject] | None:
    """Draw an object and where it shall end, beside those that are there; None if there is no room."""
    grounding = bench.setting.grounding
    for _ in range(_OBJECT_TRIES):
        scene = bench.setting.world.sample_scene(rng, 1)
        if objects > CROWD and scene.features[0, :2].max() > SMALL:
            continue
        (category,) = bench.categorise(scene.features)
        item = SceneObject(name, category, tuple(scene.features[0].tolist()), vector(scene.positions[0]))
        if any(_overlap(item, other) for other in (*items, *ends)):
            continue
        count = int(rng.integers(steps[0], steps[1] + 1))
        end = _walked(item, count, grounding, rng, may_be_held=len(items) == objects - 1)
        if any(_overlap(end, other) for other in (*items, *ends)):
            continue
        alone = Problem("alone", (item,), {name: end.position})
        if max(alone.distances(scene.positions).values()) <= TOLERANCE:
            continue
        fewest = fewest_steps(alone, grounding)
        if fewest is not None and steps[0] <= fewest <= steps[1]:
            return item, end
    return None


def _walked(
    item: SceneObject, count: int, grounding: Grounding, rng: np.random.Generator, *, may_be_held: bool
) -> SceneObject:
    """Apply live operators to an object, mostly such that lead away from where it starts."""
    live = [operator for operator in grounding.live if operator.subject == item.category]
    here = item
    for number in range(1, count + 1):
        usable = [operator for operator in live if not is_lift(operator) or (may_be_held and number == count)]
        moved = [end for operator in usable if (end := _after(here, operator, grounding))]
        away = [np.linalg.norm(np.subtract(end.position, item.position)) for end in moved]
        if not moved:
            break
        here = moved[int(np.argmax(np.array(away) + rng.normal(0.0, STRAY, len(moved))))]
    return here


def _after(item: SceneObject, operator: Operator, grounding: Grounding) -> SceneObject | None:
    alone = Problem("alone", (item,), {item.name: item.position})
    moved = validate([PlanStep(operator.name, item.name)], alone, grounding)
    if not moved.possible:
        return None
    return msgspec.structs.replace(item, position=vector(moved.positions[-1][0]))


def _overlap(one: SceneObject, other: SceneObject) -> bool:
    reach = (np.array(one.features[:2]) + np.array(other.features[:2])) / 2
    return bool(np.all(np.abs(np.subtract(one.position[:2], other.position[:2])) < reach))
