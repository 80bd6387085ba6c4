"""The whole way of one data set, by the commands that a user types, and what came of it."""

import contextlib
import io
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.commands.cli import main
from neurosym.data.interactions import Interactions
from neurosym.files import read_json
from neurosym.learning.network import EffectModel
from neurosym.learning.training import mean_over_axes, r_squared, split, trivial_predictions
from neurosym.learning.training_config import TrainingConfig
from neurosym.learning.training_report import TrainingReport
from neurosym.operators import MIN_TRIALS
from neurosym.stages import layout
from neurosym.stages.verdicts import MOST, judge_values
from neurosym.values.domain import ValueDomain
from neurosym.values.outcomes import Rows, outcomes_of
from tools.benchmarks.any_data.sets import SETS, DataSet, Task, tasks_of, write_columns, write_rows
from tools.benchmarks.options import ROOT

PLANNER = "fast-downward"
REPLANS = 40  # so many new plans are allowed, where a plan is not performed blindly
TASKS_SEED = 2026  # what starts are drawn with
_ROWS_SEED = 7000  # what rows are drawn with, by the seed of training
Found = dict[str, Any]


def neurosym(*arguments: object) -> int:
    """Type a command; return its exit code."""
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()) as said:
        try:
            main([str(one) for one in arguments])
            code = 0
        except SystemExit as ended:
            code = int(ended.code or 0)
    if code not in (0, 3):
        raise RuntimeError(said.getvalue().strip().splitlines()[-1])
    return code


def learned(one: DataSet, folder: Path, seed: int, given: Path | None = None, *options: object) -> None:
    """Go from rows to a PDDL domain.

    Args:
        one: The data set.
        folder: The domain folder, which is made anew.
        seed: Of rows and training.
        given: The table, if there is no world to make one in.
        options: More options of training.
    """
    shutil.rmtree(folder, ignore_errors=True)
    folder.parent.mkdir(parents=True, exist_ok=True)
    table, columns = given or folder.with_suffix(".csv"), folder.with_suffix(".toml")
    write_columns(one, columns)
    if not given:
        write_rows(one, table, one.rows, _ROWS_SEED + seed)
    neurosym("init", folder, "--data", table, "--columns", columns)
    if one.world:
        named = folder / layout.WORLD
        named.write_text(named.read_text().replace('world = "none"', f'world = "{one.world}"'))
    bits = "--object-bits", one.bits[0], "--action-bits", one.bits[1]
    neurosym("train", folder, "--seed", seed, *bits, *options)
    neurosym("distill", folder, "--seed", seed)
    neurosym("compile-domain", folder)


def tried(folder: Path, name: str, task: Task, replans: int | None) -> Found:
    """Plan for a task, have the plan judged, and perform it blindly and with new plans.

    Args:
        folder: The domain folder.
        name: Name of the task.
        task: The task.
        replans: How many new plans may be made; None if nothing can be performed.
    """
    features, goals = task
    scene = folder / f"{name}.json"
    thing = {"name": "thing-01", "features": features}
    document = {"format": "neurosym-value-problem-1", "name": name, "things": [thing]}
    scene.write_text(json.dumps({**document, "goals": {"thing-01": goals}}))
    try:
        neurosym("new-problem", folder, "--scene", scene, "--name", name)
    except RuntimeError as error:
        return {"status": "refused", "reason": str(error), "steps": 0, "valid": False}
    plan_file, record_file = (folder / path for path in layout.plan_files(name, PLANNER))
    code = neurosym("plan", folder, name, "--planner", PLANNER)
    record = json.loads(record_file.read_text())
    found = {key: record.get(key) for key in ("status", "reason", "seconds", "chance")}
    found |= {"steps": len(record["steps"]), "valid": False}
    if code:
        return found
    found["valid"] = neurosym("validate", folder, name, plan_file) == 0
    domain = ValueDomain.load(folder / layout.GROUNDING)
    for how, many in (("blind", 0), ("replanned", replans)) if replans is not None else ():
        reached = neurosym("execute", folder, name, plan_file, "--replans", many) == 0
        run = json.loads((folder / layout.run_file(name, plan_file)).read_text())
        kept = {"steps": len(run["steps"]), "replans": run["replans"], "reason": run["reason"]}
        kept["as_promised"] = sum(step["as_promised"] for step in run["steps"])
        last = run["steps"][-1]["happened"] if run["steps"] else ()
        kept["exactly"] = all(
            is_met(goals[axis.name], value, axis.period or 0.0)
            for axis, value in zip(domain.axes, last, strict=False)
            if axis.name in goals
        )
        found[how] = {"reached": reached, **kept}
    return found


