"""The rounds in which a budget of interactions is spent, and a domain grows.

A round learns in a folder of its own within the domain folder, and its files are put in place when it is
done. So others plan and execute meanwhile with what the rounds before it learned, and an interrupted round
goes on from what it wrote.
"""

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass, replace
from functools import cache, partial
from itertools import dropwhile, groupby
from pathlib import Path
from time import monotonic
from typing import Annotated, Any, NamedTuple

import msgspec

from neurosym.choices import CELL, StrategyName
from neurosym.data.interactions import Interactions
from neurosym.data.origin import own_name
from neurosym.errors import InvalidFile, InvalidValue, counted
from neurosym.files import (
    MOST_DATA,
    Drafts,
    digests,
    make_folder,
    read_bytes,
    read_json,
    refuse_other_kinds,
    write_atomically,
    write_json,
)
from neurosym.grounding import Grounding
from neurosym.learning.training_config import PAPER_BITS, regime_named
from neurosym.stages import layout
from neurosym.stages.compilation import compile_stage
from neurosym.stages.console import say, show_elsewhere, shown_doing
from neurosym.stages.folder import Claim, DomainFolder, Stage
from neurosym.stages.learning import (
    AIMS,
    OBJECTS,
    Aim,
    Held,
    check_steps,
    distill_stage,
    explore_stage,
    ledger_of,
    train_stage,
)
from neurosym.stages.verdicts import judge_domain
from neurosym.worlds.processes import Child, ChildEnded, parent
from neurosym.worlds.workers import WorkerDied, kept_workers

_TIMES = 5
"""So often an operator is to be seen at least, on average."""
_FIRST = 400
"""Interactions of the first round, for each part of the weights."""
_WORTH_A_ROUND = 1.6
"""A round is worth it if the budget is so many times as large as it, at least."""
_WORTH_GOING_ON = 1.2
"""What was learned stays as it is in a round unless there are so many times as many interactions for it."""
_WEIGHTS = {layout.OBJECTS: 6, layout.PLACES: 4, layout.RELATIONS: 5}
"""How the budget is shared by objects, places and other objects, if all are asked for."""
_EACH = 1000
"""So many for each part there are in all, if the user does not say how many."""
_EXPLORED = 0.4
"""Share of the interactions of each round that explore."""
_BLOCK = 512
"""So many interactions are explored between two updates of the networks."""
_HELD = 1024
"""Bits that were learned from so many explored interactions stay what they are. More are not explored for one
aim, unless the user says so: what is known then is better asked of operators."""
_IDLE = 0.9
"""A round that finds worthwhile performances for less than this share of its budget is the last."""
_SOON = 0.1
"""What a process says so soon after one began to listen to it was said before [s]."""
_ANEW = "; remove it to begin with a first round"


Count = Annotated[int, msgspec.Meta(ge=0)]
AimFolder = Annotated[str, msgspec.Meta(pattern=f"^({'|'.join(_WEIGHTS)})$")]


