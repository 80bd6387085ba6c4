"""Whatever a world of somebody's own does wrong is told in one sentence, and what was finished is kept."""

import gc
import re
import shutil
import signal
import subprocess
import sys
import time
from functools import partial
from pathlib import Path

import bad_worlds
import pytest
from command_line import neurosym, refusal

from neurosym import Grounding, PlanStep, Problem, draw_problem, execute, explore
from neurosym.errors import InvalidWorld
from neurosym.exploration.loop import ExplorationConfig
from neurosym.worlds import own_world
from neurosym.worlds.gymnasium_env import WorldEnv
from neurosym.worlds.own_world import OwnFactory
from neurosym.worlds.toy import ToyConfig, ToyWorld, make_world

BLOCK, STEPS = 4, 14
SAID = {
    "raising": "raises an error in {}: ZeroDivisionError: no friction",
    "surprising": "raises an error in {}: Surprise",
    "leaving": r"ends the program in {} \(SystemExit: 3\); valid: an error",
    "gone": "ends its process with exit code 7 in {}",
    "killed": r"has its process killed by SIGKILL \(by somebody, or for want of memory\) in {}",
    "crashed": "has its process killed by SIGSEGV in {}",
    "hanging": "has not come back from {} for 1 s",
}
"""What is said of deeds that can be done anywhere."""
OF_SCENES = {
    "nothing": "gives a NoneType as sample_scene; valid: a Scene",
    "a tuple": "gives a tuple as sample_scene",
    "nan": "gives positions in sample_scene that are not finite floats",
    "integers": "gives features in sample_scene that are not finite floats",
    "lists": "gives positions of type list in sample_scene; valid: a numpy array",
    "narrow": r"gives features of shape \(1, 2\) in sample_scene; valid for one object: \(1, 4\)",
    "flat": r"gives orientations of shape \(1, 3\)",
    "two objects": r"gives features of shape \(2, 4\) in sample_scene; valid for one object: \(1, 4\)",
    "off the table": "samples an object off its table",
}
OF_OUTCOMES = {
    "nothing": "gives a NoneType from interact; valid: an Outcome",
    "a tuple": "gives a tuple from interact; valid: an Outcome",
    "nan after": "gives positions in outcome.lifted that are not finite floats",
    "two objects after": r"gives features of shape \(2, 4\) in outcome.lifted",
    "no scenes": "gives a NoneType as outcome.end; valid: a Scene",
    "other target": "gives the target 3 when asked to act on object 0",
    "no bool": "gives outcome.held = 'held'; valid: a bool",
    "no height": "gives outcome.peak_height = nan",
    "odd kind": "gives outcome.disturbed = .*vanished.*valid: pairs of a bystander and one of moved, toppled",
    "odd touch": r"gives outcome.touched = \(5,\)",
    "a list of touches": r"gives outcome.touched = \[1\]",
}
ZOO = [
    *((deed, "sample_scene", said.format("sample_scene")) for deed, said in SAID.items()),
    *((deed, "interact", said.format("interact")) for deed, said in SAID.items()),
    *((deed, "sample_scene", said) for deed, said in OF_SCENES.items()),
    *((deed, "interact", said) for deed, said in OF_OUTCOMES.items()),
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


def explored(world_factory, folder, workers=1, strategy="random"):
    folder.mkdir(exist_ok=True)
    config = ExplorationConfig(candidates=2, block=BLOCK)
    return explore(
        world_factory,
        steps=STEPS,
        strategy=strategy,
        seed=6,
        workers=workers,
        checkpoint=folder,
        config=config,
    )


KEPT = r" \(in interaction 6; the first 4 are kept, and the same call goes on from them\)\.$"


@pytest.mark.parametrize(("deed", "place", "said"), ZOO)
def test_each_deed_is_told_with_its_interaction_and_what_is_kept(here, deed, place, said):
    with pytest.raises(InvalidWorld, match=f"^The world 'bad_worlds:make' {said}.*{KEPT}") as caught:
        explored(factory(here, deed=deed, place=place), here / "data")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("deed", ["raising", "leaving", "gone", "killed", "hanging", "nothing"])
def test_two_workers_tell_the_same(here, deed):
    said = {**SAID, **OF_OUTCOMES}[deed].format("interact")
    with pytest.raises(InvalidWorld, match=f"{said}.*{KEPT}"):
        explored(factory(here, deed=deed, place="interact"), here / "data", workers=2)


@pytest.mark.parametrize("place", ["init", "lift_height"])
@pytest.mark.parametrize("deed", SAID)
def test_a_world_that_cannot_be_made_is_told(here, deed, place, monkeypatch):
    monkeypatch.setattr(own_world, "PATIENCE", 1.0)
    with pytest.raises(InvalidWorld, match=r"The world 'bad_worlds:make' (cannot be made|raises|ends|has)"):
        factory(here, deed=deed, place=place)()


@pytest.mark.parametrize("workers", [1, 2])
def test_a_world_that_was_mended_goes_on_to_the_same_bytes(here, workers, monkeypatch):
    bad = factory(here, deed="gone", place="interact")
    for _ in range(2):
        with pytest.raises(InvalidWorld, match="exit code 7"):
            explored(bad, here / "data", workers)
    monkeypatch.setenv("BAD_WORLDS_MENDED", "yes")
    again = explored(factory(here, deed="gone", place="interact"), here / "data", workers)
    explored(make_world, here / "whole").save(here / "whole.npz")
    again.save(here / "again.npz")
    assert (here / "again.npz").read_bytes() == (here / "whole.npz").read_bytes()


UNTYPED = {"no scenes", "no bool", "no height", "odd kind", "a list of touches"}
"""Deeds that the checks of types, which are on in tests, do not let be done in this process."""


@pytest.mark.parametrize("deed", ["raising", "surprising", "leaving", *sorted(OF_OUTCOMES.keys() - UNTYPED)])
def test_a_world_in_this_process_is_told_too(deed):
    said = {**SAID, **OF_OUTCOMES}[deed].format("interact")
    make_bad = partial(bad_worlds.Bad, deed, "interact", 0.0)
    with pytest.raises(InvalidWorld, match=said):
        explore(make_bad, steps=4, strategy="random", seed=6)
    with pytest.raises(InvalidWorld, match=said):
        draw_problem(make_bad(), lambda features: ("0",) * len(features), name="p", objects=1, seed=0)
    environment = WorldEnv(make_bad)
    environment.reset(seed=0)
    with pytest.raises(InvalidWorld, match=said):
        environment.step(environment.action_space.sample())


@pytest.mark.parametrize("deed", ["raising", "leaving", "nothing"])
def test_workers_of_a_factory_in_python_tell_it(deed):
    with pytest.raises(InvalidWorld, match=SAID.get(deed, "NoneType").format("interact")):
        explore(partial(bad_worlds.Bad, deed, "interact"), steps=14, strategy="random", seed=6, workers=2)


def test_a_scene_that_is_changed_in_passing_is_told():
    class Careless(ToyWorld):
        def interact(self, scene, action, target, **options):
            scene.positions[0, 0] += 0.01
            return super().interact(scene, action, target, **options)

    with pytest.raises(InvalidWorld, match="changes the scene that interact is given"):
        explore(lambda: Careless(ToyConfig()), steps=1, strategy="random", seed=0)


def test_a_run_in_a_bad_world_names_the_step(toy_folder):
    grounding = Grounding.load(toy_folder / "grounding.json")
    problem = Problem.load(next(iter(sorted((toy_folder / "problems").glob("*.scene.json")))))
    category = problem.objects[0].category
    operator = next(one for one in grounding.live if one.category == category)
    steps = [PlanStep(operator.name, problem.objects[0].name)]
    with pytest.raises(InvalidWorld, match=r"raises an error in interact: .* \(in step 1\)"):
        execute(bad_worlds.Bad("raising", "interact", 0.0), problem, grounding, steps)


BAD = """world = "bad_worlds:make"
[options]
deed = "{}"
place = "interact"
tall = {}
"""


def commands(folder):
    plan = next(iter(sorted((folder / "plans").glob("*.plan"))), None)
    problem = plan.name.split(".")[0] if plan else ""
    return {
        "explore": ["explore", "new", "--steps", 8, "--strategy", "random", "--regime", "quick"],
        "run": ["run", "new", "--steps", 8, "--strategy", "random", "--regime", "quick"],
        "distill": ["distill", folder, "--objects", 8],
        "new-problem": ["new-problem", folder],
        "execute": ["execute", folder, problem, plan],
        "compare": ["compare", folder, "--tasks", 2, "--planners", "counting"],
        "evaluate": ["evaluate", folder],
    }


@pytest.mark.parametrize("command", commands(Path("folder")))
@pytest.mark.parametrize("deed", ["raising", "gone", "nothing"])
def test_commands_refuse_a_bad_world_in_one_sentence(here, folder, command, deed, capsys):
    (here / "new").mkdir()
    for place in (folder, here / "new"):
        (place / "world.toml").write_text(BAD.format(deed, 0.0))
    typed = commands(folder)[command]
    for workers in (1, 2) if command in ("explore", "distill", "compare") else (None,):
        assert neurosym(*typed, *([] if workers is None else ["--workers", workers])) == 2
        *_, said = capsys.readouterr().err.strip().splitlines()  # after a bar that shows how far it came
        assert said.startswith("The world 'bad_worlds:make' "), said
        assert re.search({**SAID, **OF_OUTCOMES}[deed].format("interact"), said)


@pytest.mark.parametrize("deed", ["raising", "gone", "nothing"])
def test_init_refuses_a_bad_world_and_leaves_no_folder(here, deed, capsys):
    (here / "sure_worlds.py").write_text(
        f"from bad_worlds import Bad\n\ndef make() -> Bad:\n    return Bad({deed!r}, 'interact', 0.0)\n"
    )
    where = "a first trial" if deed == "gone" else "interact"
    said = {**SAID, **OF_OUTCOMES}[deed].format(where)
    assert said in refusal(capsys, "init", "mine", "--world", "sure_worlds:make")
    assert not (here / "mine").exists()


def test_a_module_that_ends_its_process_when_imported_is_told(here, capsys):
    (here / "gone.py").write_text("import os\nos._exit(0)\n")
    said = refusal(capsys, "init", "mine", "--world", "gone:make")
    assert "The world 'gone:make' ends its process with exit code 0 in a first trial." in said


def test_no_process_is_left(here):
    made = factory(here)
    number = made().process.child.process.pid
    assert Path(f"/proc/{number}").exists()
    del made
    gc.collect()
    assert not Path(f"/proc/{number}").exists()


def test_a_world_ends_with_the_process_that_asks_it(here):
    program = """
import os, signal
from pathlib import Path
from neurosym.worlds.own_world import OwnFactory
print(OwnFactory("bad_worlds:make", {}, Path("domain"))().process.child.process.pid, flush=True)
os.kill(os.getpid(), signal.SIGKILL)
"""
    ended = subprocess.run([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    assert ended.returncode == -signal.SIGKILL
    end = time.monotonic() + 20
    while Path(f"/proc/{int(ended.stdout)}").exists() and time.monotonic() < end:
        time.sleep(0.05)
    assert not Path(f"/proc/{int(ended.stdout)}").exists()
