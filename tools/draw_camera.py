"""Draw what the camera of a domain sees: `python -m tools.draw_camera`, into docs/images.

In camera.png, above, a scene from the side, and its depth image with the objects that are found in it. Below,
of each object its crop with its bits, and what the first filters of the eye answer to it. In
camera-beside-features.png, a row for each category of a domain that knows true features: crops of its objects
with their bits, first those that most of them have, and then others.
"""

import math
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import tyro
from PIL import Image, ImageDraw, ImageFont

from neurosym.stages.folder import DomainFolder
from neurosym.worlds.world_file import read_world
from tools.benchmarks.options import ROOT

SEES, KNOWS = ROOT / "domains/camera", ROOT / "domains/places"
PICTURES = ROOT / "docs/images"
SCENE, OBJECTS = 11, 5  # the seed of the scene, and how many objects it has
WIDTH, TOP, SIDE, GAP = 1120, 380, 200, 20
FILTERS = 8
DARK, PAPER, MARK = (29, 29, 29), (255, 255, 255), (220, 60, 40)
HIGH = 0.1  # what is drawn black [m]
COMPARED, ALIKE, OTHERS, SMALL = 400, 5, 5, 96  # objects, those that are drawn of a category, and how large


def main(sees: tyro.conf.Positional[Path] = SEES, knows: tyro.conf.Positional[Path] = KNOWS) -> None:
    """Draw both, for a folder that `run DIR --world camera` learned in, and one with true features."""
    for name, page in {
        "camera.png": _scene(DomainFolder(sees)),
        "camera-beside-features.png": _beside(DomainFolder(sees), DomainFolder(knows)),
    }.items():
        page.save(PICTURES / name)
        print(f"wrote {PICTURES / name}")


def _beside(sees: DomainFolder, knows: DomainFolder) -> Image.Image:
    """Draw crops of objects by the category that they have by their true features."""
    world: Any = read_world(sees / "world.toml")()
    rng, known, crops, seen = np.random.default_rng(SCENE), [], [], []
    while len(crops) < COMPARED:
        truth = world.table_world.sample_scene(rng, 1)
        if len(found := world.look(truth)) == 1:
            known.append(truth.features[0])
            crops.append(found[0].crop)
            seen.append([*found[0].size, *world.eye.tell(found[0].crop)])
    rows = knows.network().object_symbols(np.array(known))
    bits = sees.network().object_symbols(np.array(seen))
    names = sorted({*rows})
    high = SMALL + GAP
    page = Image.new("RGB", (GAP + (ALIKE + OTHERS + 1) * high + 2 * GAP, GAP + len(names) * high), PAPER)
    draw, font = ImageDraw.Draw(page), ImageFont.load_default(15)
    for row, name in enumerate(names):
        mine = [n for n, one in enumerate(rows) if one == name]
        most = Counter(bits[n] for n in mine).most_common(1)[0][0]
        alike, others = ([n for n in mine if (bits[n] == most) == same] for same in (True, False))
        top = GAP + row * high
        draw.text((GAP, top + SMALL // 3), f"{name}: {len(mine)}", fill=DARK, font=font)
        shown = [*enumerate(alike[:ALIKE], 1), *enumerate(others[:OTHERS], 1 + ALIKE)]
        for column, n in shown:
            x = GAP + column * high + 2 * GAP * (column > ALIKE)
            page.paste(_grey(crops[n], SMALL), (x, top))
            draw.rectangle((x, top, x + SMALL, top + SMALL), outline=DARK)
            draw.text((x + 4, top + 2), bits[n], fill=MARK, font=font)
    return page


def _scene(folder: DomainFolder) -> Image.Image:
    """Draw a scene, and what is seen in it."""
    world: Any = read_world(folder / "world.toml")()
    truth = world.table_world.sample_scene(np.random.default_rng(SCENE), OBJECTS)
    sight, found = world.sight_of(truth), world.look(truth)
    seen = np.array([[*one.size, *world.eye.tell(one.crop)] for one in found])
    bits = folder.network().object_symbols(seen)
    page = Image.new("RGB", (WIDTH, TOP + SIDE + SIDE // 2 + 5 * GAP), PAPER)
    draw, font = ImageDraw.Draw(page), ImageFont.load_default(18)
    photo = Image.fromarray(world.table_world.picture(truth)).resize((TOP * 4 // 3, TOP))
    page.paste(photo, (GAP, GAP))
    left = GAP + photo.width + GAP
    page.paste(_grey(sight.points[..., 2], TOP), (left, GAP))
    for one, name in zip(found, bits, strict=True):
        outline = [_pixel(sight, corner, TOP) for corner in _corners(one)]
        placed = [(left + x, GAP + y) for x, y in outline]
        draw.line([*placed, placed[0]], fill=MARK, width=2)
        draw.text(placed[0], name, fill=MARK, font=font)
    for number, (one, name) in enumerate(zip(found, bits, strict=True)):
        x, y = GAP + number * (SIDE + GAP), TOP + 2 * GAP
        page.paste(_grey(one.crop, SIDE), (x, y))
        draw.rectangle((x, y, x + SIDE, y + SIDE), outline=DARK)
        draw.text((x + 6, y + 4), name, fill=MARK, font=font)
        answers = world.eye.first_filters(one.crop)
        for index, answer in enumerate(answers[:FILTERS]):
            small = SIDE // 4
            at = x + index % 4 * small, y + SIDE + GAP + index // 4 * small
            page.paste(_grey(answer, small - 2, high=float(answers.max()) or 1.0), at)
    return page


def _grey(values: np.ndarray, side: int, high: float = HIGH) -> Image.Image:
    """Draw numbers, 0 light and what is high dark."""
    shades = 245 - 225 * np.clip(np.nan_to_num(values) / high, 0, 1)
    return Image.fromarray(shades.astype(np.uint8)).resize((side, side), Image.Resampling.NEAREST)


def _corners(region: Any) -> list[Sequence[float]]:
    """Return the corners of the box around an object, at its top [m]."""
    x, y, z = region.position
    cosine, sine = math.cos(region.heading), math.sin(region.heading)
    wide, long = region.size[:2] / 2
    halves = [(wide, long), (wide, -long), (-wide, -long), (-wide, long)]
    return [(x + cosine * u - sine * v, y + sine * u + cosine * v, 2 * z) for u, v in halves]


def _pixel(sight: Any, point: Sequence[float], side: int) -> tuple[float, float]:
    """Return where a point lies in a picture of the depth image."""
    towards = np.asarray(point) - sight.eye
    rays = sight.rays / np.linalg.norm(sight.rays, axis=-1, keepdims=True)
    row, column = np.unravel_index(int((rays @ towards).argmax()), rays.shape[:2])
    scale = side / rays.shape[0]
    return (float(column) + 0.5) * scale, (float(row) + 0.5) * scale


if __name__ == "__main__":
    tyro.cli(main)
