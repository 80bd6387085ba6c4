"""What can be done with pairs is learned in the toy world, stage by stage, and compiled into a domain."""

from pathlib import Path

import numpy as np
import pytest
import toy_relations

from neurosym.commands.learn import init, run
from neurosym.data.interactions import Interactions
from neurosym.data.origin import Dimensions
from neurosym.errors import NeurosymError
from neurosym.files import write_json
from neurosym.learning.losses import reproducible
from neurosym.learning.network import EffectModel
from neurosym.learning.training_config import ModelConfig
from neurosym.operators import Mode, Operator, Primitive
from neurosym.pair_operators import PairStates, PlaceOperators, RelationOperators
from neurosym.stages.folder import DomainFolder, load_scene
from neurosym.stages.layout import (
    MODEL,
    PLACE_OPERATORS,
    PLACES,
    RELATION_CHANCES,
    RELATION_INTERACTIONS,
    RELATION_OPERATORS,
    RELATION_STATES,
)
from neurosym.stages.learning import TO_OBJECTS, distill_stage, explore_stage, train_stage
from neurosym.stages.problem_making import Asked, problem_stage, sight_of_pairs

STEPS = 160


def with_places(path: Path) -> DomainFolder:
    """Make a folder that knows categories of objects, whichever, and what carries all of them to places."""
    init(path, world="toy-relations")
    with reproducible(1):
        model = EffectModel(Dimensions(4, 12, 3, (3, 7, 11)), ModelConfig(2, 3)).eval()
    model.save(path / MODEL)
    nothing = (0.0, 0.0, 0.0)
    mode = Mode("carried", 20, 1.0, nothing, nothing, nothing, nothing, 0.2, 20)
    table = toy_relations.grounding().places.operators
    operators = tuple(
        Operator(f"carry-to-01-kind-{symbol}", symbol, "01", 20, (mode,))
        for symbol in ("00", "01", "10", "11")
    )
    primitives = (Primitive("01", toy_relations.CARRY, 0.0),)
    (path / PLACES).mkdir()
    places = PlaceOperators(type(table)(table.categories, primitives, operators))
    write_json(path / PLACE_OPERATORS, places)
    return DomainFolder(path)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> DomainFolder:
    """A folder in which pairs were explored, trained on and distilled."""
    domain = with_places(tmp_path_factory.mktemp("relations") / "toy")
    options = {"seed": 3, "regime": "quick"}
    domain.perform(
        explore_stage(domain, TO_OBJECTS, strategy="random", steps=STEPS, workers=1, **options), again=True
    )
    domain.perform(train_stage(domain, TO_OBJECTS, **options), again=True)
    domain.perform(distill_stage(domain, TO_OBJECTS, objects=4, seed=3, workers=1), again=True)
    return domain


def test_what_carries_is_tried_with_other_objects_and_brings_pairs_into_states(folder: DomainFolder):
    found = Interactions.load(folder / RELATION_INTERACTIONS)
    assert (len(found), found.features.shape[1]) == (STEPS, 8)
    assert np.mean(found.effects[:, -1]) > 0.1
    assert found.origin["reference"] == "object"
    states = PairStates.load(folder / RELATION_STATES)
    on, apart = states.of((0.1, 1.0, 1.0, 0.0, 0.0)), states.of((1.9, 0.0, 0.0, 0.0, 0.0))
    assert (on.bears, apart.bears) == (True, False)
    assert on.name.startswith("rests-on-")
    table = RelationOperators.load(folder / RELATION_OPERATORS)
    assert max(one.promise.share for one in table.operators if one.promise) > 0.5
    assert len({one.name for one in table.operators}) == len(table.operators)


@pytest.mark.parametrize(
    ("world", "said"),
    [("toy", "takes no object as a reference"), ("toy-relations", r"effect_model\.safetensors")],
)
def test_what_objects_and_places_are_must_be_known(tmp_path: Path, world: str, said: str):
    init(tmp_path / "toy", world=world)
    domain = DomainFolder(tmp_path / "toy")
    stage = explore_stage(domain, TO_OBJECTS, strategy="random", steps=8, seed=0, regime="quick", workers=1)
    with pytest.raises(NeurosymError, match=said):
        domain.perform(stage, again=True)


def test_whole_way_ends_with_a_domain_of_relations_and_problems_say_what_is_foreseen(tmp_path: Path):
    path = tmp_path / "toy"
    options = {"strategy": "random", "regime": "quick", "seed": 3, "workers": 1, "problems": 0}
    run(path, world="toy-relations", steps=256, places=128, relations=160, **options)
    folder = DomainFolder(path)
    assert "(:action put " in (folder / "domain.pddl").read_text()
    folder.perform(problem_stage(folder, "drawn", Asked(3, seed=1, task="boxes")), again=False)
    problem = load_scene(folder / "problems/drawn.scene.json")
    assert problem.foreseen.keys() <= problem.pairs.keys()
    (folder / RELATION_CHANCES).unlink()
    sight = sight_of_pairs(folder)
    assert sight is not None
    assert sight.chances is None
