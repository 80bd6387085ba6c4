"""Recipes of the final fit: what is descended is what was meant, and what is taught gets into the bits."""

from dataclasses import replace

import numpy as np
from toy_learning import toy_data

from neurosym.learning.training import train
from neurosym.learning.training_config import (
    CodingConfig,
    DecoderConfig,
    DirectConfig,
    ModelConfig,
    NamingConfig,
    TeacherConfig,
    TrainingConfig,
)

TABLE = {"table_actions": 300, "table_objects": 32, "table_restarts": 3}
SMALL_FIT = TrainingConfig(
    epochs=20,
    batch=128,
    teacher=TeacherConfig(DirectConfig(hidden=64), epochs=40, batch=128),
    naming=NamingConfig(**TABLE, actions=4000, objects=600, starts=1, steps=400, batch=96),
    coding=CodingConfig(actions=128, objects=8, steps=100),
    decoder=DecoderConfig(imagined=4000, imagined_epochs=15, epochs=15),
)
"""Learns the toy world well enough, in a few seconds."""


def test_taught_bits_say_more_than_those_of_the_joint_fit_and_every_code_is_used():
    data, network = toy_data(1200), ModelConfig(hidden=64)
    taught = train(data, config=SMALL_FIT, model_config=network, seed=0)
    joint = train(data, config=replace(SMALL_FIT, recipe="joint"), model_config=network, seed=0)
    assert taught.report.r2_through_codes > joint.report.r2_through_codes + 0.2
    assert taught.report.r2_direct == joint.report.r2_direct
    assert taught.report.share > 0.7
    symbols = np.array(taught.model.action_symbols(data.actions))
    assert len(set(symbols)) == 8
    assert len(set(taught.model.object_symbols(data.features))) == 4
    pushes = direction_of_pushes(data.actions)
    favourites = {}
    for push in range(4):
        names, counts = np.unique(symbols[pushes == push], return_counts=True)
        assert counts.max() > 0.7 * counts.sum()
        favourites[push] = names[counts.argmax()]
    assert len(set(favourites.values())) == 4


def test_decoder_expects_what_actions_do_that_nobody_chose_for_their_effect():
    """Nine of ten pushes that would move something are left out of the data."""
    every, test = toy_data(3000)[:2000], toy_data(3000)[2000:]
    moved = np.abs(every.effects).sum(1) > 0
    rare = np.random.default_rng(0).uniform(size=len(every)) < 0.1
    chosen = every[~moved | rare]
    errors, direct = {}, None
    for source in ("imagined", "data"):
        config = replace(
            SMALL_FIT,
            teacher=replace(SMALL_FIT.teacher, epochs=20),
            coding=replace(SMALL_FIT.coding, steps=30),
            decoder=replace(SMALL_FIT.decoder, learns_from=source),
        )
        trained = train(chosen, config=config, model_config=ModelConfig(hidden=64), seed=0, direct=direct)
        direct = trained.direct
        mean, _ = trained.model.predict_from_codes(test.features, test.actions)
        errors[source] = np.mean((mean - test.effects) ** 2)
    assert errors["imagined"] < errors["data"]


def direction_of_pushes(actions):
    """Number the direction of each push by the rules of the toy world; -1 for what is none."""
    waypoints = actions.reshape(-1, 3, 4)
    travels = waypoints[:, 2, :2] - waypoints[:, 0, :2]
    axes = np.abs(travels).argmax(1)
    along = travels[np.arange(len(travels)), axes]
    is_lift = (waypoints[:, 0, 3] >= 0.5) & (waypoints[:, 2, 3] < 0.5)
    return np.where(is_lift | (np.abs(along) < 0.02), -1, 2 * axes + (along > 0))
