"""What a page does: the methods of one object, which know nothing of a browser.

A page calls them, and is told by topic what has changed; tests call them, too. Everything that computes for
long is handed to a process (`workers`), whose answers come in threads of their own.
"""

import shutil
import tempfile
import threading
from pathlib import Path
from typing import Any

import msgspec

from neurosym.choices import AnyTask
from neurosym.errors import InvalidValue, counted
from neurosym.execution.record import Replanning, Run, StepRecord
from neurosym.files import decode_json
from neurosym.operators import vector
from neurosym.planners.planner import PlanStatus
from neurosym.planners.planner_table import PLANNERS
from neurosym.problems import Problem
from neurosym.report.symbol_words import displacement_in_words
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import INTERACTIONS, PLANS, PROBLEMS, RUNS
from neurosym.stages.plan_records import PlanRecord
from neurosym.stages.planning import check_scene
from neurosym.stages.problem_making import scene_stage
from neurosym.studio.desk import MOST_OBJECTS, Desk, Library, Topic, Word, at_rest, told
from neurosym.studio.messages import (
    Controls,
    Drawn,
    DrawTask,
    Failed,
    Grab,
    Job,
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
from neurosym.studio.studio_workers import Ticket, Workers
from neurosym.tasks.supports import is_relational
from neurosym.tasks.transition import PlanStep, validate
from neurosym.world import Scene

_MOST_FILE = 1_000_000
"""Bytes of a scene that is opened on the page."""
_MOST_SEEN = 30_000
"""So many poses of a run are kept for its film, the first ones: a quarter of an hour."""
_USUAL = "fast-downward"
"""The planner that is asked if it is there."""
_LEFT_OUT = (INTERACTIONS, "pictures", "comparison", "report.html")  # of a domain, in the folder of a page


def planners_here() -> tuple[str, ...]:
    """Name the planners of which nothing is missing."""
    return tuple(name for name, planner in PLANNERS.items() if not planner.missing())


def usual_planner() -> str:
    """Name whom to ask if nobody says whom: `_USUAL`, or else the first planner that is there."""
    names = planners_here()
    return _USUAL if _USUAL in names else names[0]


class Room:
    """The folder that a page works in: it has links to the files of a domain, which stay as they are.

    Stages replace whole files, so that a link gives way to a file and what it led to stays as it is.

    Args:
        folder: The domain folder.

    Attributes:
        path: Where it is.
    """

    def __init__(self, folder: DomainFolder):
        self.path = Path(tempfile.mkdtemp(prefix="neurosym-studio-"))
        for source in sorted(folder.path.iterdir()):
            if source.name in (PROBLEMS, PLANS, RUNS):
                (self.path / source.name).mkdir()
                for file in sorted(source.iterdir()):
                    if file.is_file():
                        (self.path / source.name / file.name).symlink_to(file.resolve())
            elif source.name not in _LEFT_OUT and not source.name.startswith("."):
                (self.path / source.name).symlink_to(source.resolve())

    def close(self) -> None:
        """Remove the folder."""
        shutil.rmtree(self.path, ignore_errors=True)


class Session(Desk):
    """One table, its plans and its run; as many windows as one likes can look at it.

    Args:
        library: The domain.
        planners: Processes that plan and draw tasks.
        runners: Processes that run.
        problem: What the page begins with; the first problem of the domain, if not given.

    Attributes:
        plans: What was planned for what is on the table, by planner.
        chosen: The planner whose plan is shown and run.
        running: The run, or what is left of it.
    """

    def __init__(self, library: Library, planners: Workers, runners: Workers, problem: Problem | None = None):
        super().__init__(library, problem)
        self._planners = planners
        self.room = Room(library.folder)
        self.plans: dict[str, Planned] = {}
        self.chosen = ""
        self.running = Running(self, runners)
        self._planning: Ticket | None = None
        self._drawing: Ticket | None = None

    def close(self) -> None:
        """End what it works on, and remove its folder."""
        self.stop_planning()
        for ticket in (self._drawing, self.running.ticket):
            if ticket:
                ticket.stop()
        self.room.close()

    @property
    def is_planning(self) -> bool:
        """Whether a planner works, or waits in line."""
        return self._planning is not None

    @property
    def place(self) -> int:
        """How many plans of others are before this page's; 0 if it does not wait."""
        ticket = self._planning
        return ticket.place if ticket else 0

    @at_rest
    def draw(self, objects: int, seed: int, task: AnyTask | None) -> None:
        """Draw a task: as the paper draws them, or of a kind that people ask for."""
        if not 1 <= objects <= MOST_OBJECTS:
            raise InvalidValue(f"{objects} objects cannot be drawn; valid: 1 to {MOST_OBJECTS}.")
        job = DrawTask(self.room.path, f"drawn-{task or 'paper'}-{objects}-{seed}", objects, seed, task)
        with self._lock:  # so that the answer is not heard before it is known that it is waited for
            if self._drawing:
                raise InvalidValue("A task is being drawn; wait for it.")
            self.say("drawing a task")
            before = self.problem
            self._drawing = self._planners.submit(job, lambda said: self._hear_drawn(said, before))

    def _hear_drawn(self, said: Any, before: Problem | None) -> None:
        """Put what was drawn on the table, if that is still as it was before."""
        with self._lock:
            self._drawing = None
            word = Word("the table was changed meanwhile; draw again", is_bad=True)
            if isinstance(said, Failed):
                word = Word(said.sentence, is_bad=True)
            elif self.problem is before and not self.running.is_active:
                assert isinstance(said, Drawn), "it is all else that is answered"
                self._change(said.problem, "scene")
                word = Word(f"a task with {counted(len(said.problem.objects), 'object')} is on the table")
        self.say(word.text, is_bad=word.is_bad)

    @at_rest
    def open_file(self, content: bytes) -> None:
        """Put the scene of a file on the table, whose bytes are as `Problem.save` writes them."""
        if len(content) > _MOST_FILE:
            raise InvalidValue(f"The file has {len(content):,} bytes; a scene has at most {_MOST_FILE:,}.")
        path = Path("the file")
        problem = decode_json(path, content, Problem)
        check_scene(self.library.folder, problem, path, self.library.world)
        if len(problem.objects) > MOST_OBJECTS:
            raise InvalidValue(
                f"The scene has {len(problem.objects)} objects; valid: at most {MOST_OBJECTS}."
            )
        self._change(problem, "scene")
        self.say(f"{problem.name} is on the table")

    @told
    def save(self) -> None:
        """Save the problem in the domain folder, as `neurosym new-problem` does."""
        problem, folder = self._problem(), self.library.folder
        if self.library.is_shipped:
            raise InvalidValue("A shipped domain is never written into; take the scene as a file instead.")
        file = self.room.path / "saved.json"
        problem.save(file)
        with folder.naming_problems():
            folder.perform(scene_stage(folder, file, name=problem.name), again=True)
        self.say(f"saved as {problem.name}")

    @at_rest
    def plan(self, planner: str) -> None:
        """Plan; plans of other planners for what is on the table are kept.

        Where there is no plan to the goals, it is one to the nearest points that are found; of relations
        there are no nearest ones.
        """
        problem = self._problem()
        if not (problem.goals or problem.related):
            raise InvalidValue("No object has a goal; give one a goal, and plan then.")
        if self.running.run is None:  # what was only tried is not where things stand
            self._clear_run()
        nearest = not is_relational(problem, self.library.grounding)
        job = PlanNew(self.room.path, problem, planner, nearest=nearest)
        with self._lock:  # so that the answer is not heard before it is known that it is waited for
            if self.is_planning:
                raise InvalidValue("A planner is at work; stop it, or wait for it.")
            self.plans.pop(planner, None)
            self.say(f"{planner} is planning")
            self._planning = self._planners.submit(job, lambda said: self._hear_plan(job, said))
        self.tell("plan")

    def stop_planning(self) -> None:
        """End the planner that works."""
        if ticket := self._planning:
            ticket.stop()

    def choose(self, planner: str) -> None:
        """Show the plan of one of the planners that were asked."""
        if planner in self.plans:
            self.chosen = planner
            self.tell("plan")

    @property
    def plan_shown(self) -> Planned | None:
        """The plan that is shown and run, if there is one."""
        return self.plans.get(self.chosen)

    def _hear_plan(self, job: PlanNew, said: Any) -> None:
        """Keep and show what a planner found, if it is for what is on the table."""
        with self._lock:
            self._planning = None
            word = Word("the table was changed meanwhile; plan again")
            if isinstance(said, Failed):
                word = Word(said.sentence, is_bad=True)
            elif job.problem == self.problem:
                assert isinstance(said, Planned), "it is all else that is answered"
                self.chosen = said.record.planner
                self.plans[self.chosen] = said
                word = _plan_word(said.record)
        self.say(word.text, is_bad=word.is_bad)
        self.tell("plan")

    @told
    def accept_nearest(self) -> None:
        """Take the points that the plan comes nearest to for goals, and plan to them."""
        problem, planned = self._problem(), self.plan_shown
        if planned is None or not planned.record.steps:
            raise InvalidValue("There is no plan whose end could be a goal.")
        steps = [PlanStep(*step) for step in planned.record.steps]
        ends = validate(steps, self.paired(), self.library.grounding).positions[-1]
        goals = {name: vector(ends[problem.object_names.index(name)]) for name in problem.goals}
        planner = planned.record.planner
        self._change(msgspec.structs.replace(problem, goals=goals, provenance="by hand"), "scene")
        self.plan(planner)

    def _refuse_while_running(self) -> None:
        if self.running.is_active:
            raise InvalidValue(
                "A plan is running; stop it first. Meanwhile objects can be dragged, and goals stay."
            )

    def _grab(self, name: str, x: float, y: float) -> bool:
        if not self.running.is_active:
            return False
        self.running.grab(Grab(name, x, y))
        return True

    def _clear_run(self) -> None:
        if self.running.seen or self.running.run:
            self.running.clear()
            self.tell("run")

    def _changed(self, topic: Topic) -> None:
        """What was planned for the table as it was no longer fits, and the last run is over."""
        with self._lock:
            had_plans, self.plans, self.chosen = bool(self.plans), {}, ""
        self._clear_run()
        self.tell(topic)
        if had_plans:
            self.tell("plan")


class Running:
    """The run of a page; there is one at a time.

    Args:
        session: The page.
        workers: Processes that run.

    Attributes:
        controls: Speed, and whether it is paused.
        ticket: What was handed in and is not over yet.
        problem: What it is a run for; None before the first.
        records: What each step did.
        replannings: The new plans that were asked for.
        left: What is left of the plan, the step at hand first.
        number: Number of that step, counted from 1.
        rest: Where everything was before that step.
        run: Its record, once it is over.
        file: Where the record lies, relative to the page's folder.
        course: Of a replay, how it agrees with the record.
        seen: The poses, for its film.
        scene: Where an action that was only tried happens, if one is.
        outcome: What that action did, once it is over.
    """

    def __init__(self, session: Session, workers: Workers):
        self._session, self._workers = session, workers
        self.controls = Controls()
        self.ticket: Ticket | None = None
        self._lock = threading.Lock()
        self.clear()

    def clear(self) -> None:
        """Forget the last run."""
        self.problem: Problem | None = None
        self.records: list[StepRecord] = []
        self.replannings: list[Replanning] = []
        self.left: tuple[tuple[str, str, str], ...] = ()
        self.number = 0
        self.rest: Scene | None = None
        self.run: Run | None = None
        self.file, self.course = "", ""
        self.seen: list[Seen] = []
        self.scene: Scene | None = None
        self.outcome: Performed | None = None

    @property
    def is_active(self) -> bool:
        """Whether something runs, or waits in line."""
        return self.ticket is not None

    @property
    def place(self) -> int:
        """How many runs of others are before this one; 0 if it does not wait."""
        ticket = self.ticket
        return ticket.place if ticket else 0

    def begin(self, replanner: str | None = None, replans: int | None = None) -> None:
        """Run the plan that is shown.

        Without a replanner, the usual one is asked; with replans = 0 the plan is followed blindly.
        """
        session = self._session
        planned, problem = session.plan_shown, session.problem
        if planned is None or not planned.plan_file or problem is None:
            session.say("There is no plan to run; plan first.", is_bad=True)
            return
        asked = replanner or usual_planner()
        job = RunPlan(session.room.path, problem.name, planned.plan_file, asked, replans, self._fresh())
        self._submit(job, problem, f"running the plan of {planned.record.planner}")

    def replay(self, name: str) -> None:
        """Run a record of the domain again, as it is; `name` is without its ending."""
        session = self._session
        problem = name.split(".")[0]
        if problem not in session.library.problem_names() or name not in session.library.run_names():
            session.say(f"There is no record of a run called {name}.", is_bad=True)
            return
        session.load(problem)
        if session.problem is not None and session.problem.name == problem:
            self._submit(Replay(session.room.path, name, self._fresh()), session.problem, f"replaying {name}")

    def perform(self, name: str, action: tuple[float, ...]) -> None:
        """Try an action on an object as it stands on the table; the table is as before afterwards."""
        session = self._session
        if session.problem is not None:
            job = Perform(session.room.path, session.problem, name, action, self._fresh())
            self._submit(job, session.problem, f"trying a motion on {name}")

    def recall(self, row: int) -> None:
        """Make an interaction of the domain's data happen again, by its number, counted from 0."""
        session = self._session
        job = Recall(session.room.path, session.library.folder / INTERACTIONS, row, self._fresh())
        self._submit(job, None, f"interaction {row} again")

    def stop(self) -> None:
        """End a run before its next step; what moves is computed to its end at once."""
        if (ticket := self.ticket) and ticket.place:
            ticket.stop()
        elif ticket:
            self._steer(is_stopped=True)

    def pause(self) -> None:
        """Hold everything where it is."""
        self._steer(is_paused=True)

    def resume(self) -> None:
        """Go on."""
        self._steer(is_paused=False)

    def one_step(self) -> None:
        """Go on to the end of one step, and wait then."""
        self._steer(is_paused=True, one_step=True)

    def set_speed(self, speed: float) -> None:
        """Run so much faster than in reality; 0 for as fast as can be computed."""
        self._steer(speed=speed)

    def _steer(self, **changes: Any) -> None:
        """Change how the run goes on, and that of the next one."""
        controls = msgspec.structs.replace(self.controls, **changes)
        if ticket := self.ticket:
            ticket.say(controls)
        self.controls = msgspec.structs.replace(controls, one_step=False)
        self._session.tell("status")

    def grab(self, grab: Grab) -> None:
        """Put an object elsewhere before the next step.

        Raises:
            InvalidValue: If there is no such object, or the place is off the table.
        """
        if self.problem is None or self.ticket is None:
            raise InvalidValue("Nothing runs.")
        self.problem.object_named(grab.object)
        self._session.library.grounding.table.check(grab.object, grab.x, grab.y)
        self.ticket.say(grab)
        self._session.say(f"{grab.object} is moved before the next step")

    def _fresh(self) -> Controls:
        return msgspec.structs.replace(self.controls, is_stopped=False, one_step=False)

    def _submit(self, job: Job, problem: Problem | None, what: str) -> None:
        with self._lock:
            if self.is_active:
                self._session.say("Something runs already; stop it first.", is_bad=True)
                return
            self.clear()
            self.controls, self.problem = self._fresh(), problem
            self.ticket = self._workers.submit(job, self._hear)
        self._session.say(what)
        self._session.tell("run")

    def _hear(self, said: Any) -> None:
        """Take in what the process sends."""
        if isinstance(said, Seen):
            if len(self.seen) < _MOST_SEEN:
                self.seen.append(said)
            else:
                self.seen[-1] = said
            self._session.tell("pose")
        elif isinstance(said, Next):
            self.number, self.left, self.rest = said.number, said.left, said.scene
            self._session.tell("step")
        elif isinstance(said, Step):
            self.records.append(said.record)
            self._session.tell("step")
        elif isinstance(said, Replanning):
            self.replannings.append(said)
            self._session.say(_replanned(said))
        elif isinstance(said, Scene):
            self.scene = said
            self._session.tell("run")
        else:
            self._end(said)

    def _end(self, said: Any) -> None:
        """Keep what came of it, and only then let something else begin."""
        with self._lock:
            self.controls = msgspec.structs.replace(self.controls, is_stopped=False, is_paused=False)
            self.left = ()
            if isinstance(said, Ran):
                self.run, self.file, self.course = said.run, said.file, said.course
                self.records = list(said.run.steps)
            elif isinstance(said, Performed):
                self.outcome = said
            self.ticket = None
        if word := _end_word(said):
            self._session.say(word.text, is_bad=word.is_bad)
        self._session.tell("run")


def _plan_word(record: PlanRecord) -> Word:
    """Return what is said when a planner is done."""
    found = len(record.steps)
    if record.status is PlanStatus.SOLVED:
        return Word(f"{record.planner} found a plan of {counted(found, 'step')}")
    towards = ", but one towards it" if found else ""
    return Word(f"{record.planner}: no plan to the goal{towards}", is_bad=True)


def _replanned(replanning: Replanning) -> str:
    """Say what came of asking for a new plan."""
    when = f"before step {replanning.before_step}"
    if replanning.reason and not replanning.plan:
        return f"No new plan was found {when}: {replanning.reason}"
    return f"Planned anew {when}: {replanning.why}"


def _end_word(said: Any) -> Word | None:
    """Return what is said of the answer to a run or an action; None if nothing is."""
    if isinstance(said, Ran):
        steps = counted(len(said.run.steps), "step")
        text = f"{said.run.outcome} in {steps}" if said.run.reached else f"goal missed: {said.run.reason}"
        again = f"; the record says {'the same' if said.course != 'another' else 'otherwise'}"
        return Word(text + (again if said.course else ""), not said.run.reached)
    if isinstance(said, Performed):
        text = f"it ended {said.kind}: {displacement_in_words(said.effect[:3])}"
        return Word("; ".join(filter(None, (text, said.said))), said.kind in ("lost", "toppled"))
    return Word(said.sentence, is_bad=True) if isinstance(said, Failed) else None
