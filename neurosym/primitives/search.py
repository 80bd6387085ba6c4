"""A search for operators: what there is to choose from, and how it goes on for what actions are aimed at."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from neurosym.arrays import Float
from neurosym.operators import Primitive
from neurosym.primitives.rehearsal import Rehearsals
from neurosym.primitives.repertoire import Repertoire
from neurosym.primitives.variety import PredictOutcomes
from neurosym.progress import OpenBar, silent
from neurosym.symbols import Categorise
from neurosym.world import WorldFactory


@dataclass(frozen=True, slots=True, eq=False)
class Search:
    """What operators are chosen from, and measured with.

    Attributes:
        candidates: Distilled actions.
        predict: A network without a bottleneck on the same data, which shortlists.
        features: What it can be asked about: of the objects of the data.
        categorise: Gives the object symbols of features.
        world_factory: Builds the world; must survive pickling if there is more than one worker.
        shown: Builds it as it is shown: every action in it is aimed.
        seed: Where all draws start.
        objects: How many objects each symbol is rehearsed on, not counting those added for rare categories.
        workers: How many processes; their number does not change the result.
        open_bar: Shows how far each part has come.
    """

    candidates: tuple[Primitive, ...]
    predict: PredictOutcomes
    features: Float[np.ndarray, "M F"]
    categorise: Categorise
    world_factory: WorldFactory
    shown: WorldFactory
    seed: int
    objects: int = 100
    workers: int = 1
    open_bar: OpenBar = silent


@dataclass(frozen=True, slots=True)
class Method:
    """How operators are found for what actions are aimed at.

    Attributes:
        adapt: Has every action in a world aimed so.
        choose: Chooses among the candidates.
        measure: Tells from the rehearsals of what was chosen what each operator does; rehearses it further.
    """

    adapt: Callable[[WorldFactory], WorldFactory]
    choose: Callable[[Search], Repertoire]
    measure: Callable[[Search, Rehearsals], Any]
