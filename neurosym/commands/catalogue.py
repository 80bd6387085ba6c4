"""The commands by name, and what `--help` says of all of them.

A command is a function of its own name, in a module of its own name; it is imported when it is typed.
"""

from collections.abc import Callable
from importlib import import_module
from textwrap import wrap

from neurosym.errors import UnknownChoice

Command = Callable[..., int]
SUMMARIES = {
    "demo": (
        "Show what neurosym does: compile a shipped domain, plan how two objects change places, execute, "
        "film."
    ),
    "run": "Go the whole way: explore, train, distil, compile, draw problems, plan and execute.",
    "init": "Make a new domain folder with a `world.toml` that holds every option of its world.",
    "explore": "Let the robot explore, curious or at random: `world.toml` -> `interactions.npz`.",
    "check": "Check a data set, of your own or explored, before it is trained on.",
    "train": (
        "Fit the effect model whose bits are the symbols: `interactions.npz` -> `effect_model.safetensors`."
    ),
    "distill": "Turn action symbols into parameters and rehearse each in the world: -> `primitives.json`.",
    "compile-domain": (
        "Compile the PDDL domain: `primitives.json` -> `domain.pddl` and its like, and `grounding.json`."
    ),
    "practise": (
        "Practise where plans fail: draw tasks, execute plans, improve the operators that broke them."
    ),
    "new-problem": (
        "Make a problem: a random scene, and a goal that random actions lead to (one in the paper) or yours."
    ),
    "plan": "Plan for a problem; exit code 3 if there is no plan, with the reason.",
    "planners": (
        "List the planners: what each is, the encodings it takes, the usual first, and whether it is here."
    ),
    "validate": "Judge a plan without executing it; exit code 3 if it is none.",
    "execute": "Run a plan in the simulator, each step beside its promise; exit code 3 if it misses.",
    "replay": "Run a record again, nudge and all, and say whether the same happens (exit code 3: no).",
    "studio": (
        "Open a page in the browser: drag objects and goals, plan, watch the robot, see what symbols mean."
    ),
    "compare": (
        "Give the same drawn tasks to several planners, and judge each plan in the model and in the world."
    ),
    "show": (
        "Show an interaction, a primitive, an operator or a problem: a strip of pictures, an "
        "animation, or live."
    ),
    "explain": (
        "Say in words what each symbol means: what the hand does and brings about, which objects are alike."
    ),
    "figures": "Draw the paper's Figure 3 (each primitive) and Figure 4 (example plans) from the simulator.",
    "report": (
        "Write one HTML page about a domain: symbols in words and pictures, exploration, operators, "
        "plans, PDDL."
    ),
    "evaluate": (
        "Print the paper's Tables I (errors), II (primitives) and III (planning) from what was measured."
    ),
}
"""The commands, each with the first sentence that it says of itself: what shows it, what does it all, and the
rest in the order in which a folder meets them."""

ABOUT = """A robot plays with objects out of curiosity; neurosym turns what it learned into a PDDL domain that
any planner takes, and turns any planner's plan back into motions.

Everything about one learned domain lies in one folder, DIR. Each command reads what stands there and adds its
own file; `neurosym run DIR` goes the whole way. To begin: neurosym demo, or neurosym run my-domain --steps
1024. Any command prints only what goes wrong with --quiet; neurosym --version says which this is."""

_MORE = "`neurosym COMMAND --help` says what a command does and takes."
_NAMES = max(map(len, SUMMARIES)) + 4  # columns of the names of commands, with the space about them


def command_named(name: str) -> Command:
    """Return a command.

    Raises:
        UnknownChoice: If there is none of that name.
    """
    if name not in SUMMARIES:
        raise UnknownChoice("command", name, SUMMARIES)
    own = name.replace("-", "_")
    command: Command = getattr(import_module(f"neurosym.commands.{own}"), own)
    return command


def overview(columns: int) -> str:
    """Return what `--help` says: what neurosym is, and its commands.

    Args:
        columns: How wide it may be.
    """
    about = (" ".join(part.split()) for part in ABOUT.split("\n\n"))
    parts = ["usage: neurosym COMMAND ...", *("\n".join(wrap(part, columns)) for part in about)]
    commands = "\n".join(_entry(name, summary, columns) for name, summary in SUMMARIES.items())
    return "\n\n".join([*parts, f"commands:\n{commands}", _MORE])


def _entry(name: str, summary: str, columns: int) -> str:
    begin = f"  {name}".ljust(_NAMES)
    lines = wrap(
        summary, columns, initial_indent=begin, subsequent_indent=" " * _NAMES, break_on_hyphens=False
    )
    return "\n".join(lines)
