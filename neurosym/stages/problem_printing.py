"""Printing the problems of a domain folder as PDDL, in every way that the domain is printed."""

from collections.abc import Collection, Iterable, Sequence
from functools import partial

import msgspec

from neurosym.files import make_folder, remove, write_atomically
from neurosym.grounding import Grounding
from neurosym.pddl.encoding_names import NUMERIC, STRIPS, EncodingName
from neurosym.pddl.encodings import GroundPlan
from neurosym.pddl.problem import check_object, problem_text
from neurosym.problems import Problem
from neurosym.reading import read_text
from neurosym.related import is_relational
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import FORMER, PROBLEMS, printed_file, problem_files, scene_file
from neurosym.stages.other_tools import write_problem
from neurosym.stages.plan_records import recorded_plans
from neurosym.tasks.task import understand


def print_problem(folder: DomainFolder, problem: Problem, grounding: Grounding) -> None:
    """Print a problem for other planners, in every way, such that plans beside it stay plans.

    Args:
        folder: The domain folder.
        problem: The problem.
        grounding: The learned domain.
    """
    problem = placed(problem, grounding)
    printed = texts_of(problem, grounding, recorded_plans(folder, problem, grounding))
    for file in sorted(printed):
        write_atomically(folder / file, printed[file])
    _remove_stale(folder, problem.name, printed)
    write_problem(folder, problem, grounding)


def put_problem(folder: DomainFolder, problem: Problem, grounding: Grounding) -> None:
    """Write a problem that was made just now, printed and as we read it.

    Args:
        folder: The domain folder.
        problem: The problem.
        grounding: The learned domain.
    """
    make_folder(folder / PROBLEMS)
    print_problem(folder, problem, grounding)
    problem.save(folder / scene_file(problem.name))


def print_beside(
    folder: DomainFolder,
    problem: Problem,
    grounding: Grounding,
    encoding: EncodingName,
    plans: Sequence[GroundPlan],
    planner: str,
) -> None:
    """Print a problem anew where it is missing, or lacks what plans beside it need.

    Args:
        folder: The domain folder.
        problem: The problem.
        grounding: The learned domain.
        encoding: The encoding that was planned in; plans may be in another.
        plans: What a planner found just now.
        planner: Name of the planner.
    """
    wanted: dict[str, EncodingName] = {
        printed_file(problem.name, plan.encoding): plan.encoding for plan in plans
    }
    if not plans and not is_relational(problem, grounding):
        wanted = {printed_file(problem.name, encoding): encoding}
    lacking = [file for file in wanted if _lacks(folder, file, _beside(file, problem, plans))]
    if not lacking:
        return
    problem = placed(problem, grounding)
    recorded = recorded_plans(folder, problem, grounding)
    every = (*plans, *recorded_plans(folder, problem, grounding, besides=planner))
    for file in sorted(lacking):
        path, print_with = folder / file, partial(problem_text, problem, grounding, wanted[file])
        ours = (print_with(plans=known) for known in ((), _beside(file, problem, recorded)))
        if path.is_file() and read_text(path) not in ours:
            folder.notify(f"{path} is not as it was printed, so it stays; the plan may be none of it")
        else:
            write_atomically(path, print_with(plans=_beside(file, problem, every)))


def _lacks(folder: DomainFolder, file: str, plans: Iterable[GroundPlan]) -> bool:
    """Say whether a printed problem is missing, or lacks what some plans need."""
    path = folder / file
    return not path.is_file() or any(plan.missing(read_text(path)) for plan in plans)


def _beside(file: str, problem: Problem, plans: Iterable[GroundPlan]) -> list[GroundPlan]:
    """Keep the plans whose problem is printed into a file."""
    return [plan for plan in plans if printed_file(problem.name, plan.encoding) == file]


def placed(problem: Problem, grounding: Grounding) -> Problem:
    """Return a problem with its places, which are drawn once for all that is printed of it.

    Args:
        problem: The problem.
        grounding: The learned domain.
    """
    for item in problem.objects:
        check_object(item, grounding)
    return msgspec.structs.replace(problem, places=understand(problem, grounding).flat.places)


def texts_of(problem: Problem, grounding: Grounding, plans: Sequence[GroundPlan] = ()) -> dict[str, str]:
    """Print a problem in each way, by file; one of relations has none in numbers.

    Args:
        problem: The problem, with its places.
        grounding: The learned domain.
        plans: The plans that stand beside it.
    """
    encodings = [STRIPS, *([] if understand(problem, grounding).relates else [NUMERIC])]
    files = {printed_file(problem.name, each): each for each in encodings}
    return {
        file: problem_text(problem, grounding, each, plans=_beside(file, problem, plans))
        for file, each in files.items()
    }


def _remove_stale(folder: DomainFolder, name: str, printed: Collection[str]) -> None:
    """Remove what a former problem of that name was printed as, and this one is not."""
    for file in (*problem_files(name), *(f"{PROBLEMS}/{name}{ending}" for ending in FORMER)):
        if file not in printed and (folder / file).exists():
            remove(folder / file)
