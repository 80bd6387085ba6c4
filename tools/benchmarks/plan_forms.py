"""The forms that plans are written in: a table of what planners and services print, one form a row.

Each form is a few templates: tests write plans in every form and read them back. Reading itself goes by what
lines are made of (`plan_reading`), not by these examples.
"""

from collections.abc import Sequence
from typing import NamedTuple


class PlanForm(NamedTuple):
    """A form that plans are written in.

    Templates may hold `{words}`, the action with blanks between; `{name}` and `{arguments}`, with commas
    between; `{under}` and `{underscored}`, the same with underscores for hyphens; `{lines}`, a word a line;
    `{capitals}`; `{json}`, the arguments as JSON; and `{number}`, which counts from 0. The tail may hold
    `{count}`, how many actions there are.
    """

    name: str
    step: str  # a ground action
    head: str = ""  # what stands before the first
    between: str = "\n"  # what stands between two
    tail: str = "\n"  # what stands after the last
    first: str = ""  # the first action, if it is written otherwise

    def write(self, actions: Sequence[Sequence[str]]) -> str:
        """Write ground actions in this form, each its name and its arguments."""
        steps = [_filled(self.step, number, *action) for number, action in enumerate(actions)]
        if self.first:
            steps[:1] = [_filled(self.first, 0, *action) for action in actions[:1]]
        return self.head + self.between.join(steps) + self.tail.format(count=len(actions))


def _filled(template: str, number: int, name: str, *arguments: str) -> str:
    words, listed = " ".join((name, *arguments)), ", ".join(arguments)
    return template.format(
        words=words,
        capitals=words.upper(),
        lines="\n    ".join((name, *arguments)),
        name=name,
        arguments=listed,
        under=name.replace("-", "_"),
        underscored=listed.replace("-", "_"),
        json=", ".join(f'"{word}"' for word in arguments),
        number=number,
    )


FORMS = (
    PlanForm("the IPC form, as plan files have it", "({words})", tail="\n; cost = {count} (unit cost)\n"),
    PlanForm(
        "Fast Downward's log",
        "{words} (1)",
        head="INFO     Running search (release).\n[t=0.002s, 9932 KB] Conducting best first search\n"
        "[t=0.003s, 9932 KB] Solution found!\n[t=0.003s, 9932 KB] Actual search time: 0.001s\n",
        tail="\n[t=0.003s, 9932 KB] Plan length: {count} step(s).\n[t=0.003s, 9932 KB] Plan cost: 9\n"
        "[t=0.003s, 9932 KB] Expanded 4 state(s).\nSolution found.\nsearch exit code: 0\n",
    ),
    PlanForm("VAL's form, with times and durations", "{number}.001: ({words}) [1.000]"),
    PlanForm(
        "FF's output",
        "        {number}: {capitals}",
        first="step    {number}: {capitals}",
        head="\nff: parsing domain file\ndomain 'TABLETOP' defined\n ... done.\n\n"
        "Cueing down from goal distance:    2 into depth [1]\n                                   0\n"
        "\nff: found legal plan as follows\n\n",
        tail="\n\ntime spent:    0.00 seconds instantiating 4 easy, 0 hard action templates\n"
        "               0.00 seconds searching, evaluating 3 states\n",
    ),
    PlanForm(
        "Metric-FF's output", "{number}: ({words})  [0.001]", tail="\nplan (cost: 49.931942)  [0.001]\n"
    ),
    PlanForm(
        "LPG's output",
        " {number}.0000: ({capitals}) [D:1.00; C:1.00]",
        head="Modality: Incremental Planner\n\nPlan computed:\n"
        "   Time: (ACTION) [action Duration; action Cost]\n",
        tail="\n\n\nSolution number: 1\nTotal time:      0.01\nActions:         {count}\n"
        "     Plan file:       plan_problem_1.SOL\n",
    ),
    PlanForm(
        "the log of OPTIC and POPF",
        "{number}.000: ({words})  [0.001]",
        head="Number of literals: 9\nInitial heuristic = 3.000\nb (2.000 | 0.000)b (1.000 | 1.0)\n"
        ";;;; Solution Found\n; States evaluated: 4\n; Cost: 3.000\n; Time 0.01\n",
        tail="\n\n * All goal deadlines now no later than 3.000\n\nResorting to best-first search\n",
    ),
    PlanForm(
        "TFD's log",
        "{number}.00100000: ({words}) [1.00000000]",
        head="Searching...\nFound new plan:\n",
        tail="\nSolution with original makespan 3 found (ignoring no-moving-targets).\n",
    ),
    PlanForm(
        "ENHSP's output",
        "{number}.0: ({words})",
        head="Domain parsed\nProblem parsed\nGrounding..\nProblem Solved\n\nFound Plan:\n",
        tail="\n\nPlan-Length:{count}\nMetric (Search):3.0\nPlanning Time (msec): 214\n",
    ),
    PlanForm(
        "Madagascar's output",
        "STEP {number}: {name}({arguments})",
        head="Horizon 0: 30 variables\nPLAN FOUND: 3 steps\n",
        tail="\n3 actions in the plan.\ntotal time 0.01 preprocess 0.01\n",
    ),
    PlanForm("PDDL4J's output", "0{number}: (   {words}) [0]", head="found plan as follows:\n\n"),
    PlanForm("pyperplan's plan file", "({words} )", head="# found by pyperplan with gbfs and hff\n"),
    PlanForm(
        "a service's JSON, strings",
        '"({words})"',
        *('{"status": "ok", "result": {"plan": [', ", ", "]}}}}\n"),
    ),
    PlanForm(
        "a service's JSON, objects with a name",
        '{{"name": "({words})", "action": "(:action {name})"}}',
        *('{"plan": [', ",\n", "]}}\n"),
    ),
    PlanForm(
        "a service's JSON, objects with a name and arguments",
        '{{"name": "{name}", "arguments": [{json}]}}',
        *("[", ",\n ", "]\n"),
    ),
    PlanForm("unified-planning's text", "    {under}({underscored})", head="SequentialPlan:\n"),
    PlanForm(
        "a block of Markdown",
        "{number}. ({words})",
        head="Here is the plan:\n\n```pddl\n",
        tail="\n```\n\nIt takes {count} actions.\n",
    ),
    PlanForm("words without brackets", "{words}", head="# as a person writes it\n"),
    PlanForm("several actions in a line", "({words})", between=" "),
    PlanForm("an action over several lines", "({lines})"),
    PlanForm("commas between arguments", "({name}, {arguments})"),
    PlanForm("times and durations in short", ".{number:03}:({words})[1e-3]"),
)
"""Every form that is read; for other forms see `written_plans`."""
