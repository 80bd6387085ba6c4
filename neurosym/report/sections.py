"""What was explored, for the page: what became of the objects, when, and by which actions."""

import base64
import io
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path
from typing import TypeVar

import msgspec
import numpy as np
from PIL import Image

from neurosym.checks import Float
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidFile, StageMissing
from neurosym.execution.record import Run
from neurosym.files import make_folder, read_bytes, read_json, write_atomically, write_json
from neurosym.grounding import Grounding
from neurosym.operators import CARRIED, NO_EFFECT, OperatorTable
from neurosym.pictures.film import Row, motion_stills, run_stills
from neurosym.problems import Problem
from neurosym.report.charts import ASPECT, Axis, Chart, Groups, areas, dots
from neurosym.report.explanation import mode_in_words
from neurosym.report.symbol_words import spread_in_words
from neurosym.stages.folder import Claim, DomainFolder, Notify, Stage, rehearsal_options
from neurosym.stages.layout import GROUNDING, MODEL, PLANS, RECORD, REPORT_PICTURES, RUNS, WORLD, scene_file
from neurosym.stages.plan_records import PlanRecord
from neurosym.stages.planning import load_problem
from neurosym.tasks.options import cost
from neurosym.world import Frame, World
from neurosym.worlds.aims import PLACE_AXES

MOST_DOTS = 2000
"""Interactions whose effects are drawn: equally spaced ones, if there are more."""
BLOCK = 256
MOST_BLOCKS = 24
_INSIDE = 0.99  # share of the points that the axes of a scatter plot must hold
_MILLIMETRES = 1000


@dataclass(frozen=True, slots=True)
class Explored:
    """What was explored.

    Attributes:
        count: How many interactions there are.
        origin: How they came about, in words.
        shares: How often each thing became of the object, by its name.
        charts: What is to be drawn of them.
    """

    count: int
    origin: str
    shares: tuple[tuple[str, float], ...]
    charts: tuple[Chart, ...]


def explored(interactions: Interactions) -> Explored:
    """Describe a data set that has one row or more."""
    kinds = what_became(interactions)
    shares = tuple((name, float(rows.mean())) for name, rows in kinds.items() if rows.any())
    return Explored(
        count=len(interactions),
        origin=_origin(interactions),
        shares=shares,
        charts=(_over_time(kinds), *_scatters(interactions, kinds)),
    )


def aimed_in_words(interactions: Interactions) -> str:
    """Tell of a data set of actions that are aimed at places; nothing if it is empty or none."""
    if not len(interactions) or interactions.effects.shape[1] != PLACE_AXES:
        return ""
    carried = float(interactions.effects[:, PLACE_AXES - 1].mean())
    more = f"{len(interactions):,} more interactions were aimed at places"
    return f"{more}; {carried:.0%} of them carried their object there."


def what_became(interactions: Interactions) -> Groups:
    """Sort interactions by what became of the object; each is of one kind."""
    moved = np.linalg.norm(interactions.effects, axis=1) > NO_EFFECT
    left = np.ones(len(interactions), dtype=bool)
    found = {}
    for name, rows in (
        ("ended in the hand", interactions.held),
        ("left the table", interactions.lost),
        ("toppled", interactions.toppled),
        ("were carried and put down", interactions.peak_heights > CARRIED),
        ("were pushed", moved),
        ("hardly moved", ~moved),
    ):
        found[name] = rows & left
        left = left & ~rows
    return found


def _origin(interactions: Interactions) -> str:
    origin = interactions.origin
    if "strategy" not in origin:
        return "data of one's own"
    return f"explored by {origin['strategy']}, seed {origin.get('seed', 'unknown')}"


