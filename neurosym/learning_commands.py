"""The commands that learn: explore, train, distil."""

from typing import Annotated

from tyro.conf import arg

from neurosym.command_options import CPUS, Folder, RegimeName, Seed, Strategy, Workers
from neurosym.console import say, say_next
from neurosym.errors import InvalidValue
from neurosym.folder import DomainFolder
from neurosym.operators import OperatorTable


def explore(
    folder: Folder,
    strategy: Strategy = "curiosity",
    steps: Annotated[int, arg(help="Interactions to make; more can be made later.")] = 10_000,
    seed: Seed = 0,
    regime: RegimeName = "default",
    workers: Annotated[
        int | None, arg(help="Processes that simulate (one per CPU); does not change the result.")
    ] = None,
    ray: Annotated[
        str | None,
        arg(
            metavar="auto|HOST:PORT",
            help="Simulate on all CPUs of a Ray cluster, this machine's or by address, instead of --workers.",
        ),
    ] = None,
) -> int:
    """Let the robot explore (Algorithm 1): `world.toml` -> `interactions.npz`.

    Interrupt it when you like: the same command goes on from the last block of 512 interactions.
    """
    from neurosym.stages import explore_stage

    if workers is not None and ray is not None:
        raise InvalidValue("Give --workers or --ray, not both: with --ray, all CPUs of the cluster simulate.")
    domain = DomainFolder(folder)
    stage = explore_stage(
        domain,
        strategy=strategy,
        steps=steps,
        seed=seed,
        regime=regime,
        workers=CPUS if workers is None else workers,
        ray=ray,
    )
    domain.perform(stage, again=True)
    say(f"{steps} interactions in {folder / 'interactions.npz'}")
    say_next(f"neurosym train {folder}")
    return 0


def train(folder: Folder, seed: Seed = 0, regime: RegimeName = "default") -> int:
    """Fit the effect model whose bits are the symbols: `interactions.npz` -> `effect_model.safetensors`."""
    from neurosym.reporting import show_training
    from neurosym.stages import TRAINING, train_stage

    domain = DomainFolder(folder)
    domain.perform(train_stage(domain, seed=seed, regime=regime), again=True)
    show_training(domain / TRAINING)
    say_next(f"neurosym distill {folder}")
    return 0


def distill(
    folder: Folder,
    objects: Annotated[int, arg(help="Objects that each primitive is rehearsed on.")] = 100,
    seed: Seed = 0,
    workers: Workers = CPUS,
) -> int:
    """Turn action symbols into parameters and rehearse each in the world: -> `primitives.json`."""
    from neurosym.files import read_json
    from neurosym.reporting import show_operators
    from neurosym.stages import distill_stage

    domain = DomainFolder(folder)
    domain.perform(distill_stage(domain, objects=objects, seed=seed, workers=workers), again=True)
    show_operators(read_json(domain / "primitives.json", OperatorTable))
    say_next(f"neurosym compile-domain {folder}")
    return 0
