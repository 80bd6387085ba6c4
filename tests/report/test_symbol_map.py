"""The map of symbols finds what matters and the boundaries between codes, and draws them to scale."""

import json
import re
from html import unescape
from xml.etree import ElementTree

import numpy as np
import pytest

from neurosym.report.drawings import effect_drawing, effect_room, ink_on, map_drawing, object_drawing
from neurosym.report.symbol_map import Atlas, atlas_of
from neurosym.world import CATEGORY_COLOURS, Palette
from neurosym.worlds.toy import ToyWorld


def graspable(features: np.ndarray) -> tuple[str, ...]:
    return tuple(f"{int(y <= 0.08 or t)}{int(x <= 0.12)}" for x, y, _, t in features)


def test_map_of_the_toy_world_has_its_rules_as_boundaries():
    atlas = atlas_of(ToyWorld(), graspable)
    assert [atlas.features[number].word for number in atlas.axes] == ["width", "depth"]
    assert [atlas.features[number].word for number in atlas.others] == ["type", "height"]
    assert atlas.matter[2] == 0
    shown = atlas.map((0.1, 0.1, 0.05, 0.0))
    assert shown.areas.keys() == {"00", "01", "10", "11"}
    (loop,) = shown.areas["11"]  # narrow and short: x to 0.08, y to 0.12 of 0.03 to 0.18
    assert loop.max(axis=0) == pytest.approx([1 / 3, 0.6], abs=0.01)
    assert atlas.map((0.1, 0.1, 0.05, 1.0)).areas.keys() == {"10", "11"}
    assert all(set(graspable(np.array(atlas.examples(code)))) == {code} for code in shown.areas)


def test_drawing_says_how_a_script_reads_a_place_and_escapes():
    atlas = Atlas(
        graspable, np.random.default_rng(1).uniform(0.03, 0.18, (200, 4)), ["s_x", "s_y", "d", "<b>"]
    )
    drawing = map_drawing(atlas.map(), Palette(["11", "10"]), title="<b>")
    root = ElementTree.fromstring(drawing)
    assert "<b>" not in drawing
    across, up = json.loads(unescape(re.search('data-map="([^"]*)"', drawing)[1]))
    (path,) = [one.get("d") for one in root if one.get("data-code") == "11"]  # narrow and short
    corners = np.array([one.split() for one in path.strip("MZ").split("L")], dtype=float)
    for axis, end, value in ((across, corners[:, 0].max(), 0.08), (up, corners[:, 1].min(), 0.12)):
        share = (value - axis["low"]) / (axis["high"] - axis["low"])
        there = axis["from"] + share * (axis["to"] - axis["from"])
        assert end == pytest.approx(there, abs=1.0)  # pixels
    assert {one.get("data-code") for one in root} - {None} == {"00", "01", "10", "11"}


@pytest.mark.parametrize("count", [1, 2, 6])
def test_any_number_of_features_is_drawn(count: int):
    samples = np.random.default_rng(2).normal(size=(100, count))
    atlas = Atlas(lambda rows: tuple("1" if row[-1] > 0 else "0" for row in rows), samples)
    assert atlas.axes[0] == count - 1 or count > 1
    assert atlas.matter[count - 1] == max(atlas.matter)
    assert count - 1 in atlas.axes
    ElementTree.fromstring(map_drawing(atlas.map(), Palette("10")))
    ElementTree.fromstring(object_drawing(samples[0], atlas.features))


def test_effects_are_arrows_to_scale_filled_where_held():
    def drawn(effect, **how):
        return effect_drawing(effect, told="x", **({"chance": 1.0, "is_held": False} | how))

    assert "circle" in drawn((0, 0, 0.001))
    assert "circle" not in drawn((0.1, 0, 0))
    assert drawn((0.1, 0, 0), is_held=True) != drawn((0.1, 0, 0))
    assert 'opacity="1.00"' in drawn((0.1, 0, 0))
    assert 'opacity="0.25"' in drawn((0.1, 0, 0), chance=0)
    assert drawn((1, -1)).count("<rect") == 2


@pytest.mark.parametrize(
    "effect", [(0.0, 0.0, 0.26), (-0.04, 0.0, 0.0), (0.0, 0.2, 0.0), (-0.05, -0.15, 0.2)]
)
def test_arrows_stay_within_their_drawing_and_pushes_have_shafts(effect: tuple[float, ...]):
    item = (0.1, 0.12, 0.08, 0.0)
    height = effect_room(effect, item, 400.0)
    drawn = effect_drawing(effect, told="x", chance=1.0, is_held=False, item=item, width=140, height=height)
    shaft, head = re.findall(r'<path d="M([^"]*)"[^>]*stroke="currentColor" stroke-width', drawn)
    points = [tuple(map(float, point)) for point in re.findall(r"([-\d.]+) ([-\d.]+)", f"{shaft}L{head}")]
    assert all(0 <= x <= 140 and 0 <= y <= height for x, y in points)
    assert np.hypot(*np.subtract(points[1], points[0])) > 4


def test_text_can_be_read_on_every_category():
    def light(colour):
        parts = np.array(colour) / 255
        linear = np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
        return float(linear @ [0.2126, 0.7152, 0.0722])

    for colour in CATEGORY_COLOURS:
        ink = 0.0 if ink_on(colour) == "#000" else 1.0
        assert (max(ink, light(colour)) + 0.05) / (min(ink, light(colour)) + 0.05) >= 4.5
