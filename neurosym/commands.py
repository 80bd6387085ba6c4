"""The commands of the command line: each names its options, performs a stage, and says what came of it."""

from pathlib import Path
from typing import Annotated

from tyro.conf import arg

from neurosym.command_options import (
    CPUS,
    Folder,
    MinPredictedEffect,
    RegimeName,
    Seed,
    Strategy,
    Workers,
)
from neurosym.console import say, say_next
from neurosym.errors import InvalidValue
from neurosym.folder import DomainFolder
from neurosym.quoting import quoted
from neurosym.strategies import DEFAULT_STRATEGY

WorldName = Annotated[
    str, arg(help="Which world, for a new folder: tabletop, toy, or your own as module:factory.")
]


def init(folder: Folder, world: WorldName = "tabletop") -> int:
    """Make a new domain folder with a `world.toml` that holds every option of its world."""
    from neurosym.stages import has_own_data

    if (folder / "world.toml").exists():
        raise InvalidValue(
            f"{folder / 'world.toml'} exists already; change it by hand, or name another folder."
        )
    _make_folder(folder, world)
    say_next(f"neurosym {'train' if has_own_data(DomainFolder(folder)) else 'explore'} {quoted(folder)}")
    return 0


def run(
    folder: Folder,
    world: Annotated[
        str | None,
        arg(help="Which world, for a new folder: tabletop (default), toy, or your own as module:factory."),
    ] = None,
    strategy: Strategy = DEFAULT_STRATEGY,
    steps: Annotated[int, arg(help="Interactions to explore for.")] = 10_000,
    seed: Seed = 0,
    regime: RegimeName = "default",
    workers: Workers = CPUS,
    rehearsals: Annotated[int, arg(help="Objects that each primitive is rehearsed on.")] = 100,
    problems: Annotated[
        int,
        arg(help="Problems to draw, every second one with two objects; up to 30 if none has a plan."),
    ] = 6,
    min_predicted_effect: MinPredictedEffect = 0.0,
) -> int:
    """Go the whole way: explore, train, distil, compile, draw problems, plan and execute.

    Interrupt it when you like: the same command goes on where it stopped, and does nothing twice.
    """
    from neurosym.pipeline import go_the_whole_way
    from neurosym.stages import check_choices, check_steps
    from neurosym.world_file import read_world

    check_choices(strategy, regime, min_predicted_effect)
    if rehearsals < 1:
        raise InvalidValue(f"rehearsals = {rehearsals} must be at least 1.")
    if folder.is_dir():
        check_steps(DomainFolder(folder), steps)
    if not (folder / "world.toml").exists():
        _make_folder(folder, world or "tabletop")
    elif world and (found := read_world(folder / "world.toml").args[0]) != world:
        raise InvalidValue(f"{folder} is of the world {found!r}, not {world!r}; name another folder.")
    go_the_whole_way(
        DomainFolder(folder),
        strategy=strategy,
        steps=steps,
        seed=seed,
        regime=regime,
        workers=workers,
        rehearsals=rehearsals,
        problems=problems,
        min_predicted_effect=min_predicted_effect,
    )
    return 0


def _make_folder(folder: Path, world: str) -> None:
    from neurosym.files import write_atomically
    from neurosym.world_file import default_text

    if folder.exists() and not folder.is_dir():
        raise InvalidValue(f"{folder} is not a folder; name another.")
    text = default_text(world, folder)
    folder.mkdir(parents=True, exist_ok=True)
    write_atomically(folder / "world.toml", text)
    say(f"wrote {folder / 'world.toml'}")
