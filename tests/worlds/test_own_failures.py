"""Whatever a world of somebody's own does wrong is told in one sentence, and what was finished is kept."""

import gc
import re
import shutil
import sys
from functools import partial
from pathlib import Path

import bad_worlds
import pytest
from command_line import neurosym

from neurosym import draw_problem, explore
from neurosym.errors import InvalidWorld
from neurosym.exploration.loop import ExplorationConfig
from neurosym.worlds import own_world
from neurosym.worlds.gymnasium_env import WorldEnv
from neurosym.worlds.own_world import OwnFactory
from neurosym.worlds.toy import make_world

SAID = {
    "raising": "raises an error in {}: ZeroDivisionError: no friction",
    "surprising": "raises an error in {}: Surprise",
    "leaving": r"ends the program in {} \(SystemExit: 3\); valid: an error",
    "gone": "ends its process with exit code 7 in {}",
    "killed": r"has its process killed by SIGKILL \(by somebody, or for want of memory\) in {}",
    "hanging": "has not come back for 1 s from {}",
    "nothing": "gives a NoneType from interact; valid: an Outcome",
    "nan": "gives positions in {} that are not finite floats",
    "other target": "gives the target 3 when asked to act on object 0",
    "odd kind": "gives outcome.disturbed = .*vanished.*valid: pairs of a bystander and one of moved, toppled",
}
DEEDS = [
    *((deed, "interact", 1) for deed in SAID if deed not in ("nan", "surprising")),
    *((deed, "sample_scene", 1) for deed in ("gone", "nan")),
    *((deed, "interact", 2) for deed in ("gone", "hanging")),
]


@pytest.fixture
def here(tmp_path, monkeypatch):
    """The current folder, with the module of bad worlds."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", list(sys.path))
    shutil.copy(Path(bad_worlds.__file__), tmp_path)
    return tmp_path


def factory(here, **options):
    return OwnFactory("bad_worlds:make", options, here / "domain")


def explored(world, folder, workers=1):
    folder.mkdir(exist_ok=True)
    options = {"config": ExplorationConfig(candidates=2, block=4), "workers": workers, "checkpoint": folder}
    return explore(world, steps=14, strategy="random", seed=6, **options)


KEPT = r" \(in interaction 6; the first 4 are kept, and the same call goes on from them\)\.$"


@pytest.mark.parametrize(("deed", "place", "workers"), DEEDS)
def test_each_deed_is_told_with_its_interaction_and_what_is_kept(here, deed, place, workers):
    said = SAID[deed].format(place)
    with pytest.raises(InvalidWorld, match=f"^The world 'bad_worlds:make' {said}.*{KEPT}") as caught:
        explored(factory(here, deed=deed, place=place), here / "data", workers)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("deed", "place"),
    [("raising", "init"), ("gone", "init"), ("hanging", "init"), ("leaving", "lift_height")],
)
def test_a_world_that_cannot_be_made_is_told(here, deed, place, monkeypatch):
    monkeypatch.setattr(own_world, "PATIENCE", 1.0)
    with pytest.raises(InvalidWorld, match=r"The world 'bad_worlds:make' (cannot be made|raises|ends|has)"):
        factory(here, deed=deed, place=place)()


@pytest.mark.parametrize("workers", [1, 2])
def test_a_world_that_was_mended_goes_on_to_the_same_bytes(here, workers, monkeypatch):
    bad = factory(here, deed="gone", place="interact")
    with pytest.raises(InvalidWorld, match="exit code 7"):
        explored(bad, here / "data", workers)
    monkeypatch.setenv("BAD_WORLDS_MENDED", "yes")
    again = explored(factory(here, deed="gone", place="interact"), here / "data", workers)
    explored(make_world, here / "whole").save(here / "whole.npz")
    again.save(here / "again.npz")
    assert (here / "again.npz").read_bytes() == (here / "whole.npz").read_bytes()


@pytest.mark.parametrize("deed", ["raising", "surprising", "leaving", "nothing", "other target"])
def test_a_world_in_this_process_is_told_too(deed):
    make_bad = partial(bad_worlds.Bad, deed, "interact", 0.0)
    environment = WorldEnv(make_bad)
    environment.reset(seed=0)
    for call in (
        lambda: explore(make_bad, steps=4, strategy="random", seed=6),
        lambda: draw_problem(make_bad(), lambda rows: ("0",) * len(rows), name="p", objects=1, seed=0),
        lambda: environment.step(environment.action_space.sample()),
    ):
        with pytest.raises(InvalidWorld, match=SAID[deed].format("interact")):
            call()


def commands(folder):
    plan = next(iter(sorted((folder / "plans").glob("*.plan"))), None)
    problem = plan.name.split(".")[0] if plan else ""
    return {
        "explore": ["explore", "new", "--steps", 8, "--strategy", "random", "--regime", "quick"],
        "run": ["run", "new", "--steps", 8, "--strategy", "random", "--regime", "quick"],
        "distill": ["distill", folder, "--objects", 4, "--workers", 1],
        "new-problem": ["new-problem", folder],
        "execute": ["execute", folder, problem, plan],
        "compare": ["compare", folder, "--tasks", 2, "--planners", "counting", "--workers", 1],
    }


@pytest.mark.parametrize(
    ("command", "deed"),
    [*((command, "raising") for command in commands(Path("folder"))), ("execute", "gone")],
)
def test_commands_refuse_a_bad_world_in_one_sentence(here, folder, command, deed, capsys):
    (here / "new").mkdir()
    for place in (folder, here / "new"):
        options = f'deed = "{deed}"\nplace = "interact"\ntall = 0.0\n'
        (place / "world.toml").write_text(f'world = "bad_worlds:make"\n[options]\n{options}')
    assert neurosym(*commands(folder)[command]) == 2
    *_, said = capsys.readouterr().err.strip().splitlines()  # after a bar that shows how far it came
    assert said.startswith("The world 'bad_worlds:make' "), said
    assert re.search(SAID[deed].format("interact"), said)
    assert command != "execute" or "(in step 1)" in said


def test_no_process_is_left(here):
    made = factory(here)
    number = made().process.pid
    assert Path(f"/proc/{number}").exists()
    del made
    gc.collect()
    assert not Path(f"/proc/{number}").exists()
