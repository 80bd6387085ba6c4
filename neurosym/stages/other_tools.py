"""What a domain folder holds for other tools: problems for temporal planners, and pictures for an editor.

No command reads these files, so no stage is out of date for want of them.
"""

from collections.abc import Iterable, Iterator

from neurosym.errors import InvalidFile, InvalidValue, NeurosymError
from neurosym.files import write_atomically
from neurosym.grounding import Grounding
from neurosym.pddl import domain_text, problem_text
from neurosym.pddl.durative import durative_domain_text, durative_problem_text
from neurosym.pddl.planviz import planviz_json, planviz_script, scenes_of
from neurosym.problems import Problem
from neurosym.reading import read_text
from neurosym.stages.folder import DomainFolder, load_scene
from neurosym.stages.layout import (
    DOMAIN,
    DURATIVE_DOMAIN,
    PLAIN_DOMAIN,
    PLANVIZ_SCRIPT,
    PROBLEMS,
    SCENE,
    durative_file,
    plain_file,
    planviz_file,
)
from neurosym.tasks.carriers import carriers_of


def write_new_problem(folder: DomainFolder, problem: Problem, grounding: Grounding) -> None:
    """Write what there is for other tools of a problem that was made or printed just now.

    Args:
        folder: The domain folder.
        problem: The problem, whose scene may not be in its place yet.
        grounding: The learned domain.
    """
    write_plain_problem(folder, problem, grounding)
    write_durative_problem(folder, problem, grounding)
    found = scenes_of(_former_script(folder))
    there = {scene.name: scene for scene in _scenes(folder)} | {problem.name: problem}
    known = {name: scene for name, scene in found.items() if name in there}
    unknown = [scene for name, scene in there.items() if name not in known or name == problem.name]
    _write_pictures(folder, planviz_script(grounding, unknown, known))


def write_pictures(
    folder: DomainFolder, grounding: Grounding, problems: Iterable[Problem], *, durative: bool
) -> None:
    """Write what draws plans in an editor, for each domain whose states say where objects are.

    Args:
        folder: The domain folder.
        grounding: The learned domain.
        problems: All problems of the folder.
        durative: Whether the domain with durative actions is about to be there.
    """
    _write_pictures(folder, planviz_script(grounding, problems), durative=durative)


def _write_pictures(folder: DomainFolder, script: str, *, durative: bool = False) -> None:
    write_atomically(folder / PLANVIZ_SCRIPT, script)
    has_durative = durative or (folder / DURATIVE_DOMAIN).exists()
    for domain in [DOMAIN, *([DURATIVE_DOMAIN] if has_durative else [])]:
        write_atomically(folder / planviz_file(domain), planviz_json())


def _former_script(folder: DomainFolder) -> str:
    try:
        return read_text(folder / PLANVIZ_SCRIPT)
    except InvalidFile:
        return ""


def _scenes(folder: DomainFolder) -> Iterator[Problem]:
    """Yield the problems of a folder that can be read."""
    for path in sorted((folder / PROBLEMS).glob(f"*{SCENE}")):
        try:
            yield load_scene(path)
        except NeurosymError:
            continue


def write_durative_domain(folder: DomainFolder, grounding: Grounding, *, is_wanted: bool) -> None:
    """Write the domain with durative actions, if it is wanted, or was before.

    Args:
        folder: The domain folder.
        grounding: The learned domain.
        is_wanted: Whether it is asked for now.

    Raises:
        InvalidValue: If it is asked for, and nothing carries objects to places.
    """
    if is_wanted or ((folder / DURATIVE_DOMAIN).exists() and carriers_of(grounding)):
        write_atomically(folder / DURATIVE_DOMAIN, durative_domain_text(grounding))


def write_durative_problem(
    folder: DomainFolder, problem: Problem, grounding: Grounding, *, is_wanted: bool = False
) -> None:
    """Write a problem for the domain with durative actions, where there is such a domain.

    If an object cannot be carried to its goal, there is no such file, and none is left from before.

    Args:
        folder: The domain folder.
        problem: The problem.
        grounding: The learned domain.
        is_wanted: Whether the domain is about to be there.
    """
    if not is_wanted and not (folder / DURATIVE_DOMAIN).exists():
        return
    file = folder / durative_file(problem.name)
    try:
        text = durative_problem_text(problem, grounding)
    except InvalidValue:
        file.unlink(missing_ok=True)
        return
    write_atomically(file, text)


def write_plain_domain(folder: DomainFolder, grounding: Grounding, *, is_wanted: bool) -> None:
    """Write the page without costs, if it is wanted, or was before.

    Args:
        folder: The domain folder.
        grounding: The learned domain.
        is_wanted: Whether it is asked for now.
    """
    if is_wanted or (folder / PLAIN_DOMAIN).exists():
        write_atomically(folder / PLAIN_DOMAIN, domain_text(grounding, costs=False))


def write_plain_problem(
    folder: DomainFolder, problem: Problem, grounding: Grounding, *, is_wanted: bool = False
) -> None:
    """Write a problem for the page without costs, where there is such a domain.

    Args:
        folder: The domain folder.
        problem: The problem.
        grounding: The learned domain.
        is_wanted: Whether the domain is about to be there.
    """
    if is_wanted or (folder / PLAIN_DOMAIN).exists():
        write_atomically(folder / plain_file(problem.name), problem_text(problem, grounding, costs=False))
