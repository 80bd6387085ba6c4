"""What a user should know of a problem that can be planned for, but hardly is what was meant."""

from collections.abc import Iterator

import msgspec
import numpy as np

from neurosym.grounding import Grounding
from neurosym.pddl.place_problem import carried_objects
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import MODEL
from neurosym.symbols import symbols_of


def remarks_on_places(problem: Problem, grounding: Grounding) -> Iterator[str]:
    """Name the objects that could be carried to their goals, if only there were a place.

    Args:
        problem: The problem; only if it names places of its own, one may be missing.
        grounding: The learned domain.
    """
    if problem.places is msgspec.UNSET:
        return
    here = carried_objects(problem, grounding)
    anywhere = carried_objects(msgspec.structs.replace(problem, places=msgspec.UNSET), grounding)
    lacking = [name for name in anywhere if name in problem.goals and name not in here]
    if lacking:
        yield (
            f'none of the "places" lies at the goal of {" and ".join(lacking)}, so nothing is carried there; '
            'name one there, or leave "places" out, and places are drawn'
        )


def remarks_on_categories(folder: DomainFolder, problem: Problem, grounding: Grounding) -> Iterator[str]:
    """Name the objects that are said to be of another category than the network sees in their features.

    Args:
        folder: The domain folder; if it has no network, nothing is said.
        problem: The problem.
        grounding: The learned domain.
    """
    from neurosym.learning.effect_model import EffectModel

    if not ((folder / MODEL).is_file() and grounding.operators.operators):
        return
    model = EffectModel.load(folder / MODEL)
    seen = symbols_of(model.object_symbols, np.array([item.features for item in problem.objects]))
    for item, symbol in zip(problem.objects, seen, strict=True):
        if item.category != symbol:
            yield f"{item.name} is said to be of category {item.category}; by its features it is of {symbol}"
