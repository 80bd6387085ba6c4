"""Plans with Aries: `python call_aries.py DOMAIN PROBLEM PLAN`. unified-planning reads the files for it."""

import sys
from pathlib import Path

from unified_planning.io import PDDLReader
from unified_planning.shortcuts import get_environment
from up_aries import Aries


def main(domain: str, problem: str, plan: str) -> None:
    """Write a plan into a file, if there is one."""
    get_environment().credits_stream = None
    task = PDDLReader().parse_problem(domain, problem)
    found = Aries().solve(task)
    print(found.status.name)
    for message in found.log_messages or ():
        print(message.message, file=sys.stderr)
    if found.plan is not None:
        lines = [
            f"({' '.join([one.action.name, *map(str, one.actual_parameters)])})" for one in found.plan.actions
        ]
        Path(plan).write_text("".join(f"{line}\n" for line in lines))


main(*sys.argv[1:])
