"""Worlds of one's own, and `world.toml`: they go the whole way, and what is wrong is said in a sentence."""

import pickle
import re
import subprocess
import sys

import numpy as np
import pytest
from command_line import neurosym, refusal
from documents import python_blocks
from places import DOCS

from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidFile, UnknownChoice
from neurosym.worlds.world_file import WORLDS, default_text, make_world, read_world

WORLD, GYMNASIUM = python_blocks("own-world.md")
SLIDER = """
from dataclasses import replace
from neurosym.worlds.toy import ToyConfig, ToyWorld

class Slider(ToyWorld):
    name = "slider"

    def __init__(self, reach):
        super().__init__(ToyConfig(lift_height=reach))
        self.reach = reach

def make(reach=0.2, marks=("a", "b"), colour=None):
    return Slider(reach)

def needy(reach):
    return Slider(reach)

def broken(reach=0.2) -> Slider:
    raise RuntimeError("no such\\nrobot")

def incomplete() -> Slider:
    return ToyConfig()

def nameless() -> Slider:
    world = Slider(0.1)
    world.name = "My World"
    return world

class Forgetful(Slider):
    def interact(self, *given, **options):
        self.reach += 0.01
        return replace(super().interact(*given, **options), peak_height=self.reach)

def forgetful() -> Slider:
    return Forgetful(0.1)
"""


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


def test_option_without_a_default_can_be_written_by_hand(here, capsys):
    assert neurosym("init", "mine", "--world", "slider:needy") == 0
    said = refusal(capsys, "explore", "mine")
    assert "mine/world.toml cannot be used" in said
    assert "missing 1 required positional argument: 'reach'; valid: reach" in said
    (here / "mine/world.toml").write_text('world = "slider:needy"\n[options]\nreach = 0.3\n')
    assert read_world(here / "mine/world.toml")().lift_height == 0.3


def test_data_say_which_world_and_options_they_come_from_whatever_the_workers(here):
    explore = ["--steps", "40", "--strategy", "random", "--regime", "quick"]
    for folder, workers in (("one", 1), ("two", 2)):
        assert neurosym("init", folder, "--world", "slider:make") == 0
        assert neurosym("explore", folder, *explore, "--workers", workers) == 0
    assert (here / "one/interactions.npz").read_bytes() == (here / "two/interactions.npz").read_bytes()
    factory = read_world(here / "one/world.toml")
    assert factory.args == ("slider:make", {"reach": 0.2, "marks": ["a", "b"]})
    assert pickle.loads(pickle.dumps(factory))().lift_height == 0.2
    origin = Interactions.load(here / "two/interactions.npz").origin
    assert origin["world"] == "slider:make"
    assert origin["world_options"] == {"reach": 0.2, "marks": ["a", "b"]}


def test_documented_world_goes_the_whole_way_as_an_installed_command(here):
    (here / "my_world.py").write_text(WORLD)
    assert len(WORLD.splitlines()) < 40
    command = "from neurosym.commands.cli import main; main()"  # like the console script: not from the folder
    learn = ["--steps", "256", "--strategy", "random", "--regime", "quick", "--workers", "1"]
    rest = ["--rehearsals", "8", "--problems", "1", "--object-bits", "1", "--action-bits", "2"]
    typed = re.search(r"`neurosym (run \S+ --world \S+)`", (DOCS / "own-world.md").read_text())[1].split()
    ended = subprocess.run(
        [sys.executable, "-P", "-c", command, *typed, *learn, *rest], capture_output=True, text=True
    )
    assert ended.returncode == 0, ended.stderr
    assert "heavy = 0.5" in (here / "ice/world.toml").read_text()
    assert "(define (domain ice)" in (here / "ice/domain.pddl").read_text()
    assert "reached" in ended.stdout


