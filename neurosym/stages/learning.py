"""The stages that explore, train and distil, and what actions are aimed at: an object, a place, another one.

All go the same way for each aim, in the world as the aim has it shown, with data and networks of its own.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from neurosym.checks import check_count
from neurosym.choices import BUDGET
from neurosym.data.interactions import Interactions
from neurosym.data.origin import (
    StrategyName,
    box_of,
    is_explored,
    model_misfit,
    own_name,
    strategy_named,
    training_problems,
    world_misfit,
)
from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice, quoted
from neurosym.files import make_folder, write_json
from neurosym.formats import PairFile, PlaceFile
from neurosym.learning.training_config import PAIR_BITS, PLACE_BITS, STATE_BITS, regime_named
from neurosym.operators import OperatorTable, Primitive, counted_axes
from neurosym.pair_operators import PairStates, describe_pair
from neurosym.primitives.audition import CHOICES
from neurosym.primitives.ledger import Ledger
from neurosym.stages import layout
from neurosym.stages.console import progress_bar
from neurosym.stages.folder import Claim, DomainFolder, Stage, versions
from neurosym.world import EFFECT_AXES, ActionBox, World, WorldFactory, references_of
from neurosym.worlds.aims import (
    PAIR_AXES,
    PLACE_AXES,
    REFERENCE,
    TARGET,
    AimedFactory,
    KnownMotions,
    RelatedFactory,
)
from neurosym.worlds.workers import check_workers
from neurosym.worlds.world_file import changed_option, has_world, origin_of, read_axes, read_world

if TYPE_CHECKING:
    from neurosym.learning.network import DirectModel
    from neurosym.primitives.operator_search import Method
    from neurosym.primitives.pair_rehearsal import Carriers


_MOST_TRIES = 100_000
"""So many actions are tried at most to set things upright."""
_FRESH = 600
"""Pairs that nobody touched, to learn states from."""
_STREAM = 0x6672  # keeps their draws apart from others


class Held(NamedTuple):
    """What is held to of what an earlier round learned.

    Attributes:
        performed: So many of the first interactions that were performed to choose and measure operators were
            paid for, and teach the network without a bottleneck.
        bits: Whether symbols stay what they are, and what was chosen before is a candidate again.
    """

    performed: int = 0
    bits: bool = False

    @property
    def options(self) -> dict[str, Any]:
        """What is unusual of it, as a stage's options."""
        return ({"performed": self.performed} if self.performed else {}) | (
            {"bits": "kept"} if self.bits else {}
        )


_NOTHING = Held()


@dataclass(frozen=True)
class Aim:
    """What actions are aimed at.

    Attributes:
        method: How operators are found, with the choice that the user made.
        table: File of the operators.
        folder: Where the other files are in the domain folder, which is also what users call it.
        at: The same in words; empty for the object alone.
        reference: What a world must take as a reference; empty for none.
        axes: How many axes effects have; None for as many as there are.
        bits: Of the symbols of objects, or pairs, and of actions; None for those of the regime.
        builds_on: Files that exploring reads besides the world's.
        networks: Which of its files has the network that shortlists, if there is anything to choose among.
        besides: Which other files of its own training writes and distilling reads.
        categories: The network that gives objects, or pairs, their symbols: a file of any aim.
        adapt: Has a world explored with such actions.
        stored: Makes of a table what its file holds.
        chosen: Reads the actions from that file.
        origin: What the data say of it.
        learn: Learns what else there is to learn of the data; gives what goes into which file.
        foresees: Files of the network that learns in the end from all that was performed.
    """

    method: Callable[[DomainFolder, str], "Method"]
    table: str
    folder: str = ""
    at: str = ""
    reference: str = ""
    axes: int | None = None
    bits: tuple[int, int] | None = None
    builds_on: tuple[str, ...] = ()
    networks: tuple[str, ...] = (layout.DIRECT_MODEL,)
    besides: tuple[str, ...] = ()
    categories: str = layout.MODEL
    adapt: Callable[[DomainFolder, WorldFactory], WorldFactory] = lambda _, factory: factory
    stored: Callable[[Any], object] = lambda table: table
    chosen: Callable[[Path], tuple[Primitive, ...]] = lambda path: OperatorTable.load(path).primitives
    origin: Mapping[str, Any] = field(default_factory=dict)
    learn: Callable[..., dict[str, Any]] = lambda *_: {}
    foresees: tuple[str, ...] = ()

    def file(self, name: str) -> str:
        """Return where one of its files is in the domain folder."""
        return f"{self.folder}/{name}" if self.folder else name

    def stage(self, verb: str) -> str:
        """Return the name of one of its stages."""
        return f"{verb}-{self.folder}" if self.folder else verb

    def check_takes(self, world: World) -> None:
        """Raise `InvalidValue` unless actions in a world can be aimed so."""
        if self.reference and self.reference not in references_of(world):
            raise InvalidValue(
                f"The world {world.name} takes no {self.reference} as a reference, so nothing can be learned "
                f"of {self.folder}; leave out --{self.folder}."
            )


