"""Where what is measured lies in a checkout."""

from pathlib import Path

ROOT = Path(__file__).parent.parent.parent
SHIPPED = ROOT / "domains" / "tabletop"
