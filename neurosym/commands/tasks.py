"""Commands for tasks and plans: `new-problem`, `plan`, `planners` and `validate`."""

import os
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal, Optional

from tyro.conf import Positional, UseAppendAction, arg

from neurosym.choices import DEFAULT_PLANNER
from neurosym.commands.arguments import (
    Folder,
    Json,
    ProblemName,
    Seed,
    Task,
    TimeLimit,
    Tolerance,
    answer_in,
    check_file,
    opened,
    refuse_options,
)
from neurosym.commands.ending import NO_RESULT
from neurosym.errors import InvalidFile, InvalidValue, counted, quoted
from neurosym.files import MOST_TEXT, make_folder, read_text, write_atomically
from neurosym.stages.console import be_quiet, is_quiet, print_raw, say, say_next, show_table
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING, PLANS, WORLD, problem_files, scene_file

if TYPE_CHECKING:
    from neurosym.problems import SceneObject
    from neurosym.stages.plan_records import PlanRecord
    from neurosym.values.problem import Goal


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
        arg(
            metavar="ITEM=X,Y[,Z]",
            help="A goal by hand, in the world frame [m], once for each object; or a condition in words, as "
            'in "all 10 y=0..". With data of your own THING.AXIS=VALUE, or LOW..HIGH.',
        ),
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
    turned: Annotated[bool, arg(help="Draw objects that lie turned by any angle.")] = False,
    like: Annotated[
        Optional[Path],
        arg(metavar="FILE", help="Another scene: objects shall be where those of the same names are there."),
    ] = None,
    tolerance: Annotated[
        Optional[float],
        arg(metavar="METRES", help="How near objects must come to their goals: 0.05, or as the scene says."),
    ] = None,
) -> int:
    """Make a problem: a random scene, and a goal that actions lead to, or yours.

    A goal is a point, or a condition in words: `item-01 x=0.3..0.6`, `2 of 10 within-reach`,
    `item-01 next-to item-02` (also apart-from, on, under, not-on), with `and` and `or` between. What it
    leaves open is chosen. With `--like FILE` objects shall be where those of the same names are in another
    scene; how they lie there is not asked for.

    With `--task` it is what people ask for: `anywhere` puts each object anywhere on the table, `swap` has
    each stand where the next one stood, `row` sets them in a row, and `crowded` clears a crowd. With
    `--relation`, one object shall be put on or into another one; goals and relations go together.

    In a domain with relations, `--task tower` asks for a tower of some of the objects, and `boxes` for things
    each on or in one of its own. `unstack` asks for a stack to be sorted so, and `exchange` for two borne
    things to change places. With `--scene` it is all yours: the file is checked, copied and printed as PDDL.
    """
    from neurosym.problems import Problem, check_names
    from neurosym.stages.problem_making import Asked, problem_stage, scene_stage
    from neurosym.stages.value_stages import goals_in_words, is_of_values, value_problem_stage

    domain, by_hand = opened(folder), bool(goal or relation or like)
    if scene and (by_hand or task or turned or (objects, actions, seed) != (1, 1, 0)):
        raise InvalidValue(
            "Give --scene, or --objects, --actions, --seed, --task, --turned, --goal, --relation and --like, "
            "not both."
        )
    if by_hand + bool(task) + (actions != 1) > 1:
        raise InvalidValue(
            "Give only one of --actions, --task, and goals by hand (--goal, --relation and --like)."
        )
    if state is not None and task not in ("tower", "boxes", "unstack", "exchange"):
        raise InvalidValue("--state is for --task tower, boxes, unstack or exchange.")
    check_names((name,) if name is not None else ())
    of_values = is_of_values(domain)
    if of_values:
        refuse_options(task=task, relation=relation, tolerance=tolerance, like=like, turned=turned)
    others = () if like is None else Problem.load(like).objects
    points, conditions = (None, ()) if of_values else _parse_goals((*goal, *map(_there, others)), relation)
    asked = Asked(
        objects=objects,
        actions=actions,
        seed=seed,
        goals=points,
        conditions=conditions,
        like={item.name: item.features for item in others},
        turned=turned,
        tolerance=tolerance,
        task=task,
        relations=tuple(map(_parse_relation, relation)),
        state=state or "",
    )
    with domain.naming_problems():
        name = name or (_name_of(scene, domain) if scene else domain.free_problem_name())
        check_names((name,))
        verb = "replaced" if name in domain.problem_names() else "wrote"
        if of_values:
            goals = _parse_value_goals(goal)
            stage = value_problem_stage(
                domain, name, things=objects, actions=actions, seed=seed, goals=goals, scene=scene
            )
        elif scene:
            stage = scene_stage(domain, scene, name=name, tolerance=tolerance)
        else:
            stage = problem_stage(domain, name, asked)
        domain.perform(stage, again=True)
    say(f"{verb} {folder / problem_files(name)[0]} and its scene")
    for line in goals_in_words(domain, name) if of_values else _goals_in_words(domain, name):
        say(line)
    say_next(f"neurosym plan {quoted(folder)} {name}")
    return 0


