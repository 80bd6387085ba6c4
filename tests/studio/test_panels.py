"""What a page draws and says: meshes, labels, drags, tables in which nothing is markup, and the tour."""

import re
from contextlib import contextmanager

import numpy as np
import pytest
from places import SHIPPED
from studio_pages import page_on, session_on, shipped_library, wait_for

from neurosym.contract import Part
from neurosym.execution.record import Replanning, Run
from neurosym.files import read_json
from neurosym.planners import PlanStatus
from neurosym.stages.plan_records import PlanRecord
from neurosym.studio import words
from neurosym.studio.panels import TablePanel
from neurosym.studio.plan_words import lanes, lines_of, pddl_page, plan_list
from neurosym.studio.tour import CARDS, TourPanel
from neurosym.studio.view import Grab, circle, mesh_of, rectangle
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep
from neurosym.world import Palette

PARTS = [
    (Part("box", (0.1, 0.2, 0.3)), 0.006),
    (Part("cylinder", (0.1, 0.4)), np.pi * 0.01 * 0.4),
    (Part("sphere", (0.1,)), 4 / 3 * np.pi * 0.001),
]


@pytest.mark.parametrize(("part", "volume"), PARTS, ids=[part.kind for part, _ in PARTS])
def test_mesh_is_closed_and_encloses_the_volume_of_its_body(part, volume):
    mesh = mesh_of([part])
    assert mesh.is_watertight
    assert volume * 0.9 < mesh.volume <= volume * 1.0001  # positive, since all faces look outwards


def test_parts_stand_where_they_are_put_and_are_one_mesh_and_outlines_are_closed():
    half = (0.0, 0.0, np.sin(np.pi / 4), np.cos(np.pi / 4))  # a quarter turn
    box = Part("box", (0.2, 0.1, 0.1), (1.0, 2.0, 3.0), half)
    assert np.allclose(mesh_of([box]).bounds[1], [1.05, 2.1, 3.05])
    both = mesh_of([box, Part("sphere", (1.0,))])
    assert np.allclose(both.bounds, [[-1.0, -1.0, -1.0], [1.05, 2.1, 3.05]], atol=0.02)
    assert both.faces.max() == len(both.vertices) - 1
    for lines in (circle(0.05, 0.0), rectangle(0.1, 0.2, 0.0)):
        assert np.allclose(lines[:, 1], np.roll(lines[:, 0], -1, axis=0))


def test_pointer_that_moves_over_the_table_moves_what_was_grabbed_by_as_much():
    eye = (1.5, 0.0, 1.0)
    grab = Grab(eye, (0.6, 0.0, 0.1), (0.58, 0.02, 0.04))
    ahead = np.array(eye) + 0.3 * (np.array([0.7, 0.1, 0.1]) - eye)  # anywhere on the line of sight
    assert grab.to(ahead) == pytest.approx((0.68, 0.12))
    for point in ((1, 0, 1), (1, 0, 2)):  # lines of sight that miss the level
        assert Grab((0, 0, 1), (0, 0, 0), (0, 0, 0)).to(point) is None


EVIL = '<img src=x onerror="alert(1)">'
LIBRARY = shipped_library()


@pytest.mark.parametrize(
    "told",
    [
        words.replanning_list([Replanning(2, EVIL, (), EVIL)]),
        words.plan_summary(PlanRecord("a", EVIL, PlanStatus.FAILED, (), 0.1, EVIL)),
        words.table([EVIL], [], label=EVIL),
        words.paragraph(EVIL, "red", head=EVIL, more=EVIL),
        words.twofold(EVIL, EVIL),
    ],
)
def test_what_comes_from_outside_is_never_markup(told):
    assert words.safe(EVIL) == "&lt;img src=x onerror=&quot;alert(1)&quot;&gt;"
    assert "\x1b" not in words.safe("\x1b[31m")
    assert "<img" not in told
    assert "&lt;img" in told


def test_plans_and_runs_are_told_with_their_steps_and_promises():
    record = read_json(LIBRARY.folder / "plans" / "task-06.fast-downward.json", PlanRecord)
    steps = [PlanStep(*step) for step in record.steps]
    lines = lines_of(steps, understand(LIBRARY.load_problem("task-06"), LIBRARY.grounding))
    told = plan_list(lines, Palette(), at=1)
    assert all(operator in told and name in told for operator, name, *_ in record.steps)
    assert told.count('aria-current="step"') == 1
    put_down = PlanStep(f"put-down-{steps[1].operator}", steps[1].object)
    (both,) = lines_of([steps[1], put_down], understand(LIBRARY.load_problem("task-06"), LIBRARY.grounding))
    assert both.said.startswith("lift item-01, put it down ")
    side_by_side = lanes({"a": lines, "b": (lines[0], both)}, Palette(), "a")
    assert "they part at step 2" in side_by_side
    assert side_by_side.count(steps[0].operator) == 1
    assert "they are the same" in lanes({"a": lines, "b": lines}, Palette(), "a")
    marked = pddl_page(LIBRARY.grounding, "push", "(push item-01)", "step 1").partition("<mark ")[2]
    assert marked.partition(">")[2].lstrip().startswith("(:action push ")
    run = read_json(LIBRARY.folder / "runs" / "task-06.fast-downward.run.json", Run)
    assert words.run_table(run.steps).count("as promised") == sum(step.as_promised for step in run.steps)


