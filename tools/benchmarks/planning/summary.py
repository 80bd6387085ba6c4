"""What the jobs of `evaluate.py` come to: shares, means over seeds, and counts of reasons."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import msgspec
import numpy as np

from neurosym.evaluation.comparison import Attempt, TaskRecord
from neurosym.evaluation.summary import summarise as compared
from neurosym.problems import Problem
from tools.benchmarks.jobs import Found, machine
from tools.benchmarks.planning import figures, jobs, measures
from tools.benchmarks.planning.jobs import COMPARED, SIZES, Agenda
from tools.benchmarks.planning.tasks import DIFFICULTIES
from tools.benchmarks.planning.trials import Trial, trials_of
from tools.benchmarks.tables import mean_of, share_of, tally

PAPER = {
    "single": {"curiosity": 0.82, "active": 0.56, "random": 0.13},
    "double": {"curiosity": 0.59, "active": 0.38, "random": 0.09},
}  # Table III of the paper: BFS in its own simulator, with its own boxes
MEASURES = ("found", "valid", "reached", "reached_with_replanning")
Entries = Sequence[Mapping[str, Any]]
Figures = dict[str, Any]
_Record = TaskRecord[Problem]


def summarise(found: Found, agenda: Agenda) -> Figures:
    """Gather jobs into tables; what is not done yet is missing."""
    size = agenda.size
    every = [name for _, turn in agenda.turns(learn=False) for name in turn]
    symbolic = {
        f"{objects} {difficulty}": symbolic_cell(entries)
        for objects in jobs.SYMBOLIC_OBJECTS
        for difficulty in DIFFICULTIES
        if (entries := _entries(found, agenda.symbolic(), f"-{objects}-{difficulty}-"))
    }
    shipped = {kind: _records(found, agenda, "shipped", 0.05, kind) for kind in SIZES}
    return {
        "command": f"make evaluate-planning SEEDS={size.seeds} STEPS={size.steps} "
        f"STRATEGIES='{' '.join(size.strategies)}'",
        "versions": machine("numpy", "pybullet", "torch", "up-fast-downward"),
        "missing": sum(name not in found for name in every),
        "size": size._asdict(),
        **whole(symbolic.values()),
        "symbolic": symbolic,
        "table3": _table3(found, agenda, 0.05),
        "table3_at_20_mm": _table3(found, agenda, 0.02),
        "paper": PAPER,
        "reasons": {kind: _reasons(records) for kind, records in shipped.items()},
        "costs": {kind: _costs(_of_size(found, agenda.costless(), kind), shipped[kind]) for kind in SIZES},
        "disturbed": {kind: disturbed(_of_size(found, agenda.disturbed(), kind)) for kind in SIZES},
        "scaling": _scaling(found, agenda),
        **_trials(found, agenda),
    }


def _entries(found: Found, names: Iterable[str], part: str) -> list[Any]:
    return [entry for name in names if part in name for entry in found.get(name, [])]


def _of_size(found: Found, names: Iterable[str], kind: str) -> list[Any]:
    """Put the entries of jobs on single or on double tasks into one list."""
    chosen = [name for name in names if name.split("-")[-3] == str(SIZES[kind])]
    return _entries(found, chosen, "")


def _records(found: Found, agenda: Agenda, domain: str, tolerance: float, kind: str) -> list[_Record]:
    return msgspec.convert(_of_size(found, agenda.table3(domain, tolerance), kind), list[_Record])


def _table3(found: Found, agenda: Agenda, tolerance: float) -> Figures:
    """Gather Table III: strategy -> single or double -> planner -> shares."""
    of_seeds = {"shipped": {"1": "shipped"}} | {
        strategy: {str(seed): jobs.domain_name(strategy, seed) for seed in range(1, agenda.size.seeds + 1)}
        for strategy in agenda.size.strategies
    }

    def cell(domains: Mapping[str, str], kind: str) -> Figures:
        records = {seed: _records(found, agenda, name, tolerance, kind) for seed, name in domains.items()}
        return table3_cell(records)

    return {strategy: {kind: cell(domains, kind) for kind in SIZES} for strategy, domains in of_seeds.items()}


def table3_cell(by_seed: Mapping[str, Sequence[_Record]]) -> Figures:
    """Say which share of the tasks each planner solved and reached: mean and spread over seeds."""
    known = {seed: compared(records, COMPARED) for seed, records in by_seed.items() if records}
    cell: Figures = {}
    for planner in COMPARED if known else ():
        shares = {
            seed: {name: getattr(one.planners[planner], name) / max(one.counted, 1) for name in MEASURES}
            for seed, one in known.items()
        }
        by_measure = {name: [share[name] for share in shares.values()] for name in MEASURES}
        cell[planner] = {
            **{name: float(np.mean(values)) for name, values in by_measure.items()},
            "spread": {name: float(np.std(values)) for name, values in by_measure.items()},
            "by_seed": shares,
            "tasks": sum(one.counted for one in known.values()),
            "met_at_start": sum(one.met_at_start for one in known.values()),
        }
    return cell


def _reasons(records: Sequence[_Record]) -> Figures:
    """Count why planners disagreed, and why goals were missed."""
    comparison = compared(records, COMPARED)
    told = {name: msgspec.to_builtins(one) for name, one in comparison.planners.items()}
    kept = ("predicted", "replans", "unfound", "invalid", "missed", "missed_with_replanning")
    asked = [record.attempts for record in records if not record.met_at_start]
    return {
        "tasks": comparison.counted,
        "solved_by_none": comparison.solved_by_none,
        **{name: {key: one[key] for key in kept} for name, one in told.items()},
        "without_plan": {
            name: tally(one[name].status.value for one in asked if not one[name].found) for name in COMPARED
        },
    }


def symbolic_cell(entries: Entries) -> Figures:
    """Say how plans for symbolic tasks compare: valid, found, and how long beside the fewest steps."""
    records = msgspec.convert([entry["record"] for entry in entries], list[_Record])
    network, searched, pddl, exact = (
        [record.attempts[name] for record in records]
        for name in ("bfs", "bfs-operators", "fast-downward", "counting")
    )
    both = [(p, e["fewest"]) for p, e in zip(pddl, entries, strict=True) if p.found and e["fewest"]]
    found, valid = sum(one.found for one in pddl), sum(one.valid for one in pddl)
    misses = zip([one.predicted_miss for one in pddl], records, strict=True)
    predicted = sum(miss is not None and miss <= record.problem.tolerance for miss, record in misses)
    return {
        "tasks": len(records),
        "found": found,
        "valid": valid,
        "valid_share": share_of(valid, found),
        "bfs_solves": sum(one.valid for one in searched),
        "solved_when_bfs_solves": _given([one.valid for one in searched], pddl),
        "counting_solves": sum(one.valid for one in exact),
        "solved_when_counting_solves": _given([one.valid for one in exact], pddl),
        "extra_steps": mean_of(one.primitives - fewest for one, fewest in both),
        "shortest": share_of(sum(one.primitives == fewest for one, fewest in both), len(both)),
        "fewest": mean_of(fewest for _, fewest in both),
        "seconds": float(np.median([one.seconds for one in pddl])) if pddl else None,
        "network_bfs": {
            "found": sum(one.found for one in network),
            "valid": sum(one.valid for one in network),
            "pddl_when_it_solves": _given([one.found for one in network], pddl),
        },
        "predicted_too": share_of(predicted, found),
        "status": tally(one.status.value for one in pddl),
    }


def _given(condition: Sequence[bool], wanted: Sequence[Attempt]) -> float | None:
    """Return the share of the tasks with a plan by one planner in which the other has one that is valid."""
    chosen = [one.valid for is_so, one in zip(condition, wanted, strict=True) if is_so]
    return share_of(sum(chosen), len(chosen))


def whole(cells: Iterable[Mapping[str, Any]]) -> Figures:
    """Put all symbolic tasks together: what the two main shares are over all of them."""
    known, found = list(cells), {}
    for share, of in (("valid_share", "found"), ("solved_when_bfs_solves", "bfs_solves")):
        parts = [(cell[share], cell[of]) for cell in known if cell[share] is not None]
        found[share] = share_of(sum(value * count for value, count in parts), sum(n for _, n in parts))
    return found


def disturbed(entries: Entries) -> Figures:
    """Say which share of the disturbed runs ended at their goal."""
    nudged = [entry["run"] for entry in entries if entry["solvable"] and entry.get("nudge")]
    reached = sum(run["reached"] for run in nudged)
    return {
        "tasks": len(entries),
        "without_plan": sum(not entry["solvable"] for entry in entries),
        "nudged": len(nudged),
        "reached": reached,
        "share": share_of(reached, len(nudged)),
        "replans": sum(run["replans"] for run in nudged),
        "missed": tally(run["kind"] for run in nudged if not run["reached"]),
    }


def _costs(entries: Entries, records: Sequence[_Record]) -> Figures:
    """Compare plans made with and without costs, followed blindly, on the tasks that both have a plan for."""
    by_task = {one.problem.name: one.attempts["fast-downward"] for one in records if not one.met_at_start}
    pairs = [(by_task[entry["task"]], entry) for entry in entries if entry["task"] in by_task]
    both = [(one, one.open_loop, entry) for one, entry in pairs if one.open_loop and "run" in entry]
    return {
        "tasks": len(pairs),
        "both_found": len(both),
        "with_costs": share_of(sum(run.reached for _, run, _ in both), len(both)),
        "without_costs": share_of(sum(entry["run"]["reached"] for *_, entry in both), len(both)),
        "primitives_with": mean_of(one.primitives for one, *_ in both),
        "primitives_without": mean_of(entry["primitives"] for *_, entry in both),
    }


def _scaling(found: Found, agenda: Agenda) -> Figures:
    """Gather the scaling table: contender -> objects and difficulty -> figures."""
    table: Figures = {}
    for contender in jobs.CONTENDERS:
        for objects, difficulty in jobs.CELLS:
            name = agenda.contender(objects, difficulty, contender)
            if name in found:
                table.setdefault(contender, {})[f"{objects} {difficulty}"] = scaling_cell(found[name])
    return {"cap_seconds": measures.CAP, "tasks_in_a_cell": agenda.size.scaling, "contenders": table}


def scaling_cell(found: Found) -> Figures:
    """Say how one contender did in one cell of the scaling table."""
    rows, memory = found["rows"], found["megabytes"]
    solved = [row for row in rows if row["status"] == "solved"]
    seconds = [row["seconds"] for row in solved]
    return {
        "tasks": len(rows),
        "solved": len(solved),
        "valid": sum(row["valid"] for row in solved),
        "seconds": float(np.median(seconds)) if solved else None,
        "slowest": max(seconds, default=None),
        "primitives": mean_of(row["primitives"] for row in solved),
        "over_fewest": mean_of(row["primitives"] / row["fewest"] for row in solved if row["fewest"]),
        "megabytes": max(memory["children"], memory["own"]),
        "status": tally(row["status"] for row in rows),
        "reasons": tally(row.get("reason", "") for row in rows if row["status"] != "solved"),
    }


def _trials(found: Found, agenda: Agenda) -> Figures:
    """Gather trials in the shipped domain into figures."""

    def drawn(tolerance: float, kind: str) -> list[Trial]:
        return msgspec.convert(_of_size(found, agenda.precision(tolerance), kind), list[Trial])

    by_size = {f"{1000 * far:g}": {kind: drawn(far, kind) for kind in SIZES} for far in jobs.TOLERANCES}
    anywhere = {str(objects): trials_of(found, names) for objects, names in agenda.far().items()}
    every, far = ([trial for of in each.values() for trial in of] for each in (by_size["50"], anywhere))
    errors = figures.promise_errors(figures.steps_of(every))
    return {
        "precision": {
            mm: {
                kind: {way: figures.share(trials, way) for way in figures.WAYS} | {"tasks": len(trials)}
                for kind, trials in sizes.items()
            }
            for mm, sizes in by_size.items()
        },
        "far_goals": {objects: figures.share(trials) for objects, trials in anywhere.items()},
        "promise_rms_mm": {name: errors[name] for name in ("all", "worst")},
        "kinds_by_seed": {
            str(seed): found[job] for seed, job in enumerate(agenda.kinds(), 1) if found.get(job) is not None
        },
        "motions": {kind: figures.motions(trials) for kind, trials in by_size["50"].items()},
        "promises": {
            "drawn, replanned": figures.promises(every, "replanned"),
            "drawn, blind": figures.promises(every, "blind"),
            "anywhere, replanned": figures.promises(far, "replanned"),
        },
        "far_details": {objects: _far_details(trials) for objects, trials in anywhere.items()},
        "calibration": figures.calibration(every),
        "calibration_replanned": figures.calibration_replanned(every),
    }


def _far_details(trials: Sequence[Trial]) -> Figures:
    plans = [trial.primitives for trial in trials if trial.replanned]
    return {
        "tasks": len(trials),
        "without_plan": len(trials) - len(plans),
        "primitives": mean_of(plans),
        "motions": figures.motions(trials),
        "missed": figures.ended_by(trials),
    }
