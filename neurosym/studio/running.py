"""A run on a page: begun, paused, stepped, nudged, stopped, and what was seen of it."""

import threading
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from neurosym.errors import InvalidValue
from neurosym.execution.record import Replanning, Run, StepRecord
from neurosym.problems import Problem
from neurosym.studio.messages import (
    Controls,
    Failed,
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
from neurosym.studio.workers import Ticket, Workers
from neurosym.table import Place
from neurosym.wording import counted
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
    """

    def __init__(self, session: "Session", workers: Workers):
        self._session, self._workers = session, workers
        self.controls = Controls()
        self._ticket: Ticket | None = None
        self._lock = threading.Lock()
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

    def begin(self, replanner: str = "fast-downward", replans: int | None = None) -> None:
        """Run the plan that is shown.

        Args:
            replanner: Whom to ask for new plans.
            replans: How many may be asked for; 0 to follow the plan blindly, as usual if not given.
        """
        session = self._session
        planned, problem = session.plan_shown, session.problem
        if planned is None or not planned.plan_file or problem is None:
            session.say("There is no plan to run; plan first.", is_bad=True)
            return
        job = RunPlan(session.room.path, problem.name, planned.plan_file, replanner, replans, self._fresh())
        self._submit(job, problem, f"running the plan of {planned.record.planner}")

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

    def perform(self, name: str, action: tuple[float, ...], place: Place | None = None) -> None:
        """Try an action on an object as it stands on the table; the table is as before afterwards.

        Args:
            name: Name of the object.
            action: The action parameters.
            place: Where it is carried, if it is an action that carries.
        """
        session = self._session
        if session.problem is None:
            return
        job = Perform(session.room.path, session.problem, name, action, place, self._fresh())
        self._submit(job, session.problem, f"trying a motion on {name}")

    def recall(self, row: int) -> None:
        """Make an interaction of the domain's data happen again.

        Args:
            row: Which, counted from 0.
        """
        session = self._session
        data = session.library.folder.path / "interactions.npz"
        self._submit(Recall(session.room.path, data, row, self._fresh()), None, f"interaction {row} again")

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

    def _submit(self, job: Job, problem: Problem | None, what: str) -> None:
        session = self._session
        with self._lock:
            if self._ticket is not None:
                session.say("Something runs already; stop it first.", is_bad=True)
                return
            self.clear()
            self.controls, self.problem = self._fresh(), problem
            self._ticket = self._workers.submit(job, self._hear)
        session.say(what)
        session.tell("run")

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
            self._session.say(f"planned anew before step {said.before_step}: {said.why}")
        elif isinstance(said, Scene):
            self.scene = said
            self._session.tell("run")
        else:
            self._end(said)

    def _end(self, said: Any) -> None:
        with self._lock:
            self._ticket = None
        self.controls = replace(self.controls, is_stopped=False, is_paused=False)
        self.left = ()
        session = self._session
        if isinstance(said, Ran):
            self.run, self.file, self.course = said.run, said.file, said.course
            self.records = list(said.run.steps)
            steps = counted(len(said.run.steps), "step")
            text = f"goal reached in {steps}" if said.run.reached else f"goal missed: {said.run.reason}"
            again = f"; the record says {'the same' if said.course != 'another' else 'otherwise'}"
            session.say(text + (again if said.course else ""), is_bad=not said.run.reached)
        elif isinstance(said, Performed):
            self.outcome = said
            session.say(said.said or f"it ended {said.kind}", is_bad=said.kind in ("lost", "toppled"))
        elif isinstance(said, Failed):
            session.say(said.sentence, is_bad=True)
        session.tell("run")
