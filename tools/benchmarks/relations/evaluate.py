"""What can be done with one object relative to another? `make evaluate-relations`, into docs/results/.

So far by actions that a person wrote, and by random ones. Goes on where it was interrupted.
"""

import json
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import tyro

from neurosym.console import progress_bar, say
from neurosym.files import write_atomically
from neurosym.markdown import markdown_table
from tools.benchmarks.jobs import as_text, machine
from tools.benchmarks.relations import by_hand
from tools.benchmarks.world.measures import Advance

RESULTS = Path("docs/results")
COMMAND = "make evaluate-relations"
WORKERS = 2
RELATIONS = ("on", "in", "leaning", "against", "beside", "apart")


def parts(scale: float) -> dict[str, Callable[[Advance], Any]]:
    """List what is measured, each part over so many times the usual number of interactions."""

    def some(count: int) -> int:
        return max(4, round(count * scale))

    return {
        "put_over": partial(by_hand.put_over, some(50), 110, WORKERS),
        "towers_by_hand": partial(by_hand.towers, some(50), 111, WORKERS),
        "random": partial(by_hand.predictability, some(1000), 112, WORKERS),
    }


def main(
    scale: Annotated[
        float, tyro.conf.arg(help="How many interactions, as a share of the full number.")
    ] = 1.0,
    results: Annotated[Path, tyro.conf.arg(help="Folder for relations.json and relations.md.")] = RESULTS,
) -> None:
    """Measure part after part, and write the results; what was measured is not measured again."""
    path = results / "relations.json"
    found = json.loads(path.read_text()) if path.exists() else {}
    if found.get("scale") != scale:
        found = {"command": COMMAND, "scale": scale}
    for name, measure in parts(scale).items():
        if name not in found:
            with progress_bar(name.replace("_", " ")) as advance:
                found[name] = measure(advance)
            found["machine"] = machine("numpy", "pybullet")
            write_atomically(path, as_text(found))
    write_atomically(results / "relations.md", page(found))
    say(f"wrote {results / 'relations.md'}")


def page(found: Mapping[str, Any]) -> str:
    """Write the tables.

    Args:
        found: What was measured, by part.
    """
    over, towers, chance = found["put_over"], found["towers_by_hand"], found["random"]
    rows = [
        [
            pair,
            f"{cell['carried']} of {cell['tried']}",
            *(str(cell["ends"].get(name, 0) or "") for name in RELATIONS),
            *("{} of {}".format(*cell[f"taken_{name}"]) for name in ("on", "in")),
        ]
        for pair, cell in over.items()
    ]
    ends = ", ".join(f"{count} {name}" for name, count in chance["ends_of_carried"].items())
    built = "; ".join(f"{cell['stand']} of {cell['tried']} of {height}" for height, cell in towers.items())
    return (
        "\n\n".join(
            [
                "# One object relative to another",
                f"`{found['command']}` wrote this page. Which relation two objects have is told by "
                "geometry that a person wrote (`tools/benchmarks/relations/geometry.py`). *On*: upright, "
                "touching, and not sunk. *In*: upright inside of a hollow one. *Leaning*: tilted. "
                "*Against*: touching from the side. *Beside*: at most 5 cm apart.",
                "## Put over one another by hand",
                "One action that a person wrote grasps an object of random size and sets it down over "
                "another. What then stands on or in that one is taken to a place by the same action, "
                "without moving the other by over 5 mm.",
                markdown_table(["pair", "carried", *RELATIONS, "taken off", "taken out"], rows),
                f"Towers of solid objects by hand, the widest below, that stand: {built}.",
                "## At random",
                f"Of {chance['interactions']} random actions aimed at another object, "
                f"{chance['carried']:.1%} carry the target over it: {ends}. Changed by 0.1 mm, "
                f"{chance['another_relation']} end in another relation.",
            ]
        )
        + "\n"
    )


if __name__ == "__main__":
    tyro.cli(main)
