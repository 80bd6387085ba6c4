"""What a page does: the methods of one object, which know nothing of a browser.

A page calls them, and is told by topic what has changed; tests call them, too. Everything that computes for
long is handed to a process (`studio_workers`), whose answers come in threads of their own.
"""

import shutil
import tempfile
import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from neurosym.choices import DEFAULT_PLANNER, AnyTask
from neurosym.errors import InvalidValue, counted
from neurosym.execution.performance import Moment
from neurosym.execution.record import Replanning, Run, StepRecord
from neurosym.files import decode_json, read_text
from neurosym.operators import vector
from neurosym.planners.planner import PlanStatus
from neurosym.planners.registry import PLANNERS
from neurosym.problems import Problem
from neurosym.report.symbols import Promise, promises_for
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import INTERACTIONS, PLAN, PLANS, PROBLEMS, RUNS
from neurosym.stages.planning import check_scene
from neurosym.stages.problem_making import scene_stage
from neurosym.studio import studio_workers as work
from neurosym.studio.desk import MOST_OBJECTS, Desk, Topic, at_rest, told
from neurosym.studio.library import Library
from neurosym.studio.messages import Controls, Grab, Planned, Ran, Seen, Tried, Word
from neurosym.studio.plan_words import STEPS
from neurosym.studio.studio_workers import Ticket, Workers
from neurosym.studio.words import promise_in_words
from neurosym.tasks.task import is_relational
from neurosym.tasks.transition import PlanStep, validate
from neurosym.world import Scene

_MOST_FILE = 1_000_000  # bytes of a scene that is opened on the page
_LEFT_OUT = (INTERACTIONS, "pictures", "comparison", "report.html")  # of a domain, in the folder of a page


def planners_here() -> tuple[str, ...]:
    """Name the planners of which nothing is missing, whom to ask if nobody says whom first."""
    found = [name for name, planner in PLANNERS.items() if not planner.missing()]
    return tuple(sorted(found, key=lambda name: name != DEFAULT_PLANNER))


def furnished_room(folder: DomainFolder) -> Path:
    """Make the folder that a page works in, with links to a domain; stages replace them by files."""
    room = Path(tempfile.mkdtemp(prefix="neurosym-studio-"))
    for source in sorted(folder.path.iterdir()):
        if source.name in (PROBLEMS, PLANS, RUNS):
            (room / source.name).mkdir()
            for file in filter(Path.is_file, source.iterdir()):
                (room / source.name / file.name).symlink_to(file.resolve())
        elif source.name not in _LEFT_OUT and not source.name.startswith("."):
            (room / source.name).symlink_to(source.resolve())
    return room


def placed(problem: Problem, scene: Scene) -> Problem:
    """Return a problem whose objects are where those of a scene are."""
    places = zip(problem.objects, scene.positions.tolist(), scene.orientations.tolist(), strict=False)
    items = tuple(
        msgspec.structs.replace(item, position=tuple(at), orientation=tuple(turn))
        for item, at, turn in places
    )
    return msgspec.structs.replace(problem, objects=items)


