"""The processes that work for pages, and what they do: they plan, draw tasks, and run plans and motions.

Whoever comes when all are busy waits in line. Each work calls the stages that the command line calls, in the
folder of one page. While something moves, it sends what is to be seen, and heeds what is said: another speed,
pause, go on, a nudge, stop.
"""

import threading
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.choices import AnyTask, told
from neurosym.data.interactions import Interactions
from neurosym.errors import CannotStart, NeurosymError
from neurosym.files import read_json
from neurosym.pictures.motions import judge, recall_interaction
from neurosym.planners.registry import planner_named
from neurosym.problems import Problem
from neurosym.report.symbols import displacement_in_words
from neurosym.stages.execution import Showing, execute_stage, load_run, replay_run
from neurosym.stages.folder import DomainFolder, load_scene
from neurosym.stages.layout import RECORD, RUNS, WORLD, plan_files, scene_file
from neurosym.stages.plan_records import PlanRecord, written_steps
from neurosym.stages.planning import plan_stage
from neurosym.stages.problem_making import Asked, problem_stage, scene_stage
from neurosym.studio.messages import Controls, Onlooker, Planned, Ran, Tried, Word
from neurosym.world import Outcome
from neurosym.worlds.processes import Child, ChildEnded, parent
from neurosym.worlds.world_file import read_world

DIED = "The process that worked on it has ended; only this is lost, so try again."
STOPPED = "It was stopped."
_Tell = Callable[[Any], None]  # takes what a process sends; the last is its answer


class Ticket:
    """Work that was handed in: it waits in line, is done, or is over."""

    def __init__(self, queue: "Workers", tell: _Tell, call: tuple[Any, ...]):
        self._queue, self.tell, self._call = queue, tell, call
        self._child: Child | None = None
        self._is_stopped = False
        self._words: list[Any] = []
        self._lock = threading.Lock()

    @property
    def place(self) -> int:
        """How many are before it in the line, itself included; 0 once it is worked on."""
        line = tuple(self._queue.line)
        return line.index(self) + 1 if self in line else 0

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
        """Give it up: its process is ended, and `tell` hears that it was stopped."""
        with self._lock:
            self._is_stopped = True
            if self._child is not None:
                self._child.process.kill()
        try:
            self._queue.line.remove(self)
        except ValueError:  # it does not wait in line
            return
        self.tell(Word(STOPPED, is_bad=True))

    def work(self, child: Child) -> bool:
        """Have a process do it, tell what it sends, and say whether the process can be asked again."""
        try:
            child.ask(*self._call)
            with self._lock:
                self._child = child
                for word in self._words:
                    child.say(word)
                if self._is_stopped:
                    child.process.kill()
            answer, is_usable = child.answer(hear=self.tell), True
        except (ChildEnded, CannotStart) as error:
            why = str(error) if isinstance(error, CannotStart) else STOPPED if self._is_stopped else DIED
            answer, is_usable = Word(why, is_bad=True), False
        with self._lock:
            self._child = None
        self.tell(answer)
        return is_usable


class Workers:
    """So many processes of one kind at most, started when they are first needed, and a line before them."""

    def __init__(self, most: int):
        self.line: list[Ticket] = []
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

    def submit(self, tell: _Tell, work: Callable[..., Any], folder: Path, *given: Any) -> Ticket:
        """Have one of the functions below called; a thread tells what is sent, the answer last."""
        ticket = Ticket(self, tell, (do, work, folder, *given))
        with self._lock:
            self.line.append(ticket)
        self._begin()
        return ticket

    def close(self) -> None:
        """End all processes that do nothing, and begin nothing any more."""
        with self._lock:
            self._is_closed = True
            self.line.clear()
            free, self._free = self._free, []
        for child in free:
            child.close(grace=0.0)

    def _begin(self) -> None:
        with self._lock:
            if self._is_closed or not self.line or self._busy >= self._most:
                return
            ticket, self._busy = self.line.pop(0), self._busy + 1
            child = self._free.pop() if self._free else None
        threading.Thread(target=self._work, args=(ticket, child), daemon=True).start()

    def _work(self, ticket: Ticket, child: Child | None) -> None:
        is_usable = False
        try:
            child = child or Child(__name__)
            is_usable = ticket.work(child)
        except CannotStart as error:
            ticket.tell(Word(str(error), is_bad=True))
        finally:
            with self._lock:
                self._busy -= 1
                keeps = is_usable and not self._is_closed
                if child is not None and keeps:
                    self._free.append(child)
            if child is not None and not keeps:
                child.close(grace=0.0)
            self._begin()