_YES_NO = {"no": "0", "yes": "1"}


def _parse_value_goals(texts: tuple[str, ...]) -> dict[str, dict[str, "Goal"]] | None:
    goals = dict[str, dict[str, "Goal"]]()
    for text in texts:
        place, _, value = text.partition("=")
        thing, _, axis = place.partition(".")
        try:
            bounds = tuple(float(_YES_NO.get(one, one)) for one in value.split(".."))
        except ValueError:
            bounds = ()
        if not (thing and axis and len(bounds) in (1, 2)):
            raise InvalidValue(
                f"The goal {text!r} cannot be read; write it as thing-01.AXIS=0.5, 0.4..0.6, or yes."
            )
        if axis in goals.get(thing, ()):
            raise InvalidValue(f"{thing}.{axis} has two goals; give each axis of a thing one.")
        goals.setdefault(thing, {})[axis] = bounds[0] if len(bounds) == 1 else (bounds[0], bounds[1])
    return goals or None


def _goals_in_words(domain: DomainFolder, name: str) -> Iterator[str]:
    from neurosym.grounding import Grounding
    from neurosym.problems import Problem
    from neurosym.tasks.task import is_reached

    problem = Problem.load(domain / scene_file(name))
    if is_reached(problem, Grounding.load(domain / GROUNDING)):
        yield f"note: it is met at the start, within {1000 * problem.tolerance:g} mm"
    for text in problem.conditions:
        yield f"  asked: {text}"
    for target, other, state in problem.relations:
        yield f"  goal: {target} {state} {other}"
    for target, (x, y, *_) in problem.goals.items() if problem.relations or problem.conditions else ():
        yield f"  goal: {target} at ({x:.3f}, {y:.3f})"


def _name_of(scene: Path, domain: DomainFolder) -> str:
    """Name the problem of a scene like its file, unless that would replace another problem."""
    if not scene.is_file():
        raise InvalidFile(scene, "there is no such file" if not scene.exists() else "it is no file")
    name = scene.name.removesuffix(".json").removesuffix(".scene")
    there = domain / scene_file(name)
    if name in domain.problem_names() and not (there.exists() and there.samefile(scene)):
        raise InvalidValue(f"{domain.path} has a problem {name} already; give another name with --name.")
    return name


def _parse_goals(
    texts: tuple[str, ...], relations: tuple[str, ...]
) -> tuple[dict[str, tuple[float, ...]] | None, tuple[str, ...]]:
    """Return the goals that are points, and the others, which are conditions.

    A point is one, too, if its object shall be in a relation.
    """
    goals, conditions = dict[str, tuple[float, ...]](), list[str]()
    related = {text.split()[0] for text in relations if text.split()}
    for text in texts:
        name, _, numbers = text.partition("=")
        if " " in text.strip():
            conditions.append(" ".join(text.split()))
            continue
        if name in goals:
            raise InvalidValue(f"An object has two goals in {' '.join(texts)}; give each object one.")
        try:
            goals[name] = tuple(map(float, numbers.split(",")))
        except ValueError as error:
            said = f"The goal {text!r} cannot be read; write it as item-01=0.60,0.10."
            raise InvalidValue(said) from error
        if name in related:
            conditions.append(f"{name} at {','.join(map(str, goals.pop(name)))}")
    return goals or None, tuple(conditions)


