"""What a user should know of a problem that can be planned for, but hardly is what was meant."""

from collections.abc import Iterator

import msgspec
import numpy as np

from neurosym.grounding import Grounding
from neurosym.problems import Problem
from neurosym.promises import is_rehearsed, usable
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import MODEL, WORLD
from neurosym.symbols import symbols_of
from neurosym.tasks.footprints import footprints_apart
from neurosym.tasks.places import blockers
from neurosym.tasks.task import understand
from neurosym.worlds.world_file import read_limits


def tell_remarks(
    folder: DomainFolder, problem: Problem, grounding: Grounding, *, is_new: bool = True
) -> None:
    """Tell a user all that is to be said of a problem.

    Args:
        folder: The domain folder.
        problem: The problem.
        grounding: The learned domain.
        is_new: Whether somebody put it there, so that nothing was said of its objects yet.
    """
    for remark in (
        *(remarks_on_objects(folder, problem, grounding) if is_new else ()),
        *remarks_on_places(problem, grounding),
        *remarks_on_blocked(problem, grounding),
        *remarks_on_number(folder, problem),
    ):
        folder.notify(remark)


def remarks_on_places(problem: Problem, grounding: Grounding) -> Iterator[str]:
    """Name the objects that could be carried to their goals, if only there were a place.

    Args:
        problem: The problem; only if it names places of its own, one may be missing.
        grounding: The learned domain.
    """
    if not problem.places:
        return
    here = understand(problem, grounding).carried
    anywhere = understand(msgspec.structs.replace(problem, places={}), grounding).carried
    lacking = [name for name in anywhere if name in problem.goals and name not in here]
    if lacking:
        yield (
            f'none of the "places" lies at the goal of {" and ".join(lacking)}, so nothing is carried there; '
            'name one there, or leave "places" out, and places are drawn'
        )


def remarks_on_blocked(problem: Problem, grounding: Grounding) -> Iterator[str]:
    """Name the places that an object stands on which nothing in the domain moves.

    Args:
        problem: The problem; only places of its own may be blocked so.
        grounding: The learned domain.
    """
    if not problem.places:
        return
    carried, apart = understand(problem, grounding).carried, footprints_apart(problem)
    fixed = [
        item.name
        for item in problem.objects
        if item.name not in carried and not usable(grounding, item, problem.tolerance)
    ]
    for name, spot in problem.places.items():
        others = blockers(carried[0], spot, problem, apart) if carried else ()
        if on := [other for other in others if other in fixed]:
            yield f"{on[0]} stands on the place {name}, and nothing in this domain moves it away"


def remarks_on_number(folder: DomainFolder, problem: Problem) -> Iterator[str]:
    """Say if there are more objects than the world of a folder simulates; plans can be found all the same.

    Args:
        folder: The domain folder.
        problem: The problem.
    """
    limits = read_limits(folder / WORLD) if (folder / WORLD).is_file() else None
    if limits and (reason := limits.too_many(len(problem.objects))):
        yield f"{reason}, so plans for this problem cannot be executed"


def remarks_on_objects(folder: DomainFolder, problem: Problem, grounding: Grounding) -> Iterator[str]:
    """Name the objects that are unlike all of their category, or seem to be of another one.

    Args:
        folder: The domain folder; if it has no network, nothing is said of other categories.
        problem: The problem.
        grounding: The learned domain.
    """
    if not grounding.operators.operators:
        return
    for item in problem.objects:
        if not is_rehearsed(grounding.category(item.category), item.features):
            yield f"{item.name} is unlike all that were rehearsed: it is promised what its category is"
    if not (folder / MODEL).is_file():
        return
    from neurosym.learning.effect_model import EffectModel  # importing torch takes seconds

    model = EffectModel.load(folder / MODEL)
    seen = symbols_of(model.object_symbols, np.array([item.features for item in problem.objects]))
    for item, symbol in zip(problem.objects, seen, strict=True):
        if item.category != symbol:
            yield f"{item.name} is said to be of category {item.category}; by its features it is of {symbol}"
