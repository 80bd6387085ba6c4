"""Choosing among candidates: what is sure and does something wins, for all categories or for each its own."""

from dataclasses import replace

import numpy as np
import pytest
from toy_learning import (
    FORWARD,
    LEFT,
    LIFT,
    SHORT,
    Changed,
    alike,
    by_affordance,
    foretell,
    search,
    some_features,
)

from neurosym.errors import UnknownChoice
from neurosym.operators import Primitive
from neurosym.primitives.audition import Round, audition, choose, choose_own, shortlist_own
from neurosym.primitives.rehearsal import rehearsal_sample, rehearse, tabulate
from neurosym.primitives.sampling import Repertoire, with_own
from neurosym.world import Outcome, Scene
from neurosym.worlds.toy import LONGEST_PUSH, make_world

RIVALS = (
    Primitive("001", SHORT, 0.001),
    Primitive("001", LEFT, 0.02),
    Primitive("100", LIFT, 0.03),
    Primitive("100", SHORT, 0.002),
)
TWELVE = Round(4, 12), Round(2, 12)


def test_audition_finds_what_works_whatever_was_foretold():
    one, two = (
        audition(search(categorise=by_affordance, workers=workers), groups, rounds=TWELVE)
        for workers, groups in ((1, RIVALS), (2, RIVALS[::-1]))
    )
    assert [(each.symbol, each.action) for each in one] == [("001", LEFT), ("100", LIFT)]
    assert one == two


def test_auditions_are_on_other_objects_than_rehearsals_and_the_same_for_every_candidate():
    auditioned, told = [], []
    world = Changed(lambda scene, action: auditioned.append(tuple(scene.features[0])) or action)
    audition(search((), alike, lambda: world, told, seed=3), RIVALS[:2], rounds=(Round(4, 5), Round(2, 5)))
    assert auditioned[:5] == auditioned[5:10]
    assert auditioned[10:15] == auditioned[15:]
    assert len(set(auditioned)) == 10  # the second audition is on others
    drawn = rehearsal_sample(world, alike, objects=10, seed=3).scenes["0"]
    rehearsed = {tuple(scene.features[0]) for scene in drawn}
    assert not rehearsed & set(auditioned)
    assert told == [(n, 20) for n in range(1, 21)]


def test_who_shone_by_luck_is_found_out_by_the_second_audition():
    groups = (Primitive("0", SHORT, 0.0), Primitive("0", LEFT, 0.0))
    performed = []

    def luck(_, action):  # does something by `SHORT` while the first audition lasts
        performed.append(action)
        return np.array(FORWARD) if tuple(action) == SHORT and len(performed) <= 2 * 12 else action

    assert audition(search((), by_affordance, lambda: Changed(luck)), groups, rounds=TWELVE)[0].action == LEFT
    assert len(performed) == 4 * 12


def test_without_a_world_the_choice_rests_on_what_is_foretold():
    options = {"predict": foretell, "features": some_features(), "categorise": by_affordance, "seed": 0}
    for choice in ("predictable", "own"):
        assert choose(RIVALS, choice, world_factory=None, **options).primitives == (RIVALS[1], RIVALS[2])
    chosen = choose(RIVALS, "lowest-error", world_factory=None, **options)
    assert chosen.primitives == (RIVALS[0], RIVALS[3])
    with pytest.raises(UnknownChoice, match="no choice 'luck'; valid: lowest-error, own, predictable"):
        choose(RIVALS, "luck", world_factory=None, **options)


def test_the_world_has_the_last_word():
    def wrong(features, actions):
        return 0.1 * np.abs(actions[:, 5:8] - 0.1)  # SHORT as good as LEFT, which comes later

    options = {"features": some_features(), "categorise": by_affordance, "seed": 0, "workers": 1}
    for factory, best in ((make_world, RIVALS[1]), (None, RIVALS[0])):
        chosen = choose(RIVALS, "predictable", predict=wrong, world_factory=factory, **options)
        assert chosen.primitives[0] == best


EDGE = (0.0, -0.04, 0.0, 0.1, 0.0, 0.0, 0.02, 0.1, 0.0, 0.04, 0.0, 0.1)
PUSHING, LIFTING, DOING_NOTHING = (Primitive("0", action, 0.01) for action in (LEFT, LIFT, SHORT))


def pushable(features):
    return tuple(f"{int(p)}" for p in features[:, 0] <= LONGEST_PUSH)


def chosen(candidates, shared, categorise=by_affordance, factory=make_world, **options):
    return choose_own(search(candidates, categorise, factory, **options), shared, factory)


def actions_of(repertoire, category):
    return [one.action for one in repertoire.primitives if repertoire.serves(one, category)]


