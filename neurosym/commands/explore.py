"""The command `neurosym explore`: the robot plays."""

from typing import Annotated, Any, Optional

from tyro.conf import arg

from neurosym.choices import DEFAULT_STRATEGY
from neurosym.commands.options import (
    CPUS,
    Folder,
    MinPredictedEffect,
    Places,
    RegimeName,
    Relations,
    Seed,
    StrategyOption,
    opened,
)
from neurosym.console import say, say_next
from neurosym.errors import InvalidValue
from neurosym.wording import quoted


def explore(
    folder: Folder,
    strategy: StrategyOption = DEFAULT_STRATEGY,
    steps: Annotated[int, arg(help="Interactions to make; more can be made later.")] = 10_000,
    seed: Seed = 0,
    regime: RegimeName = "default",
    workers: Annotated[
        Optional[int], arg(help="Processes that simulate (one per CPU); does not change the result.")
    ] = None,
    ray: Annotated[
        Optional[str],
        arg(
            metavar="auto|HOST:PORT",
            help="Simulate on all CPUs of a Ray cluster, this machine's or by address, instead of --workers.",
        ),
    ] = None,
    min_predicted_effect: MinPredictedEffect = 0.0,
    places: Places = 0,
    relations: Relations = 0,
) -> int:
    """Let the robot explore, curious or at random: `world.toml` -> `interactions.npz`.

    Interrupt it when you like: the same command goes on from the last block of 512 interactions.
    """
    from neurosym.stages.aiming import explore_places_stage
    from neurosym.stages.exploring import explore_stage
    from neurosym.stages.layout import PLACE_INTERACTIONS, RELATION_INTERACTIONS
    from neurosym.stages.relating import explore_relations_stage

    if workers is not None and ray is not None:
        raise InvalidValue("Give --workers or --ray, not both: with --ray, all CPUs of the cluster simulate.")
    domain = opened(folder)
    options: dict[str, Any] = {
        "strategy": strategy,
        "seed": seed,
        "regime": regime,
        "workers": CPUS if workers is None else workers,
        "ray": ray,
    }
    if not relations:  # which are explored once all else is learned
        stage = explore_stage(domain, steps=steps, min_predicted_effect=min_predicted_effect, **options)
        domain.perform(stage, again=True)
        say(f"{steps} interactions in {folder / 'interactions.npz'}")
    if places:
        domain.perform(explore_places_stage(domain, steps=places, **options), again=True)
        say(f"{places} interactions aimed at places in {folder / PLACE_INTERACTIONS}")
    if relations:
        domain.perform(explore_relations_stage(domain, steps=relations, **options), again=True)
        say(f"{relations} interactions aimed at other objects in {folder / RELATION_INTERACTIONS}")
    say_next(f"neurosym train {quoted(folder)}")
    return 0
