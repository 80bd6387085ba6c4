"""What can be done with pairs is learned in the toy world on the whole way, and compiled into a domain."""

import numpy as np
import pytest
from conftest import LEARN_TOY, learn_shortly

from neurosym.data.interactions import Interactions
from neurosym.formats import PairFile
from neurosym.pair_operators import PairStates
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder, load_scene
from neurosym.stages.problem_making import Asked, problem_stage, sight_of_pairs

STEPS = 160


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> DomainFolder:
    """A folder that went the whole way, with places and pairs."""
    path = tmp_path_factory.mktemp("relations") / "toy"
    few = ["--steps", 256, "--places", 128, "--relations", STEPS, "--rehearsals", 8, "--problems", 0]
    learn_shortly(path, *LEARN_TOY, "--world", "toy-relations", "--seed", 3, "--action-bits", 2, *few)
    return DomainFolder(path)


def test_what_carries_is_tried_with_other_objects_and_brings_pairs_into_states(folder: DomainFolder):
    found = Interactions.load(folder / layout.RELATION_INTERACTIONS)
    assert (len(found), found.features.shape[1]) == (STEPS, 8)
    assert np.mean(found.effects[:, -1]) > 0.1
    assert found.origin["reference"] == "object"
    states = PairStates.load(folder / layout.RELATION_STATES)
    on, apart = states.of((0.1, 1.0, 1.0, 0.0, 0.0)), states.of((1.9, 0.0, 0.0, 0.0, 0.0))
    assert (on.bears, apart.bears) == (True, False)
    assert on.name.startswith("rests-on-")
    table = PairFile.load(folder / layout.RELATION_OPERATORS).table()
    assert max(one.promise.share for one in table.operators if one.promise) > 0.5
    assert len({one.name for one in table.operators}) == len(table.operators)


def test_domain_has_relations_and_problems_say_what_is_foreseen(folder: DomainFolder):
    assert "(:action put " in (folder / layout.DOMAIN).read_text()
    folder.perform(problem_stage(folder, "drawn", Asked(3, seed=1, task="boxes")), again=False)
    problem = load_scene(folder / "problems/drawn.scene.json")
    assert problem.foreseen.keys() <= problem.pairs.keys()
    (folder / layout.RELATION_CHANCES).unlink()
    sight = sight_of_pairs(folder)
    assert sight is not None
    assert sight.chances is None
