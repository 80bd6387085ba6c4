"""Execution: a plan runs in the world, and each step is compared with what its operator promised.

A `put-down-...` step is the second half of the lift before it: the world performs both as one interaction,
and only a lift that ends the plan is left in mid-air. Where a planner is at hand, what is left of the plan is
replayed from what is seen after every step; if it would miss the goal, a new plan is asked for, as long as
new plans come nearer to it, and as long as all of them together have not taken too much work.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

import msgspec
import numpy as np

from neurosym.checks import check_all, check_callable, check_count, check_kind, check_seed
from neurosym.contract import guarded, limits_of, placed
from neurosym.errors import InvalidValue
from neurosym.execution.performance import STOP, Moment, Situation, Watcher, drawn_nudge
from neurosym.execution.record import Ended, Nudge, Replanning, Run, StepRecord, own_steps, why_missed
from neurosym.execution.replanning import (
    NEARER,
    PATIENCE,
    Experience,
    new_plan,
    usual_replans,
    usual_work,
    why_not_go_on,
)
from neurosym.grounding import Grounding, is_lift
from neurosym.planners.planner import Effort, Tell
from neurosym.planners.registry import Replanner
from neurosym.problems import Problem, Trial
from neurosym.tasks.goal_choice import with_goals
from neurosym.tasks.task import is_at, understand
from neurosym.tasks.transition import PlanStep, check_aims, named_steps, primitives, promise_of, validate
from neurosym.world import (
    FrameSink,
    OtherObject,
    Outcome,
    Reference,
    Scene,
    World,
    heading,
    heading_to,
    turned_by,
)

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
    on_trial: Callable[[str, Trial], None] | None = None,
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
        on_trial: Called with the name of an object and what became of it, for its past, if given.
        watcher: Asked before each step whether to nudge an object or to stop, and told of new plans.
        tell: Told of each step and each new plan before it is done or made, if given.

    Raises:
        InvalidValue: If something is not what it should be, or a step names an object that there is not.
        InvalidWorld: If it is no world, or a world of one's own that fails.
        UnknownChoice: If a step names an operator that there is not.
    """
    world = guarded(world)
    _check_run(world, problem, grounding, plan)
    check_count("replans", 0 if replans is None else replans, least=0)
    if replanner is not None:
        check_callable("replanner", replanner, "a function from a problem and a grounding to a plan result")
    check_seed(nudge_seed or 0, "nudge_seed")
    most = (usual_replans(plan) if replans is None else replans) if replanner else 0
    places = understand(problem, grounding).places
    here = Situation(world, msgspec.structs.replace(problem, places=places), grounding, on_frame)
    check_aims(here.problem, grounding, plan)
    run = _Running(here, plan, watcher, tell or (lambda _: None), on_trial)
    while run.ended in ("plan", "budget", "work"):
        if nudge := drawn_nudge(nudge_seed, primitives(plan), run.moment, problem, world.table):
            run.be_nudged(nudge)
        if watcher and not run.heed(watcher):
            break
        if replanner and most and (why := run.why_not_go_on()):
            run.replan(replanner, why, most, is_drawn=not problem.places)
        if not run.left:
            break
        run.step()
        if on_step:
            on_step(run.records[-1])
    return run.record(plan)


def _check_run(world: World, problem: Problem, grounding: Grounding, plan: Sequence[PlanStep]) -> None:
    """Refuse what cannot be executed before anything moves."""
    check_kind("problem", problem, Problem, "a Problem")
    check_kind("grounding", grounding, Grounding, "a Grounding")
    check_all("plan", plan, PlanStep, "steps, as in PlanResult.steps")
    for step in plan:
        grounding.operator_named(step.base)
        problem.object_named(step.object)
    if beneath := getattr(world, "beneath", None):  # of one that sees: what of it is not seen must be known
        beneath(problem.scene())
    if limits := limits_of(world):
        if reason := limits.too_many(len(problem.objects)):
            raise InvalidValue(f"The problem {problem.name} cannot be executed: {reason}.")
        for item, unseen in zip(problem.objects, problem.scene().unseen.tolist(), strict=True):
            limits.check(item.name, item.features)
            limits.check_unseen(item.name, unseen)


