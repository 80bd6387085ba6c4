"""Execution: a plan runs in the world, and each step is compared with what its operator promised.

A `put-down-...` step is the second half of the lift before it: the world performs both as one interaction,
and only a lift that ends the plan is left in mid-air. Where a planner is at hand, what is left of the plan is
replayed from what is seen after every step; if it would miss the goal, a new plan is asked for, as long as
new plans come nearer to it, and as long as all of them together have not taken too much work.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import msgspec

from neurosym.execution.beforehand import check_references, check_run
from neurosym.execution.experience import Experience, believed_name
from neurosym.execution.nudges import Nudger, nudged
from neurosym.execution.performing import lifts, perform, recorded
from neurosym.execution.reasons import why_missed
from neurosym.execution.record import Ended, Nudge, Replanning, Run, StepRecord, own_steps, record_refusal
from neurosym.execution.relating import levelled, missed_relations, prepared, seen_now
from neurosym.execution.replanning import (
    PATIENCE,
    Progress,
    new_plan,
    usual_replans,
    usual_work,
    why_not_go_on,
)
from neurosym.execution.watching import STOP, Moment, Watcher
from neurosym.grounding import Grounding
from neurosym.guarded import guarded, placed
from neurosym.planners.effort import Effort
from neurosym.planners.planner import Tell
from neurosym.planners.registry import Replanner
from neurosym.problems import Problem
from neurosym.promises import promised
from neurosym.related import Contacts, touching, unmet_relations
from neurosym.table import OtherObject, Reference
from neurosym.tasks.steps import PlanStep, Steps, named_steps, primitives
from neurosym.tasks.transition import validate
from neurosym.world import FrameSink, Outcome, Scene, World

FAR = 0.1
"""As how far from its goal an object counts whose relation is missed [m]."""


def execute(
    world: World,
    problem: Problem,
    grounding: Grounding,
    plan: Sequence[PlanStep],
    *,
    replanner: Replanner | None = None,
    replans: int | None = None,
    nudge_seed: int | None = None,
    on_frame: FrameSink | None = None,
    on_step: Callable[[StepRecord], None] | None = None,
    watcher: Watcher | None = None,
    tell: Tell | None = None,
) -> Run:
    """Run a plan in the world with the distilled parameters of its primitives.

    Without a replanner the plan is followed to its end whatever the steps do, unless an object is lost or out
    of reach.

    Args:
        world: The world to act in.
        problem: The scene to start from and the goals to judge by.
        grounding: What the operators' names mean.
        plan: The steps, whichever planner they come from.
        replanner: Plans anew where the plan would miss the goal from what is seen, if given.
        replans: How many new plans may be asked for; `usual_replans` if not given.
        nudge_seed: Nudge an object once during the run, drawn from this seed, if given.
        on_frame: Called with pictures of the motion as it happens, if given.
        on_step: Called with each step's record as soon as it is done, if given.
        watcher: Asked before each step whether to nudge an object or to stop, and told of new plans.
        tell: Told of each step and each new plan before it is done or made, if given.

    Raises:
        InvalidValue: If something is not what it should be, or a step names an object that there is not.
        InvalidWorld: If it is no world, or a world of one's own that fails.
        UnknownChoice: If a step names an operator that there is not.
    """
    world = guarded(world)
    check_run(world, problem, grounding, plan, replanner, replans, nudge_seed)
    nudger = None
    if nudge_seed is not None:
        nudger = Nudger(nudge_seed, primitives(plan))
    most = (usual_replans(plan) if replans is None else replans) if replanner else 0
    drawn = problem.places is msgspec.UNSET
    problem = prepared(problem, grounding)
    check_references(problem, grounding, plan)
    run = _Running(world, problem, grounding, list(plan), on_frame, most, drawn)
    while run.goes_on:
        if nudger and nudger.before_step == len(run.records) + 1 and not run.nudges:
            run.draw_nudge(nudger)
        if watcher and not run.heed(watcher):
            break
        if replanner and most and (why := run.why_not_go_on()):
            asked = len(run.replannings)
            if tell:
                tell(f"planning anew before step {len(run.records) + 1}, new plan {asked + 1}: {why}")
            run.replan(replanner, why)
            if watcher and run.replannings[asked:]:
                watcher.replanned(run.replannings[-1])
        if not run.left:
            break
        if tell:
            tell(f"step {len(run.records) + 1}: {run.left[0].operator} {run.left[0].object}")
        run.step()
        if on_step:
            on_step(run.records[-1])
    return run.record(named_steps(plan))


@dataclass(slots=True)
class _Running:
    """A run while it goes on: where everything is, what is left to do, and what was done."""

    world: World
    problem: Problem
    grounding: Grounding
    left: list[PlanStep]
    on_frame: FrameSink | None
    most_replans: int
    places_drawn: bool
    scene: Scene = field(init=False)
    experience: Experience = field(init=False)
    aimed: Problem = field(init=False)
    records: list[StepRecord] = field(default_factory=list)
    replannings: list[Replanning] = field(default_factory=list)
    nudges: list[Nudge] = field(default_factory=list)
    ended: Ended = "plan"
    contacts: Contacts | None = None
    progress: Progress = field(init=False)
    effort: Effort = field(init=False)
    _lifted: tuple[PlanStep, Scene] | None = None

    def __post_init__(self) -> None:
        self.scene, self.aimed = self.problem.scene(), self.problem
        self.contacts = touching(self.problem) if isinstance(self.problem.touching, tuple) else None
        self.experience = Experience(self.grounding)
        self.effort = Effort(usual_work(self.problem))
        self.progress = Progress(primitives(self.left), self._miss())

    @property
    def goes_on(self) -> bool:
        """Whether nothing has ended the run yet."""
        return self.ended in ("plan", "budget", "work")

    def draw_nudge(self, nudger: Nudger) -> None:
        """Move an object somewhere drawn at random, if there is room for that."""
        if drawn := nudger.nudge(self.problem, self.scene, self.world.table):
            self._be_nudged(drawn)

    def heed(self, watcher: Watcher) -> bool:
        """Do what a watcher wants before the next step, and say whether the run goes on."""
        number = len(self.records) + 1
        while answer := watcher.before_step(Moment(number, self.scene, tuple(self.left))):
            if answer == STOP:
                self.ended = "stopped"
                return False
            self.problem.object_named(answer.object)
            self._put_down()
            number = len(self.records) + 1
            self._be_nudged(msgspec.structs.replace(answer, before_step=number))
        return True

    def _be_nudged(self, nudge: Nudge) -> None:
        self.nudges.append(nudge)
        self.scene, self.contacts = nudged(self.scene, nudge, self.problem), None

    def why_not_go_on(self) -> str:
        """Say why what is left of the plan would miss its goals by what is believed now, or nothing."""
        aimed = self.aimed if self.left else self.problem
        return why_not_go_on(self.left, self._now(aimed), self.experience)

    def replan(self, replanner: Replanner, why: str) -> None:
        """Ask for a new plan, or else go on with the old one while nothing leaves the table.

        Args:
            replanner: Whom to ask.
            why: Why the old plan will not do.
        """
        if len(self.replannings) >= self.most_replans:
            self.ended = "budget"
            return
        if self.effort.is_used_up:
            self.ended = "work"
            return
        if self.progress.stalled >= PATIENCE:
            self.ended, self.left = "no progress", []
            return
        self._put_down()
        new = new_plan(replanner, self._with_new_places(self._now()), self.experience, self.effort)
        self.experience = new.experience
        steps = named_steps(new.steps)
        self.replannings.append(Replanning(len(self.records) + 1, why, steps, new.reason))
        self.progress.note(primitives(new.steps) if new.is_found else None, self._miss())
        if new.steps:
            self.left, self.aimed = list(new.steps), new.problem
        elif not self.left or not validate(self.left, self._now(self.aimed), self.grounding).possible:
            self.ended, self.left = "work" if self.effort.is_used_up else "no plan", []

    def step(self) -> None:
        """Perform the next step of the plan, and put down what it lifts unless that ends the plan."""
        step = self.left.pop(0)
        put_down = bool(self.left) or not lifts(step, self.grounding)
        if self.left and self.left[0].puts_down:
            self.left.pop(0)
        before = self.scene
        with placed(f"step {len(self.records) + 1}"):
            outcome = perform(
                self.world,
                self.problem,
                self.grounding,
                step,
                before,
                put_down,
                self.on_frame,
                reference=self._aim(step),
            )
        if outcome is None:
            self.records.append(record_refusal(step, self.problem, self.scene))
            self.ended = "out of reach"
            return
        self._lifted = None if put_down or not outcome.held else (step, before)
        self._take(step, outcome, put_down)

    def record(self, plan: Steps) -> Run:
        """Say what became of the run.

        Args:
            plan: The steps that were asked for.
        """
        distances = self.problem.distances(self.scene.positions)
        unmet = unmet_relations(self._now(), self.grounding)
        reached = self.problem.is_met(self.scene.positions) and not unmet
        ended = "goal" if reached else self.ended
        missed = missed_relations(unmet, self.records, self.grounding)
        return Run(
            problem=self.problem.name,
            plan=plan,
            steps=tuple(self.records),
            reached=reached,
            distances=distances,
            reason=why_missed(
                ended,
                self.records,
                self.replannings,
                distances,
                self.problem.tolerance,
                missed,
                self.effort.work,
            ),
            nudge=self.nudges[0] if self.nudges else None,
            more_nudges=tuple(self.nudges[1:]) or msgspec.UNSET,
            replannings=tuple(self.replannings),
            ended=ended,
            unmet=tuple(unmet) if self.problem.related else msgspec.UNSET,
            own=own_steps(self.records, self.replannings),
        )

    def _put_down(self) -> None:
        """Put down what the last step lifted: the same interaction, to its end."""
        if self._lifted:
            (step, before), self._lifted = self._lifted, None
            self.records.pop()
            outcome = perform(self.world, self.problem, self.grounding, step, before, put_down=True)
            assert outcome is not None, "what was performed once can be performed again"
            self._take(step, outcome, put_down=True)

    def _take(self, step: PlanStep, outcome: Outcome, put_down: bool) -> None:
        self.scene = outcome.end
        if self.grounding.relations:
            self.contacts, outcome = outcome.contacts, levelled(outcome)
        self.records.append(recorded(step, self.problem, self.grounding, outcome, put_down=put_down))
        if not self._lifted:
            self.experience.learn(step, outcome)
        if outcome.lost:
            self.ended = "lost"

    def _aim(self, step: PlanStep) -> Reference | None:
        """Return where to aim, such that an object stands at its place by what is believed of it now."""
        if not step.place:
            return None
        if step.place in self.problem.object_names:
            return OtherObject(self.problem.object_names.index(step.place))
        believed, grounding = self.experience.believed(self._now(self.aimed))
        name = believed_name(step, believed, grounding).operator
        of_item = promised(grounding, believed.object_named(step.object))
        # the object may show otherwise now
        promise = of_item.get(name, grounding.operator_named(name)).promise
        x, y = self.aimed.place_named(step.place)
        off_x, off_y = promise.resting_effect[:2] if promise else (0.0, 0.0)
        return self.world.table.nearest(x - off_x, y - off_y)

    def _miss(self) -> float:
        """Return how far objects are from their goals, in sum, a missed relation as if it were far [m]."""
        unmet = unmet_relations(self._now(), self.grounding)
        return math.fsum([*self.problem.distances(self.scene.positions).values(), FAR * len(unmet)])

    def _with_new_places(self, problem: Problem) -> Problem:
        """Return a problem with places that suit where things stand now, unless it was given its own.

        Args:
            problem: The problem as it stands now.
        """
        if not self.places_drawn:
            return problem
        believed, known = self.experience.believed(msgspec.structs.replace(problem, places=msgspec.UNSET))
        return msgspec.structs.replace(problem, places=prepared(believed, known).places)

    def _now(self, problem: Problem | None = None) -> Problem:
        """Return a problem, the one to be solved if none is given, with the objects as they stand now."""
        contacts = self.contacts if self.grounding.relations else None
        return seen_now(problem or self.problem, self.scene, contacts)
