"""The commands that learn: explore, check, train, distil."""

from typing import Annotated

from tyro.conf import arg

from neurosym.command_options import (
    CPUS,
    DataPath,
    Folder,
    MinPredictedEffect,
    RegimeName,
    Seed,
    Strategy,
    Workers,
)
from neurosym.console import say, say_next
from neurosym.errors import InvalidData, InvalidFile, InvalidValue
from neurosym.folder import INTERACTIONS, PRIMITIVES, DomainFolder
from neurosym.operators import OperatorTable
from neurosym.quoting import quoted
from neurosym.strategies import DEFAULT_STRATEGY


def explore(
    folder: Folder,
    strategy: Strategy = DEFAULT_STRATEGY,
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
    min_predicted_effect: MinPredictedEffect = 0.0,
) -> int:
    """Let the robot explore, curious or at random: `world.toml` -> `interactions.npz`.

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
        min_predicted_effect=min_predicted_effect,
    )
    domain.perform(stage, again=True)
    say(f"{steps} interactions in {folder / 'interactions.npz'}")
    say_next(f"neurosym train {quoted(folder)}")
    return 0


def check(data: DataPath) -> int:
    """Check a data set, of your own or explored, before it is trained on.

    docs/data.md says what it must hold; every problem is told in a line of its own, with exit code 2.
    """
    from neurosym.data_check import training_problems, warnings_about
    from neurosym.interactions import examine
    from neurosym.reporting import show_data

    path = DomainFolder(data).require(INTERACTIONS) if data.is_dir() else data
    if not path.is_file():
        raise InvalidFile(path, "there is no such file or folder")
    found = examine(path)
    if problems := [*found.problems, *training_problems(found.columns, found.origin)]:
        raise InvalidData(path, problems)
    interactions = found.interactions
    assert interactions is not None, "without problems there are interactions"
    show_data(interactions, path)
    for warning in warnings_about(interactions.columns, interactions.origin, found.given):
        say(f"note: {warning}")
    is_in_place = path.name == INTERACTIONS
    copying = "" if is_in_place else f"mkdir -p my-domain && cp {quoted(path)} my-domain/{INTERACTIONS} && "
    say_next(f"{copying}neurosym train {quoted(path.parent) if is_in_place else 'my-domain'}")
    return 0


def train(folder: Folder, seed: Seed = 0, regime: RegimeName = "default") -> int:
    """Fit the effect model whose bits are the symbols: `interactions.npz` -> `effect_model.safetensors`."""
    from neurosym.reporting import show_training
    from neurosym.stages import TRAINING, train_stage

    domain = DomainFolder(folder)
    domain.perform(train_stage(domain, seed=seed, regime=regime), again=True)
    show_training(domain / TRAINING)
    say_next(f"neurosym distill {quoted(folder)}")
    return 0


def distill(
    folder: Folder,
    objects: Annotated[int, arg(help="Objects that each primitive is rehearsed on.")] = 100,
    seed: Seed = 0,
    workers: Workers = CPUS,
    choice: Annotated[
        str,
        arg(help="Which candidate stands for a symbol: predictable, or lowest-error (the paper)."),
    ] = "predictable",
) -> int:
    """Turn action symbols into parameters and rehearse each in the world: -> `primitives.json`."""
    from neurosym.files import read_json
    from neurosym.naming import counted_axes
    from neurosym.reporting import show_operators
    from neurosym.stages import distill_stage

    domain = DomainFolder(folder)
    domain.perform(
        distill_stage(domain, objects=objects, seed=seed, workers=workers, choice=choice), again=True
    )
    table = read_json(domain / PRIMITIVES, OperatorTable)
    show_operators(table)
    if table.measured == "rehearsal":
        say_next(f"neurosym compile-domain {quoted(folder)}")
        return 0
    say("there is no world.toml, so nothing was rehearsed: effects are averages over the rows of the data")
    if table.axes == 3:
        say("a PDDL domain needs a world besides, and distilled again, primitives are rehearsed in it")
        say_next(f"neurosym init {quoted(folder)} --world module:factory")
    else:
        say(f"no PDDL domain can be made of {counted_axes(table.axes)}: it moves objects along x, y and z")
        say_next(f"neurosym explain {quoted(folder)}")
    return 0
