"""`neurosym show` makes things happen again and pictures them."""

import numpy as np
import pytest
from command_line import neurosym, refusal
from PIL import Image

from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pictures.film import STRIP_SIZE, film_row, picture_problem, telling
from neurosym.pictures.motions import Motion, recall_interaction, surest_carriers
from neurosym.sim.tabletop import Tabletop
from neurosym.stages.folder import DomainFolder
from neurosym.stages.planning import load_problem
from neurosym.worlds.toy import ToyConfig, ToyWorld, make_world


def size(path) -> tuple[int, int]:
    with Image.open(path) as image:
        return image.size


def test_interaction_happens_again_to_the_byte(folder, capsys):
    assert neurosym("show", folder, "--interaction", 5) == 0
    said = capsys.readouterr().out
    assert "the effect is the recorded one, byte for byte" in said
    assert f"wrote {folder / 'pictures/interaction-5.png'}" in said
    assert "next: neurosym show" in said
    width, height = size(folder / "pictures/interaction-5.png")
    assert width == 3 * STRIP_SIZE[0]
    assert height > STRIP_SIZE[1]


def test_interaction_that_turns_out_otherwise_is_said_to(folder, capsys):
    data = Interactions.load(folder / "interactions.npz")
    data.effects[5] += 0.01
    data.save(folder / "interactions.npz")
    assert neurosym("show", folder, "--interaction", 5) == 0
    assert "the effect is not the recorded one, but 17.3 mm from it" in capsys.readouterr().out


def test_interaction_of_data_without_a_seed_stands_in_the_middle_of_the_table(folder, capsys):
    data = Interactions.load(folder / "interactions.npz")
    del data.origin["seed"]
    data.save(folder / "interactions.npz")
    motion, is_same = recall_interaction(make_world(), data, 5)
    assert not is_same
    assert motion.scene.positions[0, :2] == pytest.approx([0.7, 0.0])
    assert neurosym("show", folder, "--interaction", 5) == 0
    assert "its scene cannot be drawn again" in capsys.readouterr().out


def test_animation_is_written_when_the_ending_asks_for_one(folder):
    path = folder / "five.gif"
    assert neurosym("show", folder, "--interaction", 5, "--output", path) == 0
    with Image.open(path) as image:
        assert image.n_frames > 1


def test_primitive_is_shown_on_each_category_that_the_domain_promises_something_of(folder, capsys):
    grounding = Grounding.load(folder / "grounding.json")
    symbol = grounding.live[0].primitive
    assert neurosym("show", folder, "--primitive", symbol) == 0
    said = capsys.readouterr().out
    promised = [operator.name for operator in grounding.live if operator.primitive == symbol]
    assert all(name in said for name in promised)
    rows = size(folder / f"pictures/primitive-{symbol}.png")[1] / STRIP_SIZE[1]
    assert len(promised) < rows < 1.2 * len(promised)


def test_an_action_of_a_symbol_is_shown_on_the_categories_that_it_is_for(folder, capsys):
    grounding = Grounding.load(folder / "grounding.json")
    label = next(operator.label for operator in grounding.live if operator.variant)
    assert neurosym("show", folder, "--primitive", label) == 0
    said = capsys.readouterr().out
    for operator in grounding.live:
        assert (f"{operator.name}: " in said) == (operator.label == label)
    assert (folder / f"pictures/primitive-{label}.png").is_file()


def test_operator_that_carries_is_shown_carrying_to_a_place(folder, capsys):
    carrier = surest_carriers(Grounding.load(folder / "grounding.json"))[0]
    assert neurosym("show", folder, "--operator", carrier.name) == 0
    said = capsys.readouterr().out
    x, y, _ = (round(1000 * value) for value in carrier.promise.effect)
    assert f"{carrier.name}: carried, effect ({x}, {y}, 0) mm" in said
    assert (folder / f"pictures/operator-{carrier.name}.png").is_file()