def _there(item: "SceneObject") -> str:
    """Ask for an object to be where it is in another scene."""
    return f"{item.name} at {','.join(f'{value:.4f}' for value in item.position)}"


def _parse_relation(text: str) -> tuple[str, str, str]:
    words = text.lower().split()
    if len(words) != 3:
        raise InvalidValue(f'The relation {text!r} cannot be read; write it as "item-01 STATE item-02".')
    target, state, reference = words
    return target, reference, state


_STANDARD = Path("-")
"""What names standard input or output in place of a plan file."""
_INPUT = Path("standard input")


def given_plan(
    folder: DomainFolder, typed: Path, name: str, plan_file: Path, *, must_fit: bool = True
) -> Path:
    """Return the file of a plan that was given; what standard input holds is written into the folder first.

    The folder is there as it was `typed`, too. If it `must_fit`, what standard input holds is a plan for the
    problem of that name.

    Raises:
        InvalidFile: If it is no file, or holds no plan for the problem.
        InvalidValue: If there is nothing.
    """
    if plan_file == _STANDARD:
        return _saved_plan(folder, name, must_fit)
    if plan_file.exists() and not plan_file.is_file():
        raise InvalidFile(plan_file, "it is no file; name one that holds a plan")
    if not plan_file.is_file():
        raise InvalidValue(
            f"There is no plan file {plan_file}; `neurosym plan {quoted(typed)} {name}` writes one."
        )
    return plan_file


def _saved_plan(folder: DomainFolder, name: str, must_fit: bool) -> Path:
    from neurosym.grounding import Grounding
    from neurosym.pddl.plan_reading import parse_plan
    from neurosym.stages.planning import load_problem
    from neurosym.worlds.world_file import read_world

    data = sys.stdin.buffer.read(MOST_TEXT + 1)
    if len(data) > MOST_TEXT:
        raise InvalidFile(_INPUT, f"it holds more than {MOST_TEXT} bytes")
    try:
        text = data.decode()
    except UnicodeDecodeError as error:
        raise InvalidFile(_INPUT, "it is no text") from error
    if must_fit:
        problem = load_problem(folder, name, read_world(folder.require(WORLD))())
        parse_plan(text, _INPUT, Grounding.load(folder.require(GROUNDING)), problem)
    make_folder(folder / PLANS)
    file = folder / PLANS / f"{name}.stdin.plan"
    write_atomically(file, text)
    say(f"wrote {file}")
    return file


_UNLIKELY = 0.1
"""Below this chance it is said that a plan seldom goes through."""


