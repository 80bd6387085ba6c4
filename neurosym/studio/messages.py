"""What a page and the process that works for it say, and who looks on there while something moves."""

import time
from pathlib import Path
from typing import Any, Protocol

import msgspec
import numpy as np

from neurosym.choices import AnyTask
from neurosym.contract import POSE_SECONDS, Pose, Posed
from neurosym.execution.performance import STOP, Answer, Moment
from neurosym.execution.record import Nudge, Replanning, Run, StepRecord
from neurosym.problems import Problem
from neurosym.stages.plan_records import PlanRecord
from neurosym.world import Outcome, OutcomeKind, Scene, World


class Controls(msgspec.Struct, frozen=True):
    """How a run goes on; each that is sent takes the place of the one before.

    Attributes:
        speed: How much faster than in reality; 0 for as fast as can be computed.
        is_paused: Whether it waits.
        one_step: Whether it goes on to the end of one step nevertheless.
        is_stopped: Whether it ends before its next step; what moves is computed to its end, without waiting.
    """

    speed: float = 1.0
    is_paused: bool = False
    one_step: bool = False
    is_stopped: bool = False


class Grab(msgspec.Struct, frozen=True):
    """Put an object somewhere else on the table before the next step, x and y [m]."""

    object: str
    x: float
    y: float


class Job(msgspec.Struct, frozen=True):
    """Something to do in the folder of a page.

    Attributes:
        folder: The folder.
    """

    folder: Path


class Make(Job, frozen=True):
    """Take a problem over into the folder."""

    problem: Problem


class PlanNew(Job, frozen=True):
    """Take a problem over, and plan."""

    problem: Problem
    planner: str
    nearest: bool = False


class RunPlan(Job, frozen=True):
    """Execute the file of a plan, relative to the folder, for a problem of it."""

    problem: str
    plan_file: str
    replanner: str
    replans: int | None
    controls: Controls = Controls()


class Replay(Job, frozen=True):
    """Run a record of the folder again."""

    run: str
    controls: Controls = Controls()


class DrawTask(Job, frozen=True):
    """Draw a task: as the paper draws them, or of a kind that people ask for."""

    name: str
    objects: int
    seed: int
    task: AnyTask | None


class Perform(Job, frozen=True):
    """Perform an action on an object of a scene."""

    problem: Problem
    object: str
    action: tuple[float, ...]
    controls: Controls = Controls()


class Recall(Job, frozen=True):
    """Make a row of a data set happen again."""

    data: Path
    row: int
    controls: Controls = Controls()


class Seen(msgspec.Struct, frozen=True, eq=False):
    """Where everything is; and at which step of a plan, counted from 1, or 0 if it is at none."""

    pose: Pose
    step: int = 0


class Next(msgspec.Struct, frozen=True, eq=False):
    """The step that is next: its number, what is left of the plan, and where everything is [m].

    What is left is operator, object and place of each step.
    """

    number: int
    left: tuple[tuple[str, str, str], ...]
    scene: Scene


class Step(msgspec.Struct, frozen=True):
    """What a step did."""

    record: StepRecord


class Drawn(msgspec.Struct, frozen=True):
    """A problem that lies in the folder now."""

    problem: Problem


class Planned(msgspec.Struct, frozen=True):
    """How planning went, and the file of the plan relative to the folder, if there is one."""

    record: PlanRecord
    plan_file: str


class Ran(msgspec.Struct, frozen=True):
    """What became of a run, and its file relative to the folder; how it agrees with the record it replays."""

    run: Run
    file: str
    course: str = ""


class Performed(msgspec.Struct, frozen=True, eq=False):
    """What one action did: how its object ended, how far it moved [m], and where everything is then."""

    kind: OutcomeKind
    effect: tuple[float, ...]
    end: Scene
    said: str = ""


class Failed(msgspec.Struct, frozen=True):
    """Why a job was not done, in a sentence."""

    sentence: str


_GLIDES = 18
"""Poses of a motion in a world that tells none."""
_PACE = 0.9 * POSE_SECONDS
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

    def __init__(self, way: Way, controls: Controls, pace: float = _PACE):
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
        for number in range(1, _GLIDES + 1):
            share = number / _GLIDES
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
