"""Other people's programs that judge what we print."""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any


@contextmanager
def quiet() -> Iterator[None]:
    """Hear no warnings of unified-planning and of what it imports, which are not ours to mend."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        yield


def unified_planning_accepts(domain: Path, task: Path, plan: str) -> bool:
    with quiet():
        from unified_planning.engines import SequentialPlanValidator
        from unified_planning.io import PDDLReader

        parsed = _parsed(domain.read_text(), task.read_text())
        with SequentialPlanValidator() as validator:
            return bool(validator.validate(parsed, PDDLReader().parse_plan_string(parsed, plan)))


@cache
def _parsed(domain: str, task: str) -> Any:
    from unified_planning.io import PDDLReader

    return PDDLReader().parse_problem_string(domain, task)
