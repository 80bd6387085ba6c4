"""Looking on while something moves: what is seen goes to the page, and what is said there is heeded."""

import time
from typing import Any, Protocol

import msgspec
import numpy as np

from neurosym.execution.record import Nudge, Replanning, StepRecord
from neurosym.execution.watching import STOP, Answer, Moment
from neurosym.poses import POSE_SECONDS, Pose, Posed
from neurosym.problems import Problem
from neurosym.studio.messages import Controls, Grab, Next, Seen, Step
from neurosym.world import Outcome, Scene, World

GLIDES = 18
"""Poses of a motion in a world that tells none."""
PACE = 0.9 * POSE_SECONDS
"""Least time between two poses that are sent, however fast a run is [s]."""
_PAUSED = 0.02  # how often somebody is listened to while everything rests [s]
_LONGEST_WAIT = 0.2  # of one pose, so that what is said meanwhile is heard soon [s]


class Way(Protocol):
    """The way to whoever looks, as `Connection` is one."""

    def send(self, message: Any, /) -> None:
        """Send something."""
        ...

    def poll(self, seconds: float = 0.0, /) -> bool:
        """Say whether something was said, and wait for it so long [s]."""
        ...

    def recv(self) -> Any:
        """Return what was said."""
        ...


class Onlooker:
    """Sends what is seen of a motion, at the speed that is asked for, and heeds what is said meanwhile.

    Args:
        way: The way to whoever looks.
        controls: How it begins.
        pace: Least time between two poses that are sent, by the clock [s].
    """

    def __init__(self, way: Way, controls: Controls, pace: float = PACE):
        self._connection, self._controls, self._pace = way, controls, pace
        self._rest: Scene | None = None
        self._saw = False
        self._due = time.monotonic()
        self._last, self._step = 0.0, 0
        self._grabs: list[Grab] = []
        self._names: tuple[str, ...] = ()
        self._sent = 0.0

    def begin(self, world: World, problem: Problem) -> None:
        """Ask the world for its poses, if it knows any; else objects glide to where a step brings them."""
        self._rest = problem.scene()
        self._names = problem.object_names
        if isinstance(world, Posed):
            world.on_pose = self.see

    def see(self, pose: Pose) -> None:
        """Send a pose when it is time for it."""
        self._saw = True
        apart = pose.seconds - self._last if pose.seconds > self._last else 0.0
        self._last = pose.seconds
        if time.monotonic() - self._sent >= self._pace:
            self._sent = time.monotonic()
            self._connection.send(Seen(pose, self._step))
        self._listen()
        while self._controls.is_paused and not self._controls.is_stopped and not self._controls.one_step:
            self._wait_for_word(_PAUSED)
            self._due = time.monotonic()
        if self._controls.is_stopped or self._controls.speed <= 0:
            return
        self._due = max(self._due + apart / self._controls.speed, time.monotonic() - _LONGEST_WAIT)
        while (left := self._due - time.monotonic()) > 0 and not self._controls.is_stopped:
            self._wait_for_word(min(left, _LONGEST_WAIT))

    def before_step(self, moment: Moment) -> Answer:
        """Say which step is next, wait while the run is paused, and hand over nudges."""
        self._rest, self._saw = moment.scene, False
        self._last, self._step = 0.0, moment.number
        steps = tuple((step.operator, step.object, step.place) for step in moment.left)
        self._connection.send(Next(moment.number, steps, moment.scene))
        self._controls = msgspec.structs.replace(self._controls, one_step=False)
        self._listen()
        while moment.left and self._waits():
            self._wait_for_word(_PAUSED)
        if self._controls.is_stopped:
            return STOP
        return self._nudge(moment) if self._grabs else None

    def _nudge(self, moment: Moment) -> Nudge:
        """Turn the first of what was grabbed into a nudge from where the object is now."""
        grab = self._grabs.pop(0)
        x, y, _ = moment.scene.positions[self._names.index(grab.object)].tolist()
        return Nudge(moment.number, grab.object, (grab.x - x, grab.y - y, 0.0))

    def end_step(self, record: StepRecord) -> None:
        """Send what a step did."""
        if not self._saw and self._rest is not None:
            rest = self._rest
            ends = np.array([record.positions[name] for name in self._names])
            self.glide(rest, Scene(rest.features, ends, rest.orientations))
        self._connection.send(Step(record))

    def glide(self, start: Scene, end: Scene) -> None:
        """Let objects glide from where they are to where they end, in a world that tells no poses."""
        for number in range(1, GLIDES + 1):
            share = number / GLIDES
            positions = (1 - share) * start.positions + share * end.positions
            self.see(Pose(number * POSE_SECONDS, "motion", np.zeros((0, 7)), positions, end.orientations))

    def see_outcome(self, outcome: Outcome) -> None:
        """Let the objects of an interaction glide, if the world told no poses of it."""
        if not self._saw:
            self.glide(outcome.start, outcome.lifted)
            self._last = 0.0
            self.glide(outcome.lifted, outcome.end)

    def hold(self, seconds: float) -> None:
        """Let what is seen stay for a while, unless everything is to go as fast as it can.

        The speed may change meanwhile, and time does not count while everything is paused.

        Args:
            seconds: How long, at the speed of reality [s].
        """
        while seconds > 0 and self._controls.speed > 0 and not self._controls.is_stopped:
            controls, began = self._controls, time.monotonic()
            self._wait_for_word(_PAUSED)
            if controls.one_step or not controls.is_paused:
                seconds -= controls.speed * (time.monotonic() - began)

    def replanned(self, replanning: Replanning) -> None:
        """Send what was planned anew."""
        self._connection.send(replanning)

    def _waits(self) -> bool:
        controls = self._controls
        return controls.is_paused and not (controls.one_step or controls.is_stopped or self._grabs)

    def _wait_for_word(self, seconds: float) -> None:
        if self._connection.poll(seconds):
            self._listen()

    def _listen(self) -> None:
        while self._connection.poll():
            said = self._connection.recv()
            if isinstance(said, Controls):
                self._controls = said
            elif isinstance(said, Grab) and said.object in self._names:
                self._grabs.append(said)
