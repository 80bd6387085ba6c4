"""The page: gathered from what a domain folder holds, and written as one HTML file."""

import base64
import io
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path
from typing import Any, TypeVar

import msgspec
import numpy as np
from PIL import Image

from neurosym.errors import InvalidFile, InvalidValue, Progress, StageMissing, UnknownChoice
from neurosym.evaluation.paper_tables import comparisons_of
from neurosym.execution.record import Run
from neurosym.files import make_folder, read_bytes, read_json, write_atomically, write_json
from neurosym.grounding import Grounding
from neurosym.learning.training import TrainingReport, error_table
from neurosym.operators import OperatorTable
from neurosym.pictures.film import Row, motion_stills, run_stills
from neurosym.pictures.motions import surest_carriers
from neurosym.problems import Problem
from neurosym.report.charts import aimed_in_words, explored
from neurosym.report.explanation import mode_in_words
from neurosym.report.symbol_words import spread_in_words
from neurosym.stages.compilation import operator_table
from neurosym.stages.folder import Claim, DomainFolder, Notify, Stage, rehearsal_options, versions
from neurosym.stages.layout import (
    GROUNDING,
    INTERACTIONS,
    MODEL,
    PLACE_INTERACTIONS,
    PLANS,
    PRIMITIVES,
    RECORD,
    REPORT_PICTURES,
    RUNS,
    TRAINING,
    WORLD,
    scene_file,
)
from neurosym.stages.plan_records import PlanRecord
from neurosym.stages.planning import load_problem
from neurosym.tasks.options import cost
from neurosym.world import Frame, World
from neurosym.worlds.workers import worker_pool

_T = TypeVar("_T")
_EXAMPLES = 6
"""How many runs are shown in pictures."""
PICTURED = 16
"""How many primitives are shown in pictures: each takes seconds, and symbols of six bits are 64."""


def _operator_rows(table: OperatorTable, grounding: Grounding | None) -> list[dict[str, Any]]:
    """List operators, those of the domain if it was compiled, and those first that are in it.

    What a step costs a planner is None if it is in no domain; why it is left out is empty if nobody knows.
    """
    rows = []
    for operator in grounding.every_operator if grounding else table.operators:
        promise = operator.promise
        reason = grounding.why_left_out(operator) if grounding else None
        rows.append(
            {
                "name": operator.name,
                "trials": operator.trials,
                "promised": operator.successes,
                "ends": f"{promise.kind} {promise.share:.0%}" if promise else "never as it could promise",
                "effect": mode_in_words(promise) if promise else "",
                "spread": spread_in_words(promise.scatter) if promise else "",
                "cost": cost(operator) if grounding and reason is None else None,
                "left_out": reason or "",
            }
        )
    return sorted(rows, key=lambda row: row["left_out"] != "")


_ProblemReader = Callable[[str], Problem | None]
_MOST_STEPS = 6
"""How many steps an example has at most, so that its pictures fit into a row."""


@dataclass(frozen=True, slots=True)
class Example:
    """A run of a domain folder.

    Attributes:
        path: The file of the run.
        problem: The problem it was to solve.
        run: What became of the plan.
    """

    path: Path
    problem: Problem
    run: Run

    @property
    def name(self) -> str:
        """Name of the plan, the planner's name included."""
        return self.path.name.removesuffix(RECORD)

    @property
    def planner(self) -> str:
        """Name of the planner, if the plan's file was named by it."""
        return self.name.removeprefix(self.problem.name).removeprefix(".") or self.name


def _spared(read: Callable[[], _T], notify: Notify) -> _T | None:
    """Read a record; one that is damaged is named in a note, and None."""
    try:
        return read()
    except (InvalidFile, StageMissing) as error:
        notify(f"{str(error).rstrip('.')}; left out")
        return None


def _problem_reader(folder: DomainFolder) -> _ProblemReader:
    """Return what reads each problem of a folder once; None for one that is damaged or no longer there."""
    known = folder.problem_names()
    return cache(
        lambda name: _spared(partial(load_problem, folder, name), folder.notify) if name in known else None
    )


def _runs_of(folder: DomainFolder, read_problem: _ProblemReader) -> tuple[Example, ...]:
    """Read the runs of a folder, by name, as far as they and their problems can be read."""
    found = []
    for path in sorted((folder / RUNS).glob(f"*{RECORD}")):
        run = _spared(partial(read_json, path, Run), folder.notify)
        if run and (problem := read_problem(run.problem)):
            found.append(Example(path, problem, run))
    return tuple(found)


