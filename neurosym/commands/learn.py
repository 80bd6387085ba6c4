"""Commands that learn, from `init`, which makes a domain folder, to `run`, which goes the whole way."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, Optional

from tyro.conf import Positional, arg

from neurosym.choices import CELL, DEFAULT_STRATEGY, StrategyName
from neurosym.commands.arguments import (
    CPUS,
    Folder,
    Json,
    Seed,
    Workers,
    answer_in,
    check_least,
    opened,
)
from neurosym.errors import InvalidData, InvalidFile, InvalidValue, counted, listed_briefly, quoted
from neurosym.learning.training_config import DEFAULT_BITS, PAPER_BITS
from neurosym.stages.console import say, say_next, show_table
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import (
    DIRECT_MODEL,
    DOMAIN,
    DURATIVE,
    DURATIVE_DOMAIN,
    GROUNDING,
    INTERACTIONS,
    MODEL,
    PLACE_MODEL,
    PLACE_OPERATORS,
    PRACTICE,
    PRIMITIVES,
    RELATION_MODEL,
    RELATION_OPERATORS,
    TRAINING,
    WORLD,
    problem_file,
)

if TYPE_CHECKING:
    from neurosym.operators import OperatorTable


_DataPath = Annotated[
    Positional[Path],
    arg(metavar="DATA", help="A data set: an .npz file, or a folder that holds interactions.npz."),
]
_StrategyOption = Annotated[
    StrategyName,
    arg(
        help="How actions are chosen: disagreement (of several networks), entropy (the paper's, also called "
        "curiosity), random or active."
    ),
]
_Places = Annotated[
    int, arg(help="Interactions besides that are aimed at a place, to learn what carries objects there.")
]
_Relations = Annotated[
    int,
    arg(
        help="Interactions that are aimed at another object, to learn what can be done with pairs, once it "
        "is known what carries objects to places."
    ),
]
_Choice = Annotated[
    Literal["own", "predictable", "lowest-error"],
    arg(
        help="Which candidate stands for a symbol: own (categories of objects have their own), "
        "predictable (the same for all), or lowest-error (the paper)."
    ),
]
_RegimeName = Annotated[
    Literal["default", "quick", "paper"],
    arg(help="Network and training: default, quick (a first look), paper (as printed)."),
]
_ObjectBits = Annotated[
    Optional[int],
    arg(
        help="Bits of an object symbol, 1 to 6: up to 2^bits categories of objects. By default "
        f"{DEFAULT_BITS[0]}."
    ),
]
_ActionBits = Annotated[
    Optional[int],
    arg(
        help="Bits of an action symbol, 1 to 8: up to 2^bits primitives. By default "
        f"{DEFAULT_BITS[1]}, and {PAPER_BITS[1]} with quick and paper."
    ),
]
_WorldName = Annotated[
    str, arg(help="Which world, for a new folder: tabletop, toy, or your own as module:factory.")
]


def init(folder: Folder, world: _WorldName = "tabletop") -> int:
    """Make a new domain folder with a `world.toml` that holds every option of its world."""
    _make_folder(folder, world)
    say_next(f"neurosym {_next_step(opened(folder))} {quoted(folder)}")
    return 0


def _next_step(folder: DomainFolder) -> str:
    """Return the command that comes after what a folder holds besides its world."""
    from neurosym.operators import OperatorTable

    if not (folder / INTERACTIONS).is_file():
        return "explore"
    if not all((folder / model).is_file() for model in (MODEL, DIRECT_MODEL)) or folder.outdated((MODEL,)):
        return "train"
    try:
        table = OperatorTable.load(folder / PRIMITIVES)
    except InvalidFile:
        return "distill"
    if table.measured == "data" or folder.outdated((PRIMITIVES,)):  # there is a world to rehearse in now
        return "distill"
    return "new-problem" if (folder / GROUNDING).is_file() else "compile-domain"


def _make_folder(folder: Path, world: str) -> None:
    """Make a domain folder with every option of its world."""
    from neurosym.files import make_folder, write_new
    from neurosym.worlds.world_file import default_text

    if folder.exists() and not folder.is_dir():
        raise InvalidValue(f"{folder} is not a folder; name another.")
    text = default_text(world, folder)
    make_folder(folder)
    if not write_new(folder / WORLD, text):
        said = f"{folder / WORLD} exists already; change it by hand, or name another folder."
        raise InvalidValue(said)
    say(f"wrote {folder / 'world.toml'}")


def explore(
    folder: Folder,
    strategy: _StrategyOption = DEFAULT_STRATEGY,
    steps: Annotated[int, arg(help="Interactions to make; more can be made later.")] = 10_000,
    seed: Seed = 0,
    regime: _RegimeName = "default",
    workers: Workers = CPUS,
    places: _Places = 0,
    relations: _Relations = 0,
) -> int:
    """Let the robot explore, curious or at random: `world.toml` -> `interactions.npz`.

    Interrupt it when you like: the same command goes on from the last block of 512 interactions.
    """
    from neurosym.stages.learning import OBJECTS, TO_OBJECTS, TO_PLACES, explore_stage

    domain = opened(folder)
    options: dict[str, Any] = {"strategy": strategy, "seed": seed, "regime": regime, "workers": workers}
    for aim, count, aimed in (
        (OBJECTS, 0 if relations else steps, ""),  # relations are explored once all else is learned
        (TO_PLACES, places, " aimed at places"),
        (TO_OBJECTS, relations, " aimed at other objects"),
    ):
        if count or (aim is OBJECTS and not relations):
            domain.perform(explore_stage(domain, aim, steps=count, **options), again=True)
            say(f"{count} interactions{aimed} in {folder / aim.file(INTERACTIONS)}")
    say_next(f"neurosym train {quoted(folder)}")
    return 0


def check(data: _DataPath, json: Json = False) -> int:
    """Check a data set, of your own or explored, before it is trained on.

    docs/data.md says what it must hold; every problem is told in a line of its own, with exit code 2.
    """
    from neurosym.commands.tables import show_data
    from neurosym.data.interactions import examine
    from neurosym.data.origin import training_problems, warnings_about

    path = opened(data).require(INTERACTIONS) if data.is_dir() else data
    if not path.is_file():
        raise InvalidFile(path, "there is no such file or folder")
    answer, found = answer_in(json), examine(path)
    if problems := [*found.problems, *training_problems(found.columns, found.origin)]:
        answer({"path": str(path), "problems": problems})
        raise InvalidData(path, problems)
    interactions = found.interactions
    assert interactions is not None, "without problems there are interactions"
    show_data(interactions, path)
    warnings = warnings_about(interactions.columns, interactions.origin, found.given)
    for warning in warnings:
        say(f"note: {warning}")
    is_in_place = path.name == INTERACTIONS
    copying = "" if is_in_place else f"mkdir -p my-domain && cp {quoted(path)} my-domain/{INTERACTIONS} && "
    say_next(f"{copying}neurosym train {quoted(path.parent) if is_in_place else 'my-domain'}")
    widths = {name: getattr(interactions, name).shape[1] for name in ("features", "actions", "effects")}
    rows = len(interactions)
    answer({"path": str(path), "interactions": rows, **widths, "problems": [], "notes": [*warnings]})
    return 0


def train(
    folder: Folder,
    seed: Seed = 0,
    regime: _RegimeName = "default",
    object_bits: _ObjectBits = None,
    action_bits: _ActionBits = None,
) -> int:
    """Fit the model whose bits are symbols: `interactions.npz` -> `effect_model.safetensors`."""
    from neurosym.commands.tables import show_training
    from neurosym.stages.learning import OBJECTS, TO_OBJECTS, TO_PLACES, train_stage

    domain = opened(folder)
    bits: dict[str, Any] = {"object_bits": object_bits, "action_bits": action_bits}
    for aim, about, own in (
        (OBJECTS, "", bits),
        (TO_PLACES, "what carries objects to places:", {}),
        (TO_OBJECTS, "what can be done with pairs:", {}),
    ):
        data = domain / aim.file(INTERACTIONS)
        if aim is OBJECTS or data.exists():
            domain.perform(train_stage(domain, aim, seed=seed, regime=regime, **own), again=True)
            if about:
                say(about)
            show_training(domain / aim.file(TRAINING), data)
    say_next(f"neurosym distill {quoted(folder)}")
    return 0


def distill(
    folder: Folder,
    objects: Annotated[int, arg(help="Objects that each primitive is rehearsed on.")] = 100,
    seed: Seed = 0,
    workers: Workers = CPUS,
    choice: _Choice = "own",
) -> int:
    """Turn action symbols into parameters and rehearse each: -> `primitives.json`."""
    from neurosym.commands.tables import show_operators, show_relations, show_verdict
    from neurosym.operators import OperatorTable
    from neurosym.pair_operators import PlaceOperators, RelationOperators
    from neurosym.stages.learning import TO_OBJECTS, TO_PLACES, distill_stage
    from neurosym.stages.verdicts import judge_operators, judge_relations

    domain = opened(folder)
    options: dict[str, Any] = {"objects": objects, "seed": seed, "workers": workers}
    domain.perform(distill_stage(domain, choice=choice, **options), again=True)
    table = OperatorTable.load(domain / PRIMITIVES)
    show_operators(table)
    is_rehearsed = table.measured == "rehearsal"
    after = f"neurosym compile-domain {quoted(folder)}" if is_rehearsed else _told_of_data(folder, table)
    show_verdict(judge_operators(table))
    if (domain / PLACE_MODEL).exists() and is_rehearsed:
        domain.perform(distill_stage(domain, TO_PLACES, **options), again=True)
        places = PlaceOperators.load(domain / PLACE_OPERATORS).operators
        show_operators(places)
        show_verdict(judge_operators(places))
    if (domain / RELATION_MODEL).exists() and is_rehearsed:
        domain.perform(distill_stage(domain, TO_OBJECTS, **options), again=True)
        relations = RelationOperators.load(domain / RELATION_OPERATORS)
        show_relations(relations)
        show_verdict(judge_relations(relations))
    say_next(after)
    return 0


def _told_of_data(folder: Path, table: "OperatorTable") -> str:
    """Say what a table lacks that was averaged from data; return what to type next."""
    from neurosym.operators import counted_axes

    say("there is no world.toml, so nothing was rehearsed: effects are averages over the rows of the data")
    if table.axes == 3:
        say("a PDDL domain needs a world besides, and distilled again, primitives are rehearsed in it")
        return f"neurosym init {quoted(folder)} --world module:factory"
    say(f"no PDDL domain can be made of {counted_axes(table.axes)}: it moves objects along x, y and z")
    return f"neurosym explain {quoted(folder)}"


def compile_domain(
    folder: Folder,
    cell: Annotated[float, arg(help="Edge of a grid cell [m].")] = CELL,
    name: Annotated[
        str | None, arg(help="Name of the PDDL domain; by default the one it has, or that of its world.")
    ] = None,
    durative: Annotated[
        bool, arg(help="Also what carries objects to places with durations, for PlanSys2.")
    ] = False,
    plain: Annotated[bool, arg(help="Also all of it without costs, for planners that take none.")] = False,
) -> int:
    """Compile the PDDL domain: `primitives.json` -> `domain.pddl` and `grounding.json`.

    `domain.pddl` is a page that holds all that was learned, and takes the problems NAME.pddl.
    `domain-numeric.pddl` has numbers instead of cells and places, and takes NAME.numeric.pddl.
    With `--plain` there are `domain-plain.pddl` and NAME.plain.pddl, the page without costs. With
    `--durative` there is `domain-durative.pddl`: it carries objects to places by an action that takes time,
    and takes NAME.durative.pddl. From then on they are kept up to date.
    """
    from neurosym.commands.tables import show_verdict
    from neurosym.grounding import Grounding
    from neurosym.stages.compilation import compile_stage
    from neurosym.stages.verdicts import judge_domain

    domain = opened(folder)
    domain.perform(compile_stage(domain, cell=cell, name=name, durative=durative, plain=plain), again=True)
    grounding = Grounding.load(domain / GROUNDING)
    say(f"{len(grounding.live)} operators in {folder / 'domain.pddl'}; left out: {len(grounding.left_out)}")
    for name, reason in grounding.left_out.items():
        say(f"  {name}: {reason}")
    if durative:
        names = domain.problem_names()
        left = [name for name in names if not (domain / problem_file(name, DURATIVE)).exists()]
        say(f"{folder / DURATIVE_DOMAIN} takes {len(names) - len(left)} of {counted(len(names), 'problem')}")
        if left:
            say("  left out, since not all can be carried to its goal, or something is to bear something, or")
            say(f"  does so at first: {listed_briefly(left)}")
    show_verdict(judge_domain(grounding))
    say_next(f"neurosym new-problem {quoted(folder)}")
    return 0


def practise(
    folder: Folder,
    interactions: Annotated[
        int, arg(help="Interactions in all, with those of earlier calls; the last round is finished.")
    ] = 2000,
    seed: Seed = 0,
    workers: Workers = CPUS,
) -> int:
    """Practise where plans fail: draw tasks, execute plans, improve what broke them.

    Then the domain is compiled anew. Interrupt it when you like: the same command goes on from the last round
    that was finished.
    """
    from neurosym.pddl.compiler import CELL
    from neurosym.stages.compilation import compile_stage, practice_of
    from neurosym.stages.practice import practise_stage

    domain = opened(folder)
    stage = practise_stage(domain, interactions=interactions, seed=seed, workers=workers)
    domain.perform(stage, again=True)
    compiled = domain.manifest().stages.get("compile-domain")
    domain.perform(
        compile_stage(domain, cell=compiled.options.get("cell", CELL) if compiled else CELL), again=False
    )
    found = practice_of(domain)
    rounds = found.practised.rounds if found else ()
    rows = [
        [
            str(number),
            f"{one.reached} of {one.planned}",
            ", ".join(f"{name} ({count})" for name, count in one.broke.items()) or "-",
            ", ".join(
                f"{lesson.operator} {lesson.before:.2f} -> {lesson.after:.2f}" for lesson in one.lessons
            ),
        ]
        for number, one in enumerate(rounds, 1)
    ]
    columns = ["round", "came true", "broke plans", "practised: competence before -> after"]
    show_table(f"{counted(len(rounds), 'round')} of practice", columns, rows)
    spent = counted(sum(one.spent for one in rounds), "interaction")
    say(f"{spent}; what was practised lies in {domain / PRACTICE}")
    if sum(one.spent for one in rounds) < interactions:
        say("note: it ended earlier, because no task had a plan, and no operator was left to be practised")
    say(f"{domain / DOMAIN} is compiled from it")
    say_next(f"neurosym new-problem {quoted(folder)}")
    return 0


def run(
    folder: Folder,
    world: Annotated[
        Optional[str],
        arg(help="Which world, for a new folder: tabletop (default), toy, or your own as module:factory."),
    ] = None,
    strategy: _StrategyOption = DEFAULT_STRATEGY,
    steps: Annotated[int, arg(help="Interactions to explore for.")] = 10_000,
    seed: Seed = 0,
    regime: _RegimeName = "default",
    workers: Workers = CPUS,
    rehearsals: Annotated[int, arg(help="Objects that each primitive is rehearsed on.")] = 100,
    choice: _Choice = "own",
    problems: Annotated[
        int, arg(help="Problems to draw, every second one with two objects; up to 30 if none has a plan.")
    ] = 6,
    object_bits: _ObjectBits = None,
    action_bits: _ActionBits = None,
    places: Annotated[
        Optional[int],
        arg(
            help="Interactions besides that are aimed at a place, to learn what carries objects there: a "
            "quarter of --steps from 1024 on, if not given."
        ),
    ] = None,
    relations: _Relations = 0,
) -> int:
    """Go the whole way: explore, train, distil, compile, draw problems, plan and execute.

    Interrupt it when you like: the same command goes on. Stages that were finished are not done again, and of
    exploring it loses at most a block of 512 interactions.
    """
    from neurosym.data.origin import strategy_named
    from neurosym.learning.training_config import regime_named
    from neurosym.stages.learning import check_steps
    from neurosym.stages.pipeline import go_the_whole_way
    from neurosym.worlds.workers import check_workers
    from neurosym.worlds.world_file import read_world

    strategy_named(strategy)
    regime_named(regime).model.with_bits(object_bits, action_bits)
    check_workers(workers)
    check_least(1, steps=steps, rehearsals=rehearsals)
    check_least(0, seed=seed, problems=problems, places=places or 0, relations=relations)
    if folder.is_dir():
        check_steps(opened(folder), steps)
    if not (folder / WORLD).exists():
        _make_folder(folder, world or "tabletop")
    elif world and (found := read_world(folder / WORLD).args[0]) != world:
        raise InvalidValue(f"{folder} is of the world {found!r}, not {world!r}; name another folder.")
    go_the_whole_way(
        opened(folder),
        strategy=strategy,
        steps=steps,
        seed=seed,
        regime=regime,
        workers=workers,
        rehearsals=rehearsals,
        choice=choice,
        problems=problems,
        object_bits=object_bits,
        action_bits=action_bits,
        places=places,
        relations=relations,
    )
    return 0
