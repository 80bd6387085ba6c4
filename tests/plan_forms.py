"""The forms that plans are written in, as planners and services print them, one form a row."""

from collections.abc import Sequence
from typing import Any, NamedTuple


class Form(NamedTuple):
    """How a ground action is written, and what stands around all.

    A step may hold `{words}`, the action with blanks between; `{capitals}`; `{lines}`, a word a line;
    `{name}` and `{arguments}`, with commas between; `{under}` and `{underscored}`, the same with underscores
    for hyphens; `{json}`, the arguments as JSON; `{number}`, from 0; and `{first}`, before the first alone.
    The tail may hold `{count}`, how many actions there are.
    """

    step: str
    head: str = ""
    tail: str = "\n"
    between: str = "\n"

    def write(self, actions: Sequence[Sequence[str]]) -> str:
        """Write ground actions, each its name and its arguments."""
        steps = [self._written(number, *action) for number, action in enumerate(actions)]
        return self.head + self.between.join(steps) + self.tail.format(count=len(actions))

    def _written(self, number: int, name: str, *arguments: str) -> str:
        words, listed = " ".join((name, *arguments)), ", ".join(arguments)
        return self.step.format(
            words=words,
            capitals=words.upper(),
            lines="\n    ".join((name, *arguments)),
            name=name,
            arguments=listed,
            under=name.replace("-", "_"),
            underscored=listed.replace("-", "_"),
            json=", ".join(f'"{word}"' for word in arguments),
            number=number,
            first="step    " if number == 0 else "        ",
        )


def edited(actions: Sequence[Sequence[str]], rng: Any, words: Sequence[str]) -> list[list[str]]:
    """Drop, double or swap ground actions, or change a word of one."""
    changed = [[*action] for action in actions]
    at, other = (int(number) for number in rng.integers(len(changed), size=2))
    kind = rng.integers(4)
    if kind == 0:
        del changed[at]
    elif kind == 1:
        changed.insert(other, changed[at])
    elif kind == 2:
        changed[at], changed[other] = changed[other], changed[at]
    else:
        changed[at][int(rng.integers(len(changed[at])))] = str(rng.choice(words))
    return changed


FORMS = {
    "the IPC form, as plan files have it": Form("({words})", tail="\n; cost = {count} (unit cost)\n"),
    "Fast Downward's log": Form(
        "{words} (1)",
        "INFO     Running search (release).\n[t=0.002s, 9932 KB] Conducting best first search\n"
        "[t=0.003s, 9932 KB] Solution found!\n[t=0.003s, 9932 KB] Actual search time: 0.001s\n",
        "\n[t=0.003s, 9932 KB] Plan length: {count} step(s).\n[t=0.003s, 9932 KB] Plan cost: 9\n"
        "[t=0.003s, 9932 KB] Expanded 4 state(s).\nSolution found.\nsearch exit code: 0\n",
    ),
    "VAL's form, with times and durations": Form("{number}.001: ({words}) [1.000]"),
    "FF's output": Form(
        "{first}{number}: {capitals}",
        "\nff: parsing domain file\ndomain 'TABLETOP' defined\n ... done.\n\n"
        "Cueing down from goal distance:    2 into depth [1]\n                                   0\n"
        "\nff: found legal plan as follows\n\n",
        "\n\ntime spent:    0.00 seconds instantiating 4 easy, 0 hard action templates\n"
        "               0.00 seconds searching, evaluating 3 states\n",
    ),
    "Metric-FF's output": Form("{number}: ({words})  [0.001]", tail="\nplan (cost: 49.931942)  [0.001]\n"),
    "LPG's output": Form(
        " {number}.0000: ({capitals}) [D:1.00; C:1.00]",
        "Modality: Incremental Planner\n\nPlan computed:\n   Time: (ACTION) [action Duration; action Cost]\n",
        "\n\n\nSolution number: 1\nTotal time:      0.01\nActions:         {count}\n"
        "     Plan file:       plan_problem_1.SOL\n",
    ),
    "the log of OPTIC and POPF": Form(
        "{number}.000: ({words})  [0.001]",
        "Number of literals: 9\nInitial heuristic = 3.000\nb (2.000 | 0.000)b (1.000 | 1.0)\n"
        ";;;; Solution Found\n; States evaluated: 4\n; Cost: 3.000\n; Time 0.01\n",
        "\n\n * All goal deadlines now no later than 3.000\n\nResorting to best-first search\n",
    ),
    "TFD's log": Form(
        "{number}.00100000: ({words}) [1.00000000]",
        "Searching...\nFound new plan:\n",
        "\nSolution with original makespan 3 found (ignoring no-moving-targets).\n",
    ),
    "ENHSP's output": Form(
        "{number}.0: ({words})",
        "Domain parsed\nProblem parsed\nGrounding..\nProblem Solved\n\nFound Plan:\n",
        "\n\nPlan-Length:{count}\nMetric (Search):3.0\nPlanning Time (msec): 214\n",
    ),
    "Madagascar's output": Form(
        "STEP {number}: {name}({arguments})",
        "Horizon 0: 30 variables\nPLAN FOUND: 3 steps\n",
        "\n3 actions in the plan.\ntotal time 0.01 preprocess 0.01\n",
    ),
    "PDDL4J's output": Form("0{number}: (   {words}) [0]", "found plan as follows:\n\n"),
    "pyperplan's plan file": Form("({words} )", "# found by pyperplan with gbfs and hff\n"),
    "a service's JSON, strings": Form(
        '"({words})"', '{"status": "ok", "result": {"plan": [', "]}}}}\n", ", "
    ),
    "a service's JSON, objects with a name": Form(
        '{{"name": "({words})", "action": "(:action {name})"}}', '{"plan": [', "]}}\n", ",\n"
    ),
    "a service's JSON, objects with a name and arguments": Form(
        '{{"name": "{name}", "arguments": [{json}]}}', "[", "]\n", ",\n "
    ),
    "unified-planning's text": Form("    {under}({underscored})", "SequentialPlan:\n"),
    "a block of Markdown": Form(
        "{number}. ({words})", "Here is the plan:\n\n```pddl\n", "\n```\n\nIt takes {count} actions.\n"
    ),
    "words without brackets": Form("{words}", "# as a person writes it\n"),
    "several actions in a line": Form("({words})", between=" "),
    "an action over several lines": Form("({lines})"),
    "commas between arguments": Form("({name}, {arguments})"),
    "times and durations in short": Form(".{number:03}:({words})[1e-3]"),
}