def is_met(goal: float | tuple[float, float], value: float, turn: float) -> bool:
    """Say whether a value itself meets a goal, and not only its cell; an angle may be a turn away."""
    low, high = goal if isinstance(goal, tuple) else (goal, goal)
    return any(low - 1e-6 <= value + times * turn <= high + 1e-6 for times in (-1, 0, 1))


def measured(name: str, folder: Path, seed: int, given: Path | None = None, *options: object) -> Found:
    """Go the whole way with a data set, and say what came of it."""
    one = SETS[name]
    learned(one, folder, seed, given, *options)
    report = read_json(folder / layout.TRAINING, TrainingReport)
    data = Interactions.load(folder / layout.INTERACTIONS)
    tasks = tasks_of(one, data, TASKS_SEED)
    many = REPLANS if one.world else None
    return {
        **told(report),
        "r2_trivial": trivial(data, seed),
        **judged(ValueDomain.load(folder / layout.GROUNDING)),
        "rows": len(data),
        "tasks": [tried(folder, f"task-{n:02d}", task, many) for n, task in enumerate(tasks, start=1)],
    }


def discs(folder: Path, seed: int, *options: object) -> Found:
    """Run the script of docs/data.md, and learn from what it writes."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    script = re.findall(r"```python\n(.*?)```", (ROOT / "docs/data.md").read_text(), flags=re.DOTALL)[0]
    subprocess.run([sys.executable, "-c", script], cwd=folder, check=True)
    neurosym("train", folder / "discs", "--seed", seed, *options)
    neurosym("distill", folder / "discs", "--seed", seed)
    neurosym("compile-domain", folder / "discs")
    return of_discs(folder / "discs")


def of_discs(folder: Path) -> Found:
    """Say how well discs were learned, and what keeps its promise, standing still included."""
    report = read_json(folder / layout.TRAINING, TrainingReport)
    domain = ValueDomain.load(folder / layout.GROUNDING)
    data, model = Interactions.load(folder / layout.INTERACTIONS), EffectModel.load(folder / layout.MODEL)
    rows = Rows(np.full(data.effects.shape, np.nan), data.effects.astype(float))
    pairs = np.char.add(model.object_symbols(data.features), model.action_symbols(data.actions))
    groups = [rows[pairs == pair] for pair in np.unique(pairs)]
    kept = [len(one) >= MIN_TRIALS and outcomes_of(one, domain.axes)[0].share >= MOST for one in groups]
    return {**told(report), **judged(domain), "pairs_kept": sum(kept), "pairs": len(groups)}


def told(report: TrainingReport) -> Found:
    """Say how well effects are predicted, beside predictors that look at nothing."""
    return {
        "r2_bits": report.r2_through_codes,
        "r2_bits_by_axis": report.r2_through_codes_by_axis,
        "r2_direct": report.r2_direct,
        "mae": {name: sum(errors) for name, errors in report.mae.items()},
    }


def trivial(data: Interactions, seed: int) -> float:
    """Return the R2 of the best predictor that looks at nothing, on what training holds out."""
    kept, held_out = split(data, TrainingConfig().validation_share, seed)
    effects = held_out.effects.astype(float)
    guesses = trivial_predictions(kept.effects.astype(float), len(effects)).values()
    return max(mean_over_axes(r_squared(np.asarray(guess), effects), effects) for guess in guesses)


def judged(domain: ValueDomain) -> Found:
    """Count the operators of a domain, and those that keep their promise as the verdict has it."""
    verdict = judge_values(domain)
    kept, _, of = verdict.sentence.split()[:3]
    return {
        "operators": len(domain.operators),
        "judged": int(of),
        "kept": int(kept),
        "verdict": verdict.level,
    }
