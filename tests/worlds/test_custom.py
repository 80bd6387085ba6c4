"""Worlds of one's own: they go the whole way, and what is wrong with one is said in a sentence."""

import pickle
import re
import subprocess
import sys

import pytest
from command_line import neurosym, refusal
from places import DOCS

from neurosym.data.interactions import Interactions
from neurosym.worlds.world_file import default_text, read_world

DOCUMENT = DOCS / "own-world.md"
SLIDER = '''
"""A puck on a table slides where it is pushed; the world has no physics."""

import numpy as np

from neurosym.world import Table
from neurosym.world import (Outcome, Scene)
from neurosym.world import ActionBox

class Slider:
    name = "slider"
    feature_names = ("s_x", "s_y", "d")
    action_box = ActionBox(np.array([-1.0, -1.0]), np.array([1.0, 1.0]), np.array([False, False]))
    table = Table((0.0, 1.0), (0.0, 1.0))
    lift_height = 0.1

    def __init__(self, reach):
        self.reach = reach

    def sample_scene(self, rng, objects):
        size = rng.uniform(0.02, 0.1, size=(objects, 3))
        places = np.column_stack([rng.uniform(0.3, 0.7, size=(objects, 2)), size[:, 2] / 2])
        return Scene(size, places, np.tile([0.0, 0.0, 0.0, 1.0], (objects, 1)))

    def interact(self, scene, action, target, *, put_down=True, on_frame=None, ghosts=None):
        positions = scene.positions.copy()
        positions[target, :2] += self.reach * np.sign(np.round(action))
        end = Scene(scene.features, positions, scene.orientations)
        lost = not self.table.contains(positions[target])
        return Outcome(scene, end, end, target, held=False, toppled=False, lost=lost, peak_height=0.0)

def make(reach=0.2, marks=("a", "b"), colour=None):
    return Slider(reach)

def needy(reach):
    return Slider(reach)

def broken(reach=0.2) -> Slider:
    raise RuntimeError("no such\\nrobot")

def incomplete() -> Slider:
    return Table((0.0, 1.0), (0.0, 1.0))

def nameless() -> Slider:
    world = Slider(0.1)
    world.name = "My World"
    return world

number = 3
'''