def telling_examples(runs: Sequence[Example]) -> tuple[Example, ...]:
    """Order runs such that those come first that reached their goal, moving more objects in more steps.

    Each problem comes once, and those with one object and with several take turns. Runs without a step, or
    with too many for a row of pictures, are left out.
    """
    shown = [example for example in runs if 1 <= len(example.run.steps) <= _MOST_STEPS]
    ordered = sorted(shown, key=_rank)
    first: dict[str, Example] = {}
    for example in ordered:
        first.setdefault(example.problem.name, example)
    groups = [
        [example for example in first.values() if (len(example.problem.objects) == 1) is is_single]
        for is_single in (True, False)
    ]
    longest = max(map(len, groups))
    return tuple(group[index] for index in range(longest) for group in groups if index < len(group))


def _rank(example: Example) -> tuple[bool, int, int, str]:
    steps = example.run.steps
    return not example.run.reached, -len({step.object for step in steps}), -len(steps), example.name


_PlanRow = dict[str, Any]
"""What a planner made of a problem: status says whether there is a plan, and if not, why; seconds are of
planning, None if only the run is known; own says how many steps performed are the plan's, of how many."""


def _plan_rows(
    folder: DomainFolder, examples: Sequence[Example], read_problem: _ProblemReader
) -> tuple[_PlanRow, ...]:
    """List the plans of a folder, by problem and planner, with their runs, as far as they can be read."""
    runs = {example.name: example for example in examples}
    rows = []
    for path in sorted((folder / PLANS).glob("*.json")):
        record = _spared(partial(read_json, path, PlanRecord), folder.notify)
        if record and (problem := read_problem(record.problem)):
            rows.append(_row(problem, record, runs.pop(path.stem, None) if record.solved else None))
    rows += [_row(example.problem, None, example) for example in runs.values()]
    return tuple(sorted(rows, key=lambda row: (row["problem"], row["planner"])))


def _row(problem: Problem, record: PlanRecord | None, example: Example | None) -> _PlanRow:
    """Tell of a plan with its run, or of a run alone, whose plan was given."""
    row: _PlanRow = {"problem": problem.name, "objects": len(problem.objects), "reached": None, "own": None}
    reason, tolerance = "", None
    if record:
        reason, tolerance = record.reason, record.tolerance
        row |= {"planner": record.planner, "status": record.status.value, "seconds": record.seconds}
        row["steps"] = record.primitives if record.solved else None
    if example:
        run = example.run
        reason, tolerance = run.reason or reason, run.tolerance
        given = {"planner": example.planner, "status": "given", "seconds": None, "steps": len(run.plan)}
        row = given | row | {"reached": run.reached, "own": (run.own_steps, len(run.steps))}
    within = "" if tolerance is None else f"within {1000 * tolerance:g} mm"
    return row | {"reason": ": ".join(filter(None, (within, reason)))}


def summaries(rows: Sequence[_PlanRow]) -> list[dict[str, Any]]:
    """Count for each planner the plans it found and the runs that reached their goals.

    `alone` counts those reached by its plans without a new one.
    """
    found = []
    for planner in sorted({row["planner"] for row in rows}):
        own = [row for row in rows if row["planner"] == planner]
        reached = [row for row in own if row["reached"]]
        counts = {
            "problems": len(own),
            "found": sum(row["steps"] is not None for row in own),
            "runs": sum(row["reached"] is not None for row in own),
            "reached": len(reached),
            "alone": sum(len({*(row["own"] or ())}) == 1 for row in reached),
        }
        found.append({"planner": planner, **counts})
    return found


_STILL_SIZE = (480, 360)
_QUALITY = 80


