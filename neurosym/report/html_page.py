"""The page: gathered from what a domain folder holds, and written as one HTML file."""

import base64
import io
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path
from typing import Any, TypeVar

import msgspec
import numpy as np
from PIL import Image

from neurosym.errors import InvalidFile, InvalidValue, Progress, StageMissing, UnknownChoice
from neurosym.evaluation.summary import comparisons_of
from neurosym.execution.record import Run
from neurosym.files import make_folder, read_bytes, read_json, write_atomically, write_json
from neurosym.grounding import Grounding
from neurosym.learning.training_report import TrainingReport, error_table
from neurosym.operators import OperatorTable
from neurosym.pictures.film import Row, motion_stills, run_stills
from neurosym.pictures.motions import surest_carriers
from neurosym.problems import Problem
from neurosym.report.charts import aimed_in_words, explored
from neurosym.report.drawings import is_body
from neurosym.report.overview import (
    action_codes,
    atlas_of_folder,
    kinds_of,
    maps_of,
    matrix_of,
    promises_of,
    share_kept,
)
from neurosym.report.run_film import film_of_run
from neurosym.report.symbols import effect_row
from neurosym.stages import layout
from neurosym.stages.folder import Claim, DomainFolder, Stage, rehearsal_options, versions
from neurosym.stages.plan_records import PlanRecord
from neurosym.stages.planning import load_problem
from neurosym.stages.rounds import budget_of
from neurosym.tasks.options import cost
from neurosym.world import Palette, World
from neurosym.worlds.workers import worker_pool

_T = TypeVar("_T")
_EXAMPLES = 6  # how many runs are shown in pictures
_FILMS = 3  # of these, as films, too
_MOST_STEPS = 6  # how many steps an example has at most, so that its pictures fit into a row
_PICTURED = 16
"""How many primitives are shown in pictures: each takes seconds, and symbols of six bits are 64."""
_STILL_SIZE = (480, 360)
_QUALITY = 80


def _operator_rows(table: OperatorTable, grounding: Grounding | None) -> list[dict[str, Any]]:
    """List operators with what a step costs a planner, those of the domain first, if it was compiled."""
    rows = []
    known = [one for one in grounding.operators if one.frame != "pair"] if grounding else table.operators
    for operator in known:
        reason = grounding.why_left_out(operator) if grounding else None
        domain = "" if grounding is None else f"no: {reason}" if reason else "yes"
        is_live = grounding is not None and reason is None
        row = effect_row(operator, operator.promise, domain)
        rows.append({"row": row, "cost": cost(operator) if is_live else None, "left_out": bool(reason)})
    return sorted(rows, key=lambda row: bool(row["left_out"]))


@dataclass(frozen=True, slots=True)
class _Example:
    """A run of a domain folder: its file without the ending, the problem it was to solve, and the record."""

    name: str
    problem: Problem
    run: Run


def _plans_and_runs(folder: DomainFolder) -> tuple[list[_Example], list[dict[str, Any]]]:
    """Read the runs of a folder, and tell of its plans; what is damaged is named in a note, and left out."""

    def spared(read: Callable[..., _T], *given: Any) -> _T | None:
        try:
            return read(*given)
        except (InvalidFile, StageMissing) as error:
            folder.notify(f"{str(error).rstrip('.')}; left out")
            return None

    @cache
    def problem_named(name: str) -> Problem | None:
        return spared(load_problem, folder, name) if name in folder.problem_names() else None

    runs, rows = dict[str, _Example](), list[dict[str, Any]]()
    for path in sorted((folder / layout.RUNS).glob(f"*{layout.RECORD}")):
        if (run := spared(read_json, path, Run)) and (problem := problem_named(run.problem)):
            name = path.name.removesuffix(layout.RECORD)
            runs[name] = _Example(name, problem, run)
    left = dict(runs)
    for path in sorted((folder / layout.PLANS).glob("*.json")):
        if (record := spared(read_json, path, PlanRecord)) and (problem := problem_named(record.problem)):
            rows.append(_plan_row(problem, record, left.pop(path.stem, None) if record.solved else None))
    rows += [_plan_row(example.problem, None, example) for example in left.values()]
    return [*runs.values()], sorted(rows, key=lambda row: (row["problem"], row["planner"]))


def _most_telling(runs: Sequence[_Example]) -> list[_Example]:
    """Choose a run of each problem: one that reached its goal, moving more objects in more steps of a few."""

    def rank(example: _Example) -> tuple[bool, int, int, str]:
        steps = example.run.steps
        moved = len({step.object for step in steps})
        return not example.run.reached, -moved, -len(steps), example.name

    first: dict[str, _Example] = {}
    for example in sorted(runs, key=rank):
        if 1 <= len(example.run.steps) <= _MOST_STEPS:
            first.setdefault(example.problem.name, example)
    return [*first.values()][:_EXAMPLES]


