"""The guided tour, without a browser: each card does what it says, and says what came of it."""

import pytest
from studio_pages import session_on, shipped_library, wait_for, workers

from neurosym.studio.guide import Guide
from neurosym.studio.tour import CARDS, Deed


@pytest.fixture(scope="module")
def both():
    with workers() as started:
        yield started


@pytest.fixture
def guide(both):
    with session_on(shipped_library(), both) as session:
        session.running.set_speed(0.0)
        yield Guide(session, lambda: session.problem.object_names[0])


def at(guide: Guide, deed: Deed) -> str:
    """Turn to a card, press its button, and return what it tells when it is over."""
    guide.turn([card.deed for card in CARDS].index(deed) - guide.number)
    word = guide.session.word
    guide.act()
    wait_for(lambda: guide.session.word is not word and not guide.is_busy)
    return guide.told()


def test_interaction_tells_how_the_object_moved(guide):
    assert "The object hangs from the hand: it moved " in at(guide, Deed.EXPERIENCE)
    assert " mm" in at(guide, Deed.EFFECT)


def test_other_objects_are_drawn_each_time_and_told_by_their_categories(guide):
    at(guide, Deed.CATEGORY)
    wait_for(lambda: len(guide.session.problem.objects) == 4)
    first = guide.session.problem
    assert not guide.session.complaints()
    assert not first.goals
    told = guide.told()
    assert all(item.name in told and item.category in told for item in first.objects)
    guide.act()
    wait_for(lambda: guide.session.problem.name != first.name)


def test_what_is_surest_is_told_beside_what_happened_and_what_is_less_sure_too(guide):
    sure, other = at(guide, Deed.PRIMITIVE), at(guide, Deed.OPERATOR)
    chances = [int(told.split(" sure")[0].split()[-1].rstrip("%")) for told in (sure, other)]
    assert chances[0] > chances[1]
    assert ": it moved " in sure


def test_motion_that_was_tried_leaves_the_table_as_it_was_when_the_card_is_turned(guide):
    at(guide, Deed.PRIMITIVE)
    assert guide.session.running.seen
    guide.turn(1)
    assert not guide.session.running.seen


def test_plan_is_for_two_objects_told_step_by_step_and_run_to_its_end(guide):
    guide.turn(len(CARDS))
    assert not guide.can_act, "there is nothing to run"
    guide.turn(-len(CARDS))
    told = at(guide, Deed.PLAN)
    assert len(guide.session.problem.objects) == 2
    assert "1. " in told
    assert "This was the tour." in at(guide, Deed.RUN)
    assert guide.session.running.run.reached


def test_what_is_at_work_is_stopped_from_the_card(guide):
    guide.turn([card.deed for card in CARDS].index(Deed.EXPERIENCE) - guide.number)
    guide.session.running.set_speed(0.2)
    guide.act()
    wait_for(lambda: guide.session.running.seen)
    guide.stop()
    wait_for(lambda: not guide.is_busy)