@pytest.fixture
def here(tmp_path, monkeypatch):
    """The current folder, with a module that holds a world; nothing imported from it stays."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", list(sys.path))
    (tmp_path / "slider.py").write_text(SLIDER)
    yield tmp_path
    for name, module in list(sys.modules.items()):
        if str(tmp_path) in str(getattr(module, "__file__", None) or getattr(module, "__path__", "")):
            del sys.modules[name]


def test_world_of_ones_own_is_written_with_the_options_of_its_factory(here):
    assert neurosym("init", "mine", "--world", "slider:make") == 0
    factory = read_world(here / "mine/world.toml")
    assert factory.args == ("slider:make", {"reach": 0.2, "marks": ["a", "b"]})
    assert pickle.loads(pickle.dumps(factory))().reach == 0.2


def test_option_without_a_default_can_be_written_by_hand(here, capsys):
    assert neurosym("init", "mine", "--world", "slider:needy") == 0
    assert "mine/world.toml cannot be used" in refusal(capsys, "explore", "mine")
    assert "needs the option 'reach'" in refusal(capsys, "explore", "mine")
    (here / "mine/world.toml").write_text('world = "slider:needy"\n[options]\nreach = 0.3\n')
    assert read_world(here / "mine/world.toml")().reach == 0.3


def test_data_say_which_world_and_options_they_come_from_whatever_the_workers(here):
    explore = ["--steps", "40", "--strategy", "random", "--regime", "quick"]
    for folder, workers in (("one", 1), ("two", 2)):
        assert neurosym("init", folder, "--world", "slider:make") == 0
        assert neurosym("explore", folder, *explore, "--workers", workers) == 0
    assert (here / "one/interactions.npz").read_bytes() == (here / "two/interactions.npz").read_bytes()
    origin = Interactions.load(here / "two/interactions.npz").origin
    assert origin["world"] == "slider:make"
    assert origin["world_options"] == {"reach": 0.2, "marks": ["a", "b"]}


def documented() -> list[str]:
    """The Python blocks of the document: a world, and its use with Gymnasium."""
    return re.findall(r"```python\n(.*?)```", DOCUMENT.read_text(), flags=re.DOTALL)


def test_documented_world_goes_the_whole_way_as_an_installed_command(here):
    (here / "my_world.py").write_text(documented()[0])
    command = "from neurosym.commands.cli import main; main()"  # like the console script: not from the folder
    learn = ["--steps", "1024", "--strategy", "random", "--regime", "quick", "--workers", "2"]
    rest = ["--rehearsals", "24", "--problems", "2"]
    typed = re.search(r"`neurosym (run \S+ --world \S+)`", DOCUMENT.read_text())[1].split()
    ended = subprocess.run(
        [sys.executable, "-P", "-c", command, *typed, *learn, *rest], capture_output=True, text=True
    )
    assert ended.returncode == 0, ended.stderr
    assert "heavy = 0.5" in (here / "ice/world.toml").read_text()
    assert "(define (domain ice)" in (here / "ice/domain.pddl").read_text()
    assert "reached" in ended.stdout


def test_documented_use_with_gymnasium_works(capsys):
    exec(compile(documented()[1], str(DOCUMENT), "exec"), {})
    assert re.match(r"[-\de.]+ (resting|held|toppled|lost) \[", capsys.readouterr().out)


def test_documented_world_is_short(here):
    assert len(documented()[0].splitlines()) < 40


@pytest.mark.parametrize(
    ("name", "options", "message"),
    [
        ("nowhere:make", "", "no module 'nowhere' is installed or stands in the current folder"),
        ("slider.deeper:make", "", "no module 'slider.deeper'"),
        ("slider:", "", "not of the form module:factory"),
        ("slider:missing", "", "the module 'slider' has no 'missing'"),
        ("slider:number", "", "is not callable but of type int"),
        ("slider:make", "speed = 1", "has no option 'speed'; valid: reach, marks, colour"),
        ("slider:make", "reach = nan", "reach = nan must be a finite number"),
        ("slider:broken", "", "cannot be made with its options: RuntimeError: no such robot"),
        ("slider:incomplete", "", "Table lacks name, feature_names, action_box, table, lift_height"),
        ("slider:nameless", "", "has the name 'My World'; valid: a lower-case letter"),
        ("raising:make", "", "cannot be imported: ZeroDivisionError: division by zero"),
        ("leaving:make", "", "cannot be imported: SystemExit: 7"),
        ("needing:make", "", "cannot be imported: ModuleNotFoundError: No module named 'moon_physics'"),
        ("os:system", 'command = "touch proof"', "is not known to make worlds"),
        ("subprocess:Popen", 'args = ["touch", "proof"]', "is not known to make worlds"),
        ("builtins:exec", "", "is not known to make worlds"),
    ],
)
def test_world_that_cannot_be_made_is_refused_in_one_sentence(here, name, options, message, capsys):
    (here / "raising.py").write_text("1 / 0\n")
    (here / "leaving.py").write_text("raise SystemExit(7)\n")
    (here / "needing.py").write_text("import moon_physics\n")
    (here / "mine").mkdir()
    (here / "mine/world.toml").write_text(f'world = "{name}"\n[options]\n{options}\n')
    said = refusal(capsys, "explore", "mine")
    assert message in said
    assert "mine/world.toml cannot be used" in said
    assert not (here / "proof").exists()
    if not options and "RuntimeError" not in message:
        assert message in refusal(capsys, "init", "new", "--world", name)
        assert not (here / "new").exists()


@pytest.mark.parametrize("place", [".", "downloaded"])
@pytest.mark.parametrize("name", ["evil:make", "downloaded.evil:make", "downloaded:make"])
def test_domain_folder_cannot_bring_its_own_code(here, place, name, monkeypatch, capsys):
    folder = here / "downloaded"
    folder.mkdir()
    for module in ("evil.py", "__init__.py"):
        (folder / module).write_text(f"import os\nos.mkdir({str(here / 'proof')!r})\n{SLIDER}")
    (folder / "world.toml").write_text(f'world = "{name}"\n')
    monkeypatch.chdir(here / place)
    said = refusal(capsys, "explore", folder, "--steps", 8)
    assert "in the domain folder" in said or "no module" in said
    monkeypatch.setattr(sys, "path", [str(folder), *sys.path])  # as `python -m` puts it there
    refusal(capsys, "explore", folder, "--steps", 8)
    assert not (here / "proof").exists()


def test_domain_folder_without_an_init_file_cannot_bring_its_own_code_either(here, capsys):
    (here / "downloaded").mkdir()
    (here / "downloaded/evil.py").write_text(SLIDER)
    (here / "downloaded/world.toml").write_text('world = "downloaded.evil:make"\n')
    assert "has its code in the domain folder" in refusal(capsys, "explore", "downloaded")


def test_run_refuses_another_world_of_ones_own_than_the_folders(here, capsys):
    (here / "world.toml").write_text(default_text("toy", here))
    said = refusal(capsys, "run", here, "--world", "slider:make")
    assert "of the world 'toy', not 'slider:make'" in said


def test_init_checks_how_a_world_behaves(here, capsys):
    (here / "forgetful.py").write_text(
        SLIDER.replace("self.reach = reach", "self.reach = reach; self.count = 0").replace(
            "positions = scene.positions.copy()",
            "positions = scene.positions.copy(); self.count += 1; positions[0, 0] += 0.01 * self.count",
        )
    )
    assert "has a memory" in refusal(capsys, "init", "mine", "--world", "forgetful:make")
    assert not (here / "mine").exists()
