"""Commands that learn step by step, from `init`, which makes a domain folder, to `compile-domain`."""

from contextlib import suppress
from pathlib import Path
from typing import Annotated, Any, Literal, Optional

from tyro.conf import Positional, arg

from neurosym.choices import ACTED, BUDGET, CELL, DEFAULT_STRATEGY, LOOKED, StrategyName
from neurosym.commands.arguments import (
    CPUS,
    Engine,
    Folder,
    Json,
    Seed,
    Workers,
    answer_in,
    opened,
    refuse_options,
)
from neurosym.errors import (
    InvalidData,
    InvalidFile,
    InvalidValue,
    NeurosymError,
    counted,
    listed_briefly,
    quoted,
)
from neurosym.learning.training_config import DEFAULT_BITS, PAPER_BITS
from neurosym.stages import layout
from neurosym.stages.console import say, say_next

Strategy = Annotated[
    StrategyName,
    arg(
        help="How actions are chosen: disagreement (of several networks), entropy (the paper's, also called "
        "curiosity), random or active."
    ),
]
Relations = Annotated[
    int,
    arg(
        help="Interactions that are aimed at another object, to learn what can be done with pairs, once it "
        "is known what carries objects to places."
    ),
]
Choice = Annotated[
    Literal["own", "predictable", "lowest-error"],
    arg(
        help="Which candidate stands for a symbol: own (categories of objects have their own), "
        "predictable (the same for all), or lowest-error (the paper)."
    ),
]
RegimeName = Annotated[
    Literal["default", "quick", "paper"],
    arg(help="Network and training: default, quick (a first look), paper (as printed)."),
]
ObjectBits = Annotated[
    Optional[int],
    arg(
        help="Bits of an object symbol, 1 to 6: up to 2^bits categories of objects. By default "
        f"{DEFAULT_BITS[0]}."
    ),
]
ActionBits = Annotated[
    Optional[int],
    arg(
        help="Bits of an action symbol, 1 to 8: up to 2^bits primitives. By default "
        f"{DEFAULT_BITS[1]}, and {PAPER_BITS[1]} with quick and paper."
    ),
]


def init(
    folder: Folder,
    world: Annotated[
        str, arg(help="Which world, for a new folder: tabletop, camera, toy, or yours as module:factory.")
    ] = "tabletop",
    data: Annotated[
        Optional[Path],
        arg(metavar="FILE", help="A table of your own: .csv, .npy, .npz, .pt, .safetensors (docs/data.md)."),
    ] = None,
    columns: Annotated[
        Optional[Path],
        arg(
            metavar="FILE",
            help="A TOML file that says which columns are what, if names do not, and what axes are.",
        ),
    ] = None,
    engine: Engine = None,
) -> int:
    """Make a new domain folder with a `world.toml` that holds every option of its world.

    With `--data` it holds a table of yours, and `world.toml` says along which axes effects are.
    """
    if columns and not data:
        raise InvalidValue("--columns says what the columns of --data are; give both.")
    if data:
        if world != "tabletop" or engine:
            raise InvalidValue(
                "--data is a table of which there is no world; leave out --world and --engine."
            )
        _take_data(folder, data, columns)
        say_next(f"neurosym check {quoted(folder)}")
        return 0
    if not (world == "tabletop" and _write_own_axes(folder)):
        make_domain_folder(folder, world, engine)
    from neurosym.worlds.world_file import sees

    command = "train" if (folder / layout.INTERACTIONS).is_file() else "explore"
    with suppress(NeurosymError):  # a world that needs an option is not made yet
        command = "see" if sees(folder / layout.WORLD) else command
    say_next(f"neurosym {'distill' if (folder / layout.MODEL).is_file() else command} {quoted(folder)}")
    return 0


