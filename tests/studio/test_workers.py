"""Work waits in line, shows its place, is stopped, and a process that dies takes only its own with it."""

import shutil

import pytest
from studio_pages import shipped_library, toy_library, wait_for

from neurosym.studio.messages import Controls, Planned, Seen, Word
from neurosym.studio.session import furnished_room
from neurosym.studio.studio_workers import DIED, STOPPED, Workers, draw, plan, run


@pytest.fixture
def library(tmp_path):
    return toy_library(tmp_path / "toy")


@pytest.fixture
def room(library):
    made = furnished_room(library.folder)
    yield made
    shutil.rmtree(made)


@pytest.fixture
def workers():
    made = Workers(1)
    yield made
    made.close()


def test_line_shows_places_and_gives_up_what_is_stopped(library, room, workers):
    said, given = [[] for _ in range(3)], (library.first_problem(), "counting", False)
    tickets = [workers.submit(heard.append, plan, room, *given) for heard in said]
    assert [ticket.place for ticket in tickets] == [0, 1, 2]
    tickets[1].stop()
    assert said[1] == [Word(STOPPED, is_bad=True)]
    assert tickets[2].place <= 1
    wait_for(lambda: said[0] and said[2])
    assert isinstance(said[2][-1], Planned)


def test_crash_is_told_of_its_run_only_and_a_room_is_written_alone(workers):
    library, said, name = shipped_library(), [], "task-03"
    room = furnished_room(library.folder)
    try:
        assert (room / "domain.pddl").read_bytes() == (library.folder / "domain.pddl").read_bytes()
        assert (room / "problems" / "task-01.scene.json").is_symlink()
        assert not (room / "interactions.npz").exists()
        given = name, f"plans/{name}.fast-downward.plan", "fast-downward", 0, Controls(0.05)
        ticket = workers.submit(said.append, run, room, *given)
        wait_for(lambda: any(isinstance(one, Seen) for one in said))
        ticket._child.process.kill()
        wait_for(lambda: said[-1] == Word(DIED, is_bad=True))
        workers.submit(said.append, draw, room, "drawn", 1, 0, None)
        wait_for(lambda: getattr(said[-1], "name", "") == "drawn")
    finally:
        shutil.rmtree(room)
    assert (library.folder / "domain.pddl").is_file()
