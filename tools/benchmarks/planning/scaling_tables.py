"""The scaling results of `evaluate.py` as a page of Markdown tables."""

from collections.abc import Mapping
from typing import Any

from tools.benchmarks.planning.tables import NOT_YET, markdown


def scaling_page(results: Mapping[str, Any]) -> str:
    """Write the page."""
    scaling, missing = results["scaling"], results["missing"]
    cap, tasks = scaling["cap_seconds"], scaling["tasks_in_a_cell"]
    unfinished = f" **Not finished**: {missing} jobs of the evaluation to do." if missing else ""
    sections = [
        "# Planning at scale, measured",
        f"By `{results['command']}`, which wrote this page, `scaling.json` and `scaling.png`.{unfinished} "
        f"{tasks} symbolic tasks in each cell, in the shipped domain with cells of 5 mm: goals that are "
        "1 to 3 (easy) or 5 to 8 (hard) primitives away for each object alone, by the shortest plan; "
        "above 4 objects, none is wider than 75 mm. *Object by object*: a problem for each object, plans put "
        f"one after another; *whole*: one problem. {cap:g} s at most; after two time-outs in a cell, its "
        "other tasks are not tried. BFS is allowed 3 primitives, which hard goals and many objects exceed.",
        "![Seconds and steps against objects](scaling.png)",
        "*Over the fewest*: primitives beyond the fewest there can be, counted exactly. With its costs, Fast "
        "Downward asks for what is reliable, which takes more steps; *no costs*: all operators cost alike. "
        "*Memory*: of the largest process, Python's own included.",
        *(
            f"## {difficulty.capitalize()} goals\n\n{_table(scaling['contenders'], difficulty)}"
            for difficulty in ("easy", "hard")
        ),
        "## Why not",
        _why_not(scaling["contenders"]),
    ]
    return "\n\n".join(sections) + "\n"


def _table(contenders: Mapping[str, Any], difficulty: str) -> str:
    rows = []
    for contender, cells in contenders.items():
        for size, cell in cells.items():
            objects, of = size.split()
            if of == difficulty:
                rows.append([contender, objects, *_row(cell)])
    columns = ["planner", "objects", "solved", "valid", "median [s]", "slowest [s]", "primitives"]
    return markdown([*columns, "over the fewest", "memory [MB]"], rows)


def _row(cell: Mapping[str, Any]) -> list[str]:
    told = [f"{cell['solved']} of {cell['tasks']}", str(cell["valid"])]
    for name, form in (("seconds", ".2f"), ("slowest", ".2f"), ("primitives", ".1f")):
        told.append("-" if cell[name] is None else f"{cell[name]:{form}}")
    over = cell["over_fewest"]
    told.append("-" if over is None else f"{100 * (over - 1):+.0f} %")
    return [*told, f"{cell['megabytes']:.0f}"]


def _why_not(contenders: Mapping[str, Any]) -> str:
    rows = [
        [contender, size, reason, str(count)]
        for contender, cells in contenders.items()
        for size, cell in cells.items()
        for reason, count in {**_not_tried(cell), **cell["reasons"]}.items()
    ]
    return markdown(["planner", "cell", "what it said", "tasks"], rows) if contenders else NOT_YET


def _not_tried(cell: Mapping[str, Any]) -> dict[str, int]:
    count = cell["status"].get("not tried", 0)
    return {"not tried after two time-outs": count} if count else {}
