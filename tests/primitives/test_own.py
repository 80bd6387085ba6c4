"""Categories have actions of their own where those do better, and keep the shared one where it adds."""

from contextlib import contextmanager
from dataclasses import replace

import numpy as np
import pytest
from toy_learning import foretell, search, some_features

from neurosym.operators import Primitive, name_operator
from neurosym.primitives import audition
from neurosym.primitives.audition import choose, choose_own, shortlist_own
from neurosym.primitives.rehearsal import rehearse, tabulate
from neurosym.primitives.sampling import Repertoire, repertoire_of, shared_by_all, with_own
from neurosym.world import Outcome, Scene
from neurosym.worlds.toy import LONGEST_PUSH, WIDEST_GRASP, ToyWorld, make_world

SHORT = (0.0, -0.005, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.005, 0.0, 0.1)  # too short to push anything
LEFT = (0.0, -0.04, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.04, 0.0, 0.1)
FORWARD = (-0.04, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.04, 0.0, 0.0, 0.1)
LIFT = (0.0, 0.0, 0.0, 0.9, 0.0, 0.0, 0.0, 0.9, 0.0, 0.0, 0.0, 0.1)
NAMES = make_world().feature_names
EDGE = (0.0, -0.04, 0.0, 0.1, 0.0, 0.0, 0.02, 0.1, 0.0, 0.04, 0.0, 0.1)
PUSHING, LIFTING, DOING_NOTHING = (Primitive("0", action, 0.01) for action in (LEFT, LIFT, SHORT))


def by_affordance(features):
    graspable = (features[:, 3] >= 0.5) | (features[:, 1] <= WIDEST_GRASP)
    return tuple(f"{int(g)}{int(p)}" for g, p in zip(graspable, features[:, 0] <= LONGEST_PUSH, strict=True))


def alike(features):
    return ("0",) * len(features)


def pushable(features):
    return tuple(f"{int(p)}" for p in features[:, 0] <= LONGEST_PUSH)


def chosen(candidates, shared, categorise=by_affordance, factory=make_world, **options):
    return choose_own(search(candidates, categorise, factory, **options), shared, factory)


def actions_of(repertoire, category):
    return [one.action for one in repertoire.primitives if repertoire.serves(one, category)]


class Cliff(ToyWorld):
    """A toy world in which a push goes farther if waypoint 2 is high, and nowhere if just above."""

    def interact(self, scene, action, target, **options):  # noqa: D102
        moved = np.array(action) if action[6] <= 0.0201 else np.array(SHORT)
        outcome = super().interact(scene, moved, target, **options)
        return farther(outcome, 1.5 if action[6] > 0.015 else 1.0)


def make_cliff():
    return Cliff(make_world().config)


def farther(outcome: Outcome, times: float) -> Outcome:
    moved = outcome.start.positions + times * (outcome.end.positions - outcome.start.positions)
    end = Scene(outcome.end.features, moved, outcome.end.orientations)
    return replace(outcome, lifted=end, end=end, lost=False)


class Turning(ToyWorld):
    """A toy world in which what is pushed forward turns round."""

    def interact(self, scene, action, target, **options):  # noqa: D102
        outcome = super().interact(scene, action, target, **options)
        if outcome.effect[0] > 0.01:
            end = replace(outcome.end, orientations=np.array([[0.0, 0.0, 1.0, 0.0]]))
            return replace(outcome, end=end)
        return outcome


def test_each_category_gets_the_action_that_does_best_there():
    found = chosen([LIFTING, PUSHING, DOING_NOTHING], [DOING_NOTHING])
    assert actions_of(found, "01") == [LEFT]
    assert actions_of(found, "10") == [LIFT]
    assert found.primitives[0] == DOING_NOTHING  # the shared one stays, though nothing is done with it
    assert [one.label for one in found.primitives] == ["0", "0a", "0b"]


def test_the_shared_action_stays_where_it_is_best_and_where_it_does_something_else():
    found = chosen([LIFTING, PUSHING], [PUSHING])
    assert actions_of(found, "01") == [LEFT]
    assert actions_of(found, "10") == [LIFT]
    assert sorted(actions_of(found, "11")) == sorted([LEFT, LIFT])
    assert [one.label for one in found.primitives] == ["0", "0a"]


def test_the_shared_action_does_not_stay_if_another_symbol_does_the_same():
    other = Primitive("1", LEFT, 0.0)
    found = chosen([LIFTING, PUSHING, other], [PUSHING, other])
    assert sorted(one.label for one in found.primitives if found.serves(one, "11")) == ["0a", "1"]


