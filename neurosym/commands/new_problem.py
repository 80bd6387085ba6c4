"""The command `neurosym new-problem`: a task, drawn or set by hand."""

from pathlib import Path
from typing import Annotated, Optional

from tyro.conf import UseAppendAction, arg

from neurosym.commands.options import Folder, Seed, Task, opened
from neurosym.console import say, say_next
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING, problem_files, scene_file
from neurosym.wording import quoted


def new_problem(
    folder: Folder,
    name: Annotated[
        Optional[str],
        arg(help="Its name: a letter, then a-z, digits, hyphens. Else the first free one of task-01, ..."),
    ] = None,
    objects: Annotated[int, arg(help="Objects on the table: item-01, item-02, ...")] = 1,
    actions: Annotated[int, arg(help="Random actions that lead to the goal, one after another.")] = 1,
    seed: Seed = 0,
    task: Task = None,
    goal: Annotated[
        tuple[str, ...],
        UseAppendAction,
        arg(metavar="ITEM=X,Y[,Z]", help="A goal by hand, in the world frame [m], once for each object."),
    ] = (),
    relation: Annotated[
        tuple[str, ...],
        UseAppendAction,
        arg(
            metavar='"ITEM STATE ITEM"',
            help='A goal by relation, as in "item-01 rests-on item-02": a state of the domain, or the '
            "beginning of its name; once for each.",
        ),
    ] = (),
    state: Annotated[
        Optional[str],
        arg(metavar="STATE", help="The state of pairs that a drawn task of relations asks for; else any."),
    ] = None,
    scene: Annotated[
        Optional[Path],
        arg(
            metavar="FILE", help="A whole problem by hand, in a file like those in DIR/problems/*.scene.json."
        ),
    ] = None,
    tolerance: Annotated[
        Optional[float],
        arg(metavar="METRES", help="How near objects must come to their goals: 0.05, or as the scene says."),
    ] = None,
) -> int:
    """Make a problem: a random scene, and a goal that actions lead to, or yours.

    With `--task` it is what people ask for: `anywhere` puts each object anywhere on the table, `swap` has
    each stand where the next one stood, `row` sets them in a row, and `crowded` clears a crowd. With
    `--relation`, one object shall be put on or into another one; goals and relations go together.

    In a domain with relations, `--task tower` asks for a tower of some of the objects, and `boxes` for things
    each on or in one of its own. `unstack` asks for a stack to be sorted so, and `exchange` for two borne
    things to change places. With `--scene` it is all yours: the file is checked, copied and printed as PDDL.
    """
    from neurosym.problems import check_names
    from neurosym.reading import digest
    from neurosym.stages.problem_making import Asked, problem_stage
    from neurosym.stages.scenes import scene_stage

    domain, by_hand = opened(folder), bool(goal or relation)
    if scene and (by_hand or task or (objects, actions, seed) != (1, 1, 0)):
        raise InvalidValue(
            "Give --scene, or --objects, --actions, --seed, --task, --goal and --relation, not both."
        )
    if by_hand + bool(task) + (actions != 1) > 1:
        raise InvalidValue("Give only one of --actions, --task, and goals by hand (--goal and --relation).")
    if state is not None and task not in ("tower", "boxes", "unstack", "exchange"):
        raise InvalidValue("--state is for --task tower, boxes, unstack or exchange.")
    asked = Asked(
        objects=objects,
        actions=actions,
        seed=seed,
        goals=_parse_goals(goal) if goal else None,
        tolerance=tolerance,
        task=task,
        relations=tuple(map(_parse_relation, relation)),
        state=state or "",
    )
    if name is not None:
        check_names((name,))
    with domain.naming_problems():
        name = name or (_name_of(scene, domain) if scene else domain.free_problem_name())
        check_names((name,))
        made = folder / scene_file(name)
        before = digest(made) if made.is_file() else None
        verb = "replaced" if name in domain.problem_names() else "wrote"
        if scene:
            stage = scene_stage(domain, scene, name=name, tolerance=tolerance)
        else:
            stage = problem_stage(domain, name, asked)
        domain.perform(stage, again=True)
    _say_made(domain, folder, name, verb)
    if before != digest(made) and (stale := domain.made_for(name)):
        say(f"note: made for the former {name}, and stale now: {', '.join(stale)}")
    say_next(f"neurosym plan {quoted(folder)} {name}")
    return 0


def _say_made(domain: DomainFolder, folder: Path, name: str, verb: str) -> None:
    from neurosym.grounding import Grounding
    from neurosym.problems import Problem
    from neurosym.related import is_reached

    problem = Problem.load(domain / scene_file(name))
    printed = problem_files(name)[0]
    say(f"{verb} {folder / printed} and its scene")
    if is_reached(problem, Grounding.load(domain / GROUNDING)):
        say(f"note: it is met at the start, within {1000 * problem.tolerance:g} mm")
    for target, other, state in problem.related:
        say(f"  goal: {target} {state} {other}")
    for target, (x, y, *_) in problem.goals.items() if problem.related else ():
        say(f"  goal: {target} at ({x:.3f}, {y:.3f})")


def _name_of(scene: Path, domain: DomainFolder) -> str:
    """Name the problem of a scene like its file, unless that would replace another problem."""
    if not scene.is_file():
        raise InvalidFile(scene, "there is no such file" if not scene.exists() else "it is no file")
    name = scene.name.removesuffix(".json").removesuffix(".scene")
    there = domain / scene_file(name)
    if name in domain.problem_names() and not (there.exists() and there.samefile(scene)):
        raise InvalidValue(f"{domain.path} has a problem {name} already; give another name with --name.")
    return name


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


def _parse_relation(text: str) -> tuple[str, str, str]:
    words = text.lower().split()
    if len(words) != 3:
        raise InvalidValue(f'The relation {text!r} cannot be read; write it as "item-01 STATE item-02".')
    target, state, reference = words
    return target, reference, state