def plan(
    folder: Folder,
    problem: ProblemName,
    planner: Annotated[
        str, arg(help="One that `neurosym planners` lists, or your own as module:factory.")
    ] = DEFAULT_PLANNER,
    time_limit: TimeLimit = None,
    encoding: Annotated[
        Optional[Literal["strips", "numeric", "sas"]],
        arg(help="For PDDL planners: strips, numeric or sas, instead of the usual."),
    ] = None,
    whole: Annotated[bool, arg(help="For PDDL planners: all objects at once instead of one by one.")] = False,
    nearest: Annotated[
        bool,
        arg(help="If there is no plan, plan as near to the goal as objects come (exit code 3 if it misses)."),
    ] = False,
    tolerance: Tolerance = None,
    output: Annotated[
        Optional[Path],
        arg(metavar="FILE", help="Write the plan here, too; - prints it to standard output, and only it."),
    ] = None,
    json: Json = False,
) -> int:
    """Plan for a problem; exit code 3 if there is no plan, with the reason.

    `bfs` is the paper's breadth-first search over what the network predicts, three deep without relations;
    `counting` finds the fewest primitives there can be without places. Any other planner can be given
    DIR/domain.pddl and DIR/problems/PROBLEM.pddl, and its plan file executed.
    """
    from neurosym.files import read_json
    from neurosym.stages.plan_records import PlanRecord, written_steps
    from neurosym.stages.planning import plan_stage
    from neurosym.stages.value_stages import is_of_values, plan_values_stage

    if output == _STANDARD and json:
        raise InvalidValue("Both --output - and --json ask for standard output; leave one of them out.")
    check_file(None if output == _STANDARD else output, "plan")
    be_quiet(is_quiet() or output == _STANDARD)
    answer, domain = answer_in(json), opened(folder)
    name = domain.problem(problem)
    if of_values := is_of_values(domain):
        refuse_options(encoding=encoding, whole=whole, nearest=nearest, tolerance=tolerance)
        stage = plan_values_stage(domain, name, planner=planner, time_limit=time_limit)
    else:
        stage = plan_stage(
            domain,
            name,
            planner=planner,
            time_limit=time_limit,
            encoding=encoding,
            whole=whole,
            nearest=nearest,
            tolerance=tolerance,
        )
    plan_file, record_file, _ = stage.outputs
    had_plan = (domain / plan_file).exists()
    domain.perform(stage, again=True)
    record = read_json(domain / record_file, PlanRecord)
    _say_plan(record)
    if had_plan and not (domain / plan_file).exists():
        say(f"removed {folder / plan_file}, the plan of an earlier call")
    written = written_steps(domain, name, record.planner)
    if written:
        why = "" if record.unprinted in ("", record.misses) else f": {record.unprinted}"
        said = f"; these steps are no plan of the printed problem{why}" if record.unprinted else ""
        say(f"wrote {folder / written}{said}")
        within = "" if record.tolerance is None else f" --tolerance {record.tolerance:g}"
        verb = "validate" if of_values else "execute"
        say_next(f"neurosym {verb} {quoted(folder)} {name} {quoted(folder / written)}{within}")
    elif of_values:
        say("note: steps go by whole cells; a wider goal, or a smaller cell in world.toml, may help")
    elif nearest:
        say_next(f"neurosym show {quoted(folder)} --problem {name}")
    else:
        by = "" if planner == DEFAULT_PLANNER else f" --planner {quoted(planner)}"
        say_next(f"neurosym plan {quoted(folder)} {name}{by} --nearest")
    if written and output == _STANDARD:
        be_quiet(False)
        print_raw(read_text(domain / written))
    elif written and output:
        write_atomically(output, read_text(domain / written))
        say(f"wrote {output}")
    answer(record, file=str(domain / written) if written else None)
    return 0 if record.solved else NO_RESULT


def _say_plan(record: "PlanRecord") -> None:
    from neurosym.stages.plan_records import MORE_MOTIONS

    spent = sum(os.times()[:4])  # CPU of this process and of all it started [s]
    count = counted(record.primitives, "primitive")
    if record.solved:
        remark = f" ({record.reason})" if record.reason else ""
        likely = _likely(1.0 if record.chance is None else record.chance)
        say(f"{count} in {spent:.2f} s of CPU{remark}, {likely} to go as promised:")
    else:
        say(f"no plan for {record.problem} ({record.status.value}, {spent:.2f} s of CPU): {record.reason}")
        if record.steps:
            say("as near as it comes:")
    for words in record.steps:
        say(f"  ({' '.join(words)})")
    if record.solved and record.steps and record.chance_replanned is not None:
        motions, likely = record.primitives + MORE_MOTIONS, _likely(record.chance_replanned)
        say(f"planned anew on the way, {likely} to reach the goal within {motions} motions")
    anew = "plan anew on the way (unless --replans 0)"
    if record.misses:
        say(f"note: by what was rehearsed, {record.misses}; let `neurosym execute` {anew}")
    elif record.solved and record.chance is not None and record.chance < _UNLIKELY:
        say(
            f"note: a plan of {count} seldom goes through as it stands; let `neurosym execute` {anew}, or "
            "bring the goals nearer"
        )