def _take_data(folder: Path, data: Path, columns: Path | None) -> None:
    """Make a domain folder of a table, with its axes in `world.toml`."""
    from neurosym.data.axes import axes_in
    from neurosym.data.origin import training_problems
    from neurosym.files import make_folder, write_new
    from neurosym.stages.seeing import seen_in
    from neurosym.worlds.world_file import axes_text

    found, eye = seen_in(data, columns, lambda said: say(f"note: {said}"))
    if problems := training_problems(found.columns, found.origin):
        raise InvalidData(data, problems)
    for name in (layout.INTERACTIONS, layout.WORLD):
        if (folder / name).exists():
            raise InvalidValue(f"{folder / name} exists already; name another folder.")
    make_folder(folder)
    write_new(folder / layout.WORLD, axes_text(axes_in(found.origin["axes"])))
    found.save(folder / layout.INTERACTIONS)
    if eye:
        eye.save(folder / layout.EYE)
        say(f"wrote {folder / layout.EYE}, which tells images in numbers: v1, v2 and so on")
    axes = ", ".join(f"{axis.name} ({axis.kind})" for axis in axes_in(found.origin["axes"]))
    say(f"wrote {folder / layout.INTERACTIONS}, {counted(len(found), 'interaction')}")
    say(f"wrote {folder / layout.WORLD}, where kinds, cells and bounds of axes can be set: {axes}")


def _write_own_axes(folder: Path) -> bool:
    """Write the axes of data of a user's own that lie in a folder already; say whether there are any."""
    from neurosym.data.axes import axes_in
    from neurosym.data.interactions import Interactions
    from neurosym.data.origin import is_explored
    from neurosym.files import write_new
    from neurosym.worlds.world_file import axes_text

    if not (file := folder / layout.INTERACTIONS).is_file():
        return False
    origin = Interactions.load(file).origin
    if (
        is_explored(origin)
        or not origin.get("axes")
        or not write_new(folder / layout.WORLD, axes_text(axes_in(origin["axes"])))
    ):
        return False
    say(f"wrote {folder / layout.WORLD} for the axes of {file}")
    return True


def make_domain_folder(folder: Path, world: str, engine: str | None = None) -> None:
    """Make a domain folder with every option of its world, and the engine that simulates it if it is named.

    Raises:
        InvalidValue: If it has a world already, or cannot be a folder.
    """
    from neurosym.files import make_folder, write_new
    from neurosym.worlds.world_file import default_text

    if folder.exists() and not folder.is_dir():
        raise InvalidValue(f"{folder} is not a folder; name another.")
    text = default_text(world, folder, engine)
    make_folder(folder)
    if not write_new(folder / layout.WORLD, text):
        said = f"{folder / layout.WORLD} exists already; change it by hand, or name another folder."
        raise InvalidValue(said)
    say(f"wrote {folder / layout.WORLD}")


def see(
    folder: Folder,
    interactions: Annotated[int, arg(help="Random actions to learn from.")] = ACTED,
    looks: Annotated[int, arg(help="Objects to look at besides.")] = LOOKED,
    seed: Seed = 0,
    workers: Workers = CPUS,
) -> int:
    """Teach the eye of a world that sees: `world.toml` -> `eye.safetensors` and `seen.npz`.

    It learns to tell the crop of an object in five numbers, from what random actions do to such objects. The
    second file holds what was done and seen, from which `train` learns, too.
    Interrupt it when you like: the same command goes on.
    """
    from neurosym.stages.seeing import see_stage

    domain = opened(folder)
    stage = see_stage(domain, acted=interactions, looked=looks, seed=seed, workers=workers)
    domain.perform(stage, again=True)
    say(f"wrote {folder / layout.EYE}, which learned from {counted(interactions, 'interaction')}")
    say_next(f"neurosym explore {quoted(folder)}")
    return 0


def explore(
    folder: Folder,
    strategy: Strategy = DEFAULT_STRATEGY,
    steps: Annotated[int, arg(help="Interactions to make; more can be made later.")] = 10_000,
    seed: Seed = 0,
    regime: RegimeName = "default",
    workers: Workers = CPUS,
    places: Annotated[
        int,
        arg(help="Interactions besides that are aimed at a place, to learn what carries objects there."),
    ] = 0,
    relations: Relations = 0,
) -> int:
    """Let the robot explore, curious or at random: `world.toml` -> `interactions.npz`.

    Interrupt it when you like: the same command goes on from the last block of 512 interactions.
    """
    from neurosym.stages.learning import AIMS, explore_stage

    domain = opened(folder)
    options: dict[str, Any] = {"strategy": strategy, "seed": seed, "regime": regime, "workers": workers}
    steps = 0 if relations else steps  # relations are explored once all else is learned
    for aim, count in zip(AIMS, (steps, places, relations), strict=True):
        if count:
            domain.perform(explore_stage(domain, aim, steps=count, **options), again=True)
            aimed = f" aimed at {aim.at}" if aim.at else ""
            say(f"{count} interactions{aimed} in {folder / aim.file(layout.INTERACTIONS)}")
    say_next(f"neurosym train {quoted(folder)}")
    return 0


