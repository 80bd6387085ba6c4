"""Is done what people ask for? `make evaluate-asked`, into docs/results/asked.*.

Things lie turned or on a side, goals are conditions in words, and some towers and boxes are tried. Domains
are those that are shipped. Goes on where it was interrupted.
"""

import json
import zipfile
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from neurosym.errors import InvalidValue
from neurosym.stages.folder import DomainFolder
from tools.benchmarks import options
from tools.benchmarks.asked.tasks import ALL_SHAPES, DRAWN, FORMS
from tools.benchmarks.domains import bench_of
from tools.benchmarks.jobs import Evaluation, Jobs
from tools.benchmarks.planning.jobs import blocks
from tools.benchmarks.planning.measures import TIME_LIMIT
from tools.benchmarks.planning.trials import tried
from tools.benchmarks.relations import protocols, tasks
from tools.benchmarks.relations.trying import try_all
from tools.benchmarks.tables import document, percent, share_of, table, tally, with_interval
from tools.relearn_places import SEED

PLACES, TOWERS = Path("domains/places"), Path("domains/towers")
FIRST_TASK = 960_000  # seed of the first task, far from those of other evaluations
BOXES, ONE_PUT = "three into three", "one put among 5 to 8"
RELATED = {BOXES: 50, ONE_PUT: 40}
"""What is tried of relations, and how many tasks of each."""
BIN = 30
"""So many plans with relations of like chance are looked at together."""
_BLOCK = 5


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
    words = _words()
    for name, count in RELATED.items():
        related: Jobs = {
            f"{_slug(name)}-{block.start}": partial(_related, name, words, block)
            for block in blocks(options.scaled(scale, count), _BLOCK)
        }
        evaluation.perform(related, name, report)
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


def _words() -> Mapping[str, Sequence[str]]:
    """Read which states of the shipped domain mean what, as `make evaluate-relations` measured it."""
    with zipfile.ZipFile(options.RESULTS / "relations-records.zip") as records:
        found = json.loads(records.read(f"learn-{SEED}.json"))
    words: dict[str, list[str]] = found["words"]
    return words


def _related(name: str, words: Mapping[str, Sequence[str]], block: range) -> list[Any]:
    draw = next(draw for cell, draw, _ in (*tasks.cells(1), *protocols.cells(1)) if cell == name)
    return try_all(TOWERS, words, draw, range(FIRST_TASK + block.start, FIRST_TASK + block.stop))


def summarise(found: Mapping[str, Any]) -> dict[str, Any]:
    """Sum up what was tried."""
    kinds = {name: _counted(_rows(found, _slug(name))) for name in DRAWN}
    kinds |= {name: _counted([_as_trial(row) for row in _rows(found, _slug(name))]) for name in RELATED}
    return {
        "turned": {n: kinds[f"turned, {n} object{'s' * (n != '1')}"]["replanned"] for n in ("1", "4")},
        "headings": kinds["headings"]["replanned"],
        "goal_forms": sum(bool(kinds[f"form: {form}"]["reached"]) for form in FORMS),
        "boxes": {how: kinds[BOXES][how] for how in ("blind", "replanned")},
        "one_put": kinds[ONE_PUT]["replanned"],
        "all_shapes_8": kinds[ALL_SHAPES]["replanned"],
        "upright": {how: kinds["set upright"][how] for how in ("blind", "replanned")},
        "chances": _chances([row for name in RELATED for row in _rows(found, _slug(name))]),
        "kinds": kinds,
    }


def _chances(rows: Sequence[Mapping[str, Any]]) -> list[dict[str, float]]:
    """Compare printed chances of plans with what came of these, followed blindly, in bins of like chance."""
    told = sorted((row["chance"], bool(row.get("blind"))) for row in rows if row.get("chance") is not None)
    bins = [told[begin : begin + BIN] for begin in range(0, len(told), BIN)]
    return [
        {
            "plans": len(some),
            "said": round(sum(chance for chance, _ in some) / len(some), 3),
            "came": round(sum(came for _, came in some) / len(some), 3),
        }
        for some in bins
    ]


def _as_trial(row: Mapping[str, Any]) -> dict[str, Any]:
    """Return what became of a task of relations in the form of the others."""
    blind, replanned = ({"reached": row.get(how, False)} for how in ("blind", "reached"))
    return {"status": row["status"], "blind": blind, "replanned": replanned}


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
    never = [
        f"*{name}*: {reason} ({count})" for name, one in found["kinds"].items()
        for reason, count in one["cannot_be"].items()
    ]  # fmt: skip
    return document(
        "# What people ask for, measured",
        "By `make evaluate-asked`, which wrote this page and `asked.json`, with the shipped domains. Goals "
        "within 50 mm, headings within 15 degrees. Objects of the first three rows can be grasped, and lie "
        "at any angle; of four, each that has room for it, which are two of three. What is to be set upright "
        "lies on any side, with another object on the table. Forms of goals "
        "are asked for among four objects in `domains/towers`, where relations are tried, too; geometry says "
        "what came out of these.",
        table("what | tasks | planned | followed blindly | replanned", rows),
        "Left out, since nothing that was learned brings it about in that scene:" if never else "",
        "\n".join(f"- {line}" for line in never),
        "## Chances of plans with relations",
        f"Plans of the last two rows are sorted by the chance that is printed with them, {BIN} in a group.",
        table(
            "plans | said on average | came out, followed blindly",
            [
                [str(one["plans"]), percent(one["said"]), with_interval(one["came"], one["plans"])]
                for one in found["chances"]
            ],
        ),
    )


if __name__ == "__main__":
    options.begin(main)
