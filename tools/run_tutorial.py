"""Run docs/tutorial.ipynb from its first cell to its last, and store what its cells said."""

from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbformat import NotebookNode

TUTORIAL = Path(__file__).parent.parent / "docs" / "tutorial.ipynb"
LONGEST_CELL = 900  # [s]


def run(notebook: NotebookNode) -> NotebookNode:
    """Run a notebook in the folder of the documents; a cell that fails raises."""
    folder = {"metadata": {"path": str(TUTORIAL.parent)}}
    NotebookClient(notebook, timeout=LONGEST_CELL, resources=folder, record_timing=False).execute()
    return notebook


def tidied(notebook: NotebookNode) -> NotebookNode:
    """Keep one form of each picture, and nothing of the machine that it ran on."""
    for cell in notebook.cells:
        kept = {name: cell.metadata[name] for name in ("tags", "jupyter") if name in cell.metadata}
        cell.metadata = NotebookNode(kept)  # what folds cells
        for output in cell.get("outputs", []):
            output.get("data", {}).pop("image/jpeg", None)
    notebook.metadata.language_info = NotebookNode(name="python")
    return notebook


if __name__ == "__main__":
    nbformat.write(tidied(run(nbformat.read(TUTORIAL, as_version=4))), TUTORIAL)