def _search() -> Any:
    from neurosym.primitives import operator_search  # importing it takes seconds

    return operator_search


def _with_known_motions(folder: DomainFolder, factory: WorldFactory) -> WorldFactory:
    """Have pairs explored from what carries objects to places."""
    from neurosym.learning.network import EffectModel

    categorise = EffectModel.load(folder.require(layout.MODEL)).object_symbols
    places = PlaceFile.load(folder.require(layout.PLACE_OPERATORS)).table()
    return RelatedFactory(factory, KnownMotions(places, categorise, factory().action_box))


def carriers_of(folder: DomainFolder) -> "Carriers":
    """Return what a folder has learned to carry to places with, as it is aimed at other objects."""
    from neurosym.learning.network import EffectModel
    from neurosym.primitives.distillation import encoded
    from neurosym.primitives.pair_rehearsal import Carriers

    categorise = EffectModel.load(folder.require(layout.MODEL)).object_symbols
    places = PlaceFile.load(folder.require(layout.PLACE_OPERATORS)).table()
    return Carriers(
        places, categorise, partial(encoded, EffectModel.load(folder.require(layout.RELATION_MODEL)))
    )


def _learn_states(folder: DomainFolder, interactions: Interactions, held: Held, seed: int) -> dict[str, Any]:
    """Find the states of pairs, unless they are held."""
    from neurosym.learning.state_codes import ends_in, learn_states

    path = folder / layout.RELATION_INTERACTIONS
    if not np.any(interactions.effects[:, -1]):
        raise InvalidFile(path, "nothing was carried to another object; explore more")
    if held.bits:
        states = PairStates.load(folder.require(layout.RELATION_STATES))
    else:
        rng = np.random.default_rng([seed, _STREAM])
        world = RelatedFactory(read_world(folder.require(layout.WORLD)))()
        scenes = (world.sample_scene(rng, 1).whole for _ in range(_FRESH))  # type: ignore[attr-defined]
        fresh = np.array([describe_pair(scene, TARGET, REFERENCE, ()) for scene in scenes])
        states = learn_states(fresh, *ends_in(interactions), STATE_BITS, rng)
    if not states.bearing:
        raise InvalidFile(path, "no object came to bear another one; explore more")
    return {layout.STATES: states}


