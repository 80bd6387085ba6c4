"""A run on a page: begun, paused, stepped, nudged, stopped, and what was seen of it."""

import threading
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from neurosym.errors import InvalidValue
from neurosym.execution.record import Replanning, Run, StepRecord
from neurosym.problems import Problem
from neurosym.studio.asking import usual_planner
from neurosym.studio.messages import (
    Controls,
    Grab,
    Job,
    Next,
    Perform,
    Performed,
    Ran,
    Recall,
    Replay,
    RunPlan,
    Seen,
    Step,
)
from neurosym.studio.telling import end_word, replanned
from neurosym.studio.workers import Ticket, Workers
from neurosym.table import Place
from neurosym.world import Scene

if TYPE_CHECKING:
    from neurosym.studio.session import Session

MOST_SEEN = 30_000
"""So many poses of a run are kept for its film, the first ones: a quarter of an hour."""


class Running:
    """The run of a page; there is one at a time.

    Args:
        session: The page.
        workers: Processes that run.

    Attributes:
        controls: Speed, and whether it is paused.
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
        job: Number of the run or action that was begun last, counted from 1; 0 before the first.
    """

    def __init__(self, session: "Session", workers: Workers):
        self._session, self._workers = session, workers
        self.controls = Controls()
        self._ticket: Ticket | None = None
        self._lock = threading.Lock()
        self.job = 0
        self.clear()

    @property
    def is_active(self) -> bool:
        """Whether something runs, or waits in line."""
        return self._ticket is not None

    @property
    def place(self) -> int:
        """How many runs of others are before this one; 0 if it does not wait."""
        ticket = self._ticket
        return ticket.place if ticket else 0

    @property
    def process(self) -> int | None:
        """The number of the process that runs it, once there is one."""
        ticket = self._ticket
        return ticket.process if ticket else None

    def clear(self) -> bool:
        """Forget the last run, and say whether there was anything to forget."""
        had = bool(
            getattr(self, "seen", None) or getattr(self, "records", None) or getattr(self, "run", None)
        )
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
        return had

    def forget_action(self) -> bool:
        """Forget an action that was only tried or recalled; say whether there was one. Runs are kept."""
        with self._lock:
            was_tried = self.outcome is not None or self.scene is not None
            return was_tried and self.run is None and not self.is_active and self.clear()

    def begin(self, replanner: str | None = None, replans: int | None = None) -> int | None:
        """Run the plan that is shown, and return the number of the run; None if it cannot begin.

        Args:
            replanner: Whom to ask for new plans; the usual planner if not given.
            replans: How many may be asked for; 0 to follow the plan blindly, as usual if not given.
        """
        session = self._session
        planned, problem = session.plan_shown, session.problem
        if planned is None or not planned.plan_file or problem is None:
            session.say("There is no plan to run; plan first.", is_bad=True)
            return None
        asked = replanner or usual_planner()
        job = RunPlan(session.room.path, problem.name, planned.plan_file, asked, replans, self._fresh())
        return self._submit(job, problem, f"running the plan of {planned.record.planner}")

    def replay(self, name: str) -> None:
        """Run a record of the domain again, as it is.

        Args:
            name: Name of the record, without its ending.
        """
        session = self._session
        problem = name.split(".")[0]
        if problem not in session.library.problem_names() or name not in session.library.run_names():
            session.say(f"There is no record of a run called {name}.", is_bad=True)
            return
        session.load(problem)
        if session.problem is not None and session.problem.name == problem:
            self._submit(Replay(session.room.path, name, self._fresh()), session.problem, f"replaying {name}")

    def perform(self, name: str, action: tuple[float, ...], place: Place | None = None) -> int | None:
        """Try an action on an object as it stands on the table; the table is as before afterwards.

        It is given a number, which is returned; None if it cannot begin.

        Args:
            name: Name of the object.
            action: The action parameters.
            place: Where it is carried, if it is an action that carries.
        """
        session = self._session
        if session.problem is None:
            return None
        job = Perform(session.room.path, session.problem, name, action, place, self._fresh())
        return self._submit(job, session.problem, f"trying a motion on {name}")

    def recall(self, row: int) -> int | None:
        """Make an interaction of the domain's data happen again; return its number, or None as `perform`.

        Args:
            row: Which, counted from 0.
        """
        session = self._session
        data = session.library.folder.path / "interactions.npz"
        job = Recall(session.room.path, data, row, self._fresh())
        return self._submit(job, None, f"interaction {row} again")

    def stop(self) -> None:
        """End a run before its next step; what moves is computed to its end at once."""
        with self._lock:
            ticket = self._ticket
        if ticket is None:
            return
        if ticket.place:
            ticket.stop()
        else:
            self.steer(is_stopped=True)

    def pause(self) -> None:
        """Hold everything where it is."""
        self.steer(is_paused=True)

    def resume(self) -> None:
        """Go on."""
        self.steer(is_paused=False)

    def one_step(self) -> None:
        """Go on to the end of one step, and wait then."""
        self.steer(is_paused=True, one_step=True)

    def set_speed(self, speed: float) -> None:
        """Run so much faster than in reality; 0 for as fast as can be computed."""
        self.steer(speed=speed)

    def steer(self, **changes: Any) -> None:
        """Change how the run goes on, and that of the next one."""
        self.controls = replace(self.controls, **changes)
        if ticket := self._ticket:
            ticket.say(self.controls)
        self.controls = self.controls.without_step()
        self._session.tell("status")

    def grab(self, grab: Grab) -> None:
        """Put an object elsewhere before the next step.

        Raises:
            InvalidValue: If there is no such object, or the place is off the table.
        """
        if self.problem is None or self._ticket is None:
            raise InvalidValue("Nothing runs.")
        self.problem.object_named(grab.object)
        self._session.library.grounding.table.check(grab.object, grab.x, grab.y)
        self._ticket.say(grab)
        self._session.say(f"{grab.object} is moved before the next step")

    def close(self) -> None:
        """End what runs at once."""
        if ticket := self._ticket:
            ticket.stop()

    def _fresh(self) -> Controls:
        return replace(self.controls, is_stopped=False, one_step=False)

    def _submit(self, job: Job, problem: Problem | None, what: str) -> int | None:
        session = self._session
        with self._lock:
            if self._ticket is not None:
                session.say("Something runs already; stop it first.", is_bad=True)
                return None
            self.clear()
            number = self.job = self.job + 1
            self.controls, self.problem = self._fresh(), problem
            self._ticket = self._workers.submit(job, self._hear)
        session.say(what)
        session.tell("run")
        return number

    def _hear(self, said: Any) -> None:
        """Take in what the process sends."""
        if isinstance(said, Seen):
            if len(self.seen) < MOST_SEEN:
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
            self._session.say(replanned(said))
        elif isinstance(said, Scene):
            self.scene = said
            self._session.tell("run")
        else:
            self._end(said)

    def _end(self, said: Any) -> None:
        """Keep what came of it, and only then let something else begin."""
        with self._lock:
            self.controls = replace(self.controls, is_stopped=False, is_paused=False)
            self.left = ()
            if isinstance(said, Ran):
                self.run, self.file, self.course = said.run, said.file, said.course
                self.records = list(said.run.steps)
            elif isinstance(said, Performed):
                self.outcome = said
            self._ticket = None
        if word := end_word(said):
            self._session.say(word.text, is_bad=word.is_bad)
        self._session.tell("run")