class _Strip(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What a row of pictures in one image file shows, and what each of them does, from left to right."""

    title: str
    captions: tuple[str, ...]


_Drawn = tuple[bytes, _Strip]
"""An image, and what it shows."""


@dataclass(frozen=True, slots=True)
class _Picture:
    """A strip that may be made by another process.

    Attributes:
        name: What its files are called, without an ending.
        inputs: The files of the folder that it is made from.
        make: Makes it; survives pickling.
        options: What else it depends on.
    """

    name: str
    inputs: tuple[str, ...]
    make: Callable[[], _Drawn]
    options: dict[str, int]

    def stage(self, folder: DomainFolder, make: Callable[[], _Drawn] | None = None) -> Stage:
        """Return the stage that makes the strip, or takes it if it is made elsewhere, into the folder."""
        files = image_file, about_file = (
            f"{REPORT_PICTURES}/{self.name}.webp",
            f"{REPORT_PICTURES}/{self.name}.json",
        )

        def work() -> None:
            image, strip = (make or self.make)()
            make_folder(folder / REPORT_PICTURES)
            write_atomically(folder / image_file, image)
            write_json(folder / about_file, strip)

        return Stage(f"picture {self.name}", self.inputs, files, work, self.options, Claim.NONE)


def _motion_picture(folder: DomainFolder, kind: str, what: str) -> _Picture:
    """Perform a primitive or an operator: world, model and grounding -> `pictures/report/KIND-NAME.webp`."""
    objects, seed = rehearsal_options(folder.manifest())
    make = partial(_draw_motion, folder.path, what, objects, seed)
    return _Picture(f"{kind}-{what}", (WORLD, GROUNDING, MODEL), make, {"objects": objects, "seed": seed})


def _run_picture(folder: DomainFolder, example: Example) -> _Picture:
    """Perform a run again: world, grounding, problem and run -> `pictures/report/run-NAME.webp`."""
    inputs = (WORLD, GROUNDING, scene_file(example.problem.name), f"{RUNS}/{example.path.name}")
    return _Picture(f"run-{example.name}", inputs, partial(_draw_run, folder.path, example), {})


def _draw_motion(path: Path, what: str, objects: int, seed: int) -> _Drawn:
    from neurosym.learning.network import EffectModel

    world, grounding = _learned(path)
    categorise = EffectModel.load(path / MODEL).object_symbols
    return _drawn(motion_stills(world, grounding, what, categorise, objects=objects, seed=seed))


def _draw_run(path: Path, example: Example) -> _Drawn:
    return _drawn(run_stills(*_learned(path), example.problem, example.run))


def _learned(path: Path) -> tuple[World, Grounding]:
    from neurosym.worlds.world_file import read_world

    return read_world(path / WORLD)(), Grounding.load(path / GROUNDING)


def _drawn(row: Row) -> _Drawn:
    return _side_by_side(row.frames), _Strip(row.title, row.captions)


def _side_by_side(frames: Sequence[Frame]) -> bytes:
    """Return pictures side by side, as a WebP image."""
    small = [Image.fromarray(frame).resize(_STILL_SIZE, Image.Resampling.LANCZOS) for frame in frames]
    buffer = io.BytesIO()
    Image.fromarray(np.hstack([np.asarray(image) for image in small])).save(buffer, "WEBP", quality=_QUALITY)
    return buffer.getvalue()


def _shown(folder: DomainFolder, stage: Stage) -> dict[str, Any]:
    """Read the strip that a stage made, with the image itself as a data URI, and its size [pixels]."""
    image_file, about_file = stage.outputs
    strip = read_json(folder / about_file, _Strip)
    width, height = _STILL_SIZE
    image = base64.b64encode(read_bytes(folder / image_file)).decode()
    source = f"data:image/webp;base64,{image}"
    return {"strip": strip, "source": source, "width": width * len(strip.captions), "height": height}


def gather(folder: DomainFolder, progress: Progress, *, workers: int = 1) -> dict[str, Any]:
    """Read a domain folder, and make the pictures that are not there yet.

    Args:
        folder: The domain folder.
        progress: Called after each picture.
        workers: Processes that make pictures; their number does not change these.

    Returns:
        What the template `page.html` shows, by name; what is missing is empty or None.

    Raises:
        InvalidFile: If a file is damaged, other than a plan's record, a run or a problem: those are named.
    """
    from neurosym.data.interactions import Interactions
    from neurosym.report.explanation import explain_folder

    def found(name: str, load: Callable[[Path], _T]) -> _T | None:
        return load(folder / name) if (folder / name).is_file() else None

    table = operator_table(folder) if (folder / PRIMITIVES).is_file() else None
    grounding = found(GROUNDING, Grounding.load)
    interactions = found(INTERACTIONS, Interactions.load)
    places = found(PLACE_INTERACTIONS, Interactions.load)
    report = found(TRAINING, lambda path: read_json(path, TrainingReport))
    read_problem = _problem_reader(folder)
    runs = _runs_of(folder, read_problem)
    plans = _plan_rows(folder, runs, read_problem)
    explanation = explain_folder(folder) if table else None
    domains = sorted(folder.path.glob("domain*.pddl"))
    pictures = _pictures(folder, grounding, runs, progress, workers)
    return {
        "name": folder.path.resolve().name,
        "path": str(folder.path),
        "explanation": explanation,
        **pictures,
        "data": explored(interactions) if interactions and len(interactions) else None,
        "aimed": aimed_in_words(places) if places else "",
        "learned": report,
        "errors": error_table(report) if report else None,
        "operators": _operator_rows(table, grounding) if table else (),
        "compiled": grounding is not None,
        "measured": table.measured if table else "",
        "plans": plans,
        "planners": summaries(plans),
        "comparisons": comparisons_of(folder.path),
        "texts": {path.name: read_bytes(path).decode(errors="replace") for path in domains},
        "versions": versions(),
    }


def _pictures(
    folder: DomainFolder,
    grounding: Grounding | None,
    runs: Sequence[Example],
    progress: Progress,
    workers: int,
) -> dict[str, Any]:
    """Make the strips of primitives, carriers and example runs, as far as there is what they need."""
    symbols, others, carriers, chosen = list[str](), list[str](), list[str](), list[Example]()
    if grounding and (folder / WORLD).is_file():
        chosen = list(telling_examples(runs)[:_EXAMPLES])
        if (folder / MODEL).is_file():
            symbols, others = _pictured(grounding)
            carriers = [one.name for one in surest_carriers(grounding)]
    pictures = [
        *(_motion_picture(folder, "primitive", symbol) for symbol in symbols),
        *(_motion_picture(folder, "operator", name) for name in carriers),
        *(_run_picture(folder, example) for example in chosen),
    ]
    made = iter(_made(folder, pictures, progress, workers))
    primitives = {symbol: next(made) for symbol in symbols}
    carried = [next(made) for _ in carriers]
    ran = {example.name: next(made) for example in chosen}
    return {
        "pictures": {symbol: strip for symbol, strip in primitives.items() if isinstance(strip, dict)},
        "carried": [strip for strip in carried if isinstance(strip, dict)],
        "without_picture": {symbol: why for symbol, why in primitives.items() if isinstance(why, str)}
        | {symbol: f"`neurosym show DIR --primitive {symbol}` pictures it" for symbol in others},
        "examples": {name: strip for name, strip in ran.items() if isinstance(strip, dict)},
        "unlike": [f"{name}: {reason}" for name, reason in ran.items() if isinstance(reason, str)],
    }


def _pictured(grounding: Grounding) -> tuple[list[str], list[str]]:
    """Divide the symbols into those to be pictured, which the domain uses most, and the others."""
    symbols = grounding.operators.symbols
    uses = Counter(operator.primitive for operator in grounding.live)
    chosen = set(sorted(symbols, key=lambda symbol: -uses[symbol])[:PICTURED])
    return [one for one in symbols if one in chosen], [one for one in symbols if one not in chosen]


def _made(
    folder: DomainFolder, pictures: Sequence[_Picture], progress: Progress, workers: int
) -> list[dict[str, Any] | str]:
    """Return each picture, or why it cannot be made; what is missing is made by so many processes."""
    left = [one for one in pictures if not folder.is_current(one.stage(folder))]
    if min(workers, len(left)) <= 1:
        return _kept(folder, pictures, {}, progress)
    with worker_pool(min(workers, len(left))) as submit:
        return _kept(folder, pictures, {one.name: submit(one.make) for one in left}, progress)


def _kept(
    folder: DomainFolder, pictures: Sequence[_Picture], drawing: Mapping[str, Future[Any]], progress: Progress
) -> list[dict[str, Any] | str]:
    """Put pictures into the folder, as soon as they are made, and return what they show."""
    made: list[dict[str, Any] | str] = []
    for picture in pictures:
        elsewhere = drawing.get(picture.name)
        stage = picture.stage(folder, elsewhere.result if elsewhere else None)
        try:
            folder.perform(stage, again=False)
            made.append(_shown(folder, stage))
        except (InvalidValue, UnknownChoice) as error:
            made.append(str(error))
        progress(len(made), len(pictures))
    return made


def render(page: Mapping[str, Any]) -> str:
    """Write what was gathered as HTML; whatever comes from files is escaped."""
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader("neurosym.report"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    return environment.get_template("page.html").render(page=page)
