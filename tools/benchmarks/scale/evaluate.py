"""Measure how far neurosym goes, into docs/results/scale.json and scale.md.

Finished parts are kept and not measured again, so that the run can be interrupted.
"""

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import tyro

from tools.benchmarks.jobs import Evaluation, Found, Job, machine
from tools.benchmarks.options import RESULTS, Results, Work
from tools.benchmarks.scale import measures
from tools.benchmarks.tables import document, listed, table

ROWS = (10_000, 100_000, 1_000_000)
BITS = (3, 6, 8, 10)
OBJECTS = (10, 100, 1000)


def parts(rows: tuple[int, ...], bits: tuple[int, ...], objects: tuple[int, ...]) -> dict[str, Job]:
    """List what is measured, by name."""
    found: dict[str, Job] = {"refusals": measures.refusals}
    for count in rows:
        found[f"check-{count}"] = partial(measures.command, "check", count)
        found[f"train-{count}"] = partial(measures.command, "train", count, "--regime", "quick")
    found |= {f"symbols-{2**number}": partial(measures.symbols, number) for number in bits}
    return found | {f"objects-{count}": partial(measures.objects, count) for count in objects}


def main(
    rows: Annotated[tuple[int, ...], tyro.conf.arg(help="Sizes of data sets.")] = ROWS,
    bits: Annotated[tuple[int, ...], tyro.conf.arg(help="Bits of action symbols.")] = BITS,
    objects: Annotated[tuple[int, ...], tyro.conf.arg(help="Objects in a problem.")] = OBJECTS,
    work: Work = Path("evaluation/scale"),
    results: Results = RESULTS,
) -> None:
    """Measure part after part, and write the results."""
    evaluation = Evaluation("scale", work, results)
    evaluation.perform(parts(rows, bits, objects), "measuring", fresh=True)
    found = {"machine": machine("numpy", "torch", "up-fast-downward"), **evaluation.found()}
    evaluation.write(found, page(found), records=False)


def page(found: dict[str, Any]) -> str:
    """Write the tables."""
    planned = [*measures.PLANNERS, "memory [MB]"]
    return document(
        "# How far it goes, measured",
        "By `make evaluate-scale`, which wrote this page and `scale.json`. "
        f"Machine: {listed(found['machine'])}. CPU seconds are those of all processes, on one core; memory "
        "is that of the largest process.",
        "## Rows of a data set",
        "What `neurosym check` and `neurosym train --regime quick` take.",
        table(
            "rows | command | CPU [s] | memory [MB] | fit",
            [row for name in ("check", "train") for row in _rows(found, name, partial(_fit, name))],
        ),
        "## Symbols",
        "A domain of so many action symbols and 4 categories, and a plan for one object.",
        table(
            ["symbols", "operators", "compile and print [s]", "domain [MB]", *planned],
            _rows(found, "symbols", partial(_told, ("operators", "compile_and_print", "domain_megabytes"))),
        ),
        "## Objects",
        "Problems with 8 action symbols and 4 categories: a goal for each object, 16 to 30 cm away.",
        table(
            ["objects", "print [s]", "problem [MB]", "print, numeric [s]", *planned],
            _rows(found, "objects", partial(_told, ("print", "problem_megabytes", "print_numeric"))),
        ),
        "## What is refused",
        *(f"- {name}: {said}" for name, said in found.get("refusals", {}).items()),
    )


def _rows(found: Found, kind: str, cells_of: Callable[[Found], list[str]]) -> list[list[str]]:
    """Write a row for each size of a kind, begun by it."""
    names = [name for name in found if name.startswith(f"{kind}-")]
    parts = sorted((int(name.partition("-")[2]), found[name]) for name in names)
    return [[f"{size:,}", *cells_of(part)] for size, part in parts]


def _fit(name: str, part: Found) -> list[str]:
    return [name, f"{part['cpu_seconds']:g}", str(part["megabytes"]), " ".join(part["said"]) or "-"]


def _told(names: Sequence[str], part: Found) -> list[str]:
    """Write figures, and how planners did."""
    cells = [f"{part[name]:g}" for name in names]
    for found in (part[planner] for planner in measures.PLANNERS):
        steps = f"{found['steps']} steps" if found["valid"] else f"{found['status']}: {found['reason']}"
        cells.append(f"{found['cpu_seconds']:g} s, {steps}")
    return [*cells, str(part["megabytes"])]


if __name__ == "__main__":
    tyro.cli(main)
