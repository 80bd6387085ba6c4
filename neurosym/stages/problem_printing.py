"""Printing the problems of a domain folder as PDDL, in every way that the domain is printed."""

from collections.abc import Collection

import msgspec

from neurosym.files import remove, write_atomically
from neurosym.grounding import Grounding
from neurosym.pair_sight import with_pairs
from neurosym.pddl import problem_text
from neurosym.pddl.moves import BY_RELATIONS, PLACES, Encoding
from neurosym.pddl.place_domain import carriers_of
from neurosym.pddl.places import with_places
from neurosym.pddl.problem import check_object
from neurosym.pddl.relational_task import Task
from neurosym.problems import Problem
from neurosym.related import is_relational
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import places_file, problem_files, relation_files
from neurosym.stages.other_tools import write_new_problem


def print_problem(
    folder: DomainFolder, problem: Problem, grounding: Grounding, *, only_missing: bool = False
) -> None:
    """Print a problem for other planners, in both ways.

    Args:
        folder: The domain folder.
        problem: The problem.
        grounding: The learned domain.
        only_missing: Leave what is there as it is.
    """
    problem = with_pairs(problem, grounding.relations)
    encodings = _encodings_of(problem, grounding)
    wanted = {file for file in encodings if not (only_missing and (folder / file).exists())}
    if not wanted:
        return
    problem = placed(problem, grounding)
    for file in sorted(wanted):
        write_atomically(folder / file, problem_text(problem, grounding, encodings[file]))
    if not only_missing:
        _remove_stale(folder, problem.name, encodings)
    write_new_problem(folder, problem, grounding)


def placed(problem: Problem, grounding: Grounding) -> Problem:
    """Return a problem with its places, which are drawn once for all that is printed of it.

    Args:
        problem: The problem.
        grounding: The learned domain.
    """
    for item in problem.objects:
        check_object(item, grounding)
    if is_relational(problem, grounding):
        return msgspec.structs.replace(problem, places=Task(problem, grounding).flat.places)
    return with_places(problem, grounding)


def texts_of(problem: Problem, grounding: Grounding) -> dict[str, str]:
    """Print a problem in each way, by file; one of relations in no other.

    Args:
        problem: The problem, with its places.
        grounding: The learned domain.
    """
    return {
        file: problem_text(problem, grounding, encoding)
        for file, encoding in _encodings_of(problem, grounding).items()
    }


def _encodings_of(problem: Problem, grounding: Grounding) -> dict[str, Encoding]:
    """Return what a problem is printed in, by file."""
    if is_relational(problem, grounding):
        return dict(zip(relation_files(problem.name), BY_RELATIONS, strict=True))
    encodings: list[Encoding] = ["stepwise", "numeric"]
    files = [*problem_files(problem.name)]
    if carriers_of(grounding):
        encodings.append(PLACES)
        files.append(places_file(problem.name))
    return dict(zip(files, encodings, strict=True))


def _remove_stale(folder: DomainFolder, name: str, printed: Collection[str]) -> None:
    """Remove what a former problem of that name was printed as, and this one is not."""
    for file in (*problem_files(name), places_file(name), *relation_files(name)):
        if file not in printed and (folder / file).exists():
            remove(folder / file)
