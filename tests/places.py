"""Where things lie in a checkout."""

from pathlib import Path

ROOT = Path(__file__).parent.parent
DOCS = ROOT / "docs"
SHIPPED = ROOT / "domains" / "tabletop"
"""The shipped domain folder; tests must not change it."""
GOLDEN = ROOT / "tests" / "golden"
