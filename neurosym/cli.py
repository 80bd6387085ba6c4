"""The command line: `neurosym COMMAND DIR ...`.

Exit codes: 0 done; 2 bad input, with one sentence that says what would be valid; 3 the work was done and the
answer is no (no plan, goal missed); 130 interrupted.
"""

import sys
from collections.abc import Callable, Sequence

from neurosym import commands, learning_commands, planning_commands, run_commands
from neurosym.arguments import read_arguments
from neurosym.comparison_command import compare
from neurosym.console import error_console
from neurosym.errors import NeurosymError
from neurosym.evaluation_command import evaluate
from neurosym.explain.command import explain
from neurosym.figures_command import figures
from neurosym.planners_command import planners
from neurosym.report.command import report
from neurosym.show_command import show

BAD_INPUT, INTERRUPTED = 2, 130
COMMANDS: dict[str, Callable[..., int]] = {
    "run": commands.run,
    "init": commands.init,
    "explore": learning_commands.explore,
    "check": learning_commands.check,
    "train": learning_commands.train,
    "distill": learning_commands.distill,
    "compile-domain": planning_commands.compile_domain,
    "new-problem": planning_commands.new_problem,
    "plan": planning_commands.plan,
    "planners": planners,
    "execute": run_commands.execute,
    "replay": run_commands.replay,
    "compare": compare,
    "show": show,
    "explain": explain,
    "figures": figures,
    "report": report,
    "evaluate": evaluate,
}
"""The commands, in the order in which a domain folder meets them after `run`, which does it all."""

ABOUT = """A robot plays with objects out of curiosity; neurosym turns what it learned into a PDDL domain that
any planner takes, and turns any planner's plan back into motions.

Everything about one learned domain lies in one folder, DIR. Each command reads what stands there and adds its
own file; `neurosym run DIR` goes the whole way. To begin: neurosym run my-domain --steps 1024"""


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line and exit.

    Args:
        arguments: What was typed after `neurosym`; the process's own arguments if not given.
    """
    typed = sys.argv[1:] if arguments is None else arguments
    try:
        code = read_arguments(COMMANDS, ABOUT, typed)()
    except NeurosymError as error:
        error_console.print(str(error), markup=False, style="red")
        code = BAD_INPUT
    except OSError as error:
        error_console.print(f"{error.filename}: {error.strerror}", markup=False, style="red")
        code = BAD_INPUT
    except KeyboardInterrupt:
        error_console.print("interrupted; the same command goes on from what is written", markup=False)
        code = INTERRUPTED
    sys.exit(code)
