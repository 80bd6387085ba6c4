"""The stages that use a learned domain: from a problem to a plan, and from a plan to what became of it."""

from collections.abc import Sequence

import msgspec

from neurosym.errors import StageMissing, UnknownChoice
from neurosym.files import write_atomically, write_json
from neurosym.folder import GROUNDING, MODEL, DomainFolder, Stage
from neurosym.pddl.grounding import Grounding
from neurosym.pddl.moves import Encoding
from neurosym.pddl.plan_text import PlanStep, print_ground_plan, print_plan
from neurosym.planners import PLANNERS, Branching, PlanStatus, plan, predicted_branching
from neurosym.problems import Problem


class PlanRecord(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How planning went.

    Attributes:
        problem: Name of the problem.
        planner: Name of the planner.
        status: One of `PlanStatus`.
        steps: Operator and object of each step; empty unless solved.
        seconds: How long it took [s].
        reason: Why there is no plan, or what is to be said about the one found.
    """

    problem: str
    planner: str
    status: str
    steps: tuple[tuple[str, str], ...]
    seconds: float
    reason: str

    @property
    def solved(self) -> bool:
        """Whether there is a plan."""
        return self.status == PlanStatus.SOLVED.value


def load_problem(folder: DomainFolder, name: str) -> Problem:
    """Read a problem of a folder.

    Args:
        folder: The domain folder.
        name: Name of the problem, or the path of its file.

    Raises:
        UnknownChoice: If there is no such problem.
        StageMissing: If its scene is missing.
        InvalidFile: If its scene is damaged.
    """
    scene = folder / f"problems/{folder.problem(name)}.scene.json"
    if not scene.is_file():
        raise StageMissing(scene, f"neurosym new-problem {folder.path} --name {folder.problem(name)}")
    return Problem.load(scene)


def plan_files(problem: str, planner: str) -> tuple[str, str]:
    """Name the files of a plan and of the record of how planning went, relative to the folder."""
    return f"plans/{problem}.{planner}.plan", f"plans/{problem}.{planner}.json"


def plan_stage(
    folder: DomainFolder, name: str, *, planner: str, time_limit: float, encoding: Encoding = "stepwise"
) -> Stage:
    """Plan: problem and grounding (and model, for BFS) -> `plans/NAME.PLANNER.plan` and `.json`."""
    if planner not in PLANNERS:
        raise UnknownChoice("planner", planner, PLANNERS)
    plan_file, record_file = plan_files(name, planner)
    inputs = (f"problems/{name}.scene.json", GROUNDING, *((MODEL,) if planner == "bfs" else ()))

    def work() -> None:
        grounding = Grounding.load(folder.require(GROUNDING))
        problem = load_problem(folder, name)
        branching = _branching(folder, problem, grounding) if planner == "bfs" else None
        result = plan(
            problem, grounding, planner, branching=branching, time_limit=time_limit, encoding=encoding
        )
        record = PlanRecord(
            problem=name,
            planner=planner,
            status=result.status.value,
            steps=tuple((step.operator, step.object) for step in result.steps),
            seconds=round(result.seconds, 3),
            reason=result.reason,
        )
        (folder / "plans").mkdir(exist_ok=True)
        if record.solved:
            write_atomically(folder / plan_file, _plan_text(result.steps, problem, grounding, encoding))
        else:
            (folder / plan_file).unlink(missing_ok=True)
        write_json(folder / record_file, record)

    options = {"time_limit": time_limit, "encoding": encoding}
    return Stage(f"plan {name} {planner}", inputs, (plan_file, record_file), work, options)


def _plan_text(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding, encoding: Encoding) -> str:
    """Print a plan such that validators take it, or in short if a step is not in the PDDL domain."""
    if any(step.base in grounding.left_out for step in steps):
        return print_plan(steps)
    return print_ground_plan(steps, problem, grounding, encoding)


def _branching(
    folder: DomainFolder, problem: Problem, grounding: Grounding
) -> tuple[Branching, tuple[tuple[str, ...], ...]]:
    from neurosym.effect_model import EffectModel

    symbols = [primitive.symbol for primitive in grounding.operators.primitives]
    effects = EffectModel.load(folder.require(MODEL)).branching_table(problem.scene().features, symbols)
    return predicted_branching(problem, grounding, effects)
