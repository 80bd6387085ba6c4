"""What a page does: the methods of one object, which know nothing of a browser.

A page calls them, and is told by topic what has changed; tests call them, too. Everything that computes for
long is handed to a process (`workers`), whose answers come in threads of their own.
"""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec

from neurosym.choices import AnyTask
from neurosym.errors import InvalidValue
from neurosym.operators import vector
from neurosym.pddl.encoding_names import EncodingName
from neurosym.problems import Problem
from neurosym.reading import decode_json
from neurosym.related import is_relational
from neurosym.stages.planning import check_scene
from neurosym.stages.scenes import scene_stage
from neurosym.studio.desk import MOST_OBJECTS, Desk, Topic
from neurosym.studio.library import Library
from neurosym.studio.messages import Drawn, DrawTask, Failed, Grab, Planned, PlanNew
from neurosym.studio.rooms import Room
from neurosym.studio.running import Running
from neurosym.studio.saying import Word, told
from neurosym.studio.setting import has_goals
from neurosym.studio.telling import plan_word
from neurosym.studio.workers import Ticket, Workers
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.transition import validate
from neurosym.wording import counted

MOST_FILE = 1_000_000
"""Bytes of a scene that is opened on the page."""
__all__ = ["MOST_OBJECTS", "Session", "Topic", "Word"]


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
        self._next_plans: list[PlanNew] = []

    def close(self) -> None:
        """End what it works on, and remove its folder."""
        self.stop_planning()
        self.stop_drawing()
        self.running.close()
        self.room.close()

    @property
    def is_planning(self) -> bool:
        """Whether a planner works, or waits in line."""
        return self._planning is not None

    @property
    def is_drawing(self) -> bool:
        """Whether a task is being drawn, or waits in line for that."""
        return self._drawing is not None

    @property
    def place(self) -> int:
        """How many plans of others are before this page's; 0 if it does not wait."""
        ticket = self._planning
        return ticket.place if ticket else 0

    @told
    def draw(
        self,
        objects: int,
        seed: int,
        task: AnyTask | None,
        *,
        goals: bool = True,
        done: Callable[[Problem], None] = lambda _: None,
    ) -> None:
        """Draw a task: as the paper draws them, or of a kind that people ask for.

        Args:
            objects: How many objects.
            seed: Same seed, same task.
            task: Its kind; None for the paper's.
            goals: Whether objects keep their goals.
            done: Called with the task once it is on the table; never, if it does not come there.
        """
        self._refuse_while_running()
        if not 1 <= objects <= MOST_OBJECTS:
            raise InvalidValue(f"{objects} objects cannot be drawn; valid: 1 to {MOST_OBJECTS}.")
        job = DrawTask(self.room.path, f"drawn-{task or 'paper'}-{objects}-{seed}", objects, seed, task)
        with self._lock:  # so that the answer is not heard before it is known that it is waited for
            if self.is_drawing:
                raise InvalidValue("A task is being drawn; wait for it.")
            self.say("drawing a task")
            before = self.problem
            self._drawing = self._planners.submit(
                job, lambda said: self._hear_drawn(said, before, goals=goals, done=done)
            )
        self.tell("status")

    def stop_drawing(self) -> None:
        """Give up the task that is being drawn."""
        if ticket := self._drawing:
            ticket.stop()

    def _hear_drawn(
        self, said: Any, before: Problem | None, *, goals: bool, done: Callable[[Problem], None]
    ) -> None:
        """Put what was drawn on the table, if that is still as it was before."""
        with self._lock:
            word = Word("the table was changed meanwhile; draw again", is_bad=True)
            if isinstance(said, Failed):
                word = Word(said.sentence, is_bad=True)
            elif isinstance(said, Drawn) and self.problem is before and not self.running.is_active:
                problem = said.problem
                many = counted(len(problem.objects), "object")
                word = Word(f"a task with {many} is on the table")
                if not goals:
                    problem = msgspec.structs.replace(problem, goals={}, relations=())
                    word = Word(f"{many} stand on the table")
                self._change(problem, "scene")
                done(problem)
            self._drawing = None
        self.say(word.text, is_bad=word.is_bad)

    @told
    def open_file(self, content: bytes) -> None:
        """Put the scene of a file on the table.

        Args:
            content: What the file holds, as `Problem.save` writes it.
        """
        self._refuse_while_running()
        if len(content) > MOST_FILE:
            raise InvalidValue(f"The file has {len(content):,} bytes; a scene has at most {MOST_FILE:,}.")
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
            raise InvalidValue(
                "A shipped domain is never written into; take the scene away as a file instead."
            )
        file = self.room.path / "saved.json"
        problem.save(file)
        with folder.naming_problems():
            folder.perform(scene_stage(folder, file, name=problem.name), again=True)
        self.say(f"saved as {problem.name}")

    @told
    def plan(self, *planners: str, encoding: EncodingName | None = None) -> None:
        """Plan, with one planner after another; the first plan that is found is chosen.

        Where there is no plan to the goals, it is one to the nearest points that are found; of relations
        there are no nearest ones.
        """
        problem = self._problem()
        self._refuse_while_running()
        if not has_goals(problem):
            raise InvalidValue("No object has a goal; give one a goal, and plan then.")
        nearest = not is_relational(problem, self.library.grounding)
        with self._lock:
            if self.is_planning:
                raise InvalidValue("A planner is at work; stop it, or wait for it.")
            self.plans, self.chosen = {}, ""
            self._next_plans = [
                PlanNew(self.room.path, problem, planner, encoding, nearest=nearest) for planner in planners
            ]
            self.say(f"{planners[0]} is planning")
            self._plan_next()
        self.tell("plan")
        self.tell("status")

    def stop_planning(self) -> None:
        """End the planner that works."""
        with self._lock:
            ticket, self._next_plans = self._planning, []
        if ticket is not None:
            ticket.stop()

    @told
    def choose(self, planner: str) -> None:
        """Show the plan of one of the planners that were asked."""
        if planner in self.plans:
            self.chosen = planner
            self.tell("plan")

    @property
    def plan_shown(self) -> Planned | None:
        """The plan that is shown and run, if there is one."""
        return self.plans.get(self.chosen)

    def _plan_next(self) -> str:
        """Ask the planner that is next, and name it; nobody, if all were asked.

        Whoever calls it holds the lock, so that no answer is heard before it is known whom it is from.
        """
        if not self._next_plans:
            self._planning = None
            return ""
        job = self._next_plans.pop(0)
        self._planning = self._planners.submit(job, lambda said: self._hear_plan(job, said))
        return job.planner

    def _hear_plan(self, job: PlanNew, said: Any) -> None:
        """Keep what a planner found, and only then let another one begin."""
        with self._lock:
            word = self._keep_plan(job, said)
            planner = self._plan_next()
        self.say(word.text, is_bad=word.is_bad)
        self.tell("plan")
        if planner:
            self.say(f"{planner} is planning")

    def _keep_plan(self, job: PlanNew, said: Any) -> Word:
        """Keep what a planner found for what is on the table, and return what is to be said of it."""
        if isinstance(said, Planned) and job.problem == self.problem:
            planner = said.record.planner
            self.plans[planner] = said
            if not self.chosen or (said.plan_file and not self.plans[self.chosen].plan_file):
                self.chosen = planner
            return plan_word(said.record)
        self._next_plans = []
        if isinstance(said, Failed):
            return Word(said.sentence, is_bad=True)
        return Word("the table was changed meanwhile; plan again")

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

    def forget_action(self) -> None:
        """Show the table as it is set, and not as an action left it that was only tried; runs are kept."""
        if self.running.forget_action():
            self.tell("run")

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

    def _changed(self, topic: Topic) -> None:
        """What was planned for the table as it was no longer fits, and the last run is over."""
        with self._lock:
            had_plans, self.plans, self.chosen = bool(self.plans), {}, ""
        if self.running.clear():
            self.tell("run")
        self.tell(topic)
        if had_plans:
            self.tell("plan")
