"""Choosing among candidates: what is sure and does something wins, for all categories or for each its own."""

import numpy as np
import pytest
from toy_learning import (
    LEFT,
    LIFT,
    SHORT,
    Changed,
    by_affordance,
    foretell,
    search,
    some_features,
)

from neurosym.errors import UnknownChoice
from neurosym.operators import Primitive
from neurosym.primitives.audition import choose, choose_own, moved
from neurosym.primitives.rehearsal import rehearse, tabulate
from neurosym.primitives.sampling import Repertoire, with_own
from neurosym.worlds.toy import make_world

RIVALS = (
    Primitive("001", SHORT, 0.001),
    Primitive("001", LEFT, 0.02),
    Primitive("100", LIFT, 0.03),
    Primitive("100", SHORT, 0.002),
)


def test_without_a_world_the_choice_rests_on_what_is_foretold():
    options = {"predict": foretell, "features": some_features(), "categorise": by_affordance, "seed": 0}
    for choice in ("predictable", "own"):
        assert choose(RIVALS, choice, world_factory=None, **options).primitives == (RIVALS[1], RIVALS[2])
    chosen = choose(RIVALS, "lowest-error", world_factory=None, **options)
    assert chosen.primitives == (RIVALS[0], RIVALS[3])
    with pytest.raises(UnknownChoice, match="no choice 'luck'; valid: lowest-error, own, predictable"):
        choose(RIVALS, "luck", world_factory=None, **options)


PUSHING, LIFTING, DOING_NOTHING = (Primitive("0", action, 0.01) for action in (LEFT, LIFT, SHORT))


def chosen(candidates, categorise=by_affordance, factory=make_world, **options):
    return choose_own(search(candidates, categorise, factory, **options), factory)


def actions_of(repertoire, category):
    return [one.action for one in repertoire.primitives if repertoire.serves(one, category)]


def test_each_category_gets_the_action_that_does_best_there():
    found = chosen([LIFTING, PUSHING, DOING_NOTHING])
    assert actions_of(found, "01") == [LEFT]
    assert actions_of(found, "10") == [LIFT]
    assert sorted(one.label for one in found.primitives) == ["0", "0a"]
    assert chosen([LIFTING, PUSHING, DOING_NOTHING], workers=2) == found


def test_symbols_are_chosen_such_that_they_do_different_things():
    other = Primitive("1", LEFT, 0.0)
    found = chosen([LIFTING, PUSHING, other])
    assert sorted(actions_of(found, "11")) == sorted([LEFT, LIFT])


def hopeful(features, actions):
    """Foretell that `SHORT`, too, pushes as far as `LEFT`."""
    asked = np.where(np.all(actions == np.array(SHORT, dtype=actions.dtype), axis=1)[:, None], LEFT, actions)
    return foretell(features, asked)


def test_the_world_has_the_last_word():
    found = chosen([DOING_NOTHING, PUSHING], predict=hopeful)
    assert actions_of(found, "01") == [LEFT]


def test_what_is_foreseen_to_fail_does_not_perform_for_being_chosen():
    performed = []
    world = Changed(lambda _, action: performed.append(tuple(action)) or action)
    chosen([PUSHING, DOING_NOTHING], factory=lambda: world)
    assert performed.count(SHORT) == 0


def test_candidates_perform_on_the_objects_that_the_chosen_are_rehearsed_on_and_that_counts():
    looking = search([PUSHING, LIFTING], by_affordance, objects=40)
    found = choose_own(looking, make_world)
    before = looking.ledger.spent
    rehearsals = rehearse(make_world, found, by_affordance, objects=40, seed=0, ledger=looking.ledger)
    performed = sum(one is not None for row in rehearsals.outcomes for one in row)
    assert 0 < looking.ledger.spent - before < performed
    table = tabulate(rehearsals, make_world().feature_names)
    for one in table.operators:
        assert one.trials == found.times[one.subject, one.label]
        assert len(one.objects or table.category(one.subject).objects) == one.trials


def test_no_more_is_performed_than_the_budget_allows():
    for budget in (0, 20, 60):
        looking = search([PUSHING, LIFTING, DOING_NOTHING], by_affordance, budget=budget)
        found = choose_own(looking, make_world)
        rehearse(make_world, found, by_affordance, seed=0, ledger=looking.ledger)
        assert looking.ledger.spent <= max(budget, len(found.times))  # each is seen once at least


def test_moves_stay_in_the_box_and_leave_the_gripper_alone():
    box = make_world().action_box
    corner = Primitive("0", tuple(box.high.tolist()), 0.0)
    for one in (corner, PUSHING):
        changed = moved(one, 30, box, 0)
        change = changed - np.array(one.action)
        assert all(map(box.contains, changed))
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
