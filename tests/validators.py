"""Other people's programs that judge what we print."""

import warnings
from functools import cache
from pathlib import Path
from typing import Any


def unified_planning_accepts(domain: Path, task: Path, plan: str) -> bool:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # unified-planning and what it imports, not ours to mend
        from unified_planning.engines import SequentialPlanValidator
        from unified_planning.io import PDDLReader

        parsed = _parsed(domain.read_text(), task.read_text())
        with SequentialPlanValidator() as validator:
            return bool(validator.validate(parsed, PDDLReader().parse_plan_string(parsed, plan)))


@cache
def _parsed(domain: str, task: str) -> Any:
    from unified_planning.io import PDDLReader

    return PDDLReader().parse_problem_string(domain, task)