class Session(Desk):
    """One table, its plans and its run; as many windows as one likes can look at it."""

    def __init__(self, library: Library, planners: Workers, runners: Workers, problem: Problem | None = None):
        super().__init__(library, problem)
        self._planners = planners
        self.room = furnished_room(library.folder)
        self.plans: dict[str, Planned] = {}  # for what is on the table, by planner
        self.chosen = ""  # the planner whose plan is shown and run
        self.planning: Ticket | None = None  # what was handed in, to be planned or drawn
        self.running = Running(self, runners)

    def close(self) -> None:
        """End what it works on, and remove its folder."""
        for ticket in (self.planning, self.running.ticket):
            if ticket:
                ticket.stop()
        shutil.rmtree(self.room, ignore_errors=True)

    @property
    def is_running(self) -> bool:
        """Whether something moves, so that the table cannot be set."""
        return self.running.is_active

    @property
    def plan_shown(self) -> Planned | None:
        """The plan that is shown and run, if there is one."""
        return self.plans.get(self.chosen)

    @told
    def move(self, name: str, x: float, y: float) -> None:
        """Put an object elsewhere [m]; while a plan runs, that is done before its next step."""
        if self.is_running:
            self.running.grab(Grab(name, x, y))
        else:
            super().move(name, x, y)

    @at_rest
    def draw(self, objects: int, seed: int, task: AnyTask | None) -> None:
        """Draw a task: as the paper draws them, or of a kind that people ask for."""
        if not 1 <= objects <= MOST_OBJECTS:
            raise InvalidValue(f"{objects} objects cannot be drawn; valid: 1 to {MOST_OBJECTS}.")
        name = f"drawn-{task or 'paper'}-{objects}-{seed}"

        def take(drawn: Problem) -> Word:
            if self.is_running:
                return Word("A plan is running; draw again when it is over.", is_bad=True)
            self._change(drawn, "scene")
            return Word(f"a task with {counted(len(drawn.objects), 'object')} is on the table")

        self._hand_in("drawing a task", take, work.draw, name, objects, seed, task)

    @at_rest
    def open_file(self, content: bytes) -> None:
        """Put the scene of a file on the table, whose bytes are as `Problem.save` writes them."""
        if len(content) > _MOST_FILE:
            raise InvalidValue(f"The file has {len(content):,} bytes; a scene has at most {_MOST_FILE:,}.")
        path = Path("the file")
        problem = decode_json(path, content, Problem)
        check_scene(self.library.folder, problem, path, self.library.world)
        if (count := len(problem.objects)) > MOST_OBJECTS:
            raise InvalidValue(f"The scene has {count} objects; valid: at most {MOST_OBJECTS}.")
        self._change(problem, "scene")
        self.say(f"{problem.name} is on the table")

    @told
    def save(self) -> None:
        """Save the problem in the domain folder, as `neurosym new-problem` does."""
        problem, folder = self._problem(), self.library.folder
        if self.library.is_shipped:
            raise InvalidValue("A shipped domain is never written into; take the scene as a file instead.")
        file = self.room / "saved.json"
        problem.save(file)
        with folder.naming_problems():
            folder.perform(scene_stage(folder, file, name=problem.name), again=True)
        self.say(f"saved as {problem.name}")

    @at_rest
    def plan(self, planner: str) -> None:
        """Plan to the goals, or to the nearest points that are found; other planners' plans are kept."""
        problem = self._problem()
        if not (problem.goals or problem.relations):
            raise InvalidValue("No object has a goal; give one a goal, and plan then.")
        self._clear_run()  # plans begin where the table is set, and so it is seen
        nearest = not is_relational(problem, self.library.grounding)  # of relations nothing is near
        self._hand_in(f"{planner} is planning", self._take, work.plan, problem, planner, nearest)

    def _take(self, planned: Planned) -> Word:
        """Show what a planner found, and return what is said of it."""
        record, found = planned.record, counted(len(planned.record.steps), "step")
        self.chosen = record.planner
        self.plans[self.chosen] = planned
        if record.status is PlanStatus.SOLVED:
            return Word(f"{record.planner} found a plan of {found}")
        towards = ", but one towards it" if record.steps else ""
        return Word(f"{record.planner}: no plan to the goal{towards}", is_bad=True)

    def _hand_in(self, what: str, take: Callable[[Any], Word], do: Callable[..., Any], *given: Any) -> None:
        """Have a process think about the table; its answer is taken if the table is then as it was."""
        before = self.problem

        def hear(said: Any) -> None:
            with self._lock:
                word = Word("the table was changed meanwhile; do it again", is_bad=True)
                if isinstance(said, Word):
                    word = said
                elif self.problem == before:
                    word = take(said)
                self.say(*word)  # first, so that whoever sees that it is over reads what came of it
                self.planning = None
            self.tell("plan")

        with self._lock:  # so that the answer is not heard before it is known that it is waited for
            if self.planning:
                raise InvalidValue("A planner is at work; stop it, or wait for it.")
            self.say(what)
            self.planning = self._planners.submit(hear, do, self.room, *given)
        self.tell("plan")

    def stop_planning(self) -> None:
        """End the planner that works."""
        if ticket := self.planning:
            ticket.stop()

    def steps_in_pddl(self) -> tuple[str, ...]:
        """Return the steps of the plan that is shown as its file has them, if that is a plan of the page."""
        planned = self.plan_shown
        if planned is None or not planned.plan_file.endswith(PLAN):
            return ()
        lines = read_text(self.room / planned.plan_file).splitlines()
        steps = tuple(line for line in lines if line.startswith("(") and line[1:].split()[0] in STEPS)
        return steps if len(steps) == len(planned.record.steps) else ()

    def choose(self, planner: str) -> None:
        """Show the plan of one of the planners that were asked."""
        if planner in self.plans:
            self.chosen = planner
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
        self._change(msgspec.structs.replace(problem, goals=goals, provenance="by hand"), "scene")
        self.plan(planned.record.planner)

    @at_rest
    def reset(self) -> None:
        """Show the table as it is set, and no longer what came of a run or of a try."""
        self._clear_run()

    def promises(self, name: str) -> tuple[Promise, ...]:
        """List what the operators promise for an object, the surest first."""
        return promises_for(self._problem().object_named(name), self.library.grounding)

    def unsure(self, name: str) -> Promise | None:
        """Return what an operator promises for an object of which it is least sure whether it happens."""
        return min(self.promises(name), key=lambda one: abs(one.chance - 0.5), default=None)

    def _clear_run(self) -> None:
        if self.running.has_ended:
            self.running.clear()
            self.tell("run")

    def _change(self, problem: Problem, topic: Topic) -> None:
        """Put a problem on the table: what was planned no longer fits, and the last run is over."""
        with self._lock:
            had_plans, self.plans, self.chosen = bool(self.plans), {}, ""
            self._clear_run()
            super()._change(problem, topic)
        if had_plans:
            self.tell("plan")


