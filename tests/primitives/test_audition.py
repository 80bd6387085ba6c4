"""Choosing among candidates: what is sure and does something wins."""

import numpy as np
import pytest
from toy_learning import foretell, search, some_features

from neurosym.errors import UnknownChoice
from neurosym.operators import Primitive
from neurosym.primitives.audition import CHOICES, audition, choose, lowest_error, shortlist
from neurosym.primitives.rehearsal import rehearsal_sample
from neurosym.worlds.toy import LONGEST_PUSH, WIDEST_GRASP, ToyWorld, make_world
from neurosym.worlds.workers import Task

SHORT = (0.0, -0.005, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.005, 0.0, 0.1)  # too short to push anything
LEFT = (0.0, -0.04, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.04, 0.0, 0.1)
FORWARD = (-0.04, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.04, 0.0, 0.0, 0.1)
LIFT = (0.0, 0.0, 0.0, 0.9, 0.0, 0.0, 0.0, 0.9, 0.0, 0.0, 0.0, 0.1)
RIVALS = (
    Primitive("001", SHORT, 0.001),
    Primitive("001", LEFT, 0.02),
    Primitive("100", LIFT, 0.03),
    Primitive("100", SHORT, 0.002),
)


def by_affordance(features):
    graspable = (features[:, 3] >= 0.5) | (features[:, 1] <= WIDEST_GRASP)
    return tuple(f"{int(g)}{int(p)}" for g, p in zip(graspable, features[:, 0] <= LONGEST_PUSH, strict=True))


def alike(features):
    return ("00",) * len(features)


class Watched(ToyWorld):
    """A toy world that remembers what it was asked to do."""

    asked: list[Task]

    def __init__(self):
        super().__init__(make_world().config)
        self.asked = []

    def interact(self, scene, action, target, **options):  # noqa: D102
        self.asked.append(Task(scene, action, target))
        return super().interact(scene, action, target, **options)


def test_lowest_error_takes_the_nearest_to_the_code_of_each_symbol():
    assert lowest_error(RIVALS) == (RIVALS[0], RIVALS[3])


def test_shortlist_keeps_the_best_few_of_each_symbol_best_first():
    features = some_features()
    few = shortlist(RIVALS, foretell, features, by_affordance, 1)
    assert few == (RIVALS[1], RIVALS[2])
    both = shortlist(RIVALS, foretell, features, by_affordance, 2)
    assert both == (RIVALS[1], RIVALS[0], RIVALS[2], RIVALS[3])


def test_audition_finds_what_works_whatever_was_foretold():
    for groups in (RIVALS, RIVALS[::-1]):
        chosen = audition(search(categorise=by_affordance), groups, objects=12)
        assert [(one.symbol, one.action) for one in chosen] == [("001", LEFT), ("100", LIFT)]


def test_audition_prefers_what_does_the_same_to_every_object_of_a_category():
    groups = (Primitive("0", LEFT, 0.0), Primitive("0", LIFT, 0.0))
    pushable = audition(search(categorise=lambda f: tuple(s[1] for s in by_affordance(f))), groups)
    graspable = audition(search(categorise=lambda f: tuple(s[0] for s in by_affordance(f))), groups)
    assert (pushable[0].action, graspable[0].action) == (LEFT, LIFT)


def test_auditions_are_the_same_for_any_number_of_workers():
    one, two = (
        audition(search(categorise=alike, seed=4, workers=workers), RIVALS, objects=9) for workers in (1, 2)
    )
    assert one == two


def test_auditions_are_on_other_objects_than_rehearsals_and_the_same_for_every_candidate():
    world = Watched()
    told = []
    audition(search((), alike, lambda: world, told, seed=3), RIVALS[:2], objects=5)
    auditioned = [tuple(task.scene.features[0]) for task in world.asked]
    assert auditioned[:5] == auditioned[5:10]
    assert auditioned[10:15] == auditioned[15:]
    assert len(set(auditioned)) == 10  # the second audition is on others
    drawn = rehearsal_sample(world, alike, objects=10, seed=3).scenes["00"]
    rehearsed = {tuple(scene.features[0]) for scene in drawn}
    assert not rehearsed & set(auditioned)
    assert told == [(n, 20) for n in range(1, 21)]


class Lucky(ToyWorld):
    """A toy world in which `SHORT` does something while the first audition lasts."""

    def __init__(self):
        super().__init__(make_world().config)
        self.performed = 0

    def interact(self, scene, action, target, **options):  # noqa: D102
        self.performed += 1
        lucky = tuple(action) == SHORT and self.performed <= 2 * 12
        return super().interact(scene, np.array(FORWARD) if lucky else action, target, **options)


def test_who_shone_by_luck_is_found_out_by_the_second_audition():
    groups = (Primitive("0", SHORT, 0.0), Primitive("0", LEFT, 0.0))
    world = Lucky()
    assert audition(search((), by_affordance, lambda: world), groups, objects=12)[0].action == LEFT
    assert world.performed == 4 * 12


def test_without_a_world_the_choice_rests_on_what_is_foretold():
    options = {"predict": foretell, "features": some_features(), "categorise": by_affordance, "seed": 0}
    for choice in ("predictable", "own"):
        assert choose(RIVALS, choice, world_factory=None, **options).primitives == (RIVALS[1], RIVALS[2])
    chosen = choose(RIVALS, "lowest-error", world_factory=None, **options)
    assert chosen.primitives == (RIVALS[0], RIVALS[3])


def test_the_world_has_the_last_word():
    def wrong(features, actions):
        return 0.1 * np.abs(actions[:, 5:8] - 0.1)  # SHORT as good as LEFT, which comes later

    options = {"features": some_features(), "categorise": by_affordance, "seed": 0, "workers": 1}
    for factory, best in ((make_world, RIVALS[1]), (None, RIVALS[0])):
        chosen = choose(RIVALS, "predictable", predict=wrong, world_factory=factory, **options)
        assert chosen.primitives[0] == best


def test_unknown_choice_is_refused_with_the_valid_ones():
    with pytest.raises(UnknownChoice, match="no choice 'luck'; valid: lowest-error, own, predictable"):
        choose(
            RIVALS,
            "luck",
            predict=foretell,
            features=some_features(2),
            categorise=alike,
            world_factory=None,
            seed=0,
        )
    assert set(CHOICES) == {"own", "predictable", "lowest-error"}
