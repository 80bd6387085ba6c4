"""What is counted of trials: shares with intervals, calibration, errors of promises, kinds, and tables."""

import json

import msgspec
import numpy as np
import pytest
from toy_domain import WORLD, grounding, problem

from neurosym.evaluation.comparison import Setting
from neurosym.execution.record import Run, StepRecord
from tools.benchmarks.jobs import Evaluation
from tools.benchmarks.planning import evaluate, figures, jobs, trials
from tools.benchmarks.planning.trials import Followed, Step, Trial


def step(error: float | None = 3.0, category: str = "00", kinds: tuple[str | None, str] = ("held", "held")):
    return Step("push-0", 0, category, 100, 97, error, *kinds)


def followed(reached: bool, steps: int = 1, **changes: object) -> Followed:
    run = Followed(
        reached, "goal" if reached else "budget", "" if reached else "a grasp failed", "", (0.01,), ()
    )
    return msgspec.structs.replace(run, **{"steps": (step(),) * steps, **changes})


def trial(blind: bool = True, replanned: bool = True, chance: float = 0.5, steps: int = 1) -> Trial:
    runs = {"blind": followed(blind), "replanned": followed(replanned, steps)}
    return Trial("task", "solved", primitives=2, chance=chance, cpu=1.0, **runs)


NO_PLAN = Trial("task", "unsolvable", "too far")


def test_task_without_a_plan_is_a_miss():
    assert figures.share([NO_PLAN, trial()]) == 0.5
    assert figures.share([]) is None
    assert figures.ended_by([NO_PLAN, trial(replanned=False), trial()]) == {
        "budget: a grasp failed": 1,
        "no plan at the start (unsolvable)": 1,
    }


def test_brier_score_is_compared_with_that_of_the_base_rate():
    told = figures.calibration([trial(chance=1.0), trial(blind=False, chance=0.5), NO_PLAN])
    assert (told["plans"], told["base_rate"]) == (2, 0.5)
    assert (told["brier"], told["brier_of_base_rate"]) == (0.125, 0.25)
    assert figures.calibration([])["brier"] is None


def test_interval_of_promises_holds_the_rms_and_is_wide_where_one_run_decides():
    def run(*errors: float) -> trials.Trial:
        return msgspec.structs.replace(
            trial(), replanned=msgspec.structs.replace(trial().replanned, steps=tuple(map(step, errors)))
        )

    even = [run(4.0, 4.0)] * 30
    assert figures.rms_interval(even) == (4.0, 4.0)
    low, high = figures.rms_interval([*even, run(4.0, 200.0)])
    assert low == 4.0 < np.sqrt((61 * 16 + 200**2) / 62) < high
    assert figures.promises([*even, run(4.0, 200.0)], "replanned")["first"] == 4.0
    assert figures.rms_interval([NO_PLAN]) is None
    assert figures.promises([NO_PLAN], "replanned")["first"] is None


def test_step_that_puts_down_is_measured_where_the_object_lies():
    domain, task = grounding(), problem({"item-01": (0.68, 0.08, 0.025)})
    name, item = task.object_names[0], task.objects[0]

    def error_of(operator, aim, off, **happened) -> float:
        after = tuple(np.add(item.position, [aim[0] + off[0], aim[1] + off[1], 0.0]))
        effect, promised = domain.displacement(operator), operator.promise.kind
        record = StepRecord(
            operator.name, name, promised, effect, "held", (0.0, 0.0, 0.3), 0.2, True, {name: after}
        )
        run = Run(
            task.name,
            (),
            (msgspec.structs.replace(record, **happened),),
            True,
            {name: 0.01},
            "",
            ended="goal",
        )
        return trials.shortened(run, task, domain).steps[0].error

    lift, push = (next(op for op in domain.live if op.promise.kind == kind) for kind in ("held", "resting"))
    aim = trials.resting_promise(lift.name, item, 0.05, domain)
    assert error_of(lift, aim, (0.003, 0.004)) == pytest.approx(5.0, abs=0.1)
    assert error_of(push, domain.displacement(push), (0.006, 0.008)) == pytest.approx(10.0, abs=0.1)
    assert error_of(lift, aim, (0.003, 0.004), put_down=False) == pytest.approx(200.0)


def test_task_is_planned_once_and_followed_both_ways():
    setting = Setting(WORLD, grounding(), lambda features: np.zeros((len(features), 0, 3)))
    found = trials.try_task(setting, problem({"item-01": (0.68, 0.08, 0.025)}), blind=True)
    assert (found.status, found.primitives) == ("solved", 2)
    assert found.chance == pytest.approx((21 / 22) ** 2, abs=1e-4)
    assert found.blind == found.replanned
    assert found.replanned is not None
    assert (found.replanned.reached, found.replanned.ended, found.replanned.replans) == (True, "goal", ())
    assert [(one.promised, one.kind_seen) for one in found.replanned.steps] == [(80, "resting")] * 2
    assert trials.try_task(setting, problem({"item-01": (0.68, 0.08, 0.025)}), blind=False).blind is None


def test_figures_come_into_json_and_the_page(tmp_path):
    agenda = jobs.Agenda(tmp_path, jobs.size_of(1, 2560)._replace(precise=10, far=(5, 0, 5)))
    evaluation = Evaluation("planning", tmp_path, tmp_path)
    measured = {name: [trial(blind=False)] * 10 for name in agenda.precision(0.05)}
    measured |= {name: [trial(), NO_PLAN] for names in agenda.far().values() for name in names}
    for name, found in measured.items():
        evaluation.path(name).write_text(json.dumps(trials.to_json(found)))
    evaluate.write_results(evaluation, agenda)
    summary = json.loads((tmp_path / "planning.json").read_text())
    cell = {"blind": 0.0, "replanned": 1.0, "tasks": 10}
    assert summary["precision"]["50"] == {"single": cell, "double": cell}
    assert summary["precision"]["20"]["single"]["replanned"] is None
    assert summary["far_goals"] == {"1": 0.5, "2": None, "4": 0.5}
    assert summary["promise_rms_mm"] == {"all": 3.0, "worst": 3.0}
    assert summary["motions"] == {"single": 1.0, "double": 1.0}
    assert summary["kinds_by_seed"] == {}
    page = (tmp_path / "planning.md").read_text()
    assert "| 50 mm | single | 10 | 0 % (0 to 28) | 100 % (72 to 100) |" in page
    assert "no plan at the start (unsolvable) (1)" in page
    assert "Brier score 0.250; of the base rate 0.000." in page
