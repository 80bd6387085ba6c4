"""What a page and the process that works for it say, and who looks on there while something moves."""

import math
import time
from collections.abc import Callable
from dataclasses import replace
from multiprocessing.connection import Connection
from typing import Any, NamedTuple

import msgspec
import numpy as np

from neurosym.contract import POSE_SECONDS, Pose, Posed
from neurosym.execution.performance import STOP, Answer, Moment
from neurosym.execution.record import Nudge, Replanning, Run, StepRecord
from neurosym.operators import TOLERANCE, Vector, vector
from neurosym.problems import Problem
from neurosym.report.symbols import Promise
from neurosym.stages.plan_records import PlanRecord
from neurosym.world import Outcome, OutcomeKind, Scene, World


class Controls(msgspec.Struct, frozen=True):
    """How a run goes on; each that is sent takes the place of the one before."""

    speed: float = 1.0  # how much faster than in reality; 0 for as fast as can be computed
    is_paused: bool = False
    one_step: bool = False  # it goes on to the end of one step nevertheless
    is_stopped: bool = False  # it ends before its next step; what moves is computed to its end at once

    @property
    def waits(self) -> bool:
        """Whether everything stays as it is."""
        return self.is_paused and not (self.one_step or self.is_stopped)


class Grab(msgspec.Struct, frozen=True):
    """Put an object somewhere else on the table before the next step, x and y [m]."""

    object: str
    x: float
    y: float


class Seen(msgspec.Struct, frozen=True, eq=False):
    """Where everything is; and at which step of a plan, counted from 1, or 0 if it is at none."""

    pose: Pose
    step: int = 0


class Tried(msgspec.Struct, frozen=True):
    """How a motion turned out on an object."""

    target: int  # which object of the scene
    start: Vector  # where its centre was [m]
    turn: tuple[float, ...]  # its orientation there (x, y, z, w)
    kind: OutcomeKind  # how it ended
    effect: Vector  # how far it had moved then, in the air if it is held [m]

    @classmethod
    def of(cls, outcome: Outcome) -> "Tried":
        """Return what is kept of an outcome."""
        row, effect = outcome.target, outcome.effect if outcome.held else outcome.resting_effect
        start, turn = outcome.start.positions[row], outcome.start.orientations[row]
        return cls(row, vector(start), tuple(turn.tolist()), outcome.kind, vector(effect))

    @property
    def end(self) -> Vector:
        """Where its centre was in the end [m]."""
        return vector(np.add(self.start, self.effect))

    def keeps(self, promise: Promise) -> bool:
        """Say whether it is as an operator promises."""
        kind = promise.operator.promise.kind if promise.operator.promise else None
        return self.kind == kind and math.dist(self.effect, promise.effect) <= TOLERANCE


class Word(NamedTuple):
    """What a page says of itself in a sentence, and whether it is that something could not be done."""

    text: str = ""
    is_bad: bool = False


class Planned(msgspec.Struct, frozen=True):
    """How planning went, and the file of the plan relative to the folder, if there is one."""

    record: PlanRecord
    plan_file: str


class Ran(msgspec.Struct, frozen=True):
    """What became of a run; and if it replays a record, how it agrees with that."""

    run: Run
    course: str = ""


_GLIDES = 18  # poses of a motion in a world that tells none
_PACE = 0.9 * POSE_SECONDS  # least time between two poses that are sent, however fast a run is [s]
_PAUSED = 0.02  # how often somebody is listened to while everything rests [s]
_LONGEST_WAIT = 0.2  # of one pose, so that what is said meanwhile is heard soon [s]