def _plan_row(problem: Problem, record: PlanRecord | None, example: _Example | None) -> dict[str, Any]:
    """Tell what a planner made of a problem, and what became of it; of what is not known there is None."""
    row: dict[str, Any] = {"problem": problem.name, "objects": len(problem.objects)}
    row |= {"reached": None, "own": None}
    reason, tolerance = (record.reason, record.tolerance) if record else ("", None)
    if example:
        run = example.run
        reason, tolerance = run.reason or reason, run.tolerance
        planner = example.name.removeprefix(problem.name).removeprefix(".") or example.name
        row |= {"planner": planner, "status": "given", "seconds": None, "steps": len(run.plan)}
        row |= {"reached": run.reached, "own": (run.own_steps, len(run.steps))}  # steps, of those performed
    if record:
        row |= {"planner": record.planner, "status": record.status.value, "seconds": record.seconds}
        row["steps"] = record.primitives if record.solved else None
    within = "" if tolerance is None else f"within {1000 * tolerance:g} mm"
    return row | {"reason": ": ".join(filter(None, (within, reason)))}


def summaries(rows: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """Count by planner the plans found, and the runs that reached their goals, `alone` by its own plans."""
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


class _Strip(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What a row of pictures in one image file shows, and what each of them does, from left to right."""

    title: str
    captions: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _Picture:
    """A strip that any process can make."""

    name: str  # of its files, without an ending
    inputs: tuple[str, ...]  # the files that it is made from
    draw: Callable[[World, Grounding], Row]  # survives pickling
    options: dict[str, int]  # what else it depends on

    @property
    def files(self) -> tuple[str, str]:
        """The image, and what it shows."""
        return f"{layout.REPORT_PICTURES}/{self.name}.webp", f"{layout.REPORT_PICTURES}/{self.name}.json"

    def make(self, path: Path) -> None:
        """Perform what is shown, and write the files into a domain folder."""
        from neurosym.stages.painting import painted_world

        row = self.draw(painted_world(path / layout.WORLD), Grounding.load(path / layout.GROUNDING))
        frames = [Image.fromarray(one).resize(_STILL_SIZE, Image.Resampling.LANCZOS) for one in row.frames]
        buffer = io.BytesIO()
        strip = Image.fromarray(np.hstack([np.asarray(frame) for frame in frames]))
        strip.save(buffer, "WEBP", quality=_QUALITY)
        make_folder(path / layout.REPORT_PICTURES)
        write_atomically(path / self.files[0], buffer.getvalue())
        write_json(path / self.files[1], _Strip(row.title, row.captions))

    def stage(self, work: Callable[[], None]) -> Stage:
        """Return the stage in which the files come into a folder."""
        return Stage(f"picture {self.name}", self.inputs, self.files, work, self.options, Claim.NONE)

    def shown(self, folder: DomainFolder) -> dict[str, Any]:
        """Read the strip, with the image itself as a data URI, and its size [pixels]."""
        image_file, about_file = self.files
        strip = read_json(folder / about_file, _Strip)
        image = base64.b64encode(read_bytes(folder / image_file)).decode()
        width, height = _STILL_SIZE[0] * len(strip.captions), _STILL_SIZE[1]
        source = f"data:image/webp;base64,{image}"
        return {"strip": strip, "source": source, "width": width, "height": height}


def _draw_motion(what: str, path: Path, objects: int, seed: int, world: World, grounding: Grounding) -> Row:
    categorise = DomainFolder(path).network().object_symbols
    return motion_stills(world, grounding, what, categorise, objects=objects, seed=seed)


def _wanted(
    folder: DomainFolder, grounding: Grounding | None, examples: Sequence[_Example]
) -> dict[tuple[str, str], _Picture]:
    """Name the strips to be made: of the primitives that a domain uses most, of carriers, and of runs."""
    wanted = dict[tuple[str, str], _Picture]()
    if grounding is None or not (folder / layout.WORLD).is_file():
        return wanted
    if (folder / layout.MODEL).is_file():
        objects, seed = rehearsal_options(folder.manifest())
        uses, symbols = Counter(one.primitive for one in grounding.live), grounding.objects.symbols
        pictured = sorted(symbols, key=lambda symbol: -uses[symbol])[:_PICTURED]
        names = [("primitive", symbol) for symbol in symbols if symbol in pictured]
        for kind, what in (*names, *(("operator", one.name) for one in surest_carriers(grounding))):
            draw = partial(_draw_motion, what, folder.path, objects, seed)
            options = {"objects": objects, "seed": seed}
            wanted[kind, what] = _Picture(
                f"{kind}-{what}", (layout.WORLD, layout.GROUNDING, layout.MODEL), draw, options
            )
    for example in examples:
        inputs = (
            layout.WORLD,
            layout.GROUNDING,
            layout.scene_file(example.problem.name),
            f"{layout.RUNS}/{example.name}{layout.RECORD}",
        )
        draw_run = partial(run_stills, problem=example.problem, run=example.run)
        wanted["run", example.name] = _Picture(f"run-{example.name}", inputs, draw_run, {})
    return wanted


def _pictures(
    folder: DomainFolder,
    grounding: Grounding | None,
    runs: Sequence[_Example],
    progress: Progress,
    workers: int,
) -> dict[str, Any]:
    """Make the strips that are missing, by so many processes, and return what the page shows of them."""
    wanted = _wanted(folder, grounding, _most_telling(runs))
    left = [one for one in wanted.values() if not folder.is_current(one.stage(lambda: None))]
    strips, refusals = dict[tuple[str, str], dict[str, Any]](), dict[tuple[str, str], str]()
    count = min(workers, len(left))
    with worker_pool(count) if count > 1 else nullcontext() as submit:
        making = {one.name: submit(one.make, folder.path) for one in left} if submit else {}
        for key, picture in wanted.items():
            elsewhere = making.get(picture.name)
            work = elsewhere.result if elsewhere else partial(picture.make, folder.path)
            try:
                folder.perform(picture.stage(work), again=False)
                strips[key] = picture.shown(folder)
            except (InvalidValue, UnknownChoice) as error:
                refusals[key] = str(error)
            progress(len(strips) + len(refusals), len(wanted))
    symbols = grounding.objects.symbols if grounding and (folder / layout.MODEL).is_file() else ()
    others = [one for one in symbols if ("primitive", one) not in wanted]
    return {
        "pictures": {what: strip for (kind, what), strip in strips.items() if kind == "primitive"},
        "carried": [strip for (kind, _), strip in strips.items() if kind == "operator"],
        "without_picture": {what: why for (kind, what), why in refusals.items() if kind == "primitive"}
        | {one: f"`neurosym show DIR --primitive {one}` pictures it" for one in others},
        "examples": {what: strip for (kind, what), strip in strips.items() if kind == "run"},
        "unlike": [f"{what}: {why}" for (kind, what), why in refusals.items() if kind == "run"],
    }


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

    table = folder.found(layout.PRIMITIVES, OperatorTable.load)
    grounding = folder.found(layout.GROUNDING, Grounding.load)
    interactions = folder.found(layout.INTERACTIONS, Interactions.load)
    places = folder.found(layout.PLACE_INTERACTIONS, Interactions.load)
    report = folder.found(layout.TRAINING, lambda path: read_json(path, TrainingReport))
    runs, plans = _plans_and_runs(folder)
    atlas = atlas_of_folder(folder, interactions)
    palette = Palette.of(table.categories) if table else Palette(atlas.shares() if atlas else ())
    codes = atlas.symbols(interactions.features) if atlas and interactions else ()
    acts = action_codes(folder, interactions) if codes and interactions else ()
    filmed = _most_telling(runs)[:_FILMS] if grounding and atlas and is_body(atlas.features) else []
    uses = Counter(one.primitive for one in grounding.live) if grounding else Counter[str]()
    return {
        "name": folder.path.resolve().name,
        "path": str(folder.path),
        "explanation": explain_folder(folder) if table else None,
        **_pictures(folder, grounding, runs, progress, workers),
        "films": [
            film_of_run(one.problem, one.run, palette, grounding.table, f"film-{number}")
            for number, one in enumerate(filmed)
            if grounding
        ],
        "data": explored(interactions, codes, palette, acts) if interactions and len(interactions) else None,
        "aimed": aimed_in_words(places) if places else "",
        "total": budget_of(folder).total,
        "learned": report,
        "kept": share_kept(report) if report and report.r2_direct > 0 else None,
        "map": maps_of(atlas, palette) if atlas else None,
        "kinds": kinds_of(table, atlas, palette) if table else (),
        "matrix": matrix_of(table, atlas, palette, uses) if table else None,
        "promises": promises_of(table, grounding) if table else None,
        "errors": error_table(report) if report else None,
        "operators": _operator_rows(table, grounding) if table else (),
        "compiled": grounding is not None,
        "measured": table.measured if table else "",
        "plans": plans,
        "planners": summaries(plans),
        "comparisons": comparisons_of(folder.path),
        "texts": {
            path.name: read_bytes(path).decode(errors="replace")
            for path in sorted(folder.path.glob("domain*.pddl"))
        },
        "versions": versions(),
    }


def render(page: Mapping[str, Any], template: str = "page.html") -> str:
    """Write what was gathered as HTML; whatever comes from files is escaped."""
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader("neurosym.report"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    return environment.get_template(template).render(page=page)