def test_an_action_on_an_edge_is_demoted_because_its_performances_are_moved(monkeypatch):
    safe, edge = PUSHING, Primitive("0", EDGE, 0.0)
    for candidates, shared in (([safe, edge], [safe]), ([edge, safe], [edge])):
        found = chosen(candidates, shared, pushable, make_cliff, seed=1)
        assert actions_of(found, "1")[0] == LEFT
    monkeypatch.setattr(audition, "MOVED", 0.0)
    found = chosen([safe, edge], [safe], pushable, make_cliff, seed=1)
    assert EDGE in actions_of(found, "1")


def test_an_action_that_turns_objects_is_passed_over():
    forward = Primitive("0", FORWARD, 0.0)
    turning = chosen([forward, PUSHING], [forward], pushable, lambda: Turning(make_world().config))
    assert actions_of(turning, "1") == [LEFT]
    assert FORWARD in actions_of(chosen([forward, PUSHING], [forward], pushable), "1")


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


def test_own_actions_are_the_same_for_any_number_of_workers():
    found = [chosen([LIFTING, PUSHING, DOING_NOTHING], [PUSHING], workers=workers) for workers in (1, 2)]
    assert found[0] == found[1]
    tables = [
        tabulate(rehearse(make_world, found[0], by_affordance, objects=9, seed=2, workers=workers), NAMES)
        for workers in (1, 2)
    ]
    assert tables[0] == tables[1]


def test_own_is_what_choose_gives_and_what_is_told_counts_performances():
    told = {}

    @contextmanager
    def told_of(label):
        told[label] = []
        yield lambda *numbers: told[label].append(numbers)

    found = choose(
        [LIFTING, PUSHING],
        "own",
        predict=foretell,
        features=some_features(100),
        categorise=by_affordance,
        world_factory=make_world,
        seed=0,
        open_bar=told_of,
    )
    assert {LEFT, LIFT} == {one.action for one in found.primitives}
    assert list(told) == ["auditioning", "auditioning for each category"]
    for numbers in told.values():
        assert numbers == [(done, len(numbers)) for done in range(1, len(numbers) + 1)]


def test_operators_of_a_table_are_named_for_their_actions_the_surest_of_a_pair_first():
    found = with_own([PUSHING], {"10": [LIFTING], "11": [PUSHING, LIFTING], "01": [PUSHING]})
    table = tabulate(rehearse(make_world, found, by_affordance, seed=0), make_world().feature_names)
    pairs = [(op.category, op.label) for op in table.operators]
    assert [pair for pair in pairs if pair[0] != "11"] == [("00", "0"), ("01", "0"), ("10", "0a")]
    both = [op for op in table.operators if op.category == "11"]
    assert [op.label for op in both] == ["0a", "0"]  # a push may lose the object over the edge of the table
    names = {category.symbol: category.name for category in table.categories}
    assert all(op.name == name_operator(op.label, names[op.category], op.modes) for op in table.operators)
    assert len({op.name for op in table.operators}) == len(table.operators)
    assert [one.label for one in table.primitives] == ["0", "0a"]
    assert table.symbols == ("0",)
    assert table.format == "neurosym-primitives-2"


@pytest.mark.parametrize("repertoire", [shared_by_all([LIFTING]), with_own([PUSHING], {"11": [LIFTING]})])
def test_repertoire_of_a_table_is_the_one_it_was_made_with(repertoire):
    table = tabulate(rehearse(make_world, repertoire, by_affordance, objects=40, seed=0), NAMES)
    again = repertoire_of(table)
    assert again.primitives == repertoire.primitives
    for category in ("00", "01", "10", "11"):
        assert actions_of(again, category) == actions_of(repertoire, category)


def test_letters_are_shared_by_categories_and_go_on_after_z():
    many = [Primitive("0", (float(number),) * 12, 0.0) for number in range(30)]
    found = with_own([many[0]], {f"{number:05b}": [one] for number, one in enumerate(many)})
    labels = [one.label for one in found.primitives]
    assert sorted(labels) == sorted(
        ["0", *(f"0{letter}" for letter in "abcdefghijklmnopqrstuvwxyz"), "0aa", "0ab", "0ac"]
    )
    same = with_own([PUSHING], {"0": [LIFTING], "1": [LIFTING]})
    assert same == Repertoire((PUSHING, replace_variant(LIFTING, "a")), {"0": ("0a",), "1": ("0a",)})


def replace_variant(primitive, variant):
    return Primitive(primitive.symbol, primitive.action, primitive.code_error, variant)
