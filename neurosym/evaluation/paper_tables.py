"""The paper's Tables I to III, from what was measured in domain folders."""

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import msgspec
import numpy as np

from neurosym.data.interactions import Interactions
from neurosym.data.origin import MIN_EFFECT, has_high_effect, model_misfit
from neurosym.errors import InvalidValue, Progress, quoted
from neurosym.evaluation.summary import Comparison, Tally, mean_and_spread
from neurosym.files import read_json, write_json
from neurosym.learning.training import TEST_ROWS, TrainingReport, trivial_predictions
from neurosym.operators import CARRIED, Rehearsal, Symbol, name_axes
from neurosym.primitives.rehearsal import Rehearsals
from neurosym.stages.compilation import operator_table
from neurosym.stages.folder import DomainFolder, Stage, rehearsal_options
from neurosym.stages.layout import (
    COMPARISONS,
    INTERACTIONS,
    KINDS_FOUND,
    MODEL,
    PRIMITIVES,
    TABLE_FILES,
    TRAINING,
    WORLD,
)
from neurosym.world import Outcome

# The six kinds of primitive of Table II. The rule was fixed before any result was looked at:
# - A push (right, left, forward, or pull) ends at rest upright, `_LEAST_MOVE` or more along its direction, at
#   most `_MOST_OFF_AXIS` of that along the other horizontal axis, and never higher than `CARRIED` on the way.
# - A grasp ends held, half the lift or more above the start.
# - A pick and place ends at rest upright, `_LEAST_MOVE` or more away, after more than `CARRIED` in the air.
# An object symbol says what its objects afford. So a primitive is of a kind if there is an object symbol with
# `LEAST_OBJECTS` or more of the objects on which at least `LEAST_SHARE` of its rehearsals were of that kind.

KINDS = ("right push", "left push", "forward push", "pull", "grasp", "pick and place")
_LEAST_MOVE = 0.03
"""Least displacement of a push or a placement [m]."""
_MOST_OFF_AXIS = 0.5
"""Greatest displacement across the direction of a push, as a share of that along it."""
LEAST_SHARE = 0.6
"""Least share of the rehearsals."""
LEAST_OBJECTS = 0.1
"""Least share of the objects that an object symbol must hold to count."""


def kind_of(outcome: Outcome | Rehearsal, lift_height: float) -> str | None:
    """Say which of the six kinds an outcome is, if any.

    `lift_height` is how high a grasped object is lifted [m].
    """
    if outcome.kind == "held":
        return "grasp" if outcome.effect[2] >= lift_height / 2 else None
    if outcome.kind != "resting":
        return None
    x, y, _ = outcome.resting_effect
    if outcome.peak_height > CARRIED:
        return "pick and place" if np.hypot(x, y) >= _LEAST_MOVE else None
    along, across = max(abs(x), abs(y)), min(abs(x), abs(y))
    if along < _LEAST_MOVE or across > _MOST_OFF_AXIS * along:
        return None
    if abs(x) > abs(y):
        return "forward push" if x > 0 else "pull"
    return "left push" if y > 0 else "right push"


def kinds_found(
    rehearsals: Rehearsals, lift_height: float
) -> Mapping[str, tuple[tuple[Symbol, Symbol], ...]]:
    """Say for each kind which primitives are of it, and for which object symbols.

    Args:
        rehearsals: Actions performed on objects of the categories that they serve.
        lift_height: How high a grasped object is lifted [m].
    """
    telling = [str(s) for s in np.unique(rehearsals.symbols) if rehearsals.share(s) >= LEAST_OBJECTS]
    found: dict[str, list[tuple[Symbol, Symbol]]] = {kind: [] for kind in KINDS}
    for number, primitive in enumerate(rehearsals.primitives):
        for symbol in telling:
            kinds = [kind_of(outcome, lift_height) for outcome in rehearsals.on(symbol, number)]
            for kind in KINDS:
                pair = (primitive.symbol, symbol)
                often = bool(kinds) and kinds.count(kind) / len(kinds) >= LEAST_SHARE
                if often and pair not in found[kind]:
                    found[kind].append(pair)
    return {kind: tuple(pairs) for kind, pairs in found.items()}


_OWN_DATA = "own data"
_Errors = dict[str, list[float]]
"""Mean absolute error of each predictor on each axis [m]."""
_Explained = dict[str, float]
"""R2 of each predictor, mean over the axes that vary."""