def _foresee(folder: DomainFolder, aim: Aim, ledger: Ledger, regime: str, seed: int) -> "DirectModel":
    """Learn from all that happened to pairs alone to foresee into which states they come.

    Actions count as they were performed, aimed over the middle. How it turns out among others is counted by
    operators.
    """
    from neurosym.learning.state_codes import fit_chances

    explored = Interactions.load(folder.require(aim.file(layout.INTERACTIONS)))
    states = PairStates.load(folder.require(aim.file(layout.STATES)))
    performed, carriers = ledger.interactions(explored.origin, objects=2), carriers_of(folder)
    targets = performed.features[:, : performed.features.shape[1] // 2]
    aimed = np.array([*map(carriers, performed.actions, targets)]).reshape(performed.actions.shape)
    with progress_bar("learning what is foreseen of pairs") as advance:
        return fit_chances(
            explored.join(replace(performed, actions=aimed)),
            states,
            regime_named(regime).training,
            seed=seed,
            progress=lambda stage, share: advance(round(100 * share), 100, stage),
        )


OBJECTS = Aim(lambda _, choice: _search().displacing(choice), layout.PRIMITIVES)
TO_PLACES = Aim(
    lambda *_: _search().CARRYING,
    layout.PLACE_OPERATORS,
    layout.PLACES,
    "places",
    reference="place",
    axes=PLACE_AXES,
    bits=PLACE_BITS,
    adapt=lambda _, factory: AimedFactory(factory),
    stored=PlaceFile.holding,
    chosen=lambda path: PlaceFile.load(path).operators.primitives,
    origin={"reference": "place"},
)
TO_OBJECTS = Aim(
    lambda folder, _: _search().relating(
        PairStates.load(folder.require(layout.RELATION_STATES)), carriers_of(folder)
    ),
    layout.RELATION_OPERATORS,
    layout.RELATIONS,
    "other objects",
    reference="object",
    axes=PAIR_AXES,
    bits=PAIR_BITS,
    builds_on=(layout.MODEL, layout.PLACE_OPERATORS),
    networks=(),
    besides=(layout.STATES,),
    categories=layout.RELATION_MODEL,
    adapt=_with_known_motions,
    stored=PairFile.holding,
    chosen=lambda path: PairFile.load(path).primitives,
    origin={"reference": "object", "proposed": True},
    learn=_learn_states,
    foresees=(layout.CHANCES,),
)


AIMS = (OBJECTS, TO_PLACES, TO_OBJECTS)
"""In the order in which one builds on another."""


def explore_stage(
    folder: DomainFolder,
    aim: Aim = OBJECTS,
    *,
    strategy: StrategyName,
    steps: int,
    seed: int,
    regime: str,
    workers: int,
    object_bits: int | None = None,
    action_bits: int | None = None,
) -> Stage:
    """Explore the world: `world.toml` -> `interactions.npz`, with a checkpoint after every block.

    Bits matter where a network with symbols is explored by: for the strategy `entropy`.
    """
    chosen, name, path = regime_named(regime), own_name(strategy), folder / aim.file(layout.INTERACTIONS)
    network = chosen.exploration
    if strategy_named(strategy).curious_about == "entropy":
        network = network.with_bits(object_bits, action_bits)

    def work() -> None:
        from neurosym.exploration.curiosity import LearningConfig
        from neurosym.exploration.loop import ExplorationConfig, explore

        check_count(aim.folder or "steps", steps)
        factory = read_world(folder.require(layout.WORLD))
        check_steps(folder, steps, aim, strategy=name, seed=seed)
        if aim.reference:
            aim.check_takes(factory())
        make_folder(path.parent)
        learning = LearningConfig(
            learning_rate=chosen.exploration_rate, loss_coefficient=chosen.training.loss_coefficient
        )
        shown = aim.adapt(folder, factory)
        with progress_bar(f"exploring {aim.folder} ({name})".replace("  ", " ")) as advance:
            interactions = explore(
                shown,
                steps=steps,
                strategy=strategy,
                seed=seed,
                workers=workers,
                checkpoint=path.parent,
                config=ExplorationConfig(learning=learning),
                model_config=network,
                origin={**origin_of(factory), **aim.origin},
                progress=advance,
            )
        interactions.save(path)

    options: dict[str, Any] = {"strategy": name, "steps": steps, "seed": seed, "regime": regime}
    options |= network.unusual_bits()
    inputs = (layout.WORLD, *folder.there(layout.EYE), *aim.builds_on)
    outputs = (aim.file(layout.INTERACTIONS),)
    return Stage(aim.stage("explore"), inputs, outputs, work, options, Claim.ALONE)


def _not_asked(*_: np.ndarray) -> np.ndarray:
    """Stand for a network where nothing is chosen by what one foresees."""
    raise AssertionError("nothing is chosen among")


def check_steps(folder: DomainFolder, steps: int, aim: Aim = OBJECTS, **asked: object) -> None:
    """Refuse to replace interactions by fewer, by others than are asked for, or a user's own by any."""
    path = folder / aim.file(layout.INTERACTIONS)
    if not path.exists():
        return
    found = Interactions.load(path)
    if not is_explored(found.origin):
        raise InvalidValue(
            f"{path} holds data which `neurosym explore` did not make; move it away first, or learn from it: "
            f"`neurosym train {quoted(folder.path)}`."
        )
    if len(found) > steps:
        said = f"{path} holds {len(found)} interactions already, more than {steps}"
        raise InvalidValue(f"{said}; remove it, or ask for more.")
    for name, wanted in asked.items():
        if (kept := found.origin.get(name)) != wanted:
            said = f"{path} was explored with {name} = {kept!r}, not {wanted!r}"
            raise InvalidValue(f"{said}; use that again, or another folder.")
    _check_world(folder, path, found.origin)


def _check_world(folder: DomainFolder, path: Path, origin: Mapping[str, Any]) -> None:
    """Refuse to go on with what was explored in the world as it was before an option was changed."""
    world = folder.require(layout.WORLD)
    if changed := changed_option(origin, origin_of(read_world(world))):
        name, kept, wanted = changed
        said = f"{path} was explored with {name} = {kept!r}, and {world} says {wanted!r}"
        raise InvalidValue(f"{said}; set it back, or name another folder.")


def distill_stage(
    folder: DomainFolder,
    aim: Aim = OBJECTS,
    *,
    objects: int,
    seed: int,
    workers: int,
    budget: int = BUDGET,
    held: Held = _NOTHING,
    choice: str = "own",
    regime: str = "default",
) -> Stage:
    """Distil primitives and rehearse them: model, data and world -> `primitives.json`.

    Without a `world.toml`, nothing is rehearsed: effects are averaged from the data, whose origin, or else
    least and greatest values, are the action box.

    The budget is for performances beyond those that were paid for.
    """
    check_count("objects", objects)
    check_workers(workers)
    if choice not in CHOICES:
        raise UnknownChoice("choice", choice, CHOICES)
    of_model, data, *besides = map(aim.file, (layout.MODEL, layout.INTERACTIONS, *aim.besides))
    networks = [*map(aim.file, aim.networks)]

    def work() -> None:
        from neurosym.learning.network import DirectModel, EffectModel
        from neurosym.primitives.operator_search import NothingDistilled, average_operators, find_operators

        model = EffectModel.load(folder.require(of_model))
        direct = [DirectModel.load(folder.require(name)) for name in networks]
        interactions = explored_for(folder, aim)
        for name, one in zip((of_model, *networks), (model, *direct), strict=True):
            if problem := model_misfit(one.dimensions, interactions.columns, interactions.origin):
                raise InvalidFile(folder / name, problem)
        predict = direct[0].predict_outcomes if direct else _not_asked
        try:
            if aim is OBJECTS and not has_world(folder / layout.WORLD):
                box = ActionBox(*box_of(interactions.actions, interactions.origin))
                known = model, predict, interactions, box, choice
                found = average_operators(*known, seed=seed, open_bar=progress_bar)
            else:
                method, factory = aim.method(folder, choice), read_world(folder.require(layout.WORLD))
                world = method.adapt(factory)()
                widths = len(world.feature_names), len(world.action_box.low)
                axes = getattr(world, "effect_axes", EFFECT_AXES)
                if problem := world_misfit(world.name, (*widths, axes), interactions.columns):
                    raise InvalidFile(folder / data, problem)
                ledger = ledger_of(folder, aim, workers, held.performed)
                found = find_operators(
                    model,
                    predict,
                    interactions,
                    world.action_box,
                    method,
                    categorise=EffectModel.load(folder.require(aim.categories)).object_symbols,
                    world_factory=factory,
                    objects=objects,
                    budget=budget,
                    seed=seed,
                    ledger=ledger,
                    former=aim.chosen(folder.require(aim.table)) if held.bits and direct else (),
                    open_bar=progress_bar,
                )
                for name in aim.foresees:
                    _foresee(folder, aim, ledger, regime, seed).save(folder / aim.file(name))
        except NothingDistilled as error:
            raise InvalidFile(folder / of_model, "no action encodes to its symbol; train again") from error
        write_json(folder / aim.table, aim.stored(found))

    options: dict[str, Any] = {"objects": objects, "seed": seed}
    options |= {} if budget == BUDGET else {"budget": budget}
    options |= held.options
    options |= {} if aim.folder else {"choice": choice}
    options |= {"regime": regime} if aim.foresees and regime != "default" else {}
    # which axes a user names decides nothing here
    world = () if read_axes(folder / layout.WORLD) else (layout.WORLD, *folder.there(layout.EYE))
    builds_on = () if networks else aim.builds_on
    explored = data, *_taught(folder, aim)
    inputs = tuple(
        dict.fromkeys((*world, *builds_on, aim.categories, of_model, *networks, *explored, *besides))
    )
    outputs = (aim.table, *map(aim.file, aim.foresees))
    return Stage(aim.stage("distill"), inputs, outputs, work, options, Claim.ALONE)


def explored_for(folder: DomainFolder, aim: Aim) -> Interactions:
    """Load what was explored for an aim; what taught an eye to see objects was random, and counts, too.

    Raises:
        InvalidFile: If a file is damaged, or the eye or the world is not that of what was explored.
    """
    path = folder.require(aim.file(layout.INTERACTIONS))
    found = Interactions.load(path)
    if (folder / layout.BUDGET).exists():  # whose account would not be true any more
        _check_world(folder, path, found.origin)
    for name in _taught(folder, aim) if is_explored(found.origin) else ():
        more = Interactions.load(folder / name)
        of = ("world", "world_options", "eye")
        widths = ({column: rows.shape[1:] for column, rows in one.columns.items()} for one in (found, more))
        is_alike = all(found.origin.get(what) == more.origin.get(what) for what in of)
        if not is_alike or next(widths) != next(widths):
            said = f"it is of another eye or world than {layout.INTERACTIONS}"
            raise InvalidFile(
                folder / name, f"{said}; remove it to learn without it, or see and explore anew"
            )
        found = found.join(more)
    return found


def _taught(folder: DomainFolder, aim: Aim) -> tuple[str, ...]:
    """Name the file with what taught an eye, if it tells of an aim, too."""
    return folder.there(layout.SEEN) if aim is OBJECTS else ()


def ledger_of(folder: DomainFolder, aim: Aim, workers: int = 1, free: int = 0) -> Ledger:
    """Open what was performed for an aim in the world of a folder; other worlds and versions are forgotten.

    Args:
        folder: The domain folder.
        aim: What the actions are aimed at.
        workers: How many processes perform what is new.
        free: So many were paid for before.
    """
    known = {**origin_of(read_world(folder.require(layout.WORLD))), "versions": versions()}
    return Ledger(folder / aim.file(layout.LEDGER), known, workers, free)


def upright_stage(folder: DomainFolder, *, tries: int, objects: int, seed: int, workers: int) -> Stage:
    """Find what sets things upright that lie on a side: `world.toml` -> `upright/operators.json`."""
    check_count("upright", tries)
    check_count("objects", objects)
    check_workers(workers)
    if tries > _MOST_TRIES:
        raise InvalidValue(f"upright = {tries} must be at most {_MOST_TRIES:,}.")

    def work() -> None:
        from neurosym.primitives.uprighting import find_uprighting

        factory = read_world(folder.require(layout.WORLD))
        path = folder / layout.UPRIGHT_OPERATORS
        make_folder(path.parent)
        known = {**origin_of(factory), "versions": versions()}
        ledger = Ledger(path.parent / layout.LEDGER, known, workers)
        with progress_bar("setting things upright") as advance:
            table = find_uprighting(
                factory, tries=tries, objects=objects, seed=seed, ledger=ledger, progress=advance
            )
        if not table.operators:
            raise InvalidValue(f"None of {tries} actions set anything upright in this world; try more.")
        write_json(path, table)

    options = {"tries": tries, "objects": objects, "seed": seed}
    outputs = (layout.UPRIGHT_OPERATORS,)
    inputs = layout.WORLD, *folder.there(layout.EYE)
    return Stage(f"distill-{layout.UPRIGHT}", inputs, outputs, work, options, Claim.ALONE)


def train_stage(
    folder: DomainFolder,
    aim: Aim = OBJECTS,
    *,
    seed: int,
    regime: str,
    object_bits: int | None = None,
    action_bits: int | None = None,
    held: Held = _NOTHING,
) -> Stage:
    """Make the final fit: `interactions.npz` -> `effect_model.safetensors` and `training.json`.

    Bits are those of the regime or the aim, if not given.

    Raises:
        UnknownChoice: If there is no such regime.
        InvalidValue: If there can be no such symbols.
    """
    chosen, data = regime_named(regime), aim.file(layout.INTERACTIONS)
    network = chosen.model.with_bits(*(aim.bits or ())).with_bits(object_bits, action_bits)
    learned = (*aim.besides, layout.MODEL, *aim.networks, layout.TRAINING)

    def work() -> None:
        from neurosym.learning.network import EffectModel
        from neurosym.learning.training import train

        path, interactions = folder.require(data), explored_for(folder, aim)
        if problems := training_problems(interactions.columns, interactions.origin):
            raise InvalidFile(path, problems[0])
        if aim.axes not in (None, axes := interactions.effects.shape[1]):
            raise InvalidFile(path, f"its effects have {counted_axes(axes)}; valid: {aim.axes}")
        more = None
        if held.performed:
            more = ledger_of(folder, aim).interactions(interactions.origin, held.performed)
        files: dict[str, Any] = aim.learn(folder, interactions, held, seed)
        with progress_bar(f"training {aim.folder}".rstrip()) as advance:
            trained = train(
                interactions,
                config=chosen.training,
                model_config=network,
                seed=seed,
                more=more,
                bits=EffectModel.load(folder.require(aim.file(layout.MODEL))) if held.bits else None,
                progress=lambda stage, share: advance(round(100 * share), 100, stage),
            )
        files |= {layout.DIRECT_MODEL: trained.direct, layout.MODEL: trained.model}
        files[layout.TRAINING] = trained.report
        for name in learned:
            file = folder / aim.file(name)
            if file.suffix == ".json":
                write_json(file, files[name])
            else:
                files[name].save(file)

    options: dict[str, Any] = {"seed": seed, "regime": regime}
    options |= {} if aim.bits else network.unusual_bits()
    options |= held.options
    inputs = (
        *((layout.WORLD, *folder.there(layout.EYE)) if aim.besides else ()),
        data,
        *_taught(folder, aim),
    )
    return Stage(aim.stage("train"), inputs, tuple(map(aim.file, learned)), work, options, Claim.ALONE)
