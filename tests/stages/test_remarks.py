"""What is said of problems that can be planned for, but hardly are what was meant."""

from pathlib import Path

import msgspec
import pytest
import toy_places
from command_line import neurosym
from toy_places import grounding

from neurosym.errors import InvalidValue
from neurosym.execution.executor import execute
from neurosym.grounding import Grounding
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.planning import remarks_on_number, remarks_on_places
from neurosym.worlds.world_file import read_world

SHIPPED = Path(__file__).parents[2] / "domains/tabletop"
GROUNDING = SHIPPED / "grounding.json"


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
    folder, problem = DomainFolder(SHIPPED), Problem.load(SHIPPED / "problems/task-07.scene.json")
    nine = tuple(msgspec.structs.replace(problem.objects[0], name=f"item-{n}") for n in range(9))
    (remark,) = remarks_on_number(folder, msgspec.structs.replace(problem, objects=nine, goals={}))
    assert remark.startswith("there are 9 objects; the simulator takes at most 8")
    many = msgspec.structs.replace(problem, objects=nine, goals={})
    world = read_world(SHIPPED / "world.toml")()
    with pytest.raises(InvalidValue, match="cannot be executed: there are 9 objects; the simulator takes"):
        execute(world, many, Grounding.load(GROUNDING), ())
    assert [*remarks_on_number(folder, msgspec.structs.replace(problem, objects=nine[:8], goals={}))] == []
