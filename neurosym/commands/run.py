"""The command `neurosym run`: the whole way."""

from typing import Annotated, Optional

from tyro.conf import arg

from neurosym.choices import DEFAULT_STRATEGY
from neurosym.commands.init import make_folder
from neurosym.commands.options import (
    CPUS,
    ActionBits,
    Choice,
    Folder,
    ObjectBits,
    RegimeName,
    Relations,
    Seed,
    StrategyOption,
    Workers,
    check_least,
    opened,
)
from neurosym.errors import InvalidValue
from neurosym.stages.layout import WORLD


def run(
    folder: Folder,
    world: Annotated[
        Optional[str],
        arg(help="Which world, for a new folder: tabletop (default), toy, or your own as module:factory."),
    ] = None,
    strategy: StrategyOption = DEFAULT_STRATEGY,
    steps: Annotated[int, arg(help="Interactions to explore for.")] = 10_000,
    seed: Seed = 0,
    regime: RegimeName = "default",
    workers: Workers = CPUS,
    rehearsals: Annotated[int, arg(help="Objects that each primitive is rehearsed on.")] = 100,
    choice: Choice = "own",
    problems: Annotated[
        int, arg(help="Problems to draw, every second one with two objects; up to 30 if none has a plan.")
    ] = 6,
    object_bits: ObjectBits = None,
    action_bits: ActionBits = None,
    places: Annotated[
        Optional[int],
        arg(
            help="Interactions besides that are aimed at a place, to learn what carries objects there: a "
            "quarter of --steps from 1024 on, if not given."
        ),
    ] = None,
    relations: Relations = 0,
) -> int:
    """Go the whole way: explore, train, distil, compile, draw problems, plan and execute.

    Interrupt it when you like: the same command goes on. Stages that were finished are not done again, and of
    exploring it loses at most a block of 512 interactions.
    """
    from neurosym.stages.exploring import check_choices, check_steps
    from neurosym.stages.whole_way import go_the_whole_way
    from neurosym.worlds.workers import check_workers
    from neurosym.worlds.world_file import read_world

    check_choices(strategy, regime).model.with_bits(object_bits, action_bits)
    check_workers(workers)
    check_least(1, steps=steps, rehearsals=rehearsals)
    check_least(0, seed=seed, problems=problems, places=places or 0, relations=relations)
    if folder.is_dir():
        check_steps(opened(folder), steps)
    if not (folder / WORLD).exists():
        make_folder(folder, world or "tabletop")
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