def make_cliff():
    """A toy world in which a push goes farther if waypoint 2 is high, and nowhere if just above."""
    return Changed(lambda _, action: action if action[6] <= 0.0201 else np.array(SHORT), farther)


def farther(action: np.ndarray, outcome: Outcome) -> Outcome:
    times = 1.5 if action[6] > 0.015 else 1.0
    moved = outcome.start.positions + times * (outcome.end.positions - outcome.start.positions)
    end = Scene(outcome.end.features, moved, outcome.end.orientations)
    return replace(outcome, lifted=end, end=end, lost=False)


def test_each_category_gets_the_action_that_does_best_there():
    found = chosen([LIFTING, PUSHING, DOING_NOTHING], [DOING_NOTHING])
    assert actions_of(found, "01") == [LEFT]
    assert actions_of(found, "10") == [LIFT]
    assert found.primitives[0] == DOING_NOTHING  # the shared one stays, though nothing is done with it
    assert [one.label for one in found.primitives] == ["0", "0a", "0b"]
    assert chosen([LIFTING, PUSHING, DOING_NOTHING], [DOING_NOTHING], workers=2) == found


def test_the_shared_action_stays_where_it_is_best_unless_another_symbol_does_the_same():
    found = chosen([LIFTING, PUSHING], [PUSHING])
    assert actions_of(found, "01") == [LEFT]
    assert actions_of(found, "10") == [LIFT]
    assert sorted(actions_of(found, "11")) == sorted([LEFT, LIFT])
    assert [one.label for one in found.primitives] == ["0", "0a"]
    other = Primitive("1", LEFT, 0.0)
    found = chosen([LIFTING, PUSHING, other], [PUSHING, other])
    assert sorted(one.label for one in found.primitives if found.serves(one, "11")) == ["0a", "1"]


def test_an_action_on_an_edge_is_demoted_because_its_performances_are_moved(monkeypatch):
    safe, edge = PUSHING, Primitive("0", EDGE, 0.0)
    for candidates, shared in (([safe, edge], [safe]), ([edge, safe], [edge])):
        found = chosen(candidates, shared, pushable, make_cliff, seed=1)
        assert actions_of(found, "1")[0] == LEFT
    monkeypatch.setattr("neurosym.primitives.audition.MOVED", 0.0)
    found = chosen([safe, edge], [safe], pushable, make_cliff, seed=1)
    assert EDGE in actions_of(found, "1")


def test_moves_stay_in_the_box_and_leave_the_gripper_alone():
    box, asked = make_world().action_box, []

    def predict(features, actions):
        asked.append(actions)
        return np.zeros((len(features), 4))

    corner = Primitive("0", tuple(box.high.tolist()), 0.0)
    shortlist_own([[corner, PUSHING]], predict, some_features(30), box, 6, 0)
    for action, moved in zip((corner.action, LEFT), np.split(asked[0], 2), strict=True):
        change = moved - np.array(action)
        assert all(map(box.contains, moved))
        assert not np.any(change[:, box.gripper])
        assert np.all(np.any(change[:, ~box.gripper], axis=0))
        assert np.abs(change).max() < 0.005


def test_operators_of_a_table_are_named_for_their_actions_the_surest_of_a_pair_first():
    found = with_own([PUSHING], {"10": [LIFTING], "11": [PUSHING, LIFTING], "01": [PUSHING]})
    table = tabulate(rehearse(make_world, found, by_affordance, seed=0), make_world().feature_names)
    pairs = [(op.subject, op.label) for op in table.operators]
    assert [pair for pair in pairs if pair[0] != "11"] == [("00", "0"), ("01", "0"), ("10", "0a")]
    both = [op for op in table.operators if op.subject == "11"]
    assert [op.label for op in both] == ["0a", "0"]  # a push may lose the object over the edge of the table
    assert len({op.name for op in table.operators}) == len(table.operators)
    assert [one.label for one in table.primitives] == ["0", "0a"]


def test_letters_are_shared_by_categories_and_go_on_after_z():
    many = [Primitive("0", (float(number),) * 12, 0.0) for number in range(30)]
    found = with_own([many[0]], {f"{number:05b}": [one] for number, one in enumerate(many)})
    assert {"0", "0a", "0z", "0aa", "0ab", "0ac"} <= {one.label for one in found.primitives}
    assert len({one.label for one in found.primitives}) == 30
    same = with_own([PUSHING], {"0": [LIFTING], "1": [LIFTING]})
    lifting = Primitive("0", LIFT, 0.01, "a")
    assert same == Repertoire((PUSHING, lifting), {"0": ("0a",), "1": ("0a",)})
