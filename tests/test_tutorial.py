"""The tutorial: it can be read, its imports exist, and (marked) it runs from the first cell to the last."""

import ast
import re
import warnings
from importlib import import_module

import nbformat
import pytest
from places import DOCS

from tools import run_tutorial

NOTEBOOK = nbformat.read(DOCS / "tutorial.ipynb", as_version=4)
CELLS = [cell for cell in NOTEBOOK.cells if cell.cell_type == "code"]


def imported() -> list[tuple[str, str]]:
    """List what the code imports from neurosym, as module and name."""
    found = []
    for node in ast.walk(ast.parse("\n".join(cell.source for cell in CELLS))):
        if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "neurosym":
            found += [(node.module, alias.name) for alias in node.names]
    return found


def test_notebook_is_valid_and_small():
    nbformat.validate(NOTEBOOK)
    assert (DOCS / "tutorial.ipynb").stat().st_size < 1_500_000


def test_everything_that_is_imported_exists():
    assert len(imported()) > 10
    for module, name in imported():
        assert hasattr(import_module(module), name), f"{module} has no {name}"


def test_cells_ran_in_order_and_without_errors_when_it_was_stored():
    assert [cell.execution_count for cell in CELLS] == list(range(1, len(CELLS) + 1))
    assert not [output for cell in CELLS for output in cell.outputs if output.output_type == "error"]


def test_no_path_of_a_machine_is_stored():
    said = "\n".join(
        "".join(output.get("text", "")) + str(output.get("data", {}).get("text/plain", ""))
        for cell in CELLS
        for output in cell.outputs
    )
    assert not re.search(r"(^|\s)/(tmp|home|root|opt|work|usr)/", said)


def test_documents_that_it_points_to_exist():
    text = "\n".join(cell.source for cell in NOTEBOOK.cells if cell.cell_type == "markdown")
    links = re.findall(r"\]\(([\w./-]+)", text)
    assert links
    assert not [link for link in links if not (DOCS / link).exists()]


@pytest.mark.evaluation
def test_every_cell_runs_and_what_it_asserts_holds(monkeypatch):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # those of the kernel and its messages
        ran = run_tutorial.run(nbformat.read(run_tutorial.TUTORIAL, as_version=4))
    cells = [cell for cell in ran.cells if cell.cell_type == "code"]
    assert [cell.execution_count for cell in cells] == list(range(1, len(cells) + 1))
    assert not [out for cell in cells for out in cell.outputs if out.output_type == "error"]
