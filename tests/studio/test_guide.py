"""The guided tour, without a browser: each card does what it says, and says what came of it."""

import dataclasses
from types import SimpleNamespace

import pytest
from studio_pages import session_on, shipped_library, wait_for, workers

from neurosym.execution.record import Replanning
from neurosym.planners import PLANNERS, PlanStatus
from neurosym.stages.plan_records import PlanRecord
from neurosym.studio import asking
from neurosym.studio.guide import Guide
from neurosym.studio.messages import Drawn, Failed, Performed, Planned
from neurosym.studio.telling import replanned
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


class Held:
    """In the place of processes: the test answers what was handed in last."""

    def submit(self, job, tell):
        """Keep the job; whoever stops it hears so at once."""
        self.job, self.tell = job, tell
        return SimpleNamespace(place=0, say=lambda _: None, stop=lambda: tell(Failed("It was stopped.")))


@pytest.fixture
def held(guide, monkeypatch) -> Held:
    made = Held()
    monkeypatch.setattr(guide.session, "_planners", made)
    monkeypatch.setattr(guide.session.running, "_workers", made)
    return made


def turn_to(guide: Guide, deed: Deed) -> None:
    guide.turn([card.deed for card in CARDS].index(deed) - guide.number)


def found(*steps: tuple[str, ...], status=PlanStatus.SOLVED, reason="", chance=None) -> Planned:
    """What a planner answers."""
    record = PlanRecord("task-01", "fast-downward", status, steps, 0.1, reason, chance)
    return Planned(record, "task-01.plan" if steps else "")


def at(guide: Guide, deed: Deed) -> str:
    """Turn to a card, press its button, and return what it tells when it is over."""
    turn_to(guide, deed)
    word = guide.session.word
    guide.act()
    wait_for(lambda: guide.session.word is not word and not guide.is_busy)
    return guide.told()


def test_interaction_tells_how_the_object_moved(guide):
    assert "The object hangs from the hand: it moved " in at(guide, Deed.EXPERIENCE)
    assert " mm" in at(guide, Deed.EFFECT)


def test_other_objects_are_drawn_each_time_and_told_by_their_categories(guide):
    at(guide, Deed.CATEGORY)
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
    at(guide, Deed.CATEGORY)
    assert len(guide.session.problem.objects) == 4
    told = at(guide, Deed.PLAN)
    assert len(guide.session.problem.objects) == 2
    assert "1. " in told
    assert "This was the tour." in at(guide, Deed.RUN)
    run = guide.session.running.run
    assert run.reached
    guide.turn(-1)
    assert guide.session.running.run is run, "a run is kept when the card is turned"
    assert guide.session.running.seen


def test_objects_without_goals_give_way_to_two_with_goals_however_the_card_is_reached(guide, held):
    session = guide.session
    guide.turn(len(CARDS))
    session.remove_goal("item-01")
    guide.turn(-1)
    assert len(session.problem.objects) == 2
    for name in session.problem.object_names:
        session.remove_goal(name)
    guide.act()
    assert len(session.problem.goals) == 2
    assert held.job.problem == session.problem


def test_table_with_a_goal_is_left_as_it_is(guide, held):
    guide.session.aim("item-01", 0.6, 0.1)
    before = guide.session.problem
    turn_to(guide, Deed.PLAN)
    guide.act()
    assert guide.session.problem is before
    assert held.job.problem is before


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        (found(status=PlanStatus.UNSOLVABLE, reason="out of reach"), "No plan was found: out of reach."),
        (found(status=PlanStatus.TIMEOUT), "No plan was found: timeout."),
        (
            found(("push", "item-01"), status=PlanStatus.NEAREST),
            "no plan to the goal, but one that comes near",
        ),
        (
            found(("push", "item-01"), chance=0.0),
            "The plan has 1 step. The chance that all go as promised is 0%",
        ),
        (found(("carry", "item-01", "place-02")), "1. carry item-01 place-02<"),
    ],
)
def test_what_a_planner_found_is_told_as_what_it_is(guide, held, answer, said):
    turn_to(guide, Deed.PLAN)
    guide.act()
    assert guide.is_busy
    held.tell(answer)
    assert said in guide.told()
    assert ("next card" in guide.told()) == bool(answer.plan_file)


def test_page_is_at_work_until_the_last_planner_has_answered(guide, held):
    session, seen = guide.session, []
    session.plan("fast-downward", "bfs")
    session.listen(lambda topic: seen.append((topic, session.is_planning, len(session.plans))))
    held.tell(found(("push", "item-01")))
    assert ("plan", True, 1) in seen
    assert all(is_planning for _, is_planning, _ in seen)
    assert held.job.planner == "bfs"
    held.tell(Failed("too hard"))
    assert not session.is_planning


