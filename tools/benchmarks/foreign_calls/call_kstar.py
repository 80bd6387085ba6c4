"""Plans with K*: `python call_kstar.py DOMAIN PROBLEM PLAN`. The best plan, by its defaults."""

import sys
from pathlib import Path

from kstar_planner import planners


def main(domain: str, problem: str, plan: str) -> None:
    """Write a plan into a file, if there is one."""
    found = planners.plan_topk(Path(domain), Path(problem), number_of_plans_bound=1)
    print(found["planner_output"], file=sys.stderr)
    print(found["planner_error"], file=sys.stderr)
    for best in found.get("plans", [])[:1]:
        Path(plan).write_text("".join(f"({action})\n" for action in best["actions"]))


main(*sys.argv[1:])
