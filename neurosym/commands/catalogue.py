"""The commands by name, and what `--help` says of all of them.

A command is a function of its own name; its module is imported when it is typed.
"""

from collections.abc import Callable, Iterable
from difflib import get_close_matches
from functools import partial
from importlib import import_module
from textwrap import wrap

from neurosym.errors import InvalidValue, UnknownChoice

Command = Callable[..., int]
GROUPS = {
    "To begin": {
        "demo": "Compile a shipped domain, plan how two objects change places, execute, film.",
        "run": "Go the whole way: explore, train, distil, compile, draw problems, plan and execute.",
        "plan": "Plan for a problem; exit code 3 if there is no plan, with the reason.",
        "execute": "Run a plan in the simulator, each step beside its promise; exit code 3 if it misses.",
        "studio": "Open a page in the browser: drag objects and goals, plan, watch the robot.",
        "report": "Write one HTML page about a domain: symbols, exploration, operators, plans.",
    },
    "Learning, step by step": {
        "init": "Make a new domain folder with a `world.toml` that holds every option of its world.",
        "see": "Teach the eye of a world that sees: `world.toml` -> `eye.safetensors` and `seen.npz`.",
        "explore": "Let the robot explore, curious or at random: `world.toml` -> `interactions.npz`.",
        "check": "Check a data set, of your own or explored, before it is trained on.",
        "train": "Fit the model whose bits are symbols: `interactions.npz` -> `effect_model.safetensors`.",
        "distill": "Turn action symbols into parameters and rehearse each: -> `primitives.json`.",
        "compile-domain": "Compile the PDDL domain: `primitives.json` -> `domain.pddl` and `grounding.json`.",
    },
    "Tasks and plans": {
        "new-problem": "Make a problem: a random scene, and a goal that actions lead to, or yours.",
        "meet": "Try things with the objects of a scene, and keep what each did by its name.",
        "planners": "List the planners, the encodings that they take, and whether they are here.",
        "validate": "Judge a plan without executing it; exit code 3 if it is none.",
        "replay": "Run a record again, nudge and all, and say whether the same happens (exit code 3: no).",
        "compare": "Give the same drawn tasks to several planners, and judge each plan.",
    },
    "What was learned": {
        "show": "Show interactions, primitives, operators, problems or symbols, in pictures or live.",
        "traces": "Write (bits, action symbol, bits) of all interactions, for learners of action models.",
        "explain": "Say in words what each symbol means: what is done, and which objects are alike.",
    },
}
"""The commands in groups, the main way first; each with the first sentence that it says of itself."""
SUMMARIES = {name: said for group in GROUPS.values() for name, said in group.items()}
"""The commands, as they are listed."""

ABOUT = """A robot plays with objects out of curiosity; neurosym turns what it learned into a PDDL domain that
any planner takes, and turns any planner's plan back into motions.

Everything about one learned domain lies in one folder, DIR. Each command reads what stands there and adds its
own file; `neurosym run DIR` goes the whole way. To begin: neurosym demo, or neurosym run my-domain --steps
1024. Any command prints only what goes wrong with --quiet; neurosym --version says which this is."""

_HOMES = {
    "learn": ("init", "see", "explore", "check", "train", "distill", "compile-domain"),
    "pipeline": ("run",),
    "tasks": ("new-problem", "plan", "planners", "validate"),
    "execute": ("demo", "execute", "meet", "replay"),
    "show": ("show", "traces", "explain", "report", "compare"),
    "studio": ("studio",),
}
"""In which module of this folder each command is."""
_NAMES = max(map(len, SUMMARIES)) + 4  # columns of the names of commands, with the space about them


def command_named(name: str) -> Command:
    """Return a command.

    Raises:
        InvalidValue: If there is none of that name, but one that is nearly called so.
        UnknownChoice: If there is none.
    """
    if name not in SUMMARIES:
        if near := nearest(name, SUMMARIES):
            said = f"There is no command {name!r}; the nearest is {near}, and `neurosym --help` lists all."
            raise InvalidValue(said)
        raise UnknownChoice("command", name, SUMMARIES)
    home = next(home for home, names in _HOMES.items() if name in names)
    command: Command = getattr(import_module(f"neurosym.commands.{home}"), name.replace("-", "_"))
    return command


def overview(columns: int) -> str:
    """Return what `--help` says: what neurosym is, and its commands."""
    parts = ["usage: neurosym COMMAND ..."]
    parts += ["\n".join(wrap(" ".join(part.split()), columns)) for part in ABOUT.split("\n\n")]
    entry = partial(wrap, width=columns, subsequent_indent=" " * _NAMES, break_on_hyphens=False)
    for title, group in GROUPS.items():
        lines = [f"{title}:"]
        for name, summary in group.items():
            lines += entry(summary, initial_indent=f"  {name}".ljust(_NAMES))
        parts.append("\n".join(lines))
    return "\n\n".join([*parts, "`neurosym COMMAND --help` says what a command does and takes."])


def nearest(name: str, known: Iterable[str]) -> str:
    """Return the name that a mistyped one begins, or else is nearest to; nothing if none is near."""
    names = list(known)
    begun = [one for one in names if one.startswith(name)] if name else []
    return next(iter((*begun, *get_close_matches(name[:100], names, 1))), "")
