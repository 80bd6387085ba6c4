"""`neurosym show` pictures what happens again; a colour is a category, told apart by everybody."""

import shutil
import sys
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
import toy_domain
import toy_relations
from command_line import neurosym, refusal
from PIL import Image
from places import SHIPPED
from standing import boxes
from toy_relations import PUT_ON

from neurosym.contract import Guarded
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidValue
from neurosym.execution.executor import execute
from neurosym.grounding import Grounding
from neurosym.pictures import film
from neurosym.pictures.motions import Motion, recall_interaction, surest_carriers
from neurosym.problems import Problem
from neurosym.sim.tabletop import Tabletop
from neurosym.stages.painting import painted_world
from neurosym.tasks.transition import PlanStep
from neurosym.world import CATEGORY_COLOURS, NEUTRAL, OTHER, Frame, Palette, World
from neurosym.worlds.own_world import OwnFactory
from neurosym.worlds.toy import ToyConfig, ToyWorld, make_world

FRAMES = [np.full((480, 640, 3), shade, dtype=np.uint8) for shade in (0, 120, 250)]


def size(path) -> tuple[int, int]:
    with Image.open(path) as image:
        return image.size


def test_gif_shows_every_frame_and_pauses_on_the_last(tmp_path):
    film.save_gif(tmp_path / "run.gif", FRAMES)
    with Image.open(tmp_path / "run.gif") as image:
        assert image.n_frames == 3
        image.seek(2)
        assert image.info["duration"] > 1000
        assert image.convert("L").getpixel((10, 10)) == 250


