"""Measure how far neurosym goes, into docs/results/scale.json and scale.md.

Finished parts are kept and not measured again, so that the run can be interrupted.
"""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import tyro

from neurosym.evaluation.summary import markdown_table
from tools.benchmarks.jobs import Evaluation, machine
from tools.benchmarks.options import Results, Work
from tools.benchmarks.scale import measures

RESULTS, WORK = Path("docs/results"), Path("evaluation/scale")
ROWS = (10_000, 100_000, 1_000_000)
BITS = (3, 6, 8, 10)
OBJECTS = (10, 100, 1000)


def parts(
    rows: tuple[int, ...], bits: tuple[int, ...], objects: tuple[int, ...]
) -> dict[str, Callable[[], Any]]:
    """List what is measured, by name."""
    found: dict[str, Callable[[], Any]] = {"refusals": measures.refusals}
    for count in rows:
        found[f"check-{count}"] = partial(measures.command, "check", count)
        found[f"train-{count}"] = partial(measures.command, "train", count, "--regime", "quick")
    found |= {f"symbols-{2**number}": partial(measures.symbols, number) for number in bits}
    return found | {f"objects-{count}": partial(measures.objects, count) for count in objects}


def main(
    rows: Annotated[tuple[int, ...], tyro.conf.arg(help="Sizes of data sets.")] = ROWS,
    bits: Annotated[tuple[int, ...], tyro.conf.arg(help="Bits of action symbols.")] = BITS,
    objects: Annotated[tuple[int, ...], tyro.conf.arg(help="Objects in a problem.")] = OBJECTS,
    work: Work = WORK,
    results: Results = RESULTS,
) -> None:
    """Measure part after part, and write the results."""
    evaluation = Evaluation("scale", work, results)
    evaluation.perform(parts(rows, bits, objects), "measuring", fresh=True)
    found = {"machine": machine("numpy", "torch", "up-fast-downward"), **evaluation.found()}
    evaluation.write(found, page(found), records=False)


def page(found: dict[str, Any]) -> str:
    """Write the tables."""
    sections = [
        "# How far it goes, measured",
        "By `make evaluate-scale`, which wrote this page and `scale.json`. Machine: "
        + ", ".join(f"{name} {value}" for name, value in found["machine"].items())
        + ". CPU seconds are those of all processes, on one core; memory is that of the largest process.",
        "## Rows of a data set",
        "What `neurosym check` and `neurosym train --regime quick` take.",
        _rows(found),
        "## Symbols",
        "A domain of so many action symbols and 4 categories, and a plan for one object.",
        _symbols(found),
        "## Objects",
        "Problems with 8 action symbols and 4 categories: a goal for each object, 16 to 30 cm away.",
        _objects(found),
        "## What is refused",
        *(f"- {name}: {said}" for name, said in found.get("refusals", {}).items()),
    ]
    return "\n\n".join(sections) + "\n"


def _sizes(found: dict[str, Any], kind: str) -> list[tuple[int, Any]]:
    names = [name for name in found if name.startswith(f"{kind}-")]
    return sorted((int(name.partition("-")[2]), found[name]) for name in names)


def _rows(found: dict[str, Any]) -> str:
    rows = [
        [f"{size:,}", name, f"{part['cpu_seconds']:g}", str(part["megabytes"]), " ".join(part["said"]) or "-"]
        for name in ("check", "train")
        for size, part in _sizes(found, name)
    ]
    return markdown_table(["rows", "command", "CPU [s]", "memory [MB]", "fit"], rows)


def _symbols(found: dict[str, Any]) -> str:
    rows = [
        [
            f"{size:,}",
            str(part["operators"]),
            f"{part['compile_and_print']:g}",
            f"{part['domain_megabytes']:g}",
            *_solved(part),
        ]
        for size, part in _sizes(found, "symbols")
    ]
    columns = [
        "symbols",
        "operators",
        "compile and print [s]",
        "domain [MB]",
        *measures.PLANNERS,
        "memory [MB]",
    ]
    return markdown_table(columns, rows)


def _objects(found: dict[str, Any]) -> str:
    rows = [
        [
            f"{size:,}",
            f"{part['print']:g}",
            f"{part['problem_megabytes']:g}",
            f"{part['print_numeric']:g}",
            *_solved(part),
        ]
        for size, part in _sizes(found, "objects")
    ]
    columns = [
        "objects",
        "print [s]",
        "problem [MB]",
        "print, numeric [s]",
        *measures.PLANNERS,
        "memory [MB]",
    ]
    return markdown_table(columns, rows)


def _solved(part: dict[str, Any]) -> list[str]:
    cells = []
    for planner in measures.PLANNERS:
        found = part[planner]
        steps = f"{found['steps']} steps" if found["valid"] else f"{found['status']}: {found['reason']}"
        cells.append(f"{found['cpu_seconds']:g} s, {steps}")
    return [*cells, str(part["megabytes"])]


if __name__ == "__main__":
    tyro.cli(main)
