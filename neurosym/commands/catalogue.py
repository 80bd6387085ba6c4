"""The commands by name, and what `--help` says first."""

from collections.abc import Callable

from neurosym.commands.check import check
from neurosym.commands.compare import compare
from neurosym.commands.compile_domain import compile_domain
from neurosym.commands.demo import demo
from neurosym.commands.distill import distill
from neurosym.commands.evaluate import evaluate
from neurosym.commands.execute import execute
from neurosym.commands.explain import explain
from neurosym.commands.explore import explore
from neurosym.commands.figures import figures
from neurosym.commands.init import init
from neurosym.commands.new_problem import new_problem
from neurosym.commands.plan import plan
from neurosym.commands.planners import planners
from neurosym.commands.practise import practise
from neurosym.commands.replay import replay
from neurosym.commands.report import report
from neurosym.commands.run import run
from neurosym.commands.show import show
from neurosym.commands.studio import studio
from neurosym.commands.train import train
from neurosym.commands.validate import validate

COMMANDS: dict[str, Callable[..., int]] = {
    "demo": demo,
    "run": run,
    "init": init,
    "explore": explore,
    "check": check,
    "train": train,
    "distill": distill,
    "compile-domain": compile_domain,
    "practise": practise,
    "new-problem": new_problem,
    "plan": plan,
    "planners": planners,
    "validate": validate,
    "execute": execute,
    "replay": replay,
    "studio": studio,
    "compare": compare,
    "show": show,
    "explain": explain,
    "figures": figures,
    "report": report,
    "evaluate": evaluate,
}
"""The commands: what shows it, what does it all, and the rest in the order in which a folder meets them."""

ABOUT = """A robot plays with objects out of curiosity; neurosym turns what it learned into a PDDL domain that
any planner takes, and turns any planner's plan back into motions.

Everything about one learned domain lies in one folder, DIR. Each command reads what stands there and adds its
own file; `neurosym run DIR` goes the whole way. To begin: neurosym demo, or neurosym run my-domain --steps
1024. Any command prints only what goes wrong with --quiet; neurosym --version says which this is."""
