"""What strangers bring, and how much of it is read: `python -m tools.benchmarks.strangers`.

Shipped plans are written in every form of `neurosym.pddl.plan_forms`, and read again. A form counts as read
if each plan gives the same steps as in the IPC form. Every shipped plan is judged by unified-planning's
validator, on the printed files beside it. Writes into docs/results/strangers.json.
"""

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Annotated

import tyro

from neurosym.console import say
from neurosym.errors import InvalidPlan
from neurosym.files import write_atomically
from neurosym.grounding import Grounding
from neurosym.pddl.plan_forms import FORMS, PlanForm
from neurosym.pddl.plan_reading import parse_plan
from neurosym.problems import Problem
from neurosym.shipped import DOMAINS
from neurosym.stages.folder import DomainFolder
from neurosym.stages.plan_verdict import judge_plan
from tools.benchmarks.jobs import as_text
from tools.benchmarks.places import ROOT

RESULTS = Path("docs/results")
PLANS = {
    "tabletop": "task-01.fast-downward",
    "places": "row-4-12.fast-downward",
    "towers": "tower-6-05.fast-downward",
}
"""A plan of each kind of domain: over cells, by places, and by relations."""


def main(results: Annotated[Path, tyro.conf.arg(help="Folder for the figures.")] = RESULTS) -> None:
    """Measure anew, and keep what else the file holds."""
    path = results / "strangers.json"
    kept = json.loads(path.read_text()) if path.exists() else {}
    for measure in MEASURES:
        kept |= measure()
    write_atomically(path, as_text(kept))
    say(f"wrote {path}")


def plan_forms() -> Mapping[str, int]:
    """Count the forms that are tried, and those that are read."""
    read = set[PlanForm](FORMS)
    for domain, plan in PLANS.items():
        read &= forms_read(domain, plan)
    return {"plan_forms_read": len(read), "plan_forms_tried": len(FORMS)}


def forms_read(domain: str, plan: str) -> set[PlanForm]:
    """Return the forms in which a shipped plan gives the same steps as it is shipped.

    Args:
        domain: The shipped domain.
        plan: Name of the plan.
    """
    folder = ROOT / "domains" / domain
    grounding = Grounding.load(folder / "grounding.json")
    problem = Problem.load(folder / "problems" / f"{plan.partition('.')[0]}.scene.json")
    text = (folder / "plans" / f"{plan}.plan").read_text()
    steps, found = parse_plan(text, Path(plan), grounding, problem), set[PlanForm]()
    for form in FORMS:
        try:
            again = parse_plan(form.write(actions_of(text)), Path(form.name), grounding, problem)
        except InvalidPlan as error:
            say(str(error))
            continue
        found |= {form} if again == steps else set()
    return found


def actions_of(text: str) -> list[list[str]]:
    """Return the words of the ground actions in a plan file.

    Args:
        text: A plan in the IPC form, an action a line.
    """
    lines = (line.partition(";")[0].strip() for line in text.splitlines())
    return [line.strip("()").split() for line in lines if line]


def shipped_plans() -> Mapping[str, int]:
    """Count the shipped plans, and those that are valid by the printed domain and problem."""
    valid = [
        judge_plan(DomainFolder(folder), file.name.partition(".")[0], file).valid_by_pddl
        for folder in map(ROOT.joinpath, (f"domains/{name}" for name in DOMAINS))
        for file in sorted((folder / "plans").glob("*.plan"))
    ]
    return {"shipped_plans": len(valid), "shipped_plans_valid": sum(valid)}


MEASURES: tuple[Callable[[], Mapping[str, int]], ...] = (plan_forms, shipped_plans)
"""What is measured; each gives some entries of the file."""


if __name__ == "__main__":
    tyro.cli(main)