def test_another_planner_is_asked_if_the_usual_one_is_missing(guide, held, monkeypatch):
    gone = dataclasses.replace(PLANNERS[asking.USUAL], missing=lambda: "not there")
    monkeypatch.setattr(asking, "PLANNERS", {**PLANNERS, asking.USUAL: gone})
    turn_to(guide, Deed.PLAN)
    guide.act()
    assert held.job.planner == asking.planners_here()[0] != asking.USUAL


@pytest.mark.parametrize("ends", ["fails", "is stopped", "table is changed", "something runs"])
def test_objects_that_do_not_come_are_not_waited_for(guide, held, ends):
    session = guide.session
    turn_to(guide, Deed.CATEGORY)
    guide.act()
    tell = held.tell
    assert guide.is_busy
    assert "being drawn" in guide.told()
    if ends == "table is changed":
        session.move("item-01", 0.6, 0.0)
    if ends == "something runs":
        session.running.recall(0)
    before = session.problem
    if ends == "is stopped":
        guide.stop()
    else:
        tell(Failed("no room") if ends == "fails" else Drawn(before.within(0.01)))
    assert not session.is_drawing
    assert guide.told() == ""
    assert session.problem is before
    assert session.word.is_bad


def test_categories_are_told_of_what_was_drawn(guide, held):
    turn_to(guide, Deed.CATEGORY)
    guide.act()
    held.tell(Drawn(guide.session.library.load_problem("task-15")))
    told = guide.told()
    assert "item-04" in told
    guide.session.load("task-01")
    assert guide.told() == told


@pytest.mark.parametrize("deed", [Deed.EXPERIENCE, Deed.PRIMITIVE])
def test_only_what_the_card_itself_began_is_told_on_it(guide, held, deed):
    turn_to(guide, deed)
    guide.act()
    held.tell(Performed("resting", (0.1, 0.0, 0.0), None))
    assert "it moved" in guide.told()
    guide.session.running.recall(0)
    held.tell(Performed("lost", (0.2, 0.0, 0.0), None))
    assert guide.told() == ""


def test_what_is_at_work_is_not_disturbed_by_another_press(guide, held):
    guide.act()
    began = guide.session.running.job
    guide.act()
    assert guide.session.word.is_bad
    held.tell(Performed("held", (0.1, 0.0, 0.0), None))
    assert guide.session.running.job == began
    assert "hangs from the hand" in guide.told()


def test_one_motion_that_keeps_an_object_on_the_table_is_enough_for_the_surest(guide, held, monkeypatch):
    session = guide.session
    safe = next(one for one in session.promises("item-01") if guide._stays_on_table("item-01", one))
    for promises, deed, said in (
        ((safe,), Deed.PRIMITIVE, "trying a motion on item-01"),
        ((safe,), Deed.OPERATOR, "No less sure motion that is known keeps an object on the table"),
        ((), Deed.PRIMITIVE, "No motion that is known keeps an object on the table"),
    ):
        monkeypatch.setattr(session, "promises", lambda _, promises=promises: promises)
        turn_to(guide, deed)
        guide.act()
        assert session.word.text.startswith(said)
        if guide.is_busy:
            held.tell(Performed("resting", (0.1, 0.0, 0.0), None))
        else:
            assert guide.told() == ""


def test_empty_table_is_said(guide):
    guide.session.problem = None
    for deed in (Deed.BIT, Deed.PRIMITIVE):
        guide = Guide(guide.session, str)
        turn_to(guide, deed)
        guide.act()
        assert guide.session.word.is_bad
        assert "no object on the table" in guide.session.word.text
        guide.session.say("")


def test_new_plan_that_was_not_found_is_not_told_as_one():
    assert replanned(Replanning(2, "it is too far", (), "out of reach")).startswith("No new plan was found")
    assert replanned(Replanning(2, "it is too far", (("push", "item-01"),), "")).startswith("Planned anew")


def test_what_is_at_work_is_stopped_from_the_card(guide):
    guide.turn([card.deed for card in CARDS].index(Deed.EXPERIENCE) - guide.number)
    guide.session.running.set_speed(0.2)
    guide.act()
    wait_for(lambda: guide.session.running.seen)
    assert guide.is_busy
    guide.stop()
    wait_for(lambda: not guide.is_busy)
    assert guide.can_act
