"""What a domain folder holds: the name of every file, who writes it, and what it says.

Paths are relative to the folder. Each command reads what stands there and adds its own files, so that one can
stop, look, put another file in the place of one (data of one's own, another planner's plan), and go on.
While it explores, the folder also holds `exploration.safetensors` and `interactions.partial.npz`, which an
interrupted exploration goes on from.
"""

from pathlib import Path

WORLD = "world.toml"  # `init`: which world it is of, and the world's options
EYE, SEEN, SEEN_LEDGER = "eye.safetensors", "seen.npz", "seen.safetensors"
"""`see`, of a world that sees: what tells crops in numbers; the interactions that taught it, as it sees
them; and the same as they were performed. `init --data` writes the first, too, for a table with images."""
INTERACTIONS = "interactions.npz"
"""`explore`, or a script of a user's own (docs/data.md): a row for each interaction."""
MODEL = "effect_model.safetensors"  # `train`: the network whose bits are the symbols
DIRECT_MODEL = "direct_model.safetensors"  # `train`: the network without a bottleneck that taught it
TRAINING = "training.json"  # `train`: how well the model fits, on interactions held out from training
PRIMITIVES = "primitives.json"
"""`distill`: the parameters of each symbol, and what they do to each category: the table of operators."""
LEDGER = "performed.safetensors"
"""`distill`: all that was auditioned and rehearsed, whole; nothing in it is performed again."""
BUDGET = "budget.json"  # `run`: what each of its rounds was spent on
GROWING = "growing"
"""`run`: a folder of the same kind in which a round learns; its files are put in place when it is done."""
OBJECTS = ""
"""What was learned of actions that are aimed at an object alone lies in the folder itself."""
PLACES = "places"
"""What was learned of actions that are aimed at places, in files that are called as those above."""
PLACE_INTERACTIONS = f"{PLACES}/{INTERACTIONS}"
"""`explore --places`: a row for each interaction that was aimed at a place."""
PLACE_MODEL = f"{PLACES}/{MODEL}"  # `train`: the network that was fitted to these
PLACE_OPERATORS = f"{PLACES}/operators.json"
"""`distill`: what carries objects of each category to places, and how surely."""
RELATIONS = "relations"
"""What was learned of actions that are aimed at other objects, in files that are called likewise."""
RELATION_INTERACTIONS = f"{RELATIONS}/{INTERACTIONS}"
"""`explore --relations`: a row for each interaction that was aimed at another object."""
CHANCES, STATES = "chances.safetensors", "states.json"
RELATION_MODEL = f"{RELATIONS}/{MODEL}"
"""`train`: the network that was fitted to these; its object symbols are kinds of pairs."""
RELATION_STATES = f"{RELATIONS}/{STATES}"  # `train`: the states that pairs of objects can be in
RELATION_OPERATORS = f"{RELATIONS}/operators.json"
"""`distill`: what brings which pairs of objects into which state, and how surely."""
RELATION_CHANCES = f"{RELATIONS}/{CHANCES}"
"""`distill`: the network that foresees that, fitted to all that was explored and performed."""
UPRIGHT = "upright"
"""What was learned of setting things upright that lie on a side."""
UPRIGHT_OPERATORS = f"{UPRIGHT}/operators.json"
"""`distill --upright`: what does so, for each side, and how surely."""
DOMAIN = "domain.pddl"  # `compile-domain`: the page, all that was learned in one domain
NUMERIC_DOMAIN = "domain-numeric.pddl"  # `compile-domain`: the same in numbers (PDDL 2.1)
PLAIN_DOMAIN = "domain-plain.pddl"
"""`compile-domain --plain`: the page without costs, for planners that take none; no command reads it."""
DURATIVE_DOMAIN = "domain-durative.pddl"
"""`compile-domain --durative`: what can be carried, by actions that take time; no command reads it."""
DOMAIN_FILES = {"strips": DOMAIN, "numeric": NUMERIC_DOMAIN}  # the file of a domain by its encoding
GROUNDING = "grounding.json"
"""`compile-domain`: what planning and execution need to know; no network is needed from here on."""
PROBLEMS = "problems"
"""`new-problem`: NAME.scene.json (the problem), NAME.pddl and NAME.numeric.pddl (for other planners)."""
PLANS = "plans"  # `plan`: NAME.PLANNER.plan, and how planning went, NAME.PLANNER.json
RUNS = "runs"  # `execute`: what became of each plan
PASTS = "pasts"  # `meet`: what the objects of these names did; `execute` adds to them
PICTURES = "pictures"  # `show`: pictures; those of the page are in `report`
REPORT_PICTURES = "pictures/report"  # `report`: the pictures of the page
COMPARISONS = "comparison"  # `compare`: a folder for each kind of task, with a file for each task
FOLDERS = (
    PLACES,
    UPRIGHT,
    PROBLEMS,
    PLANS,
    RUNS,
    PASTS,
    PICTURES,
    REPORT_PICTURES,
    f"{COMPARISONS}/*",
)  # as patterns
PAGE = "report.html"  # `report`: the page
MANIFEST = "manifest.json"  # every command: how its files came about

