"""The tour, without a browser: what the button of each card does, and that none is in another's way."""

import pytest
import viser
from studio_pages import session_on, shipped_library, wait_for, workers

from neurosym.studio.page import Page
from neurosym.studio.panel import CARDS, TourPanel

pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning")


@pytest.fixture
def tour():
    with workers() as both, session_on(shipped_library(), both) as session:
        server = viser.ViserServer("127.0.0.1", 0, verbose=False)
        page = Page(server, session)
        session.running.set_speed(0.0)
        yield next(panel for panel in page.panels if isinstance(panel, TourPanel))
        page.close()
        server.stop()


def test_each_card_does_what_it_says_and_the_page_says_what_came_of_it(tour):
    session, said = tour.session, []
    for number, card in enumerate(CARDS, start=1):
        assert f"{number} of {len(CARDS)}: {card.title}" in tour.text()
        assert "{" not in tour.text()
        before = session.word
        tour.act()
        wait_for(lambda before=before, card=card: not card.button or session.word is not before)
        wait_for(lambda: not (session.running.is_active or session.is_planning or session._drawing))
        said.append(session.word.text)
        tour.turn(1)
    recalled, _, drawn, performed, planned, ran = said
    assert "; the effect is" in recalled
    assert drawn == "a task with 2 objects is on the table"
    assert performed.startswith("it ended ")
    assert "found a plan of" in planned
    assert "goal reached" in ran
    assert session.running.run.reached


def test_what_is_at_work_is_stopped_from_the_card(tour):
    tour.session.running.set_speed(0.2)
    tour.act()
    wait_for(lambda: tour.session.running.seen)
    tour.stop()
    wait_for(lambda: not tour.session.running.is_active)
    assert not tour.session.is_planning
