"""Is done what people ask for? `make evaluate-asked`, into docs/results/asked.*.

Things lie turned, goals are conditions in words, some towers and boxes are tried, and what has toppled is
pushed about. Domains are those that are shipped. Goes on where it was interrupted.
"""

from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from neurosym.errors import InvalidValue
from neurosym.stages.folder import DomainFolder
from neurosym.worlds.world_file import read_world
from tools.benchmarks import options
from tools.benchmarks.asked.tasks import DRAWN, FORMS, set_upright
from tools.benchmarks.domains import bench_of
from tools.benchmarks.jobs import Evaluation, Jobs
from tools.benchmarks.planning.jobs import blocks
from tools.benchmarks.planning.measures import TIME_LIMIT
from tools.benchmarks.planning.trials import tried
from tools.benchmarks.relations import symbols, tasks
from tools.benchmarks.relations.trying import try_all
from tools.benchmarks.tables import document, share_of, table, tally, with_interval

PLACES, TOWERS = Path("domains/places"), Path("domains/towers")
FIRST_TASK = 960_000  # seed of the first task, far from those of other evaluations
NEW_PAIRS = 961_000
BOXES = "three into three"
_BLOCK, _TRIES = 5, 50


def main(
    scale: options.Scale = 1.0,
    work: options.Work = Path("evaluation/asked"),
    results: options.Results = options.RESULTS,
    workers: options.Workers = options.CORES,
) -> None:
    """Try, and write what came of it."""
    evaluation = Evaluation("asked", work, results, workers)

    def report() -> None:
        found = summarise(evaluation.found())
        evaluation.write(found, page(found))

    for name, (_, count) in DRAWN.items():
        jobs = {
            f"{_slug(name)}-{block.start}": partial(_try, name, block)
            for block in blocks(options.scaled(scale, count), _BLOCK)
        }
        evaluation.perform(jobs, name, report)
    upright: Jobs = {f"upright-{seed}": partial(_upright, seed) for seed in range(options.scaled(scale, 10))}
    evaluation.perform(upright, "toppled objects", report)
    evaluation.perform({"words": _words}, "what states mean")
    words = evaluation.found()["words"]
    boxes: Jobs = {
        f"boxes-{block.start}": partial(_boxes, words, block)
        for block in blocks(options.scaled(scale, 50), _BLOCK)
    }
    evaluation.perform(boxes, BOXES, report)
    report()


def _slug(name: str) -> str:
    return name.replace(": ", "-").replace(", ", "-").replace(" ", "-")


def _try(name: str, block: Sequence[int]) -> list[Any]:
    """Try tasks of a kind, blindly and with replanning."""
    folder, found = DomainFolder(TOWERS if name.startswith("form") else PLACES), list[Any]()
    bench = bench_of(folder.path)
    for number in block:
        try:
            drawn = DRAWN[name][0](bench, folder, FIRST_TASK + number)
        except InvalidValue as error:
            found.append({"status": "cannot be", "reason": str(error)})
            continue
        found += tried(bench.setting, [drawn], time_limit=TIME_LIMIT)
    return found


def _upright(seed: int) -> dict[str, Any]:
    return set_upright(read_world(PLACES / "world.toml")(), FIRST_TASK + seed, _TRIES)


def _words() -> Any:
    return symbols.measure(TOWERS, NEW_PAIRS, workers=1)["words"]


def _boxes(words: Mapping[str, Sequence[str]], block: range) -> list[Any]:
    draw = next(draw for name, draw, _ in tasks.cells(1) if name == BOXES)
    return try_all(TOWERS, words, draw, range(FIRST_TASK + block.start, FIRST_TASK + block.stop))


def summarise(found: Mapping[str, Any]) -> dict[str, Any]:
    """Sum up what was tried."""
    kinds = {name: _counted(_rows(found, _slug(name))) for name in DRAWN}
    boxes, toppled = (
        _rows(found, "boxes"),
        [one for name, one in found.items() if name.startswith("upright-")],
    )
    counts = {key: sum(one[key] for one in toppled) for key in ("tries", "upright", "moved")}
    return {
        "turned": {n: kinds[f"turned, {n} object{'s' * (n != '1')}"]["replanned"] for n in ("1", "4")},
        "headings": kinds["headings"]["replanned"],
        "goal_forms": sum(bool(kinds[f"form: {form}"]["reached"]) for form in FORMS),
        "boxes": {how: share_of(sum(one[key] for one in boxes), len(boxes)) for how, key in _HOWS.items()},
        "boxes_tried": len(boxes),
        "one_put": None,
        "all_shapes_8": None,
        "upright": counts,
        "kinds": kinds,
    }


_HOWS = {"blind": "blind", "replanned": "reached"}


def _rows(found: Mapping[str, Any], prefix: str) -> list[dict[str, Any]]:
    jobs = {name: rows for name, rows in found.items() if name.rpartition("-")[0] == prefix}
    return [row if isinstance(row, dict) else {} for rows in jobs.values() for row in rows]


def _counted(rows: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """Count tasks: how many there were, could be planned, and came out."""
    drawn = [row for row in rows if row.get("status") != "cannot be"]
    blind, after = (
        sum(bool((row.get(how) or {}).get("reached")) for row in drawn) for how in ("blind", "replanned")
    )
    return {
        "tasks": len(drawn),
        "cannot_be": tally(row["reason"] for row in rows if row.get("status") == "cannot be"),
        "planned": sum(row["status"] == "solved" for row in drawn),
        "reached": after,
        "blind": share_of(blind, len(drawn)),
        "replanned": share_of(after, len(drawn)),
    }


def page(found: Mapping[str, Any]) -> str:
    """Write the page."""
    rows = [
        [
            name,
            str(one["tasks"]),
            str(one["planned"]),
            with_interval(one["blind"], one["tasks"]),
            with_interval(one["replanned"], one["tasks"]),
        ]
        for name, one in found["kinds"].items()
        if one["tasks"]
    ]
    boxes, toppled = found["boxes"], found["upright"]
    never = [
        f"*{name}*: {reason} ({count})" for name, one in found["kinds"].items()
        for reason, count in one["cannot_be"].items()
    ]  # fmt: skip
    return document(
        "# What people ask for, measured",
        "By `make evaluate-asked`, which wrote this page and `asked.json`, with the shipped domains. Goals "
        "within 50 mm, headings within 15 degrees. Objects of the first three rows can be grasped, and lie "
        "at any angle; forms of goals are asked for among four objects in `domains/towers`.",
        table("what | tasks | planned | followed blindly | replanned", rows),
        "Left out, since nothing that was learned brings it about in that scene:" if never else "",
        "\n".join(f"- {line}" for line in never),
        "## Three things into three boxes",
        f"Of {found['boxes_tried']} tasks {with_interval(boxes['replanned'], found['boxes_tried'])} came out "
        f"with replanning, and {with_interval(boxes['blind'], found['boxes_tried'])} followed blindly.",
        "## What has toppled",
        f"Of {toppled['tries']:,} random actions on objects that lie on their sides, {toppled['moved']:,} "
        f"moved these, and {toppled['upright']:,} set one upright.",
    )


if __name__ == "__main__":
    options.begin(main)