def _likely(chance: float) -> str:
    if chance < 0.005:
        return "less than 1% likely"
    return f"{chance:.0%} likely" if chance < 0.995 else "more than 99% likely"


def planners(json: Json = False) -> int:
    """List the planners, the encodings that they take, and whether they are here."""
    from neurosym.planners.registry import PLANNERS

    answer, rows, told, absent = answer_in(json), [], [], dict[str, list[str]]()
    for one in PLANNERS.values():
        missing, encodings = one.missing(), ", ".join(one.encodings) or "-"
        cell = one.program.cell if one.program else 0.0
        cells = f" from {cell * 1000:g} mm" if cell else ""
        rows.append([one.name, one.about, encodings + cells, "no" if missing else "yes"])
        told.append({"name": one.name, "about": one.about, "encodings": one.encodings, "missing": missing})
        if missing:
            absent.setdefault(missing, []).append(one.name)
    show_table("Planners", ["planner", "what it is", "encodings", "installed"], rows)
    for remedy, names in absent.items():
        say(f"{', '.join(names)}: {remedy}")
    say("strips is the page, domain.pddl, for some with cells no smaller than they can bear;")
    say("sas is what Fast Downward makes of objects that are led over cells")
    say("`pip install 'neurosym-pddl[planners]'` brings all of them")
    say_next("neurosym plan DIR PROBLEM --planner NAME")
    answer(told)
    return 0


def validate(
    folder: Folder,
    problem: ProblemName,
    plan_file: Annotated[
        Positional[Path], arg(metavar="PLAN", help="Any planner's plan; - reads it from standard input.")
    ],
    tolerance: Tolerance = None,
    json: Json = False,
) -> int:
    """Judge a plan without executing it; exit code 3 if it is none.

    unified-planning's validator says whether it is a plan of the printed domain and problem. A replay says
    whether it leads to the goal by what was rehearsed, and whether objects end in each other: PDDL does not
    see that where objects are led over cells.
    """
    from neurosym.stages.value_stages import is_of_values
    from neurosym.stages.verdicts import judge_plan, judge_value_plan

    answer, domain = answer_in(json), opened(folder)
    name = domain.problem(problem)
    plan_file = given_plan(domain, folder, name, plan_file, must_fit=False)
    for remark in domain.outdated_file(plan_file):
        say(f"note: {remark}")
    of_values = is_of_values(domain)
    judged = judge_value_plan(domain, name, plan_file) if of_values else None
    verdict = judged or judge_plan(domain, name, plan_file, tolerance)
    whole = ", written out with cells and places" if verdict.written_out else ""
    where = "" if verdict.pddl_failed is None else f"action {verdict.pddl_failed}: "
    said = "valid" if verdict.valid_by_pddl else f"not valid; {where}{verdict.pddl_reason}"
    say(f"by {verdict.domain or 'PDDL'}{whole}, as unified-planning's validator says: {said}")
    say(f"by its replay: {'valid' if verdict.valid_by_replay else f'not valid; {verdict.replay_reason}'}")
    if verdict.chance is not None:
        say(f"{verdict.chance:.0%} likely to go as promised, followed as it is")
    steps = counted(len(verdict.steps), "step")
    say(f"{verdict.plan}: {f'a plan of {steps}' if verdict.valid else 'no plan'} for {verdict.problem}")
    if verdict.steps and not of_values:
        say_next(f"neurosym execute {quoted(folder)} {name} {quoted(plan_file)}")
    answer(verdict, valid=verdict.valid)
    return 0 if verdict.valid else NO_RESULT