TRIES = 10
"""How often a motion is tried in a row, each time from another start."""
_SHIFT = 0.004  # how far such a start is from where the object stands at most, along x and y [m]
_SETTING = "setting.json"  # where a page keeps the scene that it takes over, in its folder


def do(work: Callable[..., Any], path: Path, *given: Any) -> Any:
    """Do one of the works below in the folder of a page, and return its answer, or why there is none."""
    try:
        return work(DomainFolder(path), *given)
    except NeurosymError as error:  # the folder is nobody's business but the server's
        said = str(error).replace(str(path / _SETTING), "The scene").replace(f"{path}/", "")
    except Exception as error:  # of a planner or a world of somebody's own: only this is at its end
        said = f"It failed: {told(error)}"
    return Word(said, is_bad=True)


def plan(folder: DomainFolder, problem: Problem, planner: str, nearest: bool) -> Planned:
    """Take a problem over into the folder, and plan; if `nearest`, to what is nearest if need be."""
    file, name = folder / _SETTING, problem.name
    problem.save(file)
    folder.perform(scene_stage(folder, file, name=name), again=True)
    chosen = planner_named(planner, folder.path)
    folder.perform(plan_stage(folder, name, planner=planner, nearest=nearest), again=True)
    record = read_json(folder / plan_files(name, chosen.name)[1], PlanRecord)
    return Planned(record, written_steps(folder, name, chosen.name) or "")


def draw(folder: DomainFolder, name: str, objects: int, seed: int, task: AnyTask | None) -> Problem:
    """Draw a task: as the paper draws them, or of a kind that people ask for."""
    folder.perform(problem_stage(folder, name, Asked(objects, seed=seed, task=task)), again=True)
    return load_scene(folder / scene_file(name))


def run(
    folder: DomainFolder, name: str, plan: str, replanner: str, replans: int | None, controls: Controls
) -> Ran:
    """Execute the file of a plan for a problem of the folder."""
    plan_file, showing = folder / plan, Showing(audience=_onlooker(controls))
    stage = execute_stage(folder, name, plan_file, replanner=replanner, replans=replans, showing=showing)
    folder.perform(stage, again=True)
    return Ran(load_run(folder, name, plan_file))


def replay(folder: DomainFolder, name: str, controls: Controls) -> Ran:
    """Run a record of the folder again."""
    showing = Showing(audience=_onlooker(controls))
    record, agreement = replay_run(folder, folder / f"{RUNS}/{name}{RECORD}", showing)
    return Ran(record, agreement.course)


def perform(
    folder: DomainFolder, problem: Problem, name: str, action: tuple[float, ...], controls: Controls
) -> Word:
    """Perform an action on an object of a scene."""
    world, onlooker = read_world(folder.require(WORLD))(), _onlooker(controls)
    onlooker.look_at(world)
    target = problem.object_names.index(name)
    outcome = world.interact(problem.scene(), np.array(action), target, put_down=False)
    onlooker.see_outcome(outcome)
    return _performed(outcome)


def try_often(
    folder: DomainFolder, problem: Problem, name: str, action: tuple[float, ...], controls: Controls
) -> Word:
    """Perform an action on an object `TRIES` times, from starts beside it, always the same; say nothing."""
    world, onlooker = read_world(folder.require(WORLD))(), _onlooker(controls)
    target, scene = problem.object_names.index(name), problem.scene()
    for number in range(TRIES):
        if onlooker.is_stopped:
            break
        positions = scene.positions.copy()
        positions[target, :2] += np.random.default_rng([TRIES, number]).uniform(-_SHIFT, _SHIFT, 2)
        moved = replace(scene, positions=positions)
        parent().send(Tried.of(world.interact(moved, np.array(action), target)))
    return Word()


def recall(folder: DomainFolder, data: Path, row: int, controls: Controls) -> Word:
    """Make a row of a data set happen again."""
    world, onlooker = read_world(folder / WORLD)(), _onlooker(controls)
    interactions = Interactions.load(data)
    motion, is_same = recall_interaction(world, interactions, row)
    parent().send(motion.scene)
    onlooker.look_at(world)
    outcome = world.interact(motion.scene, motion.action, 0, put_down=False)
    onlooker.see_outcome(outcome)
    return _performed(outcome, judge(interactions, row, outcome, is_same))


def _onlooker(controls: Controls) -> Onlooker:
    return Onlooker(parent().send, controls, parent())


def _performed(outcome: Outcome, said: str = "") -> Word:
    moved = displacement_in_words(outcome.effect[:3].tolist())
    text = "; ".join(filter(None, (f"it ended {outcome.kind}: {moved}", said)))
    return Word(text, is_bad=outcome.kind in ("lost", "toppled"))
