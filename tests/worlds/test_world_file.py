"""`world.toml`: what goes in comes out, and mistakes are named."""

import pickle

import pytest

from neurosym.errors import InvalidFile, UnknownChoice
from neurosym.worlds.world_file import WORLDS, default_text, make_world, read_world


@pytest.mark.parametrize("name", sorted(WORLDS))
def test_written_world_reads_back_with_its_defaults_also_in_a_worker(name, tmp_path):
    (tmp_path / "world.toml").write_text(default_text(name, tmp_path))
    read = pickle.loads(pickle.dumps(read_world(tmp_path / "world.toml")))
    assert read().config == make_world(name, {}).config


def test_options_reach_the_world_and_an_unknown_one_hints_at_ones_own(tmp_path):
    path = tmp_path / "world.toml"
    path.write_text('world = "tabletop"\n[options]\nlift_height = 0.1\ntable_y = [-0.2, 0.2]\n')
    world = read_world(path)()
    assert (world.lift_height, world.table.y) == (0.1, (-0.2, 0.2))
    said = "valid: tabletop, toy, toy-relations, your own as module:factory"
    for call in (lambda: make_world("moon", {}), lambda: default_text("moon", tmp_path)):
        with pytest.raises(UnknownChoice, match=said):
            call()


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("not toml", "not TOML"),
        ('world = "moon"', "no world 'moon'; valid: tabletop, toy"),
        ('world = "tabletop"\n[options]\nlift = 1', "no option 'lift'; valid: .*lift_height"),
        ('world = "tabletop"\n[options]\nmass = "heavy"', "wrong type: .*float"),
        ('world = "toy"\n[options]\nlift_height = nan', "lift_height = nan must be a finite number"),
        ('world = "toy"\n[options.table]\nx = [0, 1]\ny = [0, 1]\nz = [0, 1]', "'table.z'; valid: table.x"),
        ("[options]", 'must hold world = "NAME"'),
    ],
)
def test_mistakes_are_named_with_the_file(text, message, tmp_path):
    path = tmp_path / "world.toml"
    path.write_text(text)
    with pytest.raises(InvalidFile, match=message) as caught:
        read_world(path)
    assert str(path) in str(caught.value)