class Spent(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What one aim had of a round."""

    explored: Count  # interactions explored so far
    performed: Count  # interactions performed so far to choose and measure operators
    budget: Count  # how many these might be
    symbols: Count = 0  # from how many explored ones the symbols were learned


class Budget(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What the rounds that are done were spent on, by what was aimed at."""

    rounds: tuple[Annotated[dict[AimFolder, Spent], msgspec.Meta(min_length=1)], ...] = ()
    seen: Count = 0  # interactions that taught an eye before

    @property
    def last(self) -> Mapping[str, Spent]:
        """What was spent so far."""
        return self.rounds[-1] if self.rounds else {}

    @property
    def total(self) -> int:
        """All interactions that were performed, whatever for."""
        return self.seen + sum(one.explored + one.performed for one in self.last.values())

    @property
    def shares(self) -> "Round":
        """What each aim got so far."""
        return {name: Share(one.explored, one.budget) for name, one in self.last.items()}

    @property
    def is_idle(self) -> bool:
        """Whether the last round found too little that was worth performing."""
        return bool(self.rounds) and all(one.performed < _IDLE * one.budget for one in self.last.values())


class Share(NamedTuple):
    """What an aim gets of a round: interactions to explore, and to choose and measure operators, so far."""

    explored: int
    budget: int


Round = dict[str, Share]
"""Shares by the folder of the aim."""


def rounds(
    ceiling: int | None,
    aims: Sequence[str],
    operators: Mapping[str, int],
    most: Mapping[str, int | None],
    seen: int = 0,
) -> list[Round]:
    """Say how much each aim gets in each round, all rounds before it included.

    Args:
        ceiling: How many interactions there may be in all; as many as are usual for these aims if None.
        aims: Their folders.
        operators: How many operators there are, where it is known.
        most: How many interactions explore at most, where it is said.
        seen: How many of the ceiling teach an eye before.

    Raises:
        InvalidValue: If so few interactions are of no use.
    """
    weights = {name: _WEIGHTS[name] for name in aims}
    every = sum(weights.values())
    ceiling = (_EACH * every if ceiling is None else ceiling) - seen
    known = [name for name in weights if name in operators]
    least = {n: math.ceil(_TIMES * operators[n] * every / weights[n] / (1 - _EXPLORED)) for n in known}
    if ceiling < least[name := max(least, key=lambda name: least[name])]:
        of = f" of {name}" if name else ""
        of += f" besides {seen} that teach an eye" if seen else ""
        raise InvalidValue(
            f"--interactions {ceiling + seen} are too few for {operators[name]} operators{of}, which are to "
            f"be seen {_TIMES} times each; give at least {least[name] + seen}, or fewer bits."
        )
    doubled = (_FIRST * every << number for number in range(ceiling.bit_length()))
    plan = list[Round]()
    for total in [*(total for total in doubled if _WORTH_A_ROUND * total <= ceiling), ceiling]:
        last = plan[-1] if plan else dict.fromkeys(weights, Share(0, 0))
        split = {name: total * weight // every for name, weight in weights.items()}
        limits = {name: most.get(name) or _HELD for name in weights}
        plan.append({name: _share(count, limits[name], last[name]) for name, count in split.items()})
    return plan


def _share(count: int, most: int, last: Share) -> Share:
    """Split what an aim gets; whole blocks are explored if there are enough, since only these are kept."""
    explored = _EXPLORED * count
    if count > 2 * _BLOCK:
        explored = round(explored / _BLOCK) * _BLOCK
    explored = max(last.explored, min(int(explored), most, count - last.budget))
    return Share(explored, count - explored)


def _left_of(plan: Sequence[Round], last: Round) -> list[Round]:
    """Say what is left of a plan: no part of a share is smaller than was spent, nor its sum than was asked.

    Args:
        plan: The rounds.
        last: What was spent so far.
    """
    left = list[Round]()
    for asked in plan:
        goes_on = any(
            sum(share) >= _WORTH_GOING_ON * sum(last[name]) for name, share in asked.items() if name in last
        )
        more, free = dict[str, Share](), sum(map(sum, asked.values())) - sum(map(sum, last.values()))
        for name, share in asked.items():
            before = last.get(name, Share(0, 0))
            wanted = sum(share) if goes_on or name not in last else sum(before)
            free -= (added := max(0, min(wanted - sum(before), free)))
            explored = max(before.explored, min(share.explored, before.explored + added))
            if explored:  # of what is asked for later there is nothing in rounds that are paid for
                more[name] = Share(explored, sum(before) + added - explored)
        if any(last.get(name) != share for name, share in more.items()):
            left.append(more)
            last = {**last, **more}
    return left


def budget_of(folder: DomainFolder) -> Budget:
    """Read what the rounds that are done were spent on."""
    refuse_other_kinds(path := folder / layout.BUDGET)
    return read_json(path, Budget, _ANEW) if path.is_file() else Budget()


_BEGAN = "began.json"
"""In the folder in which a round learns: the digests of the files that it began from."""


@dataclass(frozen=True, slots=True)
class Recipe:
    """How every round explores, learns and rehearses."""

    strategy: StrategyName  # how actions are chosen that explore
    regime: str  # networks and training
    choice: str  # which candidate stands for a symbol
    objects: int  # how many objects each symbol is rehearsed on
    seed: int  # where all draws start
    workers: int  # how many processes; their number does not change what is learned
    bits: Mapping[str, int | None]  # of the symbols of objects and actions, where they are said

    def learn(self, folder: DomainFolder, shares: Round, before: Mapping[str, Spent]) -> dict[str, Spent]:
        """Explore, train and distil, as far as each aim's share of a round goes.

        Networks of aims that build on no other one are trained while the next of these explores or rehearses.

        Args:
            folder: Where.
            shares: What there is to spend, and was.
            before: What was spent.

        Returns:
            What is spent now, by aim.
        """
        spent = dict[str, Spent]()
        for _, group in groupby(AIMS, lambda aim: bool(aim.builds_on)):
            turns = [
                self._turn(folder, aim, shares[aim.folder], before.get(aim.folder))
                for aim in group
                if aim.folder in shares
            ]
            with ExitStack() as aside:
                is_aside, fits = self.workers > 1 and len(turns) > 1, list[Stage]()
                for turn in turns:
                    perform(folder, turn.explore)
                    fits.append(_trained_aside(folder, turn, aside) if is_aside else turn.train)
                for turn, train in zip(turns, fits, strict=True):
                    perform(folder, train)
                    perform(folder, turn.distill)
                    performed = len(ledger_of(folder, turn.aim))
                    spent[turn.aim.folder] = msgspec.structs.replace(turn.spent, performed=performed)
        return spent

    def _turn(self, folder: DomainFolder, aim: Aim, share: Share, before: Spent | None) -> "_Turn":
        """Say what is to be done for an aim."""
        held = Held()
        if before is not None:
            there = len(ledger_of(folder, aim))  # none if another version performed it
            is_little = share.budget < 2 * before.performed  # to measure what other symbols mean
            held = Held(min(before.performed, there), is_little or before.symbols >= _HELD)
        fitting: dict[str, Any] = {"seed": self.seed, "regime": self.regime}
        fitting |= self.bits if aim is OBJECTS else {}
        training = fitting | {"held": held}
        searching: dict[str, Any] = {"objects": self.objects, "choice": self.choice, "seed": self.seed}
        searching["regime"] = self.regime
        searching["budget"] = max(0, share.budget - held.performed)
        exploring: dict[str, Any] = {"steps": share.explored, "strategy": self.strategy}
        symbols = before.symbols if before is not None and held.bits else share.explored
        return _Turn(
            aim,
            explore_stage(folder, aim, workers=self.workers, **exploring, **fitting),
            train_stage(folder, aim, **training),
            distill_stage(folder, aim, held=held, workers=self.workers, **searching),
            training,
            Spent(share.explored, 0, share.budget, symbols),
        )


class _Turn(NamedTuple):
    """What is done for an aim in a round."""

    aim: Aim
    explore: Stage
    train: Stage
    distill: Stage
    training: dict[str, Any]  # the options of `train`
    spent: Spent  # what comes of it, but for what is performed


def _trained_aside(folder: DomainFolder, turn: _Turn, until: ExitStack) -> Stage:
    """Begin to train in a process that ends with the stack; the stage waits for what comes of it.

    Most of a training is done by one thread, so that processors would be idle.
    """
    if folder.is_current(turn.train):
        return turn.train
    child = Child()
    until.callback(child.close, grace=0.0)
    child.ask(_trained, folder.path, turn.aim.folder, turn.training)
    return replace(turn.train, work=partial(_put_in_place, folder, child))


def _trained(path: Path, aimed_at: str, training: dict[str, Any]) -> dict[str, bytes]:
    """Train for the aim with that folder; gives what each file is to hold, and writes none."""
    show_elsewhere(parent().send)
    folder, aim = DomainFolder(path), next(aim for aim in AIMS if aim.folder == aimed_at)
    stage = train_stage(folder, aim, **training)
    with Drafts() as drafts:
        stage.work()
        written = {name: drafts.now_at(folder / name) for name in stage.outputs}
        return {name: read_bytes(file, MOST_DATA) for name, file in written.items() if file}


def _put_in_place(folder: DomainFolder, child: Child) -> None:
    """Wait for what was trained aside, and write its files."""
    try:
        with shown_doing(always=True) as show:
            begin = monotonic()
            contents = child.answer(hear=lambda said: show(said) if monotonic() - begin > _SOON else None)
    except ChildEnded as error:
        raise WorkerDied from error
    for name, content in contents.items():
        make_folder((folder / name).parent)
        write_atomically(folder / name, content)


@kept_workers()
def grow(folder: DomainFolder, plan: Sequence[Round], recipe: Recipe, *, is_open: bool) -> None:
    """Go on with the rounds that are not done yet, as long as they find what is worth performing.

    Args:
        folder: The domain folder.
        plan: What each aim gets in each round.
        recipe: How each round learns.
        is_open: Whether more rounds may come later; else there is one, of which no account is kept.

    Raises:
        FolderTaken: If another process learns in the folder.
    """
    budget = budget_of(folder) if is_open else Budget()
    budget = msgspec.structs.replace(budget, seen=max(budget.seen, acted_in(folder)))
    alone = {name: Share(count, 0) for name, count in explored_in(folder).items()}  # before there were rounds
    left = _left_of(plan, (budget.shares or alone) if is_open else {})
    shared, name = (left or [budget.shares])[-1], own_name(recipe.strategy)
    if missing := plan[-1].keys() - shared.keys():
        raise InvalidValue(
            f"{counted(budget.total, 'interaction')} were performed already, so nothing is left for "
            f"{', '.join(sorted(missing))}; "
            f"give --interactions {round(_WORTH_A_ROUND * budget.total)} or more."
        )
    for aim in (aim for aim in AIMS if aim.folder in shared):  # refuse a user's own data, and other draws
        asked = shared[aim.folder].explored
        check_steps(folder, asked, aim, strategy=name, seed=recipe.seed)
    if budget.rounds:
        _check_spent(folder, budget)
        _check_trained(folder, recipe)
    if not left:
        done, more = counted(budget.total, "interaction"), math.ceil(_WORTH_GOING_ON * budget.total)
        say(f"{done} were performed already; --interactions {more} or more go on from there")
        perform(folder, compile_stage(folder, cell=CELL))
        return
    if is_open and not (folder / layout.BUDGET).exists():
        write_json(folder / layout.BUDGET, budget)  # it says that there are rounds
    count = len(budget.rounds) + len(left)
    with folder.claimed(Claim.SHARED), _workshop(folder) as workshop:
        _check_begun(workshop, left[0])
        for shares in left:
            if budget.is_idle:
                say("the last round found too little that was worth performing, so this is the end")
                break
            if is_open:
                asked = sum(map(sum, ({**budget.shares, **shares}).values())) + budget.seen
                say(f"round {len(budget.rounds) + 1} of {count} begins: up to {asked} interactions in all")
            spent = recipe.learn(workshop, _grown(shares, budget.shares), budget.last)
            budget = Budget((*budget.rounds, {**budget.last, **spent}), budget.seen)
            if is_open:
                write_json(workshop / layout.BUDGET, budget)
            _publish(workshop, folder)
            if is_open:
                can = judge_domain(Grounding.load(folder / layout.GROUNDING)).lines[0]
                done = f"round {len(budget.rounds)} of {count}"
                say(f"{done}: {counted(budget.total, 'interaction')} so far; {can}")


def _check_spent(folder: DomainFolder, budget: Budget) -> None:
    """Refuse an account that tells of more than there is."""
    path, explored, aims = folder / layout.BUDGET, explored_in(folder), {aim.folder: aim for aim in AIMS}
    for name, spent in budget.last.items():
        there = {
            layout.INTERACTIONS: (spent.explored, explored.get(name, spent.explored)),
            layout.LEDGER: (spent.performed, len(ledger_of(folder, aims[name])) or spent.performed),
        }
        for file, (told, found) in there.items():
            if told > found:
                at = folder / aims[name].file(file)
                raise InvalidFile(path, f"it tells of {told} interactions, and {at} has {found}{_ANEW}")


def _check_trained(folder: DomainFolder, recipe: Recipe) -> None:
    """Refuse to go on from symbols that were learned in another regime, or have other bits."""
    trained = folder.manifest().stages.get(OBJECTS.stage("train"))
    network = regime_named(recipe.regime).model.with_bits(**recipe.bits)
    asked = {"regime": recipe.regime, "object_bits": network.object_bits, "action_bits": network.action_bits}
    usual = dict(zip(("object_bits", "action_bits"), PAPER_BITS, strict=True))
    kept = {**asked, **usual, **trained.options} if trained else asked
    for name, wanted in asked.items():
        if kept[name] != wanted:
            said = f"{folder / layout.MODEL} was trained with {name} = {kept[name]!r}, not {wanted!r}"
            raise InvalidValue(f"{said}; use that again, or another folder.")


def _check_begun(workshop: DomainFolder, shares: Round) -> None:
    """Refuse to go on with a round that was begun for a larger budget."""
    for name, there in explored_in(workshop).items():
        if name in shares and there > shares[name].explored:
            raise InvalidValue(
                f"{workshop.path} has explored {there} interactions for a round of another budget, more than "
                f"{shares[name].explored}; ask for that budget again, or remove {workshop.path}."
            )


def _grown(shares: Round, before: Round) -> Round:
    """Leave out the aims before the first whose share grew; each builds on those before it."""
    ordered = [(aim.folder, shares[aim.folder]) for aim in AIMS if aim.folder in shares]
    return dict(dropwhile(lambda pair: before.get(pair[0]) == pair[1], ordered))


def explored_in(folder: DomainFolder) -> Counter[str]:
    """Count what was explored, by what was aimed at."""
    paths = {aim.folder: folder / aim.file(layout.INTERACTIONS) for aim in AIMS}
    return Counter({name: len(Interactions.load(path)) for name, path in paths.items() if path.is_file()})


def acted_in(folder: DomainFolder) -> int:
    """Count what was performed to teach an eye."""
    return len(Interactions.load(folder / layout.SEEN)) if folder.there(layout.SEEN) else 0


def perform(folder: DomainFolder, stage: Stage) -> None:
    """Perform a stage unless it is done already, and say which."""
    done = folder.perform(stage, again=False)
    say(f"{stage.name}: {'done' if done else 'up to date'}")


@cache
def _files() -> tuple[str, ...]:
    """Name the files that rounds change."""
    from neurosym.exploration.loop import INTERACTIONS_FILE, STATE_FILE  # which takes seconds

    names = [layout.WORLD, layout.EYE, layout.SEEN, layout.BUDGET]
    for aim in AIMS:
        learned = layout.MODEL, *aim.networks, *aim.besides, *aim.foresees, layout.TRAINING, layout.LEDGER
        names += map(aim.file, (STATE_FILE, INTERACTIONS_FILE, layout.INTERACTIONS, *learned))
        names.append(aim.table)
    return tuple(dict.fromkeys(names))


def _digests(folder: DomainFolder) -> dict[str, str]:
    return digests({name: folder / name for name in _files()})


@contextmanager
def _workshop(folder: DomainFolder) -> Iterator[DomainFolder]:
    """Open the folder in which rounds learn, and remove it when they are done; nobody else learns in it.

    It begins with what was learned, and anew if that was changed since.
    """
    path = folder / layout.GROWING
    if path.is_symlink():
        raise InvalidFile(path, "it is a link, and should be a folder; move it away")
    make_folder(path)
    workshop = DomainFolder(path, folder.notify)
    with workshop.claimed(Claim.ALONE):
        now, began = _digests(folder), path / _BEGAN
        if not began.is_file() or read_json(began, dict[str, str], "; remove it to go on") != now:
            for name in (*_files(), layout.MANIFEST):
                (path / name).unlink(missing_ok=True)
            workshop.take_over(folder, _files())
            write_json(began, now)
        yield workshop
        for name in (*_files(), layout.MANIFEST, _BEGAN):
            (path / name).unlink(missing_ok=True)
        for place in (path / layout.PLACES, path / layout.RELATIONS, path):
            with suppress(OSError):  # what else is there stays
                place.rmdir()


def _publish(workshop: DomainFolder, folder: DomainFolder) -> None:
    """Put what was learned in its place, and compile it, when nobody works with what was there."""
    with folder.alone():
        if read_json(workshop / _BEGAN, dict[str, str]) != _digests(folder):
            raise InvalidValue(
                f"Files of {folder.path} were changed while it grew; the same command begins there."
            )
        folder.take_over(workshop, _files())
        write_json(workshop / _BEGAN, _digests(folder))
        perform(folder, compile_stage(folder, cell=CELL))