COMMANDS = {
    WORLD: "init",
    EYE: "see",
    INTERACTIONS: "explore",
    MODEL: "train",
    DIRECT_MODEL: "train",
    PRIMITIVES: "distill",
    CHANCES: "distill",
    STATES: "train",
    Path(PLACE_OPERATORS).name: "distill",
    DOMAIN: "compile-domain",
    NUMERIC_DOMAIN: "compile-domain",
    GROUNDING: "compile-domain",
}
"""Which command writes each file that a later stage reads, by its name without the folder."""

SCENE = ".scene.json"  # what the file of a problem as we read it ends with
PDDL, NUMERIC_PDDL, PLAIN, DURATIVE = ".pddl", ".numeric.pddl", ".plain.pddl", ".durative.pddl"
"""What its files for other planners end with: the page, in numbers, without costs, with durative actions."""
FORMER = (".places.pddl", ".relational.pddl", ".relational-lifted.pddl")
"""What files of problems ended with that earlier versions printed, and no longer are."""
FORMER_DOMAINS = tuple(
    f"domain-{encoding}.pddl" for encoding in ("operators", "places", "relational", "relational-lifted")
)
"""The domains that earlier versions printed, and no longer are."""
PLAN, STEPS = ".plan", ".steps"
"""What the file of a plan of the printed domain and problem ends with, and that of steps that are none.

Such steps only come near the goal, miss it when they are replayed, or need what the domain does not have.
"""
RECORD = ".run.json"  # what the file of a record of a run ends with


def problem_file(problem: str, ending: str) -> str:
    """Name the file of a problem that ends so."""
    return f"{PROBLEMS}/{problem}{ending}"


def scene_file(problem: str) -> str:
    """Name the file of a problem as we read it."""
    return problem_file(problem, SCENE)


def problem_files(problem: str) -> tuple[str, str]:
    """Name a problem's files for other planners, for the page and in numbers."""
    return problem_file(problem, PDDL), problem_file(problem, NUMERIC_PDDL)


def plan_files(problem: str, planner: str) -> tuple[str, str]:
    """Name the files of a plan and of the record of how planning went."""
    return f"{PLANS}/{problem}.{planner}{PLAN}", f"{PLANS}/{problem}.{planner}.json"


def steps_file(plan_file: str) -> str:
    """Name the file that stands in the place of a plan's where its steps are none of the printed domain."""
    return plan_file.removesuffix(PLAN) + STEPS


def run_file(problem: str, plan_file: Path) -> str:
    """Name the file that says what became of a plan for a problem."""
    return f"{RUNS}/{run_name(problem, plan_file)}{RECORD}"


def run_name(problem: str, plan_file: Path) -> str:
    """Name a run after its problem and its plan, whose name mostly begins with the problem's."""
    stem = plan_file.stem
    return stem if stem.startswith(f"{problem}.") else f"{problem}.{stem}"


def past_file(item: str) -> str:
    """Name the file that says what an object was seen to do."""
    return f"{PASTS}/{item}.json"


def printed_file(problem: str, encoding: str) -> str:
    """Name the file that holds a problem in an encoding of the domain."""
    return problem_file(problem, NUMERIC_PDDL if encoding == "numeric" else PDDL)


def problem_of(file: str) -> str:
    """Return the name of the problem that a file is of."""
    for ending in (SCENE, NUMERIC_PDDL, PLAIN, DURATIVE, *FORMER, PDDL):
        file = file.removesuffix(ending)
    return file
