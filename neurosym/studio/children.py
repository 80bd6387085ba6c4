"""What a process of the studio does: it plans, runs and draws tasks, one job after another.

A job calls the stages that the command line calls, in the folder of one page. While it works it sends what is
to be seen, and heeds what is said to it: another speed, pause, go on, a nudge, stop.
"""

import os
import time
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import Any

import numpy as np

from neurosym.errors import NeurosymError
from neurosym.execution.record import Nudge, Replanning, StepRecord
from neurosym.execution.watching import STOP, Answer, Moment
from neurosym.factories import told
from neurosym.poses import POSE_SECONDS, Pose, Posed
from neurosym.problems import Problem
from neurosym.studio.messages import (
    Controls,
    Drawn,
    DrawTask,
    Failed,
    Grab,
    Job,
    Make,
    Next,
    Perform,
    Performed,
    Planned,
    PlanNew,
    Ran,
    Recall,
    Replay,
    RunPlan,
    Seen,
    Step,
)
from neurosym.world import World
from neurosym.worlds.children import GRACE, end_with_parent, leave_signals_to_parent, say_up

SETTING = "setting.json"
"""Where a page keeps the scene that it takes over, in its folder."""
_PAUSED = 0.02  # how often somebody who pauses is listened to [s]
_EARLY = 0.9  # share of a pose's time after which the next is sent, however fast a run is
_LONGEST_WAIT = 0.2  # of one pose, so that what is said meanwhile is heard soon [s]


def serve(requests: int, lifeline: int, errors: int) -> None:
    """Do jobs until the other end is closed; see `Serve`."""
    leave_signals_to_parent()
    end_with_parent(lifeline, _end_slowly)
    connection = say_up(requests, errors)
    while True:
        try:
            message = connection.recv()
        except EOFError:
            return
        if isinstance(message, Job):
            connection.send(_done(message, connection))


def _end_slowly() -> None:
    time.sleep(GRACE)
    os._exit(1)


def _done(job: Job, connection: Connection) -> Any:
    try:
        return _WORK[type(job)](job, connection)
    except NeurosymError as error:
        return Failed(str(error))
    except Exception as error:  # of a planner or a world of somebody's own: this job only is at its end
        return Failed(f"It failed: {told(error)}")


class Stage:
    """Sends what is seen of a motion, at the speed that is asked for, and heeds what is said meanwhile.

    Args:
        connection: The way to the page.
        controls: How it begins.
    """

    def __init__(self, connection: Connection, controls: Controls):
        self._connection, self._controls = connection, controls
        self._due = time.monotonic()
        self._last = 0.0
        self._grabs: list[Grab] = []
        self._names: tuple[str, ...] = ()
        self._sent = 0.0

    def begin(self, world: World, problem: Problem) -> None:
        """Ask the world for its poses, if it knows any."""
        self._names = problem.object_names
        if isinstance(world, Posed):
            world.on_pose = self.see

    def see(self, pose: Pose) -> None:
        """Send a pose when it is time for it."""
        apart = pose.seconds - self._last if pose.seconds > self._last else 0.0
        self._last = pose.seconds
        if time.monotonic() - self._sent >= POSE_SECONDS * _EARLY:
            self._sent = time.monotonic()
            self._connection.send(
                Seen(pose.seconds, pose.phase, pose.links, pose.positions, pose.orientations)
            )
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
        self._last = 0.0
        steps = tuple((step.operator, step.object, step.place) for step in moment.left)
        self._connection.send(Next(moment.number, steps, moment.scene))
        self._controls = self._controls.without_step()
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
        self._connection.send(Step(record))

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


def _make(job: Make, _: Connection) -> Any:
    """Take a scene over into the folder, under the name of the problem."""
    from neurosym.stages.folder import DomainFolder
    from neurosym.stages.scenes import scene_stage

    file = job.folder / SETTING
    job.problem.save(file)
    folder = DomainFolder(job.folder)
    folder.perform(scene_stage(folder, file, name=job.problem.name), again=True)
    return Drawn(job.problem)