def test_strip_sets_the_frames_side_by_side_with_captions(tmp_path):
    film.save_sheet(tmp_path / "run.png", [film.Row("", tuple(FRAMES), ("start", "one", "two"))])
    with Image.open(tmp_path / "run.png") as image:
        width, height = film.STRIP_SIZE
        assert image.size[0] == 3 * width
        assert [image.getpixel((width // 2 + width * k, 100))[0] for k in range(3)] == [0, 120, 250]
        caption = np.asarray(image.convert("L"))[height:, :width]
        assert caption.min() < 128 < caption.max()


def test_interaction_happens_again_to_the_byte_and_is_pictured_the_same(folder, capsys):
    assert neurosym("show", folder, "--interaction", 5) == 0
    said = capsys.readouterr().out
    assert "the effect is the recorded one, byte for byte" in said
    path = folder / "pictures/interaction-5.png"
    assert f"wrote {path}" in said
    assert "next: neurosym show" in said
    width, height = size(path)
    assert (width, height > film.STRIP_SIZE[1]) == (3 * film.STRIP_SIZE[0], True)
    assert neurosym("show", folder, "--interaction", 5, "--output", folder / "two.png") == 0
    assert path.read_bytes() == (folder / "two.png").read_bytes()
    assert neurosym("show", folder, "--interaction", 5, "--output", folder / "five.gif") == 0
    with Image.open(folder / "five.gif") as image:
        assert image.n_frames > 1


def test_interaction_that_turns_out_otherwise_or_has_no_scene_is_said_to(folder, capsys):
    data = Interactions.load(folder / "interactions.npz")
    data.effects[5] += 0.01
    data.save(folder / "interactions.npz")
    assert neurosym("show", folder, "--interaction", 5) == 0
    assert "the effect is not the recorded one, but 17.3 mm from it" in capsys.readouterr().out
    del data.origin["seed"]
    data.save(folder / "interactions.npz")
    motion, is_same = recall_interaction(make_world(), data, 5)
    assert not is_same
    assert motion.scene.positions[0, :2] == pytest.approx([0.7, 0.0])
    assert neurosym("show", folder, "--interaction", 5) == 0
    assert "its scene cannot be drawn again" in capsys.readouterr().out


def test_primitive_is_shown_on_each_category_that_the_domain_promises_something_of(folder, capsys):
    grounding = Grounding.load(folder / "grounding.json")
    symbol = grounding.live[0].primitive
    assert neurosym("show", folder, "--primitive", symbol) == 0
    said = capsys.readouterr().out
    promised = [operator.name for operator in grounding.live if operator.primitive == symbol]
    assert all(name in said for name in promised)
    rows = size(folder / f"pictures/primitive-{symbol}.png")[1] / film.STRIP_SIZE[1]
    assert len(promised) < rows < 1.2 * len(promised)


def test_each_category_is_carried_by_what_does_it_most_surely_if_most_of_it_can_be(folder, capsys):
    grounding = Grounding.load(folder / "grounding.json")
    carriers = surest_carriers(grounding)
    surest = {one.subject: one for one in carriers}
    every = [one for one in grounding.places.operators if one.trials]
    for category in {one.subject for one in every}:
        best = max(one.successes / one.trials for one in every if one.subject == category)
        assert (category in surest) == (best >= 0.5)
        if category in surest:
            assert surest[category].successes / surest[category].trials == best
    carrier = carriers[0]
    assert neurosym("show", folder, "--operator", carrier.name) == 0
    x, y, _ = (round(1000 * value) for value in carrier.promise.effect)
    assert f"{carrier.name}: carried, effect ({x}, {y}, 0) mm" in capsys.readouterr().out
    assert (folder / f"pictures/operator-{carrier.name}.png").is_file()


def test_problem_is_shown_with_its_goals_unless_a_world_draws_nothing(folder):
    assert neurosym("show", folder, "--problem", "task-02") == 0
    assert size(folder / "pictures/problem-task-02.png")[0] == film.STRIP_SIZE[0]

    class Blind(ToyWorld):
        picture = None

    with pytest.raises(InvalidValue, match="The toy world draws no pictures"):
        film.picture_problem(Blind(ToyConfig()), toy_domain.problem({}), folder / "x.png")


def test_symbols_are_drawn_in_one_file_with_a_legend_and_an_effect_of_each_operator(folder, capsys):
    assert neurosym("show", folder, "--symbols") == 0
    path = folder / "pictures/symbols.svg"
    assert f"wrote {path}" in capsys.readouterr().out
    root, table = ElementTree.parse(path).getroot(), Grounding.load(folder / "grounding.json").objects
    told = [one.text for one in root.iter() if one.text]
    palette = Palette.of(table.categories)
    for category in table.categories:
        assert any(text.startswith(f"{category.name}, ") for text in told)
        assert palette.hex(category.symbol) in path.read_text()
    pairs = {(one.subject, one.primitive): one for one in reversed(table.operators)}
    assert all(any(text.startswith(f"{one.name}: ") for text in told) for one in pairs.values())
    assert neurosym("show", folder, "--symbols", "--output", folder / "two.svg") == 0
    assert path.read_bytes() == (folder / "two.svg").read_bytes()
    (folder / "effect_model.safetensors").unlink()
    assert "effect_model.safetensors" in refusal(capsys, "show", folder, "--symbols")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "Name one thing to show: --interaction I, --primitive CODE, --operator NAME, --problem NAME or"),
        (["--interaction", "1024"], "no interaction 1024; the data have 1024 rows, 0 to 1023"),
        (["--primitive", "wave"], "no primitive 'wave'; valid: 0"),
        (["--operator", "wave"], "no operator 'wave'; valid: "),
        (["--problem", "task-99"], "no problem 'task-99'; valid: task-01, task-02"),
        (["--interaction", "0", "--output", "x.jpg"], "x.jpg; name a file that ends in .png or .gif"),
        (["--interaction", "0", "--gui"], "The toy world has no window"),
        (["--interaction", "0", "--gui", "--output", "x.png"], "leave out --output"),
        (["--symbols", "--problem", "task-01"], "Name one thing to show"),
        (["--symbols", "--output", "x.png"], "x.png; name a file that ends in .svg"),
        (["--symbols", "--gui"], "leave out --symbols"),
    ],
)
def test_impossible_request_is_refused_in_one_sentence(folder, arguments, message, capsys):
    assert message in refusal(capsys, "show", folder, *arguments)
    assert not list((folder / "pictures").glob("*"))


