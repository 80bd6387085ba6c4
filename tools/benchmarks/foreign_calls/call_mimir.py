"""Plans with pymimir: `python call_mimir.py DOMAIN PROBLEM PLAN`. Greedy search by the FF heuristic."""

import sys
from pathlib import Path

import pymimir


def main(domain: str, problem: str, plan: str) -> None:
    """Write a plan into a file, if there is one."""
    task = pymimir.Problem(pymimir.Domain(Path(domain)), Path(problem), mode="grounded")
    found = pymimir.gbfs_eager(task, task.get_initial_state(), pymimir.FFHeuristic(task))
    print(found.status)
    if found.solution is not None:
        lines = [
            f"({' '.join([one.get_action().get_name(), *(each.get_name() for each in one.get_objects())])})"
            for one in found.solution
        ]
        Path(plan).write_text("".join(f"{line}\n" for line in lines))


main(*sys.argv[1:])