SHOWN = """
import numpy as np
from my_world import Ice

class Shown(Ice):
    def __init__(self, heavy: float = 0.4):
        super().__init__(heavy)

    def images(self, scene):
        every = np.zeros((len(scene), 20, 20))
        for image, (s_x, s_y, d, mass) in zip(every, scene.features):
            along, across = (np.abs(np.linspace(-0.1, 0.1, 20)) < side / 2 for side in (s_x, s_y))
            image[np.ix_(along, across)] = d * (0.2 if mass > self.heavy else 1.0)  # heavy: hollow
        return every

class Torn(Shown):
    def images(self, scene):
        return super().images(scene)[:, :, :-1]

class Blank(Shown):
    def images(self, scene):
        return 0.0 * super().images(scene)

class Grey(Shown):
    def images(self, scene):
        return (2550 * super().images(scene)).astype(np.uint8)

class Deep(Shown):
    def images(self, scene):
        return 1e200 + super().images(scene)

class Moody(Shown):
    def images(self, scene):
        self.heavy = 1.0 - self.heavy
        return super().images(scene) + self.heavy

class Named(Shown):
    feature_names = ("s_x", "s_y", "d", "v1")

class Album(Shown):
    images = ["ice.png"]

def needy(heavy) -> Shown:
    return Shown(heavy)
"""


@pytest.mark.evaluation  # half a minute of training
def test_world_that_gives_images_goes_the_whole_way(here, capsys):
    (here / "my_world.py").write_text(WORLD)
    (here / "shown.py").write_text(SHOWN)
    few = ["--interactions", "3000", "--regime", "quick", "--problems", "2"]
    assert neurosym("run", "ice", "--world", "shown:Shown", *few) == 0
    assert "2000 seen" in capsys.readouterr().out


def test_eye_learns_in_a_world_that_gives_images_and_its_features_are_not_shown(here, capsys):
    (here / "my_world.py").write_text(WORLD)
    (here / "shown.py").write_text(SHOWN)
    assert neurosym("init", "ice", "--world", "shown:Shown") == 0
    assert "next: neurosym see ice" in capsys.readouterr().out
    assert "has not learned to see yet" in refusal(capsys, "explore", "ice")
    assert neurosym("see", "ice", "--interactions", "200", "--looks", "40", "--workers", "2") == 0
    assert neurosym("explore", "ice", "--steps", "40", "--strategy", "random", "--workers", "2") == 0
    factory = read_world(here / "ice/world.toml")
    world = pickle.loads(pickle.dumps(factory))()
    assert world.feature_names == ("s_x", "s_y", "d", "mass", "v1", "v2", "v3", "v4", "v5")
    origin = Interactions.load(here / "ice/interactions.npz").origin
    assert (origin["world"], origin["unshown"]) == ("shown:Shown", [0, 1, 2, 3])
    scene = world.sample_scene(np.random.default_rng(3), 3)
    outcome = world.interact(scene, np.array([1.0, 1.0]), 1)
    assert outcome.end.features.tobytes() == scene.features.tobytes()
    assert outcome.effect[:2] == pytest.approx([0.1, 0.1] if scene.features[1, 3] < 0.4 else [0.05, 0.05])
    capsys.readouterr()
    too_few = refusal(capsys, "run", "ice", "--world", "shown:Shown", "--interactions", "300")
    assert "besides 200 that teach an eye" in too_few


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("Torn", "gives images of shape (1, 20, 19) of 1 object"),
        ("Grey", "gives images of type uint8"),
        ("Deep", "gives images with a height of 1e+200 m"),
        ("Moody", "gives other images of the same scene the second time"),
        ("Named", "has a feature v1"),
        ("Blank", "40 objects all look the same in the images of the world that Blank/world.toml names"),
    ],
)
def test_images_that_cannot_be_are_refused(here, name, message, capsys):
    (here / "my_world.py").write_text(WORLD)
    (here / "shown.py").write_text(SHOWN)
    if name in ("Blank", "Named"):
        assert neurosym("init", name, "--world", f"shown:{name}") == 0
        capsys.readouterr()
        assert message in refusal(capsys, "see", name, "--interactions", "40", "--looks", "0")
    else:
        assert message in refusal(capsys, "init", name, "--world", f"shown:{name}")


