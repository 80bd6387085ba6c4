"""What is said between a page and the process that works for it."""

from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from neurosym.arrays import Float
from neurosym.choices import AnyTask
from neurosym.execution.record import Run, StepRecord
from neurosym.pddl.encoding_names import EncodingName
from neurosym.problems import Problem
from neurosym.stages.plan_records import PlanRecord
from neurosym.table import Place
from neurosym.world import OutcomeKind, Scene


@dataclass(frozen=True, slots=True)
class Controls:
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

    def without_step(self) -> "Controls":
        """Return the controls once the one step is done."""
        return replace(self, one_step=False)


@dataclass(frozen=True, slots=True)
class Grab:
    """Put an object somewhere else on the table before the next step, x and y [m]."""

    object: str
    x: float
    y: float


@dataclass(frozen=True, slots=True)
class Job:
    """Something to do in the folder of a page.

    Attributes:
        folder: The folder.
    """

    folder: Path


@dataclass(frozen=True, slots=True)
class Make(Job):
    """Take a problem over into the folder."""

    problem: Problem


@dataclass(frozen=True, slots=True)
class PlanNew(Job):
    """Take a problem over, and plan; in the planner's usual encoding if none is given."""

    problem: Problem
    planner: str
    encoding: EncodingName | None = None
    nearest: bool = False
    time_limit: float | None = None


@dataclass(frozen=True, slots=True)
class RunPlan(Job):
    """Execute the file of a plan, relative to the folder, for a problem of it."""

    problem: str
    plan_file: str
    replanner: str
    replans: int | None
    controls: Controls = field(default_factory=Controls)


@dataclass(frozen=True, slots=True)
class Replay(Job):
    """Run a record of the folder again."""

    run: str
    controls: Controls = field(default_factory=Controls)


@dataclass(frozen=True, slots=True)
class DrawTask(Job):
    """Draw a task: as the paper draws them, or of a kind that people ask for; `tolerance` in metres."""

    name: str
    objects: int
    seed: int
    task: AnyTask | None
    tolerance: float | None = None


@dataclass(frozen=True, slots=True)
class Perform(Job):
    """Perform an action on an object of a scene."""

    problem: Problem
    object: str
    action: tuple[float, ...]
    reference: Place | None = None
    controls: Controls = field(default_factory=Controls)


@dataclass(frozen=True, slots=True)
class Recall(Job):
    """Make a row of a data set happen again."""

    data: Path
    row: int
    controls: Controls = field(default_factory=Controls)


@dataclass(frozen=True, slots=True, eq=False)
class Seen:
    """Where everything is, see `Pose`; and at which step of a plan, counted from 1, or 0 if it is at none."""

    seconds: float
    phase: str
    links: Float[np.ndarray, "L 7"]
    positions: Float[np.ndarray, "M 3"]
    orientations: Float[np.ndarray, "M 4"]
    step: int = 0


@dataclass(frozen=True, slots=True, eq=False)
class Next:
    """The step that is next: its number, what is left of the plan, and where everything is [m].

    What is left is operator, object and place of each step.
    """

    number: int
    left: tuple[tuple[str, str, str], ...]
    scene: Scene


@dataclass(frozen=True, slots=True)
class Step:
    """What a step did."""

    record: StepRecord


@dataclass(frozen=True, slots=True)
class Drawn:
    """A problem that lies in the folder now."""

    problem: Problem


@dataclass(frozen=True, slots=True)
class Planned:
    """How planning went, and the file of the plan relative to the folder, if there is one."""

    record: PlanRecord
    plan_file: str


@dataclass(frozen=True, slots=True)
class Ran:
    """What became of a run, and its file relative to the folder; how it agrees with the record it replays."""

    run: Run
    file: str
    course: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class Performed:
    """What one action did: how its object ended, how far it moved [m], and where everything is then."""

    kind: OutcomeKind
    effect: tuple[float, ...]
    end: Scene
    said: str = ""


@dataclass(frozen=True, slots=True)
class Failed:
    """Why a job was not done, in a sentence."""

    sentence: str


ANSWERS = (Drawn, Planned, Ran, Performed, Failed)
"""What a job ends with."""
