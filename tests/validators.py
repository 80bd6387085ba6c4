"""Other people's programs that judge what we print."""

import warnings
from pathlib import Path


def unified_planning_accepts(domain: Path, task: Path, plan: str) -> bool:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # unified-planning and what it imports, not ours to mend
        from unified_planning.engines import SequentialPlanValidator
        from unified_planning.io import PDDLReader

        reader = PDDLReader()
        parsed = reader.parse_problem(str(domain), str(task))
        with SequentialPlanValidator() as validator:
            return bool(validator.validate(parsed, reader.parse_plan_string(parsed, plan)))
