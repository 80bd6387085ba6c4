"""The command `neurosym new-problem`: a task, drawn or set by hand."""

from typing import TYPE_CHECKING, Annotated

from tyro.conf import UseAppendAction, arg

from neurosym.commands.options import Folder, Seed, opened
from neurosym.console import say, say_next
from neurosym.errors import InvalidValue
from neurosym.stages.layout import scene_file
from neurosym.wording import quoted

if TYPE_CHECKING:
    pass


def new_problem(
    folder: Folder,
    name: Annotated[
        str | None,
        arg(help="Its name: a letter, then a-z, digits, hyphens. Else the first free one of task-01, ..."),
    ] = None,
    objects: Annotated[int, arg(help="Objects on the table: item-01, item-02, ...")] = 1,
    actions: Annotated[int, arg(help="Random actions that lead to the goal, one after another.")] = 1,
    seed: Seed = 0,
    goal: Annotated[
        tuple[str, ...],
        UseAppendAction,
        arg(metavar="ITEM=X,Y[,Z]", help="A goal by hand, in the world frame [m], once for each object."),
    ] = (),
) -> int:
    """Make a problem: a random scene, and a goal that random actions lead to (one in the paper) or yours."""
    from neurosym.files import digest
    from neurosym.problems import check_names
    from neurosym.stages.compiling import problem_stage

    domain = opened(folder)
    name = domain.free_problem_name() if name is None else name
    check_names((name,))
    if goal and actions != 1:
        raise InvalidValue("Give --actions or goals by hand, not both.")
    goals = _parse_goals(goal) if goal else None
    scene = folder / scene_file(name)
    before = digest(scene) if scene.is_file() else None
    verb = "replaced" if name in domain.problem_names() else "wrote"
    stage = problem_stage(domain, name=name, objects=objects, actions=actions, seed=seed, goals=goals)
    domain.perform(stage, again=True)
    say(f"{verb} {folder / 'problems' / name}.pddl and its scene")
    if before != digest(scene) and (stale := domain.made_for(name)):
        say(f"note: made for the former {name}, and stale now: {', '.join(stale)}")
    say_next(f"neurosym plan {quoted(folder)} {name}")
    return 0


def _parse_goals(texts: tuple[str, ...]) -> dict[str, tuple[float, ...]]:
    goals = dict(map(_parse_goal, texts))
    if len(goals) < len(texts):
        raise InvalidValue(f"An object has two goals in {' '.join(texts)}; give each object one.")
    return goals


def _parse_goal(text: str) -> tuple[str, tuple[float, ...]]:
    name, _, numbers = text.partition("=")
    try:
        return name, tuple(float(number) for number in numbers.split(","))
    except ValueError as error:
        raise InvalidValue(f"The goal {text!r} cannot be read; write it as item-01=0.60,0.10.") from error
