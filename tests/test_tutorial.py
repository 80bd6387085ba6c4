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


def test_notebook_is_valid_small_and_ran_in_order_without_errors():
    nbformat.validate(NOTEBOOK)
    assert (DOCS / "tutorial.ipynb").stat().st_size < 1_500_000
    check_ran(CELLS)
    said = "\n".join(
        "".join(output.get("text", "")) + str(output.get("data", {}).get("text/plain", ""))
        for cell in CELLS
        for output in cell.outputs
    )
    assert not re.search(r"(^|\s)/(tmp|home|root|opt|work|usr)/", said), "paths of a machine"


def test_imports_are_folded_and_the_first_picture_is_of_symbols():
    assert CELLS[0].metadata["jupyter"]["source_hidden"]
    assert "hide-input" in CELLS[0].metadata["tags"]
    pictures = (picture for cell in CELLS for out in cell.outputs for picture in out.get("data", {}).items())
    kind, drawn = next(one for one in pictures if one[0].startswith("image/"))
    assert kind == "image/svg+xml"
    assert "Symbols of tabletop" in drawn


def check_ran(cells) -> None:
    """Check that cells were run one after the other, without errors."""
    assert [cell.execution_count for cell in cells] == list(range(1, len(cells) + 1))
    assert not [output for cell in cells for output in cell.outputs if output.output_type == "error"]


def test_everything_that_is_imported_exists():
    code = ast.parse("\n".join(cell.source for cell in CELLS))
    ours = [
        (node.module, alias.name)
        for node in ast.walk(code)
        if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "neurosym"
        for alias in node.names
    ]
    assert len(ours) > 10
    for module, name in ours:
        assert hasattr(import_module(module), name), f"{module} has no {name}"


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
    check_ran([cell for cell in ran.cells if cell.cell_type == "code"])
