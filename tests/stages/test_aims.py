"""A fourth aim is one value, which the same three stages explore, train and distil: the table's middle."""

from dataclasses import dataclass
from functools import partial

import numpy as np
import pytest

from neurosym.commands.learn import init
from neurosym.data.interactions import Interactions
from neurosym.data.origin import Dimensions
from neurosym.errors import InvalidValue
from neurosym.learning.losses import reproducible
from neurosym.learning.network import EffectModel
from neurosym.learning.training_config import ModelConfig
from neurosym.operators import OperatorTable
from neurosym.primitives.operator_search import choose_carriers, measured
from neurosym.primitives.rehearsal import Method
from neurosym.stages import folder as domain_folder
from neurosym.stages.folder import DomainFolder
from neurosym.stages.learning import Aim, distill_stage, explore_stage, train_stage
from neurosym.world import Place, World, WorldFactory
from neurosym.worlds.aims import PLACE_AXES, Aimed, AimedScene
from neurosym.worlds.toy import make_world


class Middle(Aimed):
    """A world in which every action is aimed at the middle of the table."""

    __module__ = "neurosym.worlds.middle"  # where it would be: it is not checked like a user's world

    def sample_scene(self, rng: np.random.Generator, objects: int) -> AimedScene:
        """Draw objects alone."""
        scene, table = self._world.sample_scene(rng, objects), self._world.table
        middle = Place(sum(table.x) / 2, sum(table.y) / 2)
        return AimedScene(scene.features, scene.positions, scene.orientations, middle)


@dataclass(frozen=True)
class MiddleFactory:
    """Makes such worlds."""

    plain: WorldFactory

    def __call__(self) -> World:
        """Make a world."""
        return Middle(self.plain())


METHOD = Method(MiddleFactory, partial(choose_carriers, crowd=MiddleFactory), measured)
TO_MIDDLE = Aim(
    lambda _, __: METHOD,
    "middle/operators.json",
    "middle",
    reference="place",
    axes=PLACE_AXES,
    bits=(1, 2),
    adapt=lambda _, factory: MiddleFactory(factory),
    origin={"reference": "place", "where": "middle"},
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> DomainFolder:
    """A folder in which that was explored, trained and distilled."""
    path = tmp_path_factory.mktemp("aims") / "toy"
    init(path, world="toy")
    with reproducible(1):
        EffectModel(Dimensions(4, 12, 3, (3, 7, 11)), ModelConfig(2, 3)).eval().save(
            path / "effect_model.safetensors"
        )
    domain, learning = DomainFolder(path), {"seed": 3, "regime": "quick"}
    for stage in (
        explore_stage(domain, TO_MIDDLE, strategy="random", steps=240, workers=1, **learning),
        train_stage(domain, TO_MIDDLE, **learning),
        distill_stage(domain, TO_MIDDLE, objects=6, seed=3, workers=1),
    ):
        assert stage.name.endswith("-middle")
        domain.perform(stage, again=True)
    return domain


def test_a_fourth_aim_has_data_and_networks_of_its_own(folder: DomainFolder):
    data = Interactions.load(folder / "middle/interactions.npz")
    assert (data.effects.shape, data.origin["where"]) == ((240, PLACE_AXES), "middle")
    assert EffectModel.load(folder / "middle/effect_model.safetensors").dimensions.effects == PLACE_AXES
    assert not (folder / "interactions.npz").exists()


def test_what_makes_it_anew_is_the_same_command_for_every_aim(folder: DomainFolder):
    assert domain_folder._command(folder.path, "train-middle", TO_MIDDLE.file("training.json")) == (
        f"neurosym train {folder.path}"
    )


def test_something_carries_objects_to_the_middle(folder: DomainFolder):
    table = OperatorTable.load(folder / TO_MIDDLE.table)
    best = max(table.operators, key=lambda one: one.successes)
    assert best.promise is not None
    assert best.promise.kind == "carried"


def test_a_world_that_cannot_be_acted_on_so_is_refused(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("neurosym.stages.learning.references_of", lambda _: ())
    with pytest.raises(InvalidValue, match=r"takes no place as a reference.*leave out --middle"):
        TO_MIDDLE.check_takes(make_world())