class Onlooker:
    """Tells what is seen of a motion, at the speed that is asked for, and heeds what is said meanwhile.

    Args:
        send: Takes what is seen: poses, moments before a step, what a step did, and new plans.
        controls: How it begins.
        way: Where `Controls` and `Grab` come from, if anybody says something.
        pace: Least time between two poses that are sent, by the clock [s].
    """

    _rest: Scene
    _names: tuple[str, ...] = ()

    def __init__(
        self,
        send: Callable[[Any], object],
        controls: Controls,
        way: Connection | None = None,
        pace: float = _PACE,
    ):
        self._send, self._controls, self._way, self._pace = send, controls, way, pace
        self._saw, self._step, self._last = False, 0, 0.0
        self._unsent: Seen | None = None  # the last pose, if it came too soon after another
        self._due, self._sent = time.monotonic(), 0.0
        self._grabs: list[Grab] = []

    def begin(self, world: World, problem: Problem) -> None:
        """Ask the world for its poses, if it knows any; else objects glide to where a step brings them."""
        self._rest, self._names = problem.scene(), problem.object_names
        self.look_at(world)

    def look_at(self, world: World) -> None:
        """Ask a world for its poses, if it knows any."""
        if isinstance(world, Posed):
            world.on_pose = self.see

    def see(self, pose: Pose) -> None:
        """Send a pose when it is time for it."""
        self._saw = True
        apart, self._last = max(0.0, pose.seconds - self._last), pose.seconds
        self._unsent = Seen(pose, self._step)
        if time.monotonic() - self._sent >= self._pace:
            self._send_pose()
        self._listen()
        while self._controls.waits:
            self._listen(_PAUSED)
            self._due = time.monotonic()
        if self._controls.is_stopped or self._controls.speed <= 0:
            return
        self._due = max(self._due + apart / self._controls.speed, time.monotonic() - _LONGEST_WAIT)
        while (left := self._due - time.monotonic()) > 0 and not self._controls.is_stopped:
            self._listen(min(left, _LONGEST_WAIT))

    def before_step(self, moment: Moment) -> Answer:
        """Say which step is next, wait while the run is paused, and hand over nudges."""
        self._rest, self._saw = moment.scene, False
        self._last, self._step = 0.0, moment.number
        self._send(moment)
        self._controls = msgspec.structs.replace(self._controls, one_step=False)
        self._listen()
        while moment.left and self._controls.waits and not self._grabs:
            self._listen(_PAUSED)
        if self._controls.is_stopped:
            return STOP
        if not self._grabs:
            return None
        grab = self._grabs.pop(0)
        x, y, _ = moment.scene.positions[self._names.index(grab.object)].tolist()
        return Nudge(moment.number, grab.object, (grab.x - x, grab.y - y, 0.0))

    def end_step(self, record: StepRecord) -> None:
        """Send what a step did."""
        if not self._saw:
            ends = np.array([record.positions[name] for name in self._names])
            self._glide(self._rest, replace(self._rest, positions=ends))
        self._send(record)

    def see_outcome(self, outcome: Outcome) -> None:
        """Send how an interaction ended; its objects glide there if the world told no poses of it."""
        if not self._saw:
            self._glide(outcome.start, outcome.lifted)
        self._send_pose()
        self._send(Tried.of(outcome))

    @property
    def is_stopped(self) -> bool:
        """Whether nothing more is wanted, by what was said until now."""
        self._listen()
        return self._controls.is_stopped

    def replanned(self, replanning: Replanning) -> None:
        """Send what was planned anew."""
        self._send(replanning)

    def _send_pose(self) -> None:
        """Send the last pose, if it was not sent yet."""
        if self._unsent:
            self._sent = time.monotonic()
            self._send(self._unsent)
            self._unsent = None

    def _glide(self, start: Scene, end: Scene) -> None:
        """Let objects glide from where they are to where they end, in a world that tells no poses."""
        self._last = 0.0
        for number in range(1, _GLIDES + 1):
            share = number / _GLIDES
            positions = (1 - share) * start.positions + share * end.positions
            self.see(Pose(number * POSE_SECONDS, "motion", np.zeros((0, 7)), positions, end.orientations))

    def _listen(self, seconds: float = 0.0) -> None:
        """Heed what is said, and wait for it so long [s]."""
        while self._way and self._way.poll(seconds):
            said, seconds = self._way.recv(), 0.0
            if isinstance(said, Controls):
                self._controls = said
            elif isinstance(said, Grab) and said.object in self._names:
                self._grabs.append(said)