def test_worlds_without_a_method_for_images_or_with_an_option_to_give_are_made_as_before(here, capsys):
    (here / "my_world.py").write_text(WORLD)
    (here / "shown.py").write_text(SHOWN)
    for name in ("Album", "needy"):
        assert neurosym("init", name, "--world", f"shown:{name}") == 0
        assert f"next: neurosym explore {name}" in capsys.readouterr().out


def test_documented_use_with_gymnasium_works(capsys):
    exec(GYMNASIUM, {})
    assert re.match(r"[-\de.]+ (resting|held|toppled|lost) \[", capsys.readouterr().out)


@pytest.mark.parametrize(
    ("name", "options", "message"),
    [
        ("nowhere:make", "", "no module 'nowhere' is installed or stands in the current folder"),
        ("slider:", "", "not of the form module:factory"),
        ("slider:missing", "", "the module 'slider' has no 'missing'"),
        ("slider:make", "speed = 1", "unexpected keyword argument 'speed'; valid: reach, marks, colour"),
        ("slider:broken", "", "cannot be made with its options: RuntimeError: no such robot"),
        ("slider:incomplete", "", "ToyConfig lacks name, feature_names, action_box"),
        ("slider:nameless", "", "has the name 'My World'; valid: a lower-case letter"),
        ("raising:make", "", "cannot be imported: ZeroDivisionError: division by zero"),
        ("os:system", 'command = "touch proof"', "is not known to make worlds"),
    ],
)
def test_world_that_cannot_be_made_is_refused_in_one_sentence(here, name, options, message, capsys):
    (here / "raising.py").write_text("1 / 0\n")

    (here / "mine").mkdir()
    (here / "mine/world.toml").write_text(f'world = "{name}"\n[options]\n{options}\n')
    said = refusal(capsys, "explore", "mine")
    assert message in said
    assert "mine/world.toml cannot be used" in said
    assert not (here / "proof").exists()
    if name in ("nowhere:make", "slider:incomplete"):
        assert message in refusal(capsys, "init", "new", "--world", name)
        assert not (here / "new").exists()


@pytest.mark.parametrize(
    ("name", "place", "modules"),
    [
        ("evil:make", "downloaded", ["evil.py"]),
        ("downloaded:make", ".", ["__init__.py"]),
        ("downloaded.evil:make", ".", ["evil.py", "__init__.py"]),
        ("downloaded.evil:make", ".", ["evil.py"]),
    ],
)
def test_domain_folder_cannot_bring_its_own_code(here, place, name, modules, monkeypatch, capsys):
    folder = here / "downloaded"
    folder.mkdir()
    for module in modules:
        (folder / module).write_text(f"import os\nos.mkdir({str(here / 'proof')!r})\n{SLIDER}")
    (folder / "world.toml").write_text(f'world = "{name}"\n')
    monkeypatch.chdir(here / place)
    said = refusal(capsys, "explore", folder, "--steps", 8)
    assert "in the domain folder" in said or "no module" in said
    monkeypatch.setattr(sys, "path", [str(folder), *sys.path])  # as `python -m` puts it there
    refusal(capsys, "explore", folder, "--steps", 8)
    assert not (here / "proof").exists()


def test_run_refuses_another_world_of_ones_own_than_the_folders_and_init_one_with_a_memory(here, capsys):
    (here / "world.toml").write_text(default_text("toy", here))
    said = refusal(capsys, "run", here, "--world", "slider:make")
    assert "of the world 'toy', not 'slider:make'" in said
    assert "has a memory" in refusal(capsys, "init", "mine", "--world", "slider:forgetful")
    assert not (here / "mine").exists()


# `world.toml`: what goes in comes out, and mistakes are named


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
    said = "valid: camera, tabletop, toy, toy-relations, your own as module:factory"
    for call in (lambda: make_world("moon", {}), lambda: default_text("moon", tmp_path)):
        with pytest.raises(UnknownChoice, match=said):
            call()


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("not toml", "not TOML"),
        ('world = "moon"', "no world 'moon'; valid: camera, tabletop, toy"),
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