def _plan(job: PlanNew, connection: Connection) -> Any:
    from neurosym.planners import planner_named
    from neurosym.reading import read_json
    from neurosym.stages.folder import DomainFolder
    from neurosym.stages.layout import plan_files
    from neurosym.stages.plan_records import PlanRecord
    from neurosym.stages.planning import plan_stage

    _make(Make(job.folder, job.problem), connection)
    folder, name = DomainFolder(job.folder), job.problem.name
    chosen = planner_named(job.planner, job.folder)
    stage = plan_stage(
        folder,
        name,
        planner=job.planner,
        encoding=job.encoding,
        nearest=job.nearest,
        time_limit=job.time_limit,
    )
    folder.perform(stage, again=True)
    plan_file, record_file = plan_files(name, chosen.name)
    record = read_json(folder / record_file, PlanRecord)
    return Planned(record, plan_file if (folder / plan_file).is_file() else "")


def _run(job: RunPlan, connection: Connection) -> Any:
    from neurosym.stages.executing import Showing, execute_stage, load_run
    from neurosym.stages.folder import DomainFolder
    from neurosym.stages.layout import run_file

    folder, plan_file = DomainFolder(job.folder), job.folder / job.plan_file
    stage = execute_stage(
        folder,
        job.problem,
        plan_file,
        replanner=job.replanner,
        replans=job.replans,
        showing=Showing(audience=Stage(connection, job.controls)),
    )
    folder.perform(stage, again=True)
    return Ran(load_run(folder, job.problem, plan_file), run_file(job.problem, plan_file))


def _replay(job: Replay, connection: Connection) -> Any:
    from neurosym.stages.executing import Showing, replay_run
    from neurosym.stages.folder import DomainFolder
    from neurosym.stages.layout import RECORD, RUNS

    folder, file = DomainFolder(job.folder), f"{RUNS}/{job.run}{RECORD}"
    showing = Showing(audience=Stage(connection, job.controls))
    run, agreement = replay_run(folder, folder / file, showing)
    return Ran(run, file, agreement.course)


def _draw(job: DrawTask, _: Connection) -> Any:
    from neurosym.stages.compiling import problem_stage
    from neurosym.stages.folder import DomainFolder, load_scene
    from neurosym.stages.layout import scene_file

    folder = DomainFolder(job.folder)
    stage = problem_stage(
        folder, name=job.name, objects=job.objects, seed=job.seed, task=job.task, tolerance=job.tolerance
    )
    folder.perform(stage, again=True)
    return Drawn(load_scene(folder / scene_file(job.name)))


def _perform(job: Perform, connection: Connection) -> Any:
    """Perform one action in a scene, and send its poses."""
    from neurosym.stages.folder import DomainFolder
    from neurosym.stages.layout import WORLD
    from neurosym.world import relative_to
    from neurosym.worlds.world_file import read_world

    world = read_world(DomainFolder(job.folder).require(WORLD))()
    stage = Stage(connection, job.controls)
    stage.begin(world, job.problem)
    target = job.problem.object_names.index(job.object)
    aim = relative_to(world, job.reference)
    outcome = world.interact(job.problem.scene(), np.array(job.action), target, **aim)
    return Performed(outcome.kind, tuple(map(float, outcome.effect)), outcome.end)


def _recall(job: Recall, connection: Connection) -> Any:
    """Make an interaction of the data happen again."""
    from neurosym.data.interactions import Interactions
    from neurosym.pictures.motions import judge, recall_interaction
    from neurosym.stages.layout import WORLD
    from neurosym.worlds.world_file import read_world

    world = read_world(job.folder / WORLD)()
    interactions = Interactions.load(job.data)
    motion, is_same = recall_interaction(world, interactions, job.row)
    stage = Stage(connection, job.controls)
    connection.send(motion.scene)
    if isinstance(world, Posed):
        world.on_pose = stage.see
    outcome = world.interact(motion.scene, motion.action, 0)
    said = judge(interactions, job.row, outcome, is_same)
    return Performed(outcome.kind, tuple(map(float, outcome.effect)), outcome.end, said)


_WORK: dict[type[Job], Callable[[Any, Connection], Any]] = {
    Make: _make,
    PlanNew: _plan,
    RunPlan: _run,
    Replay: _replay,
    DrawTask: _draw,
    Perform: _perform,
    Recall: _recall,
}
