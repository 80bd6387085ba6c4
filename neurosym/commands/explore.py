"""The command `neurosym explore`: the robot plays."""

from typing import Annotated, Any

from tyro.conf import arg

from neurosym.choices import DEFAULT_STRATEGY
from neurosym.commands.options import (
    CPUS,
    Folder,
    Places,
    RegimeName,
    Relations,
    Seed,
    StrategyOption,
    Workers,
    opened,
)
from neurosym.console import say, say_next
from neurosym.wording import quoted


def explore(
    folder: Folder,
    strategy: StrategyOption = DEFAULT_STRATEGY,
    steps: Annotated[int, arg(help="Interactions to make; more can be made later.")] = 10_000,
    seed: Seed = 0,
    regime: RegimeName = "default",
    workers: Workers = CPUS,
    places: Places = 0,
    relations: Relations = 0,
) -> int:
    """Let the robot explore, curious or at random: `world.toml` -> `interactions.npz`.

    Interrupt it when you like: the same command goes on from the last block of 512 interactions.
    """
    from neurosym.stages.aims import TO_OBJECTS, TO_PLACES
    from neurosym.stages.exploring import explore_stage
    from neurosym.stages.layout import PLACE_INTERACTIONS, RELATION_INTERACTIONS

    domain = opened(folder)
    options: dict[str, Any] = {
        "strategy": strategy,
        "seed": seed,
        "regime": regime,
        "workers": workers,
    }
    if not relations:  # which are explored once all else is learned
        stage = explore_stage(domain, steps=steps, **options)
        domain.perform(stage, again=True)
        say(f"{steps} interactions in {folder / 'interactions.npz'}")
    if places:
        domain.perform(explore_stage(domain, TO_PLACES, steps=places, **options), again=True)
        say(f"{places} interactions aimed at places in {folder / PLACE_INTERACTIONS}")
    if relations:
        domain.perform(explore_stage(domain, TO_OBJECTS, steps=relations, **options), again=True)
        say(f"{relations} interactions aimed at other objects in {folder / RELATION_INTERACTIONS}")
    say_next(f"neurosym train {quoted(folder)}")
    return 0
