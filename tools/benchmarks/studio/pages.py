"""What is read beside the studio: how tall reports are, barriers on reports and site, and the colours."""

import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.choices import DOMAINS
from neurosym.world import CATEGORY_COLOURS
from tools.benchmarks.options import ROOT
from tools.benchmarks.studio.browser import serious_violations
from tools.benchmarks.studio.measures import chromium

KINDS = ("Prot", "Deuter", "Trit")  # of colour blindness
LOOKS = ((1280, "light"), (390, "dark"))  # how wide windows are [pixels], and whether light or dark


def least_colour_distance() -> float:
    """Return how far apart the nearest two colours of categories are (CIEDE2000) to any eye."""
    import colour  # what judges colours, of the extra for developers

    linear = colour.cctf_decoding(np.array(CATEGORY_COLOURS) / 255)
    blind = [colour.blindness.matrix_cvd_Machado2009(f"{kind}anomaly", 1.0) for kind in KINDS]
    seen = (colour.RGB_to_XYZ(np.clip(linear @ eye.T, 0, 1), "sRGB") for eye in (np.eye(3), *blind))
    pairs = (pair for xyz in seen for pair in combinations(colour.XYZ_to_Lab(xyz), 2))
    return min(float(colour.delta_E(*pair, method="CIE 2000")) for pair in pairs)


def look(browser: Any, pages: list[Path]) -> Iterator[tuple[int, int, list[str]]]:
    """Say of pages how wide and tall they are with folds closed, and which serious barriers they have."""
    for page in pages:
        for width, scheme in LOOKS:
            tab = browser.new_page(viewport={"width": width, "height": 900}, color_scheme=scheme)
            tab.goto(page.as_uri())
            height = tab.evaluate("document.documentElement.scrollHeight")
            tab.evaluate("document.querySelectorAll('details').forEach(one => one.open = true)")
            yield width, height, serious_violations(tab)
            tab.close()


def measure_pages() -> dict[str, Any]:
    """Write each shipped domain's report, and the site, and look at them."""
    with tempfile.TemporaryDirectory() as place, chromium() as browser:
        root = Path(place)
        for name in DOMAINS:
            shutil.copytree(ROOT / "domains" / name, root / name, dirs_exist_ok=True)
            subprocess.run([sys.executable, "-m", "neurosym", "report", root / name, "--quiet"], check=True)
        builder = "sphinx", "-q", "-b", "html", ROOT / "docs", root / "site"
        subprocess.run([sys.executable, "-m", *builder], check=True)
        reports = [*look(browser, [root / name / "report.html" for name in DOMAINS])]
        site = [*look(browser, sorted((root / "site").rglob("[!_]*.html")))]
    return {
        "report_px": {str(w): max(tall for wide, tall, _ in reports if wide == w) for w, _ in LOOKS},
        "serious barriers on reports": sum(len(bad) for *_, bad in reports),
        "serious barriers on the site": sum(len(bad) for *_, bad in site),
        "least_colour_distance": round(least_colour_distance(), 1),
    }