def check(
    data: Annotated[
        Positional[Path],
        arg(metavar="DATA", help="A data set: an .npz file, or a folder that holds interactions.npz."),
    ],
    json: Json = False,
) -> int:
    """Check a data set, of your own or explored, before it is trained on.

    docs/data.md says what it must hold; every problem is told in a line of its own, with exit code 2.
    """
    from neurosym.commands.tables import show_data
    from neurosym.data.foreign_tables import IMAGES
    from neurosym.data.interactions import examine
    from neurosym.data.origin import training_problems, warnings_about
    from neurosym.stages.value_stages import check_own

    path = opened(data).require(layout.INTERACTIONS) if data.is_dir() else data
    if not path.is_file():
        raise InvalidFile(path, "there is no such file or folder")
    answer, found = answer_in(json), examine(path)
    if IMAGES in found.given and "features" not in found.given:
        said = "it has images in place of features"
        raise InvalidFile(path, f"{said}, which `neurosym init DIR --data {quoted(path)}` reads")
    if problems := [*found.problems, *training_problems(found.columns, found.origin)]:
        answer({"path": str(path), "problems": problems})
        raise InvalidData(path, problems)
    if data.is_dir():
        check_own(opened(data))
    interactions = found.interactions
    assert interactions is not None, "without problems there are interactions"
    show_data(interactions, path)
    warnings = warnings_about(interactions.columns, interactions.origin, found.given)
    for warning in warnings:
        say(f"note: {warning}")
    if path.name == layout.INTERACTIONS:
        say_next(f"neurosym train {quoted(path.parent)}")
    else:
        copying = f"mkdir -p my-domain && cp {quoted(path)} my-domain/{layout.INTERACTIONS}"
        say_next(f"{copying} && neurosym train my-domain")
    widths = {name: getattr(interactions, name).shape[1] for name in ("features", "actions", "effects")}
    rows = len(interactions)
    answer({"path": str(path), "interactions": rows, **widths, "problems": [], "notes": [*warnings]})
    return 0


def train(
    folder: Folder,
    seed: Seed = 0,
    regime: RegimeName = "default",
    object_bits: ObjectBits = None,
    action_bits: ActionBits = None,
) -> int:
    """Fit the model whose bits are symbols: `interactions.npz` -> `effect_model.safetensors`."""
    from neurosym.commands.tables import show_training
    from neurosym.stages.learning import AIMS, OBJECTS, explored_for, train_stage
    from neurosym.stages.value_stages import check_own

    domain = opened(folder)
    check_own(domain)
    bits: dict[str, Any] = {"object_bits": object_bits, "action_bits": action_bits}
    for aim in AIMS:
        data = domain / aim.file(layout.INTERACTIONS)
        if aim is OBJECTS or data.exists():
            own = bits if aim is OBJECTS else {}
            domain.perform(train_stage(domain, aim, seed=seed, regime=regime, **own), again=True)
            if aim.at:
                say(f"actions aimed at {aim.at}:")
            show_training(domain / aim.file(layout.TRAINING), explored_for(domain, aim))
    say_next(f"neurosym distill {quoted(folder)}")
    return 0