def _over_time(kinds: Groups) -> Chart:
    count = len(next(iter(kinds.values())))
    blocks = np.array_split(np.arange(count), max(2, min(MOST_BLOCKS, count // BLOCK)))
    blocks = [block for block in blocks if len(block)]
    at = [float(block.mean()) + 1 for block in blocks]
    at[0], at[-1] = 1.0, float(max(2, count))
    shares = {name: [float(rows[block].mean()) for block in blocks] for name, rows in kinds.items()}
    told = ", ".join(f"{name} {rows.mean():.0%}" for name, rows in kinds.items() if rows.any())
    return areas(
        "What became of the objects, as exploration went on",
        f"Stacked shares over {count} interactions; over all of them: {told}.",
        Axis("interactions", 1.0, float(max(2, count))),
        at if len(at) > 1 else [1.0, 2.0],
        shares if len(at) > 1 else {name: values * 2 for name, values in shares.items()},
    )


def _scatters(interactions: Interactions, kinds: Groups) -> list[Chart]:
    rows = np.unique(np.linspace(0, len(interactions) - 1, min(MOST_DOTS, len(interactions))).astype(int))
    effects = interactions.effects[rows].astype(float)
    groups = {name: found[rows] for name, found in kinds.items()}
    shown = f"{len(rows):,} of {len(interactions):,} interactions"
    if effects.shape[1] != 3:
        return []
    away = _from_above(effects)
    level = np.hypot(away[:, 0], away[:, 1])
    charts = [
        _seen_from_above("Effects, seen from above", f"Where the objects of {shown} went", away, groups),
        dots(
            "Effects, far and high",
            f"How far and how high the objects of {shown} were moved, at the end of the rise.",
            Axis("distance along the table [mm]", 0.0, _reach(level)),
            Axis("height [mm]", *_range(_MILLIMETRES * effects[:, 2])),
            np.column_stack([level, _MILLIMETRES * effects[:, 2]]),
            groups,
        ),
    ]
    actions = interactions.actions[rows].astype(float)
    if actions.shape[1] == 12:
        travel = _from_above(actions[:, 8:11] - actions[:, :3])
        what = f"From the first to the last waypoint of the hand, in {shown}"
        charts.append(_seen_from_above("Actions, seen from above", what, travel, groups))
    return charts


def _from_above(vectors: Float[np.ndarray, "P 3"]) -> Float[np.ndarray, "P 2"]:
    """Turn vectors [m] to how far they go to the right and forward [mm]."""
    return _MILLIMETRES * np.column_stack([-vectors[:, 1], vectors[:, 0]])


def _seen_from_above(title: str, what: str, points: Float[np.ndarray, "P 2"], groups: Groups) -> Chart:
    reach = _reach(np.maximum(np.abs(points[:, 0]) / ASPECT, np.abs(points[:, 1])))
    return dots(
        title,
        f"{what}: right is to the right, forward is up.",
        Axis("right [mm]", -ASPECT * reach, ASPECT * reach),
        Axis("forward [mm]", -reach, reach),
        points,
        groups,
    )


def _reach(distances: Float[np.ndarray, "P"]) -> float:
    return float(np.quantile(distances, _INSIDE)) * 1.05 or 1.0


def _range(values: Float[np.ndarray, "P"]) -> tuple[float, float]:
    rest = (1 - _INSIDE) / 2
    low, high = (float(value) for value in np.quantile(values, [rest, 1 - rest]))
    room = 0.05 * (high - low) or 1.0
    return low - room, high + room


# The table of operators, for the page: what each promises, and why it is in the domain or not


@dataclass(frozen=True, slots=True)
class OperatorRow:
    """What an operator promises.

    Attributes:
        name: Its name, as in the PDDL domain.
        trials: How many rehearsals there were, or rows of the data.
        promised: How many of them ended as promised.
        ends: How the object is to end, and in which share of the trials it did.
        effect: How far it is to move, in words.
        spread: Standard deviation of that, in words.
        cost: What a step costs a planner; None if it is in no domain.
        left_out: Why it is not in the domain; empty if it is, or nobody knows.
    """

    name: str
    trials: int
    promised: int
    ends: str
    effect: str
    spread: str
    cost: int | None
    left_out: str


def operator_rows(table: OperatorTable, grounding: Grounding | None) -> tuple[OperatorRow, ...]:
    """List operators, those of the domain if it was compiled, and those first that are in it."""
    rows = []
    for operator in grounding.every_operator if grounding else table.operators:
        promise = operator.promise
        reason = grounding.why_left_out(operator) if grounding else None
        in_domain = grounding is not None and reason is None
        rows.append(
            OperatorRow(
                name=operator.name,
                trials=operator.trials,
                promised=operator.successes,
                ends=f"{promise.kind} {promise.share:.0%}" if promise else "never as it could promise",
                effect=mode_in_words(promise) if promise else "",
                spread=spread_in_words(promise.scatter) if promise else "",
                cost=cost(operator) if in_domain else None,
                left_out=reason or "",
            )
        )
    return tuple(sorted(rows, key=lambda row: row.left_out != ""))


# Examples: the runs of a domain folder, those first that show most of what plans can do

Record = TypeVar("Record")
ProblemReader = Callable[[str], Problem | None]
MOST_STEPS = 6
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


def spared(read: Callable[[], Record], notify: Notify) -> Record | None:
    """Read a record; one that is damaged is named in a note, and None."""
    try:
        return read()
    except (InvalidFile, StageMissing) as error:
        notify(f"{str(error).rstrip('.')}; left out")
        return None


def problem_reader(folder: DomainFolder) -> ProblemReader:
    """Return what reads each problem of a folder once; None for one that is damaged or no longer there."""
    known = folder.problem_names()
    return cache(
        lambda name: spared(partial(load_problem, folder, name), folder.notify) if name in known else None
    )


def runs_of(folder: DomainFolder, read_problem: ProblemReader) -> tuple[Example, ...]:
    """Read the runs of a folder, by name, as far as they and their problems can be read."""
    found = []
    for path in sorted((folder / RUNS).glob(f"*{RECORD}")):
        run = spared(partial(read_json, path, Run), folder.notify)
        if run and (problem := read_problem(run.problem)):
            found.append(Example(path, problem, run))
    return tuple(found)


def telling_examples(runs: Sequence[Example]) -> tuple[Example, ...]:
    """Order runs such that those come first that reached their goal, moving more objects in more steps.

    Each problem comes once, and those with one object and with several take turns. Runs without a step, or
    with too many for a row of pictures, are left out.
    """
    shown = [example for example in runs if 1 <= len(example.run.steps) <= MOST_STEPS]
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


# Plans and what became of them, for the page


@dataclass(frozen=True, slots=True)
class PlanRow:
    """What a planner made of a problem.

    Attributes:
        problem: Name of the problem.
        objects: How many objects it has.
        planner: Name of the planner.
        status: Whether there is a plan, and if not, why.
        steps: How many steps the plan has; None without one.
        seconds: How long planning took [s]; None if only the run is known.
        reached: Whether its run reached the goal; None without a run.
        own: How many of the steps performed are the plan's own, and how many there are; None without a run.
        reason: What is to be said about it.
    """

    problem: str
    objects: int
    planner: str
    status: str
    steps: int | None
    seconds: float | None
    reached: bool | None
    own: tuple[int, int] | None
    reason: str


def plan_rows(
    folder: DomainFolder, examples: Sequence[Example], read_problem: ProblemReader
) -> tuple[PlanRow, ...]:
    """List the plans of a folder, by problem and planner, with their runs, as far as they can be read."""
    runs = {example.name: example for example in examples}
    rows = []
    for path in sorted((folder / PLANS).glob("*.json")):
        record = spared(partial(read_json, path, PlanRecord), folder.notify)
        if record and (problem := read_problem(record.problem)):
            rows.append(_row(problem, record, runs.pop(path.stem, None) if record.solved else None))
    rows += [_row(example.problem, None, example) for example in runs.values()]
    return tuple(sorted(rows, key=lambda row: (row.problem, row.planner)))


def _row(problem: Problem, record: PlanRecord | None, example: Example | None) -> PlanRow:
    """Tell of a plan with its run, or of a run alone, whose plan was given."""
    run = example.run if example else None
    if record:
        planner, status, seconds = record.planner, record.status.value, record.seconds
        steps = record.primitives if record.solved else None
    else:
        assert example, "either is there"
        planner, status, seconds, steps = example.planner, "given", None, len(example.run.plan)
    return PlanRow(
        problem=problem.name,
        objects=len(problem.objects),
        planner=planner,
        status=status,
        steps=steps,
        seconds=seconds,
        reached=run.reached if run else None,
        own=(run.own_steps, len(run.steps)) if run else None,
        reason=_remark(run or record, record.reason if record else ""),
    )


def _remark(record: PlanRecord | Run | None, otherwise: str) -> str:
    """Say what is to be said about a plan or its run, and by which tolerance it is judged if by its own."""
    assert record, "either is there"
    within = "" if record.tolerance is None else f"within {1000 * record.tolerance:g} mm"
    return ": ".join(filter(None, (within, record.reason or otherwise)))


@dataclass(frozen=True, slots=True)
class PlannerSummary:
    """What a planner made of all problems; `alone` counts those reached by its plans without a new one."""

    planner: str
    problems: int
    found: int
    runs: int
    reached: int
    alone: int


def summaries(rows: Sequence[PlanRow]) -> tuple[PlannerSummary, ...]:
    """Count for each planner the plans it found and the runs that reached their goals."""
    found = []
    for planner in sorted({row.planner for row in rows}):
        own = [row for row in rows if row.planner == planner]
        reached = [row for row in own if row.reached]
        found.append(
            PlannerSummary(
                planner=planner,
                problems=len(own),
                found=sum(row.steps is not None for row in own),
                runs=sum(row.reached is not None for row in own),
                reached=len(reached),
                alone=sum(len({*(row.own or ())}) == 1 for row in reached),
            )
        )
    return tuple(found)


# What the page needs and takes long to make: pictures, each made once

STILL_SIZE = (480, 360)
_QUALITY = 80


class Strip(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A row of pictures in one image file.

    Attributes:
        title: What it shows.
        captions: What each picture shows, from left to right.
    """

    title: str
    captions: tuple[str, ...]


class Shown(msgspec.Struct, frozen=True):
    """A strip as a page shows it.

    Attributes:
        strip: What it shows.
        source: The image itself, as a data URI.
        width: How wide it is [pixels].
        height: How high it is [pixels].
    """

    strip: Strip
    source: str
    width: int
    height: int


Drawn = tuple[bytes, Strip]
"""An image, and what it shows."""


@dataclass(frozen=True, slots=True)
class Picture:
    """A strip that may be made by another process.

    Attributes:
        name: What its files are called, without an ending.
        inputs: The files of the folder that it is made from.
        make: Makes it; survives pickling.
        options: What else it depends on.
    """

    name: str
    inputs: tuple[str, ...]
    make: Callable[[], Drawn]
    options: dict[str, int]

    def stage(self, folder: DomainFolder, make: Callable[[], Drawn] | None = None) -> Stage:
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


def motion_picture(folder: DomainFolder, kind: str, what: str) -> Picture:
    """Perform a primitive or an operator: world, model and grounding -> `pictures/report/KIND-NAME.webp`."""
    objects, seed = rehearsal_options(folder.manifest())
    make = partial(_draw_motion, folder.path, what, objects, seed)
    return Picture(f"{kind}-{what}", (WORLD, GROUNDING, MODEL), make, {"objects": objects, "seed": seed})


def run_picture(folder: DomainFolder, example: Example) -> Picture:
    """Perform a run again: world, grounding, problem and run -> `pictures/report/run-NAME.webp`."""
    inputs = (WORLD, GROUNDING, scene_file(example.problem.name), f"{RUNS}/{example.path.name}")
    return Picture(f"run-{example.name}", inputs, partial(_draw_run, folder.path, example), {})


def _draw_motion(path: Path, what: str, objects: int, seed: int) -> Drawn:
    from neurosym.learning.network import EffectModel

    world, grounding = _learned(path)
    categorise = EffectModel.load(path / MODEL).object_symbols
    return _drawn(motion_stills(world, grounding, what, categorise, objects=objects, seed=seed))


def _draw_run(path: Path, example: Example) -> Drawn:
    return _drawn(run_stills(*_learned(path), example.problem, example.run))


def _learned(path: Path) -> tuple[World, Grounding]:
    from neurosym.worlds.world_file import read_world

    return read_world(path / WORLD)(), Grounding.load(path / GROUNDING)


def _drawn(row: Row) -> Drawn:
    return _side_by_side(row.frames), Strip(row.title, row.captions)


def _side_by_side(frames: Sequence[Frame]) -> bytes:
    """Return pictures side by side, as a WebP image."""
    small = [Image.fromarray(frame).resize(STILL_SIZE, Image.Resampling.LANCZOS) for frame in frames]
    buffer = io.BytesIO()
    Image.fromarray(np.hstack([np.asarray(image) for image in small])).save(buffer, "WEBP", quality=_QUALITY)
    return buffer.getvalue()


def shown(folder: DomainFolder, stage: Stage) -> Shown:
    """Read the strip that a stage made."""
    image_file, about_file = stage.outputs
    strip = read_json(folder / about_file, Strip)
    width, height = STILL_SIZE
    image = base64.b64encode(read_bytes(folder / image_file)).decode()
    return Shown(strip, f"data:image/webp;base64,{image}", width * len(strip.captions), height)
