"""What the jobs of `evaluate.py` come to: shares, means over seeds, and counts of reasons."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import msgspec
import numpy as np

from neurosym.evaluation.comparison import TaskRecord
from neurosym.evaluation.summary import summarise
from neurosym.execution.rerun import Execution

MEASURES = ("found", "valid", "reached", "reached_with_replanning")
Entries = Sequence[Mapping[str, Any]]


def records_of(entries: Entries) -> list[TaskRecord]:
    """Read the records that a job kept."""
    return msgspec.convert(list(entries), list[TaskRecord])


def table3_cell(by_seed: Mapping[str, Sequence[TaskRecord]], planners: Sequence[str]) -> dict[str, Any]:
    """Say which share of the tasks each planner solved and reached: mean and spread over seeds."""
    cell: dict[str, Any] = {}
    counted = {seed: summarise(records, planners) for seed, records in by_seed.items() if records}
    for planner in planners:
        shares = {
            seed: {name: getattr(c.planners[planner], name) / max(c.counted, 1) for name in MEASURES}
            for seed, c in counted.items()
        }
        if shares:
            by_measure = {name: [share[name] for share in shares.values()] for name in MEASURES}
            cell[planner] = {
                **{name: float(np.mean(values)) for name, values in by_measure.items()},
                "spread": {name: float(np.std(values)) for name, values in by_measure.items()},
                "by_seed": shares,
                "tasks": sum(c.counted for c in counted.values()),
                "met_at_start": sum(c.met_at_start for c in counted.values()),
            }
    return cell


def reasons(records: Sequence[TaskRecord], planners: Sequence[str]) -> dict[str, Any]:
    """Count why planners disagreed, and why goals were missed."""
    comparison = summarise(records, planners)
    found = {name: msgspec.to_builtins(tally) for name, tally in comparison.planners.items()}
    kept = ("predicted", "replans", "unfound", "invalid", "missed", "missed_with_replanning")
    return {
        "tasks": comparison.counted,
        "solved_by_none": comparison.solved_by_none,
        **{name: {key: tally[key] for key in kept} for name, tally in found.items()},
        "without_plan": {name: _unsolved(records, name) for name in planners},
    }


def _unsolved(records: Sequence[TaskRecord], planner: str) -> dict[str, int]:
    attempts = (record.attempts[planner] for record in records if not record.met_at_start)
    return _counted(attempt.status.value for attempt in attempts if not attempt.found)


def collisions(records: Sequence[TaskRecord], planners: Sequence[str]) -> dict[str, Any]:
    """Count how often objects left the table, and bystanders were touched or moved, in the world."""
    table = {}
    for planner in planners:
        attempts = [record.attempts[planner] for record in records if not record.met_at_start]
        for way in ("open_loop", "replanned"):
            runs = [run for run in (getattr(attempt, way) for attempt in attempts) if run]
            table[f"{planner}, {way.replace('_', '-')}"] = _collisions_of(runs)
    return table


def _collisions_of(runs: Sequence[Execution]) -> dict[str, Any]:
    interactions = sum(run.interactions for run in runs)
    return {
        "runs": len(runs),
        "interactions": interactions,
        "kept": _share(sum(run.kept for run in runs), interactions),
        "off_table": _share(sum(bool(run.off_table) for run in runs), len(runs)),
        "touched": _share(sum(run.touched for run in runs), interactions),
        "disturbed": _share(sum(run.disturbed for run in runs), interactions),
    }


def symbolic_cell(entries: Entries) -> dict[str, Any]:
    """Say how plans for symbolic tasks compare: valid, found, and how long beside the fewest steps."""
    records, fewest = records_of([entry["record"] for entry in entries]), [e["fewest"] for e in entries]
    pddl, exact = ([record.attempts[name] for record in records] for name in ("fast-downward", "counting"))
    searched = [record.attempts["bfs-operators"] for record in records]
    network = [record.attempts["bfs"] for record in records]
    both = [(p, n) for p, n in zip(pddl, fewest, strict=True) if p.found and n]
    return {
        "tasks": len(records),
        "found": sum(attempt.found for attempt in pddl),
        "valid": sum(attempt.valid for attempt in pddl),
        "valid_share": _share(sum(a.valid for a in pddl), sum(a.found for a in pddl)),
        "bfs_solves": sum(attempt.valid for attempt in searched),
        "solved_when_bfs_solves": _given(searched, pddl),
        "counting_solves": sum(attempt.valid for attempt in exact),
        "solved_when_counting_solves": _given(exact, pddl),
        "extra_steps": float(np.mean([p.primitives - n for p, n in both])) if both else None,
        "shortest": _share(sum(p.primitives == n for p, n in both), len(both)),
        "fewest": float(np.mean([n for _, n in both])) if both else None,
        "seconds": float(np.median([attempt.seconds for attempt in pddl])) if pddl else None,
        "network_bfs": {
            "found": sum(attempt.found for attempt in network),
            "valid": sum(attempt.valid for attempt in network),
            "pddl_when_it_solves": _given(network, pddl, valid=False),
        },
        "predicted_too": _share(sum(_predicted(r) for r in records), sum(a.found for a in pddl)),
        "status": _counted(attempt.status.value for attempt in pddl),
    }


def _predicted(record: TaskRecord) -> bool:
    miss = record.attempts["fast-downward"].predicted_miss
    return miss is not None and miss <= record.problem.tolerance


def _given(condition: Sequence[Any], wanted: Sequence[Any], *, valid: bool = True) -> float | None:
    """Share of the tasks with a plan by one planner in which the other has one that is valid."""
    pairs = [(a, b) for a, b in zip(condition, wanted, strict=True) if (a.valid if valid else a.found)]
    return _share(sum(b.valid for _, b in pairs), len(pairs))


def whole(cells: Iterable[Mapping[str, Any]]) -> dict[str, Any]:
    """Put all symbolic tasks together: what the two main shares are over all of them."""
    known = list(cells)

    def mean(share: str, of: str) -> float | None:
        parts = [(cell[share], cell[of]) for cell in known if cell[share] is not None]
        return _share(sum(value * count for value, count in parts), sum(count for _, count in parts))

    return {
        "valid_share": mean("valid_share", "found"),
        "solved_when_bfs_solves": mean("solved_when_bfs_solves", "bfs_solves"),
    }


def disturbed(entries: Entries) -> dict[str, Any]:
    """Say which share of the disturbed runs ended at their goal."""
    nudged = [entry["run"] for entry in entries if entry["solvable"] and entry.get("nudge")]
    return {
        "tasks": len(entries),
        "without_plan": sum(not entry["solvable"] for entry in entries),
        "nudged": len(nudged),
        "reached": sum(run["reached"] for run in nudged),
        "share": _share(sum(run["reached"] for run in nudged), len(nudged)),
        "replans": sum(run["replans"] for run in nudged),
        "missed": _counted(run["kind"] for run in nudged if not run["reached"]),
    }


def costs(entries: Entries, records: Sequence[TaskRecord]) -> dict[str, Any]:
    """Compare plans made with and without costs, followed blindly, on the tasks that both have a plan for."""
    by_task = {record.problem.name: record for record in records if not record.met_at_start}
    pairs = [
        (by_task[entry["task"]].attempts["fast-downward"], entry)
        for entry in entries
        if entry["task"] in by_task
    ]
    both = [(attempt, entry) for attempt, entry in pairs if attempt.open_loop and "run" in entry]
    return {
        "tasks": len(pairs),
        "both_found": len(both),
        "with_costs": _share(sum(a.open_loop.reached for a, _ in both), len(both)),
        "without_costs": _share(sum(e["run"]["reached"] for _, e in both), len(both)),
        "primitives_with": float(np.mean([a.primitives for a, _ in both])) if both else None,
        "primitives_without": float(np.mean([e["primitives"] for _, e in both])) if both else None,
    }


def scaling_cell(found: Mapping[str, Any]) -> dict[str, Any]:
    """Say how one contender did in one cell of the scaling table."""
    rows = found["rows"]
    solved = [row for row in rows if row["status"] == "solved"]
    ratios = [row["primitives"] / row["fewest"] for row in solved if row["fewest"]]
    memory = found["megabytes"]
    return {
        "tasks": len(rows),
        "solved": len(solved),
        "valid": sum(row["valid"] for row in solved),
        "seconds": float(np.median([row["seconds"] for row in solved])) if solved else None,
        "slowest": max((row["seconds"] for row in solved), default=None),
        "primitives": float(np.mean([row["primitives"] for row in solved])) if solved else None,
        "over_fewest": float(np.mean(ratios)) if ratios else None,
        "megabytes": max(memory["children"], memory["own"]),
        "status": _counted(row["status"] for row in rows),
        "reasons": _counted(row.get("reason", "") for row in rows if row["status"] != "solved"),
    }


def _share(part: float, of: float) -> float | None:
    return part / of if of else None


def _counted(names: Iterable[str]) -> dict[str, int]:
    counted = Counter(filter(None, names))
    return dict(sorted(counted.items(), key=lambda item: (-item[1], item[0])))