class KindsFound(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Which kinds of primitive there are.

    Attributes:
        objects: How many objects each primitive was rehearsed on.
        kinds: For each kind, which primitives are of it on objects of which symbol.
    """

    objects: int
    kinds: dict[str, tuple[tuple[str, str], ...]]


class Measured(msgspec.Struct, frozen=True):
    """What was measured in one domain folder; what was not is None or empty.

    Attributes:
        folder: The folder.
        strategy: How its interactions were chosen.
        errors: Errors of prediction.
        rows: On how many interactions.
        r2: R2 of each predictor on them.
        kinds: The kinds of primitive that were found.
        comparisons: How planners did, by the kind of task.
    """

    folder: str
    strategy: str
    errors: _Errors | None
    rows: int
    kinds: KindsFound | None
    comparisons: dict[str, Comparison]
    r2: _Explained | None = None


@dataclass(frozen=True, slots=True)
class Table:
    """A table, and what is to be said about it."""

    title: str
    remark: str
    columns: list[str]
    rows: list[list[str]]


def _kinds_stage(folder: DomainFolder, *, workers: int, progress: Progress | None = None) -> Stage:
    """Rehearse primitives and judge their kinds: primitives, model and world -> `kinds.json`."""
    objects, seed = rehearsal_options(folder.manifest())

    def work() -> None:
        from neurosym.learning.network import EffectModel
        from neurosym.primitives.rehearsal import rehearse
        from neurosym.primitives.sampling import repertoire_of
        from neurosym.worlds.world_file import read_world

        factory = read_world(folder.require(WORLD))
        categorise = EffectModel.load(folder.require(MODEL)).object_symbols
        rehearsals = rehearse(
            factory,
            repertoire_of(operator_table(folder)),
            categorise,
            objects=objects,
            seed=seed,
            workers=workers,
            progress=progress,
        )
        found = kinds_found(rehearsals, factory().lift_height)
        write_json(folder / KINDS_FOUND, KindsFound(objects, dict(found)))

    options = {"objects": objects, "seed": seed}
    return Stage("kinds", (WORLD, *TABLE_FILES, MODEL), (KINDS_FOUND,), work, options)


def measure(
    folder: DomainFolder, test: Interactions | None, *, workers: int, progress: Progress | None = None
) -> Measured:
    """Gather what was measured in a folder, and judge the kinds of its primitives if that was not done.

    Args:
        folder: The domain folder.
        test: Interactions to measure errors on; None for the training report's held-out ones.
        workers: Processes that simulate.
        progress: Called after each interaction of the rehearsals.

    Raises:
        InvalidFile: If a file is damaged.
    """
    report = read_json(folder / TRAINING, TrainingReport) if (folder / TRAINING).is_file() else None
    errors, rows = (report.mae, report.held_out) if report else (None, 0)
    r2 = {"model": report.r2_through_codes} if report else None
    if test is not None and (folder / MODEL).is_file():
        errors, r2, rows = errors_on(folder, test)
    kinds = None
    if all((folder / name).is_file() for name in (WORLD, PRIMITIVES, MODEL)):
        folder.perform(_kinds_stage(folder, workers=workers, progress=progress), again=False)
        kinds = read_json(folder / KINDS_FOUND, KindsFound)
    origin = Interactions.load(folder.require(INTERACTIONS)).origin
    strategy = str(origin.get("strategy", _OWN_DATA))
    return Measured(str(folder.path), strategy, errors, rows, kinds, comparisons_of(folder.path), r2)


def errors_on(folder: DomainFolder, test: Interactions) -> tuple[_Errors, _Explained, int]:
    """Measure a folder's model and the trivial predictors on the test interactions with a high effect.

    Returned are mean absolute error and R2 of each predictor, and the number of these interactions.

    Raises:
        InvalidValue: If none has a high effect, or they are not what the model predicts.
    """
    from neurosym.learning.network import EffectModel
    from neurosym.learning.training import mean_over_axes, r_squared

    model, seen = EffectModel.load(folder / MODEL), Interactions.load(folder.require(INTERACTIONS))
    if problem := model_misfit(model.dimensions, test.columns, test.origin):
        raise InvalidValue(
            f"The model of {folder.path} cannot be tested on these interactions: "
            f"{problem.removesuffix('; train it again')}."
        )
    test = test[np.flatnonzero(has_high_effect(test.effects))[:TEST_ROWS]]
    if not len(test):
        raise InvalidValue(
            f"No interaction of the test set has absolute displacements that sum to {MIN_EFFECT} m or more; "
            "errors are measured on those."
        )
    effects = np.asarray(test.effects, dtype=np.float64)
    guesses = {
        "model": model.predict_from_codes(test.features, test.actions)[0],
        **trivial_predictions(seen.effects, len(effects)),
    }
    errors = {name: np.abs(guess - effects).mean(0).tolist() for name, guess in guesses.items()}
    r2 = {name: mean_over_axes(r_squared(guess, effects), effects) for name, guess in guesses.items()}
    return errors, r2, len(test)


def comparisons_of(folder: Path) -> dict[str, Comparison]:
    """Read what `neurosym compare` measured in a folder, by the kind of task.

    Raises:
        InvalidFile: If a file is damaged.
    """
    paths = sorted((folder / COMPARISONS).glob("*/comparison.json"))
    return {path.parent.name: read_json(path, Comparison) for path in paths}


def tables(measured: Sequence[Measured], test: Path | None) -> tuple[Table, ...]:
    """Make the paper's tables, with a row for each strategy: mean and standard deviation over folders.

    Args:
        measured: What was measured in each folder.
        test: What errors were measured on, if not on the held-out interactions of each folder.
    """
    return _table1(measured, test), _table2(measured), _table3(measured)


def _table1(measured: Sequence[Measured], test: Path | None) -> Table:
    rows = []
    known = [m for m in measured if m.errors]
    for strategy, group in _by_strategy(known).items():
        for name in group[0].errors or ():
            values = np.array([m.errors[name] for m in group if m.errors and name in m.errors])
            scale = 1000 if values.shape[1] == 3 else 1
            cells = [mean_and_spread((scale * column).tolist(), 1) for column in values.T]
            r2 = [m.r2[name] for m in group if m.r2 and name in m.r2]
            rows.append([strategy, str(len(values)), name, *cells, mean_and_spread(r2, 2) if r2 else "-"])
    axes = name_axes(max((len(errors["model"]) for m in known if (errors := m.errors)), default=3))
    unit = " [mm]" if len(axes) == 3 else ""
    counts = ", ".join(sorted({str(m.rows) for m in known}))
    where = (
        f"on the first {counts} interactions of {test} whose absolute displacements sum to 8 cm or more"
        if test
        else f"on the held-out interactions of each folder ({counts}), which strategies chose themselves, so "
        "that rows of different strategies are not of the same test; --test DATA gives all the same"
    )
    columns = ["strategy", "folders", "predictor", *(f"{axis}{unit}" for axis in axes), "R2"]
    said = f"Mean absolute error on each axis, and R2 (mean over the axes that vary), {where}."
    return Table("Table I: errors of prediction", said, columns, rows)


def _table2(measured: Sequence[Measured]) -> Table:
    known = [m for m in measured if m.kinds]
    found = {
        strategy: {
            m.folder: [kind for kind, pairs in m.kinds.kinds.items() if pairs] for m in group if m.kinds
        }
        for strategy, group in _by_strategy(known).items()
    }
    remark = "In how many folders each kind was found, by rehearsal."
    return Table("Table II: primitives", remark, *kinds_table(found, "folder"))


def kinds_table(
    found: Mapping[str, Mapping[str, Collection[str]]], repetition: str
) -> tuple[list[str], list[list[str]]]:
    """Return headings and rows of Table II: in how many repetitions each kind was found."""
    rows = [
        [
            kind,
            *(
                f"{sum(kind in kinds for kinds in repeated.values())} of {len(repeated)}"
                for repeated in found.values()
            ),
        ]
        for kind in KINDS
    ]
    counts = [", ".join(str(len(kinds)) for kinds in repeated.values()) for repeated in found.values()]
    return ["", *found], [*rows, [f"kinds, by {repetition}", *counts]]


def _table3(measured: Sequence[Measured]) -> Table:
    shares: tuple[Callable[[Tally], int], ...] = (
        lambda tally: tally.found,
        lambda tally: tally.valid,
        lambda tally: tally.reached,
        lambda tally: tally.reached_with_replanning,
    )
    rows = []
    for strategy, group in _by_strategy(measured).items():
        for task in sorted({task for m in group for task in m.comparisons}):
            compared = [m.comparisons[task] for m in group if task in m.comparisons]
            for planner in dict.fromkeys(name for comparison in compared for name in comparison.planners):
                of = [(c.planners[planner], c.counted) for c in compared if planner in c.planners]
                cells = [
                    mean_and_spread([100 * share(tally) / max(1, count) for tally, count in of], 1)
                    for share in shares
                ]
                tasks = sum(count for _, count in of)
                rows.append([strategy, task, planner, str(len(of)), str(tasks), *cells])
    columns = ["strategy", "tasks", "planner", "folders", "counted"]
    columns += ["found [%]", "valid [%]", "reached [%]", "with replanning [%]"]
    without = [m.folder for m in measured if not m.comparisons]
    missing = "".join(f" Not measured yet: `neurosym compare {quoted(folder)}`." for folder in without)
    remark = f"Shares of the tasks that are not met at the start.{missing}"
    return Table("Table III: planning", remark, columns, rows)


def _by_strategy(measured: Sequence[Measured]) -> dict[str, list[Measured]]:
    groups: dict[str, list[Measured]] = {}
    for found in measured:
        groups.setdefault(found.strategy, []).append(found)
    return groups
