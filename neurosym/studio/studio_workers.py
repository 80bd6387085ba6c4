"""The processes that work for pages: some plan, some run; whoever comes when all are busy waits in line."""

import threading
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import numpy as np

from neurosym.choices import told
from neurosym.contract import Posed
from neurosym.data.interactions import Interactions
from neurosym.errors import CannotStart, NeurosymError
from neurosym.files import read_json
from neurosym.pictures.motions import judge, recall_interaction
from neurosym.planners.registry import planner_named
from neurosym.stages.execution import Showing, execute_stage, load_run, replay_run
from neurosym.stages.folder import DomainFolder, load_scene
from neurosym.stages.layout import RECORD, RUNS, WORLD, plan_files, run_file, scene_file
from neurosym.stages.plan_records import PlanRecord, written_steps
from neurosym.stages.planning import plan_stage
from neurosym.stages.problem_making import Asked, problem_stage, scene_stage
from neurosym.studio.messages import (
    Drawn,
    DrawTask,
    Failed,
    Job,
    Make,
    Onlooker,
    Perform,
    Performed,
    Planned,
    PlanNew,
    Ran,
    Recall,
    Replay,
    RunPlan,
)
from neurosym.worlds.processes import Child, ChildEnded, parent
from neurosym.worlds.world_file import read_world

DIED = "The process that worked on it has ended; only this is lost, so try again."
STOPPED = "It was stopped."
_Tell = Callable[[Any], None]
"""Takes what a process sends; the last is its answer."""


class Ticket:
    """A job that was handed in: it waits in line, is worked on, or is done.

    Args:
        job: The job.
        tell: Called in a thread of its own with what is sent, the answer last.
        queue: Where it was handed in.
    """

    def __init__(self, job: Job, tell: _Tell, queue: "Workers"):
        self.job, self.tell = job, tell
        self._queue = queue
        self._child: Child | None = None
        self._is_stopped = False
        self._words: list[Any] = []
        self._lock = threading.Lock()

    @property
    def place(self) -> int:
        """How many jobs are before it in the line; 0 once it is worked on."""
        return self._queue.place_of(self)

    @property
    def process(self) -> int | None:
        """The number of the process that works on it, while one does."""
        child = self._child
        return child.process.pid if child is not None else None

    def say(self, word: Any) -> None:
        """Say something to the process that works on it, or will; nothing is said of what is done."""
        with self._lock, suppress(ChildEnded):
            if self._child is not None:
                self._child.say(word)
            else:
                self._words.append(word)

    def stop(self) -> None:
        """Give the job up: its process is ended, and `tell` hears that it was stopped."""
        with self._lock:
            self._is_stopped = True
            if self._child is not None:
                self._child.process.kill()
        self._queue.drop(self)

    def work(self, child: Child) -> bool:
        """Have a process do the job, tell what it sends, and say whether the process can do another one."""
        try:
            child.ask(do, self.job)
            with self._lock:
                self._child = child
                for word in self._words:
                    child.say(word)
                if self._is_stopped:
                    child.process.kill()
            answer, is_usable = child.answer(hear=self.tell), True
        except (ChildEnded, CannotStart) as error:
            why = str(error) if isinstance(error, CannotStart) else STOPPED if self._is_stopped else DIED
            answer, is_usable = Failed(why), False
        with self._lock:
            self._child = None
        self.tell(answer)
        return is_usable


class Workers:
    """Processes of one kind, started when they are first needed, and a line before them.

    Args:
        most: How many work at once.
    """

    def __init__(self, most: int):
        self._line: deque[Ticket] = deque()
        self._free: list[Child] = []
        self._busy, self._most = 0, most
        self._lock = threading.Lock()
        self._is_closed = False

    def warm(self) -> None:
        """Start a process before it is needed."""
        with suppress(CannotStart):
            child = Child(__name__)
            with self._lock:
                self._free.append(child)

    def submit(self, job: Job, tell: _Tell) -> Ticket:
        """Hand in a job.

        `tell` is called in a thread of its own with what is sent, the answer last.
        """
        ticket = Ticket(job, tell, self)
        with self._lock:
            self._line.append(ticket)
        self._begin()
        return ticket

    def place_of(self, ticket: Ticket) -> int:
        """Return how many jobs are before one, itself included; 0 if it does not wait."""
        with self._lock:
            return self._line.index(ticket) + 1 if ticket in self._line else 0

    def drop(self, ticket: Ticket) -> None:
        """Take a job out of the line, if it is there."""
        with self._lock:
            if ticket not in self._line:
                return
            self._line.remove(ticket)
        ticket.tell(Failed(STOPPED))

    def close(self) -> None:
        """End all processes, and whatever they work on."""
        with self._lock:
            self._is_closed = True
            self._line.clear()
            free, self._free = self._free, []
        for child in free:
            child.close(grace=0.0)

    def _begin(self) -> None:
        with self._lock:
            if self._is_closed or not self._line or self._busy >= self._most:
                return
            ticket, self._busy = self._line.popleft(), self._busy + 1
            child = self._free.pop() if self._free else None
        threading.Thread(target=self._work, args=(ticket, child), daemon=True).start()

    def _work(self, ticket: Ticket, child: Child | None) -> None:
        is_usable = False
        try:
            child = child or Child(__name__)
            is_usable = ticket.work(child)
        except CannotStart as error:
            ticket.tell(Failed(str(error)))
        finally:
            with self._lock:
                self._busy -= 1
                keeps = is_usable and child is not None and not self._is_closed
                if keeps and child is not None:
                    self._free.append(child)
            if child is not None and not keeps:
                child.close(grace=0.0)
            self._begin()


