"""The documents: what they point to and the tests that they name exist."""

import re
from pathlib import Path

import pytest
from places import ROOT

DOCUMENTS = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
MEASURED = ROOT / "docs" / "results"
"""Written by the evaluations, each when it is run."""


def links(text: str) -> list[str]:
    """List the local files that a text points to."""
    return [link for link in re.findall(r"\]\(([^)#\s]+)", text) if "://" not in link]


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.name)
def test_every_local_link_leads_somewhere(path: Path):
    targets = [(path.parent / link).resolve() for link in links(path.read_text())]
    assert not [target for target in targets if not target.exists() and target.parent != MEASURED]


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.name)
def test_every_test_that_is_named_exists(path: Path):
    text = path.read_text()
    for name in re.findall(r"tests/(?:\w+/)*test_\w+\.py", text):
        assert (ROOT / name).is_file(), name
    sources = "".join(file.read_text() for file in (ROOT / "tests").rglob("test_*.py"))
    for name in re.findall(r"`(test_\w+)`", text):
        assert f"def {name}(" in sources, name