def distill(
    folder: Folder,
    objects: Annotated[int, arg(help="Objects that each primitive is rehearsed on.")] = 100,
    interactions: Annotated[int, arg(help="Interactions at most, for each kind of aim.")] = BUDGET,
    seed: Seed = 0,
    workers: Workers = CPUS,
    choice: Choice = "own",
    upright: Annotated[
        Optional[int],
        arg(help="Only find what sets things upright that lie on a side, among so many random actions."),
    ] = None,
) -> int:
    """Turn action symbols into parameters and rehearse each: -> `primitives.json`.

    Interrupt it when you like: the same command goes on. What was performed is kept in
    `performed.safetensors`, and not performed again.
    """
    from neurosym.checks import check_count
    from neurosym.commands.tables import show_operators, show_relations, show_righting, show_verdict
    from neurosym.formats import PairFile, PlaceFile
    from neurosym.operators import OperatorTable
    from neurosym.stages.learning import TO_OBJECTS, TO_PLACES, distill_stage, upright_stage
    from neurosym.stages.value_stages import is_of_values
    from neurosym.stages.verdicts import judge_operators, judge_relations

    check_count("interactions", interactions)
    domain, after = opened(folder), f"compile-domain {quoted(folder)}"
    if upright is not None:
        stage = upright_stage(domain, tries=upright, objects=objects, seed=seed, workers=workers)
        domain.perform(stage, again=True)
        show_righting(OperatorTable.load(domain / layout.UPRIGHT_OPERATORS))
        say_next(f"neurosym {after}")
        return 0
    options: dict[str, Any] = {"objects": objects, "budget": interactions, "seed": seed, "workers": workers}
    domain.perform(distill_stage(domain, choice=choice, **options), again=True)
    table = OperatorTable.load(domain / layout.PRIMITIVES)
    is_rehearsed = table.measured == "rehearsal"
    if is_rehearsed:
        show_operators(table)
        show_verdict(judge_operators(table))
    else:
        found = counted(len(table.symbols), "action symbol"), counted(len(table.categories), "object symbol")
        say(f"{' and '.join(found)}; there is no world, so nothing was rehearsed")
        if is_of_values(domain):
            say("what each does to each is told from the rows of the data, when a domain is compiled")
        else:
            after = f"init {quoted(folder)} --world module:factory"
    if is_rehearsed and (domain / layout.PLACE_MODEL).exists():
        domain.perform(distill_stage(domain, TO_PLACES, **options), again=True)
        places = PlaceFile.load(domain / layout.PLACE_OPERATORS).table()
        show_operators(places)
        show_verdict(judge_operators(places))
    if is_rehearsed and (domain / layout.RELATION_MODEL).exists():
        domain.perform(distill_stage(domain, TO_OBJECTS, **options), again=True)
        relations = PairFile.load(domain / layout.RELATION_OPERATORS).table()
        show_relations(relations)
        show_verdict(judge_relations(relations))
    say_next(f"neurosym {after}")
    return 0


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
    from neurosym.commands.tables import show_values, show_verdict
    from neurosym.grounding import Grounding
    from neurosym.stages.compilation import compile_stage
    from neurosym.stages.value_stages import compile_values_stage, is_of_values
    from neurosym.stages.verdicts import judge_domain

    domain = opened(folder)
    if is_of_values(domain):
        refuse_options(cell=None if cell == CELL else cell, durative=durative, plain=plain)
        domain.perform(compile_values_stage(domain, name=name), again=True)
        show_values(domain)
        say_next(f"neurosym new-problem {quoted(folder)}")
        return 0
    domain.perform(compile_stage(domain, cell=cell, name=name, durative=durative, plain=plain), again=True)
    grounding = Grounding.load(domain / layout.GROUNDING)
    known = {one.name for one in grounding.objects.operators}
    left_out = {name: reason for name, reason in grounding.left_out.items() if name in known}
    say(f"{len(grounding.live)} operators in {folder / layout.DOMAIN}; left out: {len(left_out)}")
    for operator, reason in left_out.items():
        say(f"  {operator}: {reason}")
    if durative:
        names = domain.problem_names()
        left = [one for one in names if not (domain / layout.problem_file(one, layout.DURATIVE)).exists()]
        taken = f"{len(names) - len(left)} of {counted(len(names), 'problem')}"
        say(f"{folder / layout.DURATIVE_DOMAIN} takes {taken}")
        if left:
            say("  left out, since not all can be carried to its goal, or something is to be set upright, or")
            say(f"  to bear something, or does so at first: {listed_briefly(left)}")
    show_verdict(judge_domain(grounding))
    say_next(f"neurosym new-problem {quoted(folder)}")
    return 0
