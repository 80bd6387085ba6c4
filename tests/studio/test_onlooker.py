"""What is seen of a motion says at which step it is, and what is said meanwhile is heeded."""

import time

import numpy as np

from neurosym.execution.performance import Moment
from neurosym.execution.record import StepRecord
from neurosym.studio.messages import Controls, Onlooker
from neurosym.studio.view import Reel, step_labels
from neurosym.world import Scene

SCENE = Scene(np.full((1, 4), 0.05), np.array([[0.6, 0.0, 0.025]]), np.array([[0.0, 0.0, 0.0, 1.0]]))


class Speaker(Reel):
    """Says something after some time each [s]."""

    def __init__(self, *words: tuple[float, Controls]):
        super().__init__()
        self.words, self.began = list(words), time.monotonic()

    def poll(self, seconds: float = 0.0, /) -> bool:
        """Say whether it is time for the next word."""
        time.sleep(min(seconds, 0.01))
        return bool(self.words) and time.monotonic() - self.began >= self.words[0][0]

    def recv(self) -> Controls:
        """Return it."""
        return self.words.pop(0)[1]


def held_for(seconds: float, *words: tuple[float, Controls]) -> float:
    """How long it takes to hold what is seen [s]."""
    way = Speaker(*words)
    Onlooker(way, Controls()).hold(seconds)
    return time.monotonic() - way.began


def test_what_is_seen_says_at_which_step_it_is():
    reel = Reel()
    onlooker = Onlooker(reel, Controls(speed=0.0), pace=0.0)
    onlooker.glide(SCENE, SCENE)
    onlooker.before_step(Moment(2, SCENE, ()))
    onlooker.glide(SCENE, SCENE)
    steps = [one.step for one in reel.seen]
    assert steps == sorted(steps)
    assert {*steps} == {0, 2}


def test_film_names_a_step_in_full_and_only_where_there_is_a_record_of_it():
    record = StepRecord(
        "carry", "item-01", None, None, "resting", (0, 0, 0), None, True, {}, place="place-02"
    )
    assert step_labels([record]) == {1: "1: carry item-01 place-02"}


def test_what_is_held_waits_while_it_is_paused():
    assert held_for(0.1, (0.0, Controls(is_paused=True)), (0.4, Controls())) > 0.4


def test_what_is_held_is_let_go_when_the_speed_changes_or_it_is_stopped():
    assert held_for(5.0, (0.1, Controls(speed=0.0))) < 4.0
    assert held_for(5.0, (0.1, Controls(speed=100.0))) < 4.0
    assert held_for(5.0, (0.1, Controls(is_paused=True)), (0.2, Controls(is_stopped=True))) < 4.0