class Running:
    """The run of a page, by processes that run; there is one at a time, and nothing else moves."""

    def __init__(self, session: Session, workers: Workers):
        self._session, self._workers = session, workers
        self.controls = Controls()
        self.ticket: Ticket | None = None  # what was handed in and is not over yet
        self._lock = threading.Lock()
        self.clear()

    def clear(self) -> None:
        """Forget the last run."""
        self.problem: Problem | None = None  # what is on the table; None if what moves is elsewhere
        self.records: list[StepRecord] = []
        self.replannings: list[Replanning] = []
        self.moment: Moment | None = None  # the step at hand, what is left, and where all was before it
        self.run: Run | None = None  # its record, once it is over
        self.seen: Seen | None = None  # the last pose
        self.scene: Scene | None = None  # where something of the data happens again
        self.tries: list[Tried] = []  # how motions turned out
        self._left: Scene | None = None  # where a run left everything, before motions were tried
        self.promise: Promise | None = None  # what all of them are compared with, if they are many

    @property
    def is_active(self) -> bool:
        """Whether something runs, or waits in line."""
        return self.ticket is not None

    @property
    def here(self) -> Scene | None:
        """Where everything on the table is by a run, at rest; None if it is as it was set."""
        return self.moment.scene if self.moment else self._left

    @property
    def has_ended(self) -> bool:
        """Whether the table is not as it is set, since something ran or was tried there."""
        return not self.is_active and bool(self.seen or self.run or self.tries)

    def as_it_stands(self) -> Problem | None:
        """Return what is on the table where a run has it by now; what is only tried leaves nothing."""
        problem = self._session.problem
        return placed(problem, self.here) if problem and self.here else problem

    def begin(self, replans: int | None = None) -> None:
        """Run the plan that is shown; with replans = 0 it is followed blindly."""
        planned, problem = self._session.plan_shown, self._session.problem
        if planned is None or not planned.plan_file or problem is None:
            self._session.say("There is no plan to run; plan first.", is_bad=True)
            return
        given = problem.name, planned.plan_file, planners_here()[0], replans
        self._submit(f"running the plan of {planned.record.planner}", problem, work.run, *given)

    def replay(self, name: str) -> None:
        """Run a record of the domain again, as it is; `name` is without its ending."""
        session, problem = self._session, name.split(".")[0]
        library = session.library
        if problem not in library.folder.problem_names() or name not in library.run_names():
            session.say(f"There is no record of a run called {name}.", is_bad=True)
            return
        session.load(problem)
        if session.problem is not None and session.problem.name == problem:
            self._submit(f"replaying {name}", session.problem, work.replay, name)

    def perform(self, name: str, action: tuple[float, ...]) -> None:
        """Try an action on an object as it stands; how that ends is seen until the table is `reset`."""
        if problem := self.as_it_stands():
            given = self._session.problem, work.perform, problem, name, action
            self._submit(f"trying a motion on {name}", *given, left=self.here)

    def try_ten(self, name: str, operator: str) -> None:
        """Try an operator on an object `TRIES` times, each from a start a few millimetres beside the last."""
        problem, session = self.as_it_stands(), self._session
        promise = next((one for one in session.promises(name) if one.operator.name == operator), None)
        if problem is None or promise is None:
            session.say(f"{operator} promises nothing for {name}.", is_bad=True)
            return
        action = session.library.grounding.primitive_of(promise.operator).action
        given = session.problem, work.try_often, problem, name, action
        self._submit(
            f"trying {operator} on {name} {work.TRIES} times", *given, promise=promise, left=self.here
        )

    def tally(self) -> str:
        """Say how many tries went as promised, if they are compared with a promise."""
        if self.promise is None:
            return ""
        kept = sum(one.keeps(self.promise) for one in self.tries)
        told = f"{promise_in_words(self.promise)}: {kept} of {len(self.tries)} as promised"
        return f"{told}; promised {self.promise.chance:.0%}"

    def recall(self, row: int) -> None:
        """Make an interaction of the domain's data happen again, by its number, counted from 0."""
        data = self._session.library.folder / INTERACTIONS
        self._submit(f"interaction {row} again", None, work.recall, data, row)

    def stop(self) -> None:
        """End a run before its next step; what moves is computed to its end at once."""
        if (ticket := self.ticket) and ticket.place:
            ticket.stop()
        elif ticket:
            self.steer(is_stopped=True)

    def steer(self, **changes: float | bool) -> None:
        """Change how the run goes on, and the next one, too; the changes are fields of `Controls`."""
        controls = msgspec.structs.replace(self.controls, **changes)
        if ticket := self.ticket:
            ticket.say(controls)
        self.controls = msgspec.structs.replace(controls, one_step=False)
        self._session.tell("status")

    def grab(self, grab: Grab) -> None:
        """Put an object elsewhere before the next step, or raise `NeurosymError` if it cannot be."""
        if self.problem is None or self.ticket is None:
            raise InvalidValue("Nothing runs.")
        self.problem.object_named(grab.object)
        self._session.library.grounding.table.check(grab.object, grab.x, grab.y)
        self.ticket.say(grab)
        self._session.say(f"{grab.object} is moved before the next step")

    def _submit(
        self,
        what: str,
        problem: Problem | None,
        do: Callable[..., Any],
        *given: Any,
        promise: Promise | None = None,
        left: Scene | None = None,
    ) -> None:
        with self._lock:
            if self.is_active:
                self._session.say("Something runs already; stop it first.", is_bad=True)
                return
            self.clear()
            self.problem, self.promise, self._left = problem, promise, left
            self.controls = msgspec.structs.replace(self.controls, is_stopped=False)
            self._session.say(what)  # first, since an answer may come at once
            self.ticket = self._workers.submit(self._hear, do, self._session.room, *given, self.controls)
        self._session.tell("run")

    def _hear(self, said: Any) -> None:
        """Take in what the process sends."""
        if isinstance(said, Seen):
            self.seen = said
            self._session.tell("pose")
        elif isinstance(said, Moment):
            self.moment = said
            self._session.tell("step")
        elif isinstance(said, StepRecord):
            self.records.append(said)
            self._session.tell("step")
        elif isinstance(said, Replanning):
            self.replannings.append(said)
            self._session.say(_replanned(said))
        elif isinstance(said, Tried):
            self.tries.append(said)
            self._session.tell("step")
        elif isinstance(said, Scene):
            self.scene = said
            self._session.tell("run")
        else:
            self._end(said)

    def _end(self, said: Ran | Word) -> None:
        """Keep and say what came of it, and only then let something else begin."""
        with self._lock:
            self.controls = msgspec.structs.replace(self.controls, is_stopped=False, is_paused=False)
            if isinstance(said, Ran):
                self.run, self.records = said.run, list(said.run.steps)
                if self.moment and said.run.ended == "lost":  # no step is asked for after that
                    before, ends = self.moment.scene, np.array([*self.records[-1].positions.values()])
                    scene = replace(before, positions=ends)
                    self.moment = replace(self.moment, scene=scene)
            word = _ran(said) if isinstance(said, Ran) else said if said.text else Word(self.tally())
            self._session.say(*word)
            self.ticket = None
        self._session.tell("run")


def _replanned(replanning: Replanning) -> str:
    """Say what came of asking for a new plan."""
    when = f"before step {replanning.before_step}"
    if replanning.reason and not replanning.plan:
        return f"No new plan was found {when}: {replanning.reason}"
    return f"Planned anew {when}: {replanning.why}"


def _ran(said: Ran) -> Word:
    """Say what became of a run."""
    run, steps = said.run, counted(len(said.run.steps), "step")
    text = f"{run.outcome} in {steps}" if run.reached else f"goal missed: {run.reason}"
    if said.course:
        text += f"; the record says {'the same' if said.course != 'another' else 'otherwise'}"
    return Word(text, is_bad=not run.reached)