def test_strip_of_the_tabletop_shows_every_phase_of_a_lift():
    assert film.telling(["start", "start", "waypoint 1", "waypoint 1", "rise", "rise", "rise"]) == (2, 3, 6)
    scene = Tabletop().sample_scene(np.random.default_rng(0), 1)
    scene.features[0] = [0.05, 0.05, 0.05, 0.0]
    scene.positions[0, 2] = 0.025
    lift = np.array([0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0.03, 0], dtype=float)
    world = Tabletop()
    row, outcome = film.film_row(world, Motion("lift", scene, lift))
    assert outcome.held
    assert row.captions == ("start", "waypoint 1", "waypoint 2", "waypoint 3", "rise", "put down")
    assert all(frame.min() < 100 for frame in row.frames)
    assert world.wanted_pictures is None


def test_run_is_shown_from_its_goals_to_its_start_if_it_goes_the_same_way():
    world, grounding = toy_domain.WORLD, toy_domain.grounding()
    asked = toy_domain.problem({"item-01": (0.68, 0.0, 0.025), "item-02": (0.8, 0.18, 0.025)})
    plan = (PlanStep("push-forward-010-cube", "item-01"), PlanStep("push-left-001-cube", "item-02"))
    run = execute(world, asked, grounding, plan)
    stills = film.run_stills(world, grounding, asked, run)
    assert len(stills.frames) == len(stills.captions) == 3
    assert stills.captions[-1].endswith("item-02: resting, goal reached")
    np.testing.assert_array_equal(stills.frames[0], world.picture(asked.scene(), asked.goal_positions()))
    assert not np.array_equal(stills.frames[0], world.picture(asked.scene()))
    nearer = ToyWorld(replace(ToyConfig(), lift_height=0.1))
    assert film.run_stills(nearer, grounding, asked, run).frames
    lifted = execute(world, asked, grounding, [PlanStep("lift-000-cube", "item-01")])
    with pytest.raises(InvalidValue, match="Step 1 of the run of errand goes another way"):
        film.run_stills(nearer, grounding, asked, lifted)


def test_run_that_stacks_is_shown_with_its_start():
    """What stood at the start is a ghost in the last picture, whatever relations are asked for."""
    world, grounding, asked = toy_relations.WORLD, toy_relations.grounding(), toy_relations.tower()
    plan = [PlanStep(PUT_ON, "item-03", "item-02"), PlanStep(PUT_ON, "item-01", "item-03")]
    run = execute(world, asked, grounding, plan)
    assert film.run_stills(world, grounding, asked, run).captions[-1].endswith("goal reached")


# A colour is a category: in all pictures of a domain, told apart by everybody, and nobody else's

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
    pytest.importorskip("colour", reason="pip install colour-science")
    pages = pytest.importorskip("tools.benchmarks.studio.pages", reason="an extra")
    assert pages.least_colour_distance() >= LEAST


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
    palette = Palette.of(Grounding.load(SHIPPED / "grounding.json").objects.categories)
    problem = Problem.load(SHIPPED / "problems/task-17.scene.json")
    colours = world.painter(problem.scene().features)
    assert colours.tolist() == [list(palette(item.category)) for item in problem.objects]
    assert len({*map(tuple, colours.tolist())}) > 1
    for name, text in (("world.toml", None), ("grounding.json", None), ("effect_model.safetensors", "x")):
        shutil.copy(SHIPPED / name, tmp_path) if text is None else (tmp_path / name).write_text(text)
    assert {*map(tuple, painted_world(tmp_path / "world.toml").painter(SCENE.features).tolist())} == {OTHER}
    (tmp_path / "effect_model.safetensors").unlink()
    assert painted_world(tmp_path / "world.toml").painter is None
