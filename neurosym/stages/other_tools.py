"""What a domain folder holds for other planners: the page without costs, and with durative actions.

No command reads these files, so no stage is out of date for want of them.
"""

from collections.abc import Callable, Collection
from functools import partial
from typing import NamedTuple

from neurosym.errors import InvalidValue
from neurosym.files import write_atomically
from neurosym.grounding import Grounding
from neurosym.pddl.durative import durative_domain_text, durative_problem_text
from neurosym.pddl.encodings import domain_text
from neurosym.pddl.problem import problem_text
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import DURATIVE_DOMAIN, PLAIN_DOMAIN, durative_file, plain_file


class _Form(NamedTuple):
    """One more way to print a domain: its files, and what writes them."""

    domain: str
    problem_file: Callable[[str], str]
    domain_text: Callable[[Grounding], str]
    problem_text: Callable[[Problem, Grounding], str]


_FORMS = (
    _Form(PLAIN_DOMAIN, plain_file, partial(domain_text, costs=False), partial(problem_text, costs=False)),
    _Form(DURATIVE_DOMAIN, durative_file, durative_domain_text, durative_problem_text),
)


def write_domains(folder: DomainFolder, grounding: Grounding, wanted: Collection[str]) -> None:
    """Write the domain in each form that is wanted, or was before.

    Args:
        folder: The domain folder.
        grounding: The learned domain.
        wanted: Names of the files that are asked for now.

    Raises:
        InvalidValue: If it is asked for durative actions, and nothing carries objects to places.
    """
    for form in _FORMS:
        if form.domain in wanted or (folder / form.domain).exists():
            try:
                write_atomically(folder / form.domain, form.domain_text(grounding))
            except InvalidValue:
                if form.domain in wanted:
                    raise


def write_problem(
    folder: DomainFolder, problem: Problem, grounding: Grounding, wanted: Collection[str] = ()
) -> None:
    """Write a problem in each form that there is a domain in; none is left from before where it has none.

    Args:
        folder: The domain folder.
        problem: The problem.
        grounding: The learned domain.
        wanted: Names of the domains that are about to be there.
    """
    for form in _FORMS:
        if form.domain in wanted or (folder / form.domain).exists():
            file = folder / form.problem_file(problem.name)
            try:
                write_atomically(file, form.problem_text(problem, grounding))
            except InvalidValue:  # an object cannot be carried to its goal
                file.unlink(missing_ok=True)
