"""Tables for the command line: how well a model fits, what operators do, what became of plans."""

from pathlib import Path

import msgspec

from neurosym.console import say, show_table
from neurosym.execution import Run
from neurosym.files import read_json
from neurosym.operators import Operator, OperatorTable, Vector


class TrainingSummary(msgspec.Struct, frozen=True):
    """What is shown of a training report; see `neurosym.training.assess`."""

    held_out: int
    r2_through_codes: float
    r2: float
    mae: dict[str, list[float]]
    object_symbols: dict[str, float]
    action_symbols: dict[str, float]


def show_training(path: Path) -> None:
    """Print how well a model fits interactions it was not trained on, beside trivial predictors.

    Args:
        path: The training report.

    Raises:
        InvalidFile: If it is no training report.
    """
    report = read_json(path, TrainingSummary)
    rows = [[name, *(f"{1000 * error:.1f}" for error in errors)] for name, errors in report.mae.items()]
    axes = [f"{axis} [mm]" for axis in "xyz"[: len(rows[0]) - 1]]
    show_table(f"mean absolute error, {report.held_out} held-out interactions", ["predictor", *axes], rows)
    say(f"R2 through the bits {report.r2_through_codes:.2f}, without cutting to bits {report.r2:.2f}")
    used = f"{len(report.action_symbols)} for actions, {len(report.object_symbols)} for objects"
    say(f"symbols used: {used}")


def show_operators(table: OperatorTable) -> None:
    """Print what each primitive does to each category."""
    columns = ["operator", "rehearsals", "as promised", "ends", "effect [mm]", "spread [mm]"]
    show_table("operators", columns, [_operator_row(operator) for operator in table.operators])


def _operator_row(operator: Operator) -> list[str]:
    promise = operator.promise
    row = [operator.name, str(operator.trials)]
    if promise is None:
        return [*row, "0", "never at rest or held", "", ""]
    ends = f"{promise.kind} {promise.share:.0%}"
    measured = [_millimetres(promise.outcome), _millimetres(promise.scatter)]
    return [*row, str(operator.successes), ends, *measured]


def show_run(run: Run) -> None:
    """Print for each step what was promised and what happened, and whether the goal was reached."""
    rows = [
        [
            str(number),
            f"{step.operator} {step.object}",
            f"{step.promised} {_millimetres(step.promised_effect)}" if step.promised_effect else "nothing",
            f"{step.happened} {_millimetres(step.effect)}",
            "" if step.deviation is None else f"{1000 * step.deviation:.0f}",
            "yes" if step.as_promised else "no",
        ]
        for number, step in enumerate(run.steps, 1)
    ]
    columns = ["", "step", "promised [mm]", "happened [mm]", "apart [mm]", "as promised"]
    show_table(f"run of {run.problem}", columns, rows)
    far = ", ".join(f"{name} {1000 * distance:.0f} mm" for name, distance in run.distances.items())
    say(f"goal {'reached' if run.reached else 'missed'}: {far} from it")
    for number, step in enumerate(run.steps, 1):
        if step.touched:
            say(f"in step {number} the robot touched {', '.join(step.touched)}")
        for name, how in step.disturbed.items():
            say(f"in step {number} {name} was {how}, though it was not acted upon")
    if run.reason:
        say(run.reason)


def _millimetres(vector: Vector) -> str:
    return "(" + ", ".join(f"{1000 * value:.0f}" for value in vector) + ")"
