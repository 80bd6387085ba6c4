"""A colour is a category: in all pictures of a domain, told apart by everybody, and nobody else's."""

import shutil
import sys
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from places import SHIPPED
from standing import boxes

from neurosym.colours import CATEGORY_COLOURS, NEUTRAL, OTHER, Palette
from neurosym.contract import Guarded
from neurosym.grounding import Grounding
from neurosym.problems import Problem
from neurosym.sim.tabletop import Tabletop
from neurosym.stages.painting import painted_world
from neurosym.world import Frame, World
from neurosym.worlds.own_world import OwnFactory
from neurosym.worlds.toy import ToyWorld

LEAST = 20
"""Between any two colours of categories, by CIEDE2000."""
SCENE = boxes((0.1, 0.1, 0.06, 0.0, 0.65, 0.0), (0.1, 0.08, 0.05, 0.0, 0.8, 0.15))


def reds(features: np.ndarray) -> np.ndarray:
    """Paint wide objects red, and others pink."""
    return np.array([(255, 0, 0) if wide else (255, 0, 255) for wide in features[:, 1] > 0.09], np.uint8)


def shares(frame: Frame) -> list[int]:
    """Count the pixels that are red, and those that are pink."""
    red, green, blue = frame.astype(int).transpose(2, 0, 1)
    coloured = (red > 100) & (green < 0.15 * red)
    return [int(np.sum(coloured & mask)) for mask in (blue < 0.15 * red, blue > 0.85 * red)]


@pytest.mark.filterwarnings("ignore")
def test_colours_of_categories_are_told_apart_by_all_eyes():
    colour = pytest.importorskip("colour", reason="pip install colour-science")
    matrix = colour.blindness.matrix_cvd_Machado2009
    linear = colour.cctf_decoding(np.array(CATEGORY_COLOURS) / 255)
    kinds = [matrix(kind, 1.0) for kind in ("Protanomaly", "Deuteranomaly", "Tritanomaly")]
    for seen in (linear, *(np.clip(linear @ kind.T, 0, 1) for kind in kinds)):
        lab = colour.XYZ_to_Lab(colour.RGB_to_XYZ(seen, "sRGB"))
        pairs = combinations(lab, 2)
        assert min(colour.delta_E(one, other, method="CIE 2000") for one, other in pairs) >= LEAST


def test_neutral_colours_are_greyer_than_every_category():
    def spread(colours):
        return [max(colour) - min(colour) for colour in colours]

    assert 2 * max(spread((*NEUTRAL, OTHER))) <= min(spread(CATEGORY_COLOURS))


@pytest.mark.parametrize("world", [Tabletop(), ToyWorld(), Guarded(ToyWorld())], ids=type)
def test_pictures_are_painted_with_their_ghosts_and_neutral_otherwise(world: World):
    assert shares(world.picture(SCENE)) == [0, 0]
    world.painter = reds
    one, other = shares(world.picture(SCENE))
    assert min(one, other) > 500
    film: list[Frame] = []
    action = np.array([0, -0.05, 0.3, 0, 0, 0, 0.3, 0, 0, 0.05, 0.3, 0.0])
    world.interact(SCENE, action, 0, on_frame=lambda frame, _: film.append(frame))
    assert min(shares(film[-1])) > 400
    goals = np.array([(np.nan,) * 3, (0.55, -0.15, 0.025)])
    assert not np.array_equal(world.picture(SCENE, goals), world.picture(SCENE))
    world.painter = None
    assert shares(world.picture(SCENE)) == [0, 0]


def test_world_in_a_process_of_its_own_is_painted_too(tmp_path: Path, monkeypatch):
    monkeypatch.setattr(sys, "path", list(sys.path))
    (tmp_path / "mine.py").write_text("from neurosym.worlds.toy import ToyWorld as Mine\n")
    monkeypatch.chdir(tmp_path)
    world = OwnFactory("mine:Mine", {}, tmp_path / "domain")()
    world.painter = reds
    assert min(shares(world.picture(SCENE))) > 500
    film: list[Frame] = []
    world.interact(SCENE, np.zeros(12), 0, on_frame=lambda frame, _: film.append(frame))
    assert min(shares(film[-1])) > 500


def test_world_of_a_domain_shows_the_categories_that_its_problems_name(tmp_path: Path):
    world = painted_world(SHIPPED / "world.toml")
    palette = Palette.of(Grounding.load(SHIPPED / "grounding.json").operators.categories)
    problem = Problem.load(SHIPPED / "problems/task-17.scene.json")
    colours = world.painter(problem.scene().features)
    assert colours.tolist() == [list(palette(item.category)) for item in problem.objects]
    assert len({*map(tuple, colours.tolist())}) > 1
    for name, text in (("world.toml", None), ("grounding.json", None), ("effect_model.safetensors", "x")):
        shutil.copy(SHIPPED / name, tmp_path) if text is None else (tmp_path / name).write_text(text)
    assert {*map(tuple, painted_world(tmp_path / "world.toml").painter(SCENE.features).tolist())} == {OTHER}
    (tmp_path / "effect_model.safetensors").unlink()
    assert painted_world(tmp_path / "world.toml").painter is None