def test_each_category_has_the_surest_carrier_if_most_of_its_objects_can_be_carried(folder):
    grounding = Grounding.load(folder / "grounding.json")
    surest = {one.category: one for one in surest_carriers(grounding)}
    every = [one for one in grounding.places.operators.operators if one.trials]
    for category in {one.category for one in every}:
        best = max(one.successes / one.trials for one in every if one.category == category)
        assert (category in surest) == (best >= 0.5)
        if category in surest:
            assert surest[category].successes / surest[category].trials == best


def test_problem_is_shown_with_its_goals(folder):
    assert neurosym("show", folder, "--problem", "task-02") == 0
    assert size(folder / "pictures/problem-task-02.png")[0] == STRIP_SIZE[0]


def test_same_command_writes_the_same_bytes(folder):
    for name in ("one.png", "two.png"):
        assert neurosym("show", folder, "--interaction", 2, "--output", folder / name) == 0
    assert (folder / "one.png").read_bytes() == (folder / "two.png").read_bytes()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "Name one thing to show: --interaction I, --primitive CODE, --operator NAME or --problem NAME"),
        (["--interaction", "0", "--primitive", "000"], "Name one thing to show"),
        (["--interaction", "1024"], "no interaction 1024; the data have 1024 rows, 0 to 1023"),
        (["--interaction", "-1"], "no interaction -1"),
        (["--primitive", "wave"], "no primitive 'wave'; valid: 0"),
        (["--operator", "wave"], "no operator 'wave'; valid: "),
        (["--problem", "task-99"], "no problem 'task-99'; valid: task-01, task-02"),
        (["--interaction", "0", "--output", "x.jpg"], "x.jpg; name a file that ends in .png or .gif"),
        (["--interaction", "0", "--output", "none/x.png"], "none/x.png; name a file that ends in "),
        (["--interaction", "0", "--gui"], "The toy world has no window"),
        (["--interaction", "0", "--gui", "--output", "x.png"], "leave out --output"),
    ],
)
def test_impossible_request_is_refused_in_one_sentence(folder, arguments, message, capsys):
    assert message in refusal(capsys, "show", folder, *arguments)
    assert not list((folder / "pictures").glob("*"))


@pytest.mark.parametrize(
    ("file", "asked", "writer"),
    [
        ("interactions.npz", ["--interaction", "0"], "explore"),
        ("grounding.json", ["--primitive", "000"], "compile-domain"),
        ("world.toml", ["--problem", "task-01"], "init"),
    ],
)
def test_missing_file_is_refused_with_the_command_that_writes_it(folder, file, asked, writer, capsys):
    (folder / file).unlink()
    assert f"`neurosym {writer} {folder}` writes it" in refusal(capsys, "show", folder, *asked)


def test_world_that_draws_nothing_is_refused(folder):
    class Blind(ToyWorld):
        picture = None

    problem = load_problem(DomainFolder(folder), "task-01")
    with pytest.raises(InvalidValue, match="The toy world draws no pictures"):
        picture_problem(Blind(ToyConfig()), problem, folder / "x.png")


def test_telling_pictures_are_the_first_in_place_and_the_last_of_each_phase():
    phases = ["start", "start", "waypoint 1", "waypoint 1", "rise", "rise", "rise"]
    assert telling(phases) == (2, 3, 6)


def test_strip_of_the_tabletop_shows_every_phase_of_a_lift():
    scene = Tabletop().sample_scene(np.random.default_rng(0), 1)
    scene.features[0] = [0.05, 0.05, 0.05, 0.0]
    scene.positions[0, 2] = 0.025
    lift = np.array([0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0.03, 0], dtype=float)
    world = Tabletop()
    row, outcome = film_row(world, Motion("lift", scene, lift))
    assert outcome.held
    assert row.captions == ("start", "waypoint 1", "waypoint 2", "waypoint 3", "rise", "put down")
    assert all(frame.min() < 100 for frame in row.frames)
    assert world.wanted_pictures is None
