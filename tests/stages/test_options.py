"""What is recorded of bits, how many actions `run` aims at places, and what is said of odd problems."""

from pathlib import Path

import msgspec
import pytest
import shipped
import toy_places
from command_line import neurosym
from conftest import RUN_TOY
from places import SHIPPED
from toy_places import grounding

from neurosym.errors import InvalidValue
from neurosym.execution.executor import execute
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.learning import explore_stage, train_stage
from neurosym.stages.planning import remarks_on_number, remarks_on_places
from neurosym.worlds.world_file import read_world

EXPLORING = {"steps": 8, "seed": 0, "regime": "default", "workers": 1}


@pytest.fixture
def empty(tmp_path):
    return DomainFolder(tmp_path)


def trained_with(folder, regime="default", **bits):
    return train_stage(folder, seed=0, regime=regime, **bits).options


def explored_with(folder, strategy, **bits):
    return explore_stage(folder, strategy=strategy, **EXPLORING, **bits).options


def test_bits_of_the_paper_are_not_recorded_and_others_are(empty):
    assert trained_with(empty, object_bits=2, action_bits=3) == {"seed": 0, "regime": "default"}
    assert trained_with(empty, "paper") == {"seed": 0, "regime": "paper"}
    wide = trained_with(empty, object_bits=2, action_bits=5)
    assert wide == {"seed": 0, "regime": "default", "action_bits": 5}
    assert trained_with(empty, "paper", object_bits=1)["object_bits"] == 1


def test_bits_change_what_is_explored_only_where_a_network_with_symbols_is_explored_by(empty):
    for strategy in ("disagreement", "random"):
        assert explored_with(empty, strategy, action_bits=5) == explored_with(empty, strategy)
    assert explored_with(empty, "entropy", action_bits=5)["action_bits"] == 5
    assert "action_bits" not in explored_with(empty, "entropy")


def test_no_fewer_are_aimed_at_places_than_there_are_so_that_nothing_is_done_again(folder: Path, capsys):
    assert RUN_TOY[-2] == "--places"
    assert neurosym("run", folder, *RUN_TOY[:-2]) == 0
    assert ": done" not in capsys.readouterr().out


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--steps", "256"], "with what carries objects to places; give --places a number"),
        (["--world", "toy"], "The world toy takes no object as a reference"),
    ],
)
def test_relations_that_cannot_be_are_refused_before_anything_is_done(tmp_path: Path, capsys, options, said):
    folder = tmp_path / "new"
    assert neurosym("run", folder, *options, "--relations", "64") == 2
    assert said in capsys.readouterr().err
    assert not (folder / "exploration.safetensors").exists()
    assert not (folder / "interactions.npz").exists()


# Of problems that can be planned for, but hardly are what was meant


def test_goals_without_a_place_are_named_where_a_scene_names_places_of_its_own():
    own = msgspec.structs.replace(toy_places.swap(), places={"left": (0.8, 0.1), "park-a": (0.6, 0.2)})
    (remark,) = remarks_on_places(own, grounding())
    assert remark.startswith('none of the "places" lies at the goal of item-02, so nothing is carried there')
    both = msgspec.structs.replace(own, places={"left": (0.8, 0.1), "right": (0.5, -0.1)})
    assert [*remarks_on_places(both, grounding())] == []
    assert [*remarks_on_places(toy_places.swap(), grounding())] == []


def test_other_categories_than_the_network_sees_are_said_and_taken(folder, capsys):
    file = folder / "problems/task-01.scene.json"
    problem = Problem.load(file)
    assert neurosym("new-problem", folder, "--scene", file) == 0
    assert "note" not in capsys.readouterr().out
    right = problem.objects[0].category
    wrong = next(code for code in ("00", "01", "10", "11") if code != right)
    item = msgspec.structs.replace(problem.objects[0], category=wrong)
    msgspec.structs.replace(problem, objects=(item, *problem.objects[1:])).save(file)
    note = f"note: item-01 is said to be of category {wrong}; by its features it is of {right}"
    neurosym("plan", folder, "task-01")  # nothing was said yet of a file that was changed here
    assert note in capsys.readouterr().out
    assert neurosym("new-problem", folder, "--name", "task-01", "--scene", file) == 0
    assert note in capsys.readouterr().out
    neurosym("plan", folder, "task-01")
    assert note not in capsys.readouterr().out


def test_more_objects_than_are_simulated_are_said_and_taken():
    folder, problem = shipped.FOLDER, Problem.load(SHIPPED / "problems/task-07.scene.json")
    nine = tuple(msgspec.structs.replace(problem.objects[0], name=f"item-{n}") for n in range(9))
    (remark,) = remarks_on_number(folder, msgspec.structs.replace(problem, objects=nine, goals={}))
    assert remark.startswith("there are 9 objects; the simulator takes at most 8")
    many = msgspec.structs.replace(problem, objects=nine, goals={})
    world = read_world(SHIPPED / "world.toml")()
    with pytest.raises(InvalidValue, match="cannot be executed: there are 9 objects; the simulator takes"):
        execute(world, many, shipped.GROUNDING, ())
    assert [*remarks_on_number(folder, msgspec.structs.replace(problem, objects=nine[:8], goals={}))] == []
