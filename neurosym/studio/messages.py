"""What is said between a page and the process that works for it."""

from pathlib import Path

import msgspec

from neurosym.choices import AnyTask
from neurosym.execution.record import Run, StepRecord
from neurosym.pddl.encoding_names import EncodingName
from neurosym.poses import Pose
from neurosym.problems import Problem
from neurosym.stages.plan_records import PlanRecord
from neurosym.table import Place
from neurosym.world import OutcomeKind, Scene


class Controls(msgspec.Struct, frozen=True):
    """How a run goes on; each that is sent takes the place of the one before.

    Attributes:
        speed: How much faster than in reality; 0 for as fast as can be computed.
        is_paused: Whether it waits.
        one_step: Whether it goes on to the end of one step nevertheless.
        is_stopped: Whether it ends before its next step; what moves is computed to its end, without waiting.
    """

    speed: float = 1.0
    is_paused: bool = False
    one_step: bool = False
    is_stopped: bool = False


class Grab(msgspec.Struct, frozen=True):
    """Put an object somewhere else on the table before the next step, x and y [m]."""

    object: str
    x: float
    y: float


class Job(msgspec.Struct, frozen=True):
    """Something to do in the folder of a page.

    Attributes:
        folder: The folder.
    """

    folder: Path


class Make(Job, frozen=True):
    """Take a problem over into the folder."""

    problem: Problem


class PlanNew(Job, frozen=True):
    """Take a problem over, and plan; in the planner's usual encoding if none is given."""

    problem: Problem
    planner: str
    encoding: EncodingName | None = None
    nearest: bool = False
    time_limit: float | None = None


class RunPlan(Job, frozen=True):
    """Execute the file of a plan, relative to the folder, for a problem of it."""

    problem: str
    plan_file: str
    replanner: str
    replans: int | None
    controls: Controls = Controls()


class Replay(Job, frozen=True):
    """Run a record of the folder again."""

    run: str
    controls: Controls = Controls()


class DrawTask(Job, frozen=True):
    """Draw a task: as the paper draws them, or of a kind that people ask for; `tolerance` in metres."""

    name: str
    objects: int
    seed: int
    task: AnyTask | None
    tolerance: float | None = None


class Perform(Job, frozen=True):
    """Perform an action on an object of a scene."""

    problem: Problem
    object: str
    action: tuple[float, ...]
    reference: Place | None = None
    controls: Controls = Controls()


class Recall(Job, frozen=True):
    """Make a row of a data set happen again."""

    data: Path
    row: int
    controls: Controls = Controls()


class Seen(msgspec.Struct, frozen=True, eq=False):
    """Where everything is; and at which step of a plan, counted from 1, or 0 if it is at none."""

    pose: Pose
    step: int = 0


class Next(msgspec.Struct, frozen=True, eq=False):
    """The step that is next: its number, what is left of the plan, and where everything is [m].

    What is left is operator, object and place of each step.
    """

    number: int
    left: tuple[tuple[str, str, str], ...]
    scene: Scene


class Step(msgspec.Struct, frozen=True):
    """What a step did."""

    record: StepRecord


class Drawn(msgspec.Struct, frozen=True):
    """A problem that lies in the folder now."""

    problem: Problem


class Planned(msgspec.Struct, frozen=True):
    """How planning went, and the file of the plan relative to the folder, if there is one."""

    record: PlanRecord
    plan_file: str


class Ran(msgspec.Struct, frozen=True):
    """What became of a run, and its file relative to the folder; how it agrees with the record it replays."""

    run: Run
    file: str
    course: str = ""


class Performed(msgspec.Struct, frozen=True, eq=False):
    """What one action did: how its object ended, how far it moved [m], and where everything is then."""

    kind: OutcomeKind
    effect: tuple[float, ...]
    end: Scene
    said: str = ""


class Failed(msgspec.Struct, frozen=True):
    """Why a job was not done, in a sentence."""

    sentence: str