@contextmanager
def shown(library, both):
    """The panels of a page that nobody looks at, by their kinds."""
    with session_on(library, both) as session, page_on(session) as page:
        session.running.steer(speed=0.0)
        yield {type(panel): panel for panel in page.panels}


@pytest.fixture
def tour(both):
    with shown(LIBRARY, both) as panels:
        yield panels[TourPanel]


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_each_card_does_what_it_says_and_can_be_stopped(tour):
    session, said = tour.session, []
    session.running.steer(speed=0.2)
    tour.act()
    wait_for(lambda: session.running.seen)
    tour.stop()
    wait_for(lambda: not session.running.is_active)
    session.running.steer(speed=0.0)
    for number, card in enumerate(CARDS, start=1):
        assert f"{number} of {len(CARDS)}: {card.title}" in tour.text()
        assert "{" not in tour.text()
        before = session.word
        tour.act()
        wait_for(lambda before=before, card=card: not card.button or session.word is not before)
        wait_for(lambda: not (session.running.is_active or session.planning))
        said.append(session.word.text)
        tour.turn(1)
    recalled, widened, drawn, performed, planned, ran = said
    assert "; the effect is" in recalled
    assert re.search(r" is \d+ mm wider now, \d+ mm: it turns from [01]+ to [01]+$", widened)
    assert drawn == "a task with 3 objects is on the table"
    assert performed.startswith("it ended ")
    assert "found a plan of" in planned
    assert "goal reached" in ran
    assert session.running.run.reached
    tour.act(is_more=True)
    wait_for(lambda: len(session.running.tries) == 10 and not session.running.is_active)
    assert 0.2 < session.running.promise.chance < 0.8
    assert re.search(r": \d+ of 10 as promised; promised ", session.word.text)


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_page_begins_with_a_tower_where_relations_are_known_and_a_card_asks_for_another(both):
    assert len(LIBRARY.first_problem.objects) == 3
    with shown(shipped_library(SHIPPED.with_name("towers")), both) as panels:
        tour, session = panels[TourPanel], panels[TourPanel].session
        (top, middle, _), (below, *_) = session.problem.relations
        assert below in (top, middle)
        assert len(tour.cards) == len(CARDS) + 1
        tour.turn(99)
        assert "Pairs of objects have bits" in tour.text()
        before = session.problem.relations
        tour.act()
        assert session.problem.relations != before
        assert re.fullmatch(r"goal: item-\d+ (on|in|leaning on) item-\d+", session.word.text)


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_place_on_the_map_is_the_size_of_the_object_and_decides_its_bits(both):
    with shown(LIBRARY, both) as panels:
        field, page, atlas = panels[TablePanel].map, panels[TablePanel].page, LIBRARY.atlas
        assert [atlas.features[number].word for number in atlas.axes] == ["width", "depth"]
        marks = atlas.map(page.item.features).marks
        for code, mark in marks.items():
            ends = [(axis.low, axis.high) for axis in (atlas.features[number] for number in atlas.axes)]
            spot = [low + share * (high - low) for (low, high), share in zip(ends, mark, strict=True)]
            field.take(" ".join(map(str, spot)))
            assert page.item.category == code
            assert page.item.features[1] == pytest.approx(spot[0], abs=6e-4)
        assert len(marks) > 2
        before = page.item
        for told in ("0.05", "0.05 nan", "0.05 x", "0.05 9"):
            field.take(told)
        assert page.item == before
        assert page.session.word.text == "item-01 has depth = 9 m; valid: 0.03 to 0.18 m."
        page.session.aim("item-01", *before.position[:2], 5.0)  # said beside the field, too
        wait_for(lambda: "the goal of item-01 is 5 m high" in panels[TablePanel]._wrong.content)


def test_paths_are_told_as_names_of_files_and_relations_in_words():
    for path in ("/home/ann/x/world.toml", r"C:\Users\ann\world.toml", "/tmp/a b/c/world.toml"):
        assert words.nameless(f"{path}: it is no 1/2 of /", "/tmp/a b/c") == "world.toml: it is no 1/2 of /"
    assert "/home" not in words.paragraph("cannot read '/home/ann/x/y.npz'", head="/home/ann/")
    assert words.three_numbers((0.057, -0.09, 0.0)) == "57 mm forward, 90 mm right, 0 mm up"
    assert words.relation_in_words("rests-on-011") == ("on", "011")
    assert words.relation_in_words("apart-from-000") == ("apart from", "000")
    assert "Goal: a in b " in words.goals_in_words([("a", "b", "sits-in-111")])
