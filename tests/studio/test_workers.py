"""Jobs wait in line, show their place, are stopped, and a process that dies takes only its own with it."""

import pytest
from studio_pages import shipped_library, toy_library, wait_for

from neurosym.studio.messages import Controls, Failed, Make, RunPlan, Seen
from neurosym.studio.session import Room
from neurosym.studio.studio_workers import DIED, STOPPED, Workers


@pytest.fixture
def room(tmp_path):
    made = Room(toy_library(tmp_path / "toy").folder)
    yield made
    made.close()


@pytest.fixture
def workers():
    made = Workers(1)
    yield made
    made.close()


def test_line_shows_places_and_gives_up_what_is_stopped(room, workers):
    problem = toy_library(room.path.parent / "again").first_problem()
    said = [[] for _ in range(3)]
    tickets = [workers.submit(Make(room.path, problem), heard.append) for heard in said]
    assert [ticket.place for ticket in tickets] == [0, 1, 2]
    tickets[1].stop()
    assert said[1] == [Failed(STOPPED)]
    assert tickets[2].place <= 1
    wait_for(lambda: said[0] and said[2])
    assert not isinstance(said[2][-1], Failed)


def test_job_that_cannot_be_done_is_a_sentence_and_the_next_is_done(room, workers):
    said = []
    workers.submit(RunPlan(room.path, "errand", "plans/none.plan", "fast-downward", 0), said.append)
    wait_for(lambda: said)
    assert isinstance(said[0], Failed)
    assert "none.plan" in said[0].sentence
    problem = toy_library(room.path.parent / "again").first_problem()
    workers.submit(Make(room.path, problem), said.append)
    wait_for(lambda: len(said) == 2)
    assert not isinstance(said[1], Failed)


def test_crash_is_told_of_its_job_only(workers):
    room, said, name = Room(shipped_library().folder), [], "task-03"
    try:
        job = RunPlan(room.path, name, f"plans/{name}.fast-downward.plan", "fast-downward", 0, Controls(0.05))
        ticket = workers.submit(job, said.append)
        wait_for(lambda: any(isinstance(one, Seen) for one in said))
        ticket._child.process.kill()
        wait_for(lambda: isinstance(said[-1], Failed))
        assert said[-1].sentence == DIED
        workers.submit(Make(room.path, shipped_library().load_problem(name)), said.append)
        wait_for(lambda: type(said[-1]).__name__ == "Drawn")
    finally:
        room.close()


def test_room_looks_like_the_domain_and_is_written_alone():
    library = shipped_library()
    room = Room(library.folder)
    try:
        assert (room.path / "domain.pddl").read_bytes() == (library.folder / "domain.pddl").read_bytes()
        assert (room.path / "problems" / "task-01.scene.json").is_symlink()
        assert not (room.path / "interactions.npz").exists()
    finally:
        room.close()
    assert not room.path.exists()
    assert (library.folder / "domain.pddl").is_file()