# What a process of the studio does: it plans, runs and draws tasks, one job after another.
#
# A job calls the stages that the command line calls, in the folder of one page. While it works it sends
# what is to be seen, and heeds what is said to it: another speed, pause, go on, a nudge, stop.

_HOLD = 3.0
"""So long is the end of an interaction shown before the table is there again [s]."""
_SETTING = "setting.json"
"""Where a page keeps the scene that it takes over, in its folder."""


def do(job: Job) -> Any:
    """Do a job, and return its answer."""
    try:
        return _WORK[type(job)](job)
    except NeurosymError as error:
        return Failed(_without_paths(str(error), job))
    except Exception as error:  # of a planner or a world of somebody's own: this job only is at its end
        return Failed(f"It failed: {told(error)}")


def _without_paths(sentence: str, job: Job) -> str:
    """Return a sentence without the folder of the page, which is nobody's business but the server's."""
    return sentence.replace(str(job.folder / _SETTING), "The scene").replace(f"{job.folder}/", "")


def _make(job: Make) -> Any:
    """Take a scene over into the folder, under the name of the problem."""
    file = job.folder / _SETTING
    job.problem.save(file)
    folder = DomainFolder(job.folder)
    folder.perform(scene_stage(folder, file, name=job.problem.name), again=True)
    return Drawn(job.problem)


def _plan(job: PlanNew) -> Any:
    _make(Make(job.folder, job.problem))
    folder, name = DomainFolder(job.folder), job.problem.name
    chosen = planner_named(job.planner, job.folder)
    folder.perform(plan_stage(folder, name, planner=job.planner, nearest=job.nearest), again=True)
    record = read_json(folder / plan_files(name, chosen.name)[1], PlanRecord)
    return Planned(record, written_steps(folder, name, chosen.name) or "")


def _run(job: RunPlan) -> Any:
    folder, plan_file = DomainFolder(job.folder), job.folder / job.plan_file
    stage = execute_stage(
        folder,
        job.problem,
        plan_file,
        replanner=job.replanner,
        replans=job.replans,
        showing=Showing(audience=Onlooker(parent(), job.controls)),
    )
    folder.perform(stage, again=True)
    return Ran(load_run(folder, job.problem, plan_file), run_file(job.problem, plan_file))


def _replay(job: Replay) -> Any:
    folder, file = DomainFolder(job.folder), f"{RUNS}/{job.run}{RECORD}"
    showing = Showing(audience=Onlooker(parent(), job.controls))
    run, agreement = replay_run(folder, folder / file, showing)
    return Ran(run, file, agreement.course)


def _draw(job: DrawTask) -> Any:
    folder = DomainFolder(job.folder)
    asked = Asked(job.objects, seed=job.seed, task=job.task)
    folder.perform(problem_stage(folder, job.name, asked), again=True)
    return Drawn(load_scene(folder / scene_file(job.name)))


def _perform(job: Perform) -> Any:
    """Perform one action in a scene, and send its poses."""
    world = read_world(DomainFolder(job.folder).require(WORLD))()
    onlooker = Onlooker(parent(), job.controls)
    onlooker.begin(world, job.problem)
    target = job.problem.object_names.index(job.object)
    outcome = world.interact(job.problem.scene(), np.array(job.action), target)
    onlooker.see_outcome(outcome)
    return Performed(outcome.kind, tuple(map(float, outcome.effect)), outcome.end)


def _recall(job: Recall) -> Any:
    """Make an interaction of the data happen again."""
    world = read_world(job.folder / WORLD)()
    interactions = Interactions.load(job.data)
    motion, is_same = recall_interaction(world, interactions, job.row)
    onlooker = Onlooker(parent(), job.controls)
    parent().send(motion.scene)
    if isinstance(world, Posed):
        world.on_pose = onlooker.see
    outcome = world.interact(motion.scene, motion.action, 0)
    onlooker.see_outcome(outcome)
    onlooker.hold(_HOLD)
    said = judge(interactions, job.row, outcome, is_same)
    return Performed(outcome.kind, tuple(map(float, outcome.effect)), outcome.end, said)


_WORK: dict[type[Job], Callable[[Any], Any]] = {
    Make: _make,
    PlanNew: _plan,
    RunPlan: _run,
    Replay: _replay,
    DrawTask: _draw,
    Perform: _perform,
    Recall: _recall,
}