class _Running:
    """A run while it goes on: where everything is, what is left to do, and what was done.

    Of the plans so far, `fewest` is how many primitives any had left; `nearest` is the least sum of the
    distances from the goals [m], and `stalled` how many new plans in a row changed neither.
    """

    def __init__(
        self,
        here: Situation,
        plan: Sequence[PlanStep],
        watcher: Watcher | None,
        tell: Tell,
        on_trial: Callable[[str, Trial], None] | None = None,
    ):
        self.here, self.left, self.watcher, self.tell = here, list(plan), watcher, tell
        self.on_trial = on_trial
        self.aimed, self.experience = here.problem, Experience(here.grounding)
        self.effort = Effort(usual_work(here.problem))
        self.fewest, self.nearest, self.stalled = primitives(plan), self._miss(), 0
        self.records, self.replannings, self.nudges = list[StepRecord](), list[Replanning](), list[Nudge]()
        self.ended: Ended = "plan"
        self._lifted: tuple[PlanStep, Scene] | None = None

    @property
    def moment(self) -> Moment:
        """The run before its next step."""
        return Moment(len(self.records) + 1, self.here.scene, tuple(self.left))

    def heed(self, watcher: Watcher) -> bool:
        """Do what a watcher wants before the next step, and say whether the run goes on."""
        while answer := watcher.before_step(self.moment):
            if answer == STOP:
                self.ended = "stopped"
                return False
            self.here.problem.object_named(answer.object)
            self._put_down()
            self.be_nudged(msgspec.structs.replace(answer, before_step=self.moment.number))
        return True

    def be_nudged(self, nudge: Nudge) -> None:
        """Note that an object was moved; a drawn nudge comes while the hand holds what it lifted."""
        self.nudges.append(nudge)
        self.here.be_nudged(nudge)

    def why_not_go_on(self) -> str:
        """Say why what is left of the plan would miss its goals by what is believed now, or nothing."""
        aimed = self.aimed if self.left else self.here.problem
        return why_not_go_on(self.left, self.here.now(aimed), self.experience)

    def replan(self, replanner: Replanner, why: str, most: int, *, is_drawn: bool) -> None:
        """Ask for a new plan, with places drawn anew or not; if there is none, go on with a possible one."""
        number, asked = self.moment.number, len(self.replannings) + 1
        self.tell(f"planning anew before step {number}, new plan {asked}: {why}")
        if asked > most or self.effort.is_used_up:
            self.ended = "budget" if asked > most else "work"
            return
        if self.stalled >= PATIENCE:
            self.ended, self.left = "no progress", []
            return
        self._put_down()
        seen = self._asked_now()
        if is_drawn:
            believed = self.experience.believed(msgspec.structs.replace(seen, places={}))
            seen = msgspec.structs.replace(seen, places=understand(believed, self.here.grounding).places)
        new = new_plan(replanner, seen, self.experience, self.effort)
        self.experience = new.experience
        steps = named_steps(new.steps)
        self.replannings.append(Replanning(number, why, steps, new.reason))
        if self.watcher:
            self.watcher.replanned(self.replannings[-1])
        is_found = bool(new.steps) and not new.reason
        fewest, miss = primitives(new.steps) if is_found else self.fewest, self._miss()
        is_nearer = fewest < self.fewest or miss < self.nearest - NEARER
        self.stalled = 0 if is_nearer else self.stalled + 1
        self.fewest, self.nearest = min(fewest, self.fewest), min(miss, self.nearest)
        if new.steps:
            self.left, self.aimed = list(new.steps), new.problem
        elif not (self.left and validate(self.left, self.here.now(self.aimed), self.here.grounding).possible):
            self.ended, self.left = "work" if self.effort.is_used_up else "no plan", []

    def step(self) -> None:
        """Perform the next step of the plan, and put down what it lifts unless that ends the plan."""
        number, grounding = self.moment.number, self.here.grounding
        step, before = self.left.pop(0), self.here.scene
        self.tell(f"step {number}: {step.operator} {step.object}")
        put_down = bool(self.left) or not is_lift(grounding.operator_named(step.operator))
        if self.left and self.left[0].puts_down:
            self.left.pop(0)
        with placed(f"step {number}"):
            record, outcome = self.here.perform(step, put_down, self._aim(step))
        self.records.append(record)
        if outcome is None:
            self.ended = "out of reach"
        elif put_down or not outcome.held:
            self._take(step, outcome)
        else:
            self._lifted = step, before

    def record(self, plan: Sequence[PlanStep]) -> Run:
        """Say what became of the run, whose steps were asked for."""
        judged = self.here.judge()
        run = Run(
            problem=self.here.problem.name,
            plan=named_steps(plan),
            steps=tuple(self.records),
            reason="",
            nudge=self.nudges[0] if self.nudges else None,
            more_nudges=tuple(self.nudges[1:]) or msgspec.UNSET,
            replannings=tuple(self.replannings),
            ended="goal" if judged["reached"] else self.ended,
            own=own_steps(self.records, self.replannings),
            **judged,
        )
        reason = why_missed(run, self.here.now(), self.here.grounding, self.effort.work)
        return msgspec.structs.replace(run, reason=reason)

    def _put_down(self) -> None:
        """Put down what the last step lifted: the same interaction, to its end."""
        if self._lifted:
            (step, self.here.scene), self._lifted = self._lifted, None
            self.records[-1], outcome = self.here.perform(step, put_down=True, is_shown=False)
            assert outcome is not None, "what was performed once can be performed again"
            self._take(step, outcome)

    def _take(self, step: PlanStep, outcome: Outcome) -> None:
        trial = self.experience.learn(step, outcome)
        if trial and self.on_trial:
            self.on_trial(step.object, trial)
        if outcome.lost:
            self.ended = "lost"

    def _asked_now(self) -> Problem:
        """Return the problem from here, with goals chosen anew where conditions leave a choice."""
        seen = self.here.now()
        try:
            return with_goals(seen, self.here.grounding)
        except InvalidValue:  # nothing meets them from here
            return seen

    def _aim(self, step: PlanStep) -> Reference | None:
        """Return where to aim, such that an object stands at its place by what is believed of it now."""
        names, table = self.here.problem.object_names, self.here.world.table
        if not step.place:
            return None
        if step.place in names:
            return OtherObject(names.index(step.place))
        believed = self.experience.believed(self.here.now(self.aimed))
        promise = promise_of(step, believed, self.here.grounding).promise
        x, y = self.aimed.place_named(step.place)
        off_x, off_y = promise.resting_effect[:2] if promise else (0.0, 0.0)
        asked = self.aimed.headings.get(step.object)
        if asked is None or not is_at(step.object, (x, y), understand(self.aimed, self.here.grounding).flat):
            return table.nearest(x - off_x, y - off_y)
        wanted, lies = math.radians(asked), self.here.scene.orientations[names.index(step.object)]
        turn = heading(lies) + heading_to(lies, wanted)
        off_x, off_y = turned_by(turn, np.array([off_x, off_y])).tolist()
        return replace(table.nearest(x - off_x, y - off_y), heading=wanted)

    def _miss(self) -> float:
        """Return how far objects are from their goals, in sum, a missed relation as if it were far [m]."""
        distances = self.here.problem.distances(self.here.scene.positions)
        return math.fsum([*distances.values(), FAR * len(self.here.unmet())])
