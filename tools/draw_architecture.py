"""Draw docs/images/architecture.svg: the folders of the package and what each imports, from the code itself.

An arrow that follows from others is left out: what imports `execution` may import what that imports, too.
"""

from collections.abc import Mapping
from itertools import pairwise
from pathlib import Path
from xml.sax.saxutils import escape

from tools.package_imports import arrows

ROOT = Path(__file__).parent.parent
PACKAGE, PICTURE = ROOT / "neurosym", ROOT / "docs" / "images" / "architecture.svg"
WIDTH, HEIGHT, GAP_X, GAP_Y, MARGIN = 112, 40, 58, 22, 16  # pixels
Graph = Mapping[str, set[str]]
ABOUT = {
    "sim": "the robot, simulated",
    "worlds": "where it acts",
    "data": "interactions",
    "learning": "networks",
    "exploration": "curiosity",
    "primitives": "symbols to actions",
    "pddl": "the compiler",
    "planners": "problems to plans",
    "execution": "plans to motions",
    "pictures": "strips and films",
    "stages": "the domain folder",
    "evaluation": "tables",
    "explain": "words",
    "report": "the page",
    "commands": "the command line",
}


def reduced(graph: Graph) -> dict[str, set[str]]:
    """Leave out arrows that follow from others."""
    return {
        folder: {target for target in targets if not _reachable(graph, targets - {target}, target)}
        for folder, targets in graph.items()
    }


def _reachable(graph: Graph, starts: set[str], target: str) -> bool:
    return any(start == target or _reachable(graph, graph[start], target) for start in starts)


def layout(graph: Graph) -> tuple[list[list[str]], list[tuple[str, ...]]]:
    """Put each folder one column to the right of the last that it imports, near those that it imports.

    Returns:
        What stands in each column, from the top, and the way of each arrow. An arrow that passes a column has
        a place of its own there, which is called like the arrow.
    """
    depth: dict[str, int] = {}

    def visit(folder: str) -> int:
        if folder not in depth:
            depth[folder] = 1 + max(map(visit, sorted(graph[folder])), default=-1)
        return depth[folder]

    for folder in sorted(graph):
        visit(folder)
    ways = []
    for folder, target in [(name, target) for name in sorted(graph) for target in sorted(graph[name])]:
        passed = {
            f"{folder} > {target} {column}": column for column in range(depth[target] + 1, depth[folder])
        }
        depth |= passed
        ways.append((folder, *reversed(passed), target))
    height: dict[str, float] = {}
    placed: list[list[str]] = []
    for column in range(max(depth.values()) + 1):
        near = {name: [height[way[k + 1]] for way in ways for k in range(len(way) - 1) if way[k] == name]
                for name in sorted(depth) if depth[name] == column}  # fmt: skip
        members = sorted(near, key=lambda name: sum(near[name]) / max(1, len(near[name])))
        height |= {name: row - (len(members) - 1) / 2 for row, name in enumerate(members)}
        placed.append(members)
    return placed, ways


def drawing(graph: Graph) -> str:
    """Return the picture as SVG; the same folders and imports give the same text."""
    placed, ways = layout(reduced(graph))
    tallest = max(map(len, placed))
    spots = {
        name: (
            MARGIN + column * (WIDTH + GAP_X),
            MARGIN + (row + (tallest - len(members)) / 2) * (HEIGHT + GAP_Y),
        )
        for column, members in enumerate(placed)
        for row, name in enumerate(members)
    }
    width = 2 * MARGIN + len(placed) * (WIDTH + GAP_X) - GAP_X
    height = 2 * MARGIN + tallest * (HEIGHT + GAP_Y) - GAP_Y
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
        f'height="{height}" font-family="sans-serif" text-anchor="middle">',
        '<defs><marker id="tip" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" markerHeight="7" '
        'orient="auto"><path d="M0,0 L8,4 L0,8 z" fill="#7a7a7a"/></marker></defs>',
        f'<rect width="{width}" height="{height}" fill="#ffffff"/>',
        *(_arrow([spots[name] for name in way]) for way in ways),
        *(_box(name, spots[name]) for name in sorted(graph)),
        "</svg>",
    ]
    return "\n".join(lines) + "\n"


def _arrow(spots: list[tuple[float, float]]) -> str:
    """Draw an arrow from what imports, on the right, to what is imported, on the left."""
    bend, middle = GAP_X * 0.7, HEIGHT / 2
    path = f"M{spots[0][0]:g},{spots[0][1] + middle:g}"
    for (x, y), (left, below) in pairwise(spots):
        start, end = (x, y + middle), (left + WIDTH, below + middle)
        path += f" C{start[0] - bend:g},{start[1]:g} {end[0] + bend:g},{end[1]:g} {end[0]:g},{end[1]:g}"
        path += f" L{left:g},{end[1]:g}" if (left, below) != spots[-1] else ""
    return f'<path d="{path}" fill="none" stroke="#9a9a9a" stroke-width="1.3" marker-end="url(#tip)"/>'


def _box(name: str, spot: tuple[float, float]) -> str:
    x, y = spot
    middle, size = x + WIDTH / 2, f'width="{WIDTH}" height="{HEIGHT}"'
    about = escape(ABOUT.get(name, ""))
    return (
        f'<rect x="{x:g}" y="{y:g}" {size} rx="6" fill="#eaf2fb" stroke="#33608f"/>'
        f'<text x="{middle:g}" y="{y + 17:g}" font-size="14" font-weight="bold">{escape(name)}</text>'
        f'<text x="{middle:g}" y="{y + 32:g}" font-size="10.5" fill="#444444">{about}</text>'
    )


if __name__ == "__main__":
    PICTURE.write_text(drawing(arrows(PACKAGE)))
