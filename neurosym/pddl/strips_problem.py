"""The problem that goes with the page: what is particular to the objects of a task, as facts and prices."""

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import pairwise

import msgspec

from neurosym.data.cells import Cells, Step
from neurosym.errors import counted
from neurosym.grounding import Grounding
from neurosym.pair_operators import PairState
from neurosym.pddl.grid import GoalRegion, anchor, goal_region, grid_of
from neurosym.pddl.movement import sums
from neurosym.pddl.strips import ALONG, FROM_PERCH, FROM_SPOT, NOWHERE
from neurosym.pddl.syntax import Atom, Facts, PddlProblem, Typed
from neurosym.tasks.options import Move, Put, step_cost
from neurosym.tasks.supports import loads_of
from neurosym.tasks.task import START, Pair, Task, is_at

_Way = tuple[tuple[str, str, int], ...]
"""What a way costs from each origin, and onto what bears so many."""
COUNTS = ("n0", *(f"n{number}" for number in range(1, 100)))
"""How many objects another one bears."""
STEPS = 1
"""How many steps the rounding of is reckoned with, unless the caller says otherwise.

More would be safer, but smaller goals make plans longer or impossible; a replay tells when it matters.
"""
COARSEST = 2
"""So many of the domain's cells a cell of a problem is long at most."""
CELLS_IN_TOLERANCE = 5
"""So many cells the tolerance of goals holds at least, or as many as the domain's own cells allow."""


def printed_cell(task: Task) -> float:
    """Return how long the cells of a printed problem are [m]: the coarser, the larger the tolerance."""
    own = task.grounding.cell
    whole = math.floor(task.problem.tolerance / CELLS_IN_TOLERANCE / own + 1e-9)
    return own * min(max(whole, 1), COARSEST)


def motion_name(move: Move) -> str:
    """Name a motion by its symbol, like `m-0110b`, whatever it does to which category."""
    return f"m-{move.operator.label}"


def step_name(axis: int, cells: int) -> str:
    """Name a step along an axis, like `dx12` or `dx-3`."""
    return f"d{ALONG[axis].name}{cells}"


BEGUN_BY = {"rest": ("push", "pushes"), "lift": ("lift", "lifts"), "put-down": ("put-down", "lowers")}
"""What begins each kind of move, and what says that it is offered."""


def words_of(name: str, move: Move) -> Atom:
    """Return what follows these words: the object, the motion, how far it goes, and what that costs."""
    shifts = (step_name(axis, move.cells[axis]) for axis in (0, 1))
    price = () if move.kind == "put-down" else (price_name(move.cost),)
    return (name, motion_name(move), *shifts, *price)


def price_name(cost: int) -> str:
    """Name a price, like `cost12`."""
    return f"cost{cost}"


def zone_name(zone: int) -> str:
    """Name the cells over which so many heights meet a goal, like `zone2`."""
    return f"zone{zone}"


class StripsProblem:
    """What a problem is printed of.

    Args:
        task: The task.
        led: The objects that are led over cells; those that cannot be carried to their goals, if not given.
        grid: The learned domain with the cells, and the table, that objects are led over.
        steps: How many steps the rounding of is taken off the goal regions.
        margin: How many cells at either edge of the table no step may end in.
        kept: Object and operator of what is told, though another one leads the object alike more cheaply.
        every: Whether all such are told.
    """

    def __init__(
        self,
        task: Task,
        *,
        led: Sequence[str] | None = None,
        grid: Grounding | None = None,
        steps: int = STEPS,
        margin: int = 0,
        kept: Collection[tuple[str, str]] = (),
        every: bool = False,
    ):
        self.task, self.steps, self.margin = task, steps, margin
        self._kept, self._every = kept, every
        self.led = tuple(task.led if led is None else led)
        self.cells = grid or msgspec.structs.replace(task.grounding, cell=printed_cell(task))

    @cached_property
    def grid(self) -> tuple[Cells, Cells, Cells]:
        """The grid that objects are led over."""
        return grid_of(self.cells)

    def data(self, beside: Iterable[Atom] = (), spots: Iterable[str] = ()) -> PddlProblem:
        """Return the problem as data, with the facts and the spots that plans beside it need."""
        task, facts = self.task, [*self._facts()]
        known = {atom for row in facts for atom in row.atoms}
        if more := [atom for atom in dict.fromkeys(beside) if atom not in known]:
            facts.append(Facts("for plans beside this problem, which the exact replay takes", tuple(more)))
        goals: list[Atom] = [("done", name) for name in sorted(task.problem.goals)]
        for target, reference, state in task.problem.relations:
            goals.append(("stands", target, self.perch(task.state_named(state), reference)))
        goals += [("settled", name) for name in task.lying]
        return PddlProblem(
            name=task.problem.name,
            domain=task.grounding.name,
            head=tuple(self._head()),
            objects=(*self._objects(), *((name, "spot") for name in dict.fromkeys(spots))),
            facts=tuple(facts),
            costs={("cost", price_name(cost)): cost for cost in self._prices},
            goals=tuple(goals),
        )

    @cached_property
    def regions(self) -> Mapping[str, GoalRegion]:
        """The goal region of each object that is led and has a goal."""
        problem, goals = self.task.problem, self.task.problem.goals
        return {
            name: goal_region(
                problem.object_named(name), goals[name], problem.tolerance, self.cells, steps=self.steps
            )
            for name in self.led
            if name in goals
        }

    @cached_property
    def moves(self) -> Mapping[str, tuple[Move, ...]]:
        """What is done to each object that is led, the surest of what does the same, in cells."""
        found = {name: self.task.every_move_on(self.cells, name) for name in self.led}
        if self._every:
            return found
        told = {(name, one) for name in self.led for one in _surest(self.task.moves_on(self.cells, name))}
        told |= {*self._kept}
        return {
            name: tuple(move for move in moves if (name, move.operator.name) in told)
            for name, moves in found.items()
        }

    def _head(self) -> Iterator[str]:
        problem = self.task.problem
        yield f"Problem {problem.name} of the learned domain {self.task.grounding.name}."
        yield f"How it came about: {' '.join(problem.provenance.split())}."
        if self.task.places:
            yield "start-: where an object stands at first; goal-: meets a goal; park-: to wait at."
        if self.led:
            yield (
                f"Cells of {1000 * self.cells.cell:g} mm. A goal is met within "
                f"{1000 * problem.tolerance:g} mm; goal cells keep inside by what the rounding of "
                f"{counted(self.steps, 'motion')} may take."
            )

    def _objects(self) -> Iterator[Typed]:
        task = self.task
        for item in task.problem.objects:
            yield item.name, task.grounding.category(item.category).name
        if task.places:
            starts = [f"{START}{name}" for name in task.names if name not in task.supports]
            yield from ((name, "spot") for name in (*starts, *task.places))
        if task.relates:
            yield from ((name, "perch") for name in self._perches)
            yield from ((name, "count") for name in COUNTS[1 : task.most_borne + 1])
            yield from ((name, "way") for name in self._ways.values())
        if self.led:
            motions = {motion_name(move) for moves in self.moves.values() for move in moves}
            yield from ((name, "motion") for name in sorted(motions))
            zones = {1, *(zone for region in self.regions.values() for zone in region.zone.values())}
            yield from ((zone_name(zone), "zone") for zone in sorted(zones))
            for number, axis in enumerate(ALONG):
                yield from ((step_name(number, cells), axis.steps) for cells in self._steps(number))
                yield from ((name, f"{axis.name}-cell") for name in self.grid[number].names)
        yield from ((price_name(cost), "price") for cost in self._prices)

    def _facts(self) -> Iterator[Facts]:
        task = self.task
        yield Facts("", (("hand-empty",), ("ready",)))
        if task.grounding.upright:
            settled = [("settled", name) for name in task.names if name not in task.lying]
            raised = [("rights", name, price_name(cost)) for name, cost in self._raised.items()]
            yield Facts("what lies as it shall, and what is to be set upright", (*settled, *raised))
        if task.places or task.relates:
            yield Facts("where objects are at first", tuple(self._starts()))
        if task.places:
            for place, (x, y) in task.places.items():
                rooms = [atom for name in task.occupants[place] for atom in self.room(name, place)]
                yield Facts(f"{place} lies at ({x:.4f}, {y:.4f}) m", (("free", place), *rooms))
            carried: list[Atom] = [("can-carry", *words, price_name(cost)) for words, cost in self._carried]
            yield Facts("what can be carried, from where, and its price", tuple(carried))
        if task.relates:
            yield from self._relations()
        for name in self.led:
            yield from self._leading(name)
        if self.led:
            yield Facts("where steps lead", tuple(self._sums()))

    @cached_property
    def _prices(self) -> list[int]:
        """All that steps cost, in order."""
        found = {move.cost for moves in self.moves.values() for move in moves if move.kind != "put-down"}
        found |= {*self._raised.values()}
        found |= {cost for _, cost in self._carried} | {cost for way in self._ways for *_, cost in way}
        return sorted(found)

    # Places

    def _starts(self) -> Iterator[Atom]:
        task = self.task
        takers = {*task.carried, *(target for target, _ in task.put_options)}
        for name in task.names:
            if borne := task.supports.get(name):
                yield "stands", name, self.perch(borne.state, borne.by)
            elif task.places:
                place = f"{START}{name}"
                yield "stands", name, place
                if name not in self.led:
                    yield from self._goal_at(name, place, task.flat.object_named(name).position)
            if task.grounding.relations:
                yield "bears", name, COUNTS[len(loads_of(name, task.supports))]
            if name in takers:
                yield "can-take", name

    def _goal_at(self, name: str, place: str, spot: Sequence[float]) -> list[Atom]:
        is_there = name in self.task.problem.goals and is_at(name, (spot[0], spot[1]), self.task.flat)
        return [("goal-place", name, place)] if is_there else []

    def room(self, name: str, place: str) -> list[Atom]:
        """Say which places must be free, one after another, for an object to have room at a place or spot."""
        spot = self.task.flat.place_named(place)
        chain = [*(f"{START}{other}" for other in self.task.blockers(name, spot)), NOWHERE]
        links: list[Atom] = [("then", name, place, here, then) for here, then in pairwise(chain)]
        return [*self._goal_at(name, place, spot), ("check", name, place, chain[0]), *links]

    @cached_property
    def _raised(self) -> dict[str, int]:
        """What setting an object upright costs, by its name."""
        lie, grounding = self.task.lying, self.task.grounding
        return {name: step_cost(operator, grounding) for name, operator in lie.items()}

    @cached_property
    def _carried(self) -> list[tuple[list[str], int]]:
        """What can be carried to places, from where if objects may be on others, and what that costs."""
        task, found = self.task, list[tuple[list[str], int]]()
        for name in task.carried:
            takes = task.relates and task.carriers[name][0].takes("borne")
            for borne in (False, True) if takes else (False,):
                origin = [FROM_PERCH if borne else FROM_SPOT] if task.grounding.relations else []
                found.append(([name, *origin], task.carry_cost(name, borne=borne)))
        return found

    # Relations

    @cached_property
    def _perches(self) -> Mapping[str, str]:
        """The relations in which things bear, or may come to bear something, each with the thing."""
        task = self.task
        found = [(borne.state, borne.by) for borne in task.supports.values()]
        found += [(task.state_named(state), other) for _, other, state in task.problem.relations]
        found += [(one.state, other) for (_, other), row in task.put_options.items() for one in row]
        named = {self.perch(state, name): name for state, name in found}
        return dict(sorted(named.items(), key=lambda one: one[::-1]))

    def perch(self, state: PairState, thing: str) -> str:
        """Name a relation to a thing that bears something in it, like `rests-on-item-06`.

        Its bits are named, too, if the domain has another relation of that name.
        """
        plain = _plain(state)
        is_only = sum(_plain(one) == plain for one in self.task.grounding.bearing_states) < 2
        return f"{plain if is_only else state.name}-{thing}"

    @cached_property
    def _offers(self) -> Mapping[Pair, Mapping[tuple[PairState, bool], _Way]]:
        """The states that each pair can be brought to, with or without a load, each with what it costs."""
        counts, offers = COUNTS[: self.task.most_borne], dict[Pair, dict[tuple[PairState, bool], _Way]]()
        for pair, options in self.task.put_options.items():
            found = offers.setdefault(pair, {})
            for one in options:
                key, cost = (one.state, "laden" in one.case), one.cost(self.task.grounding)
                origin = FROM_PERCH if "borne" in one.case else FROM_SPOT
                rows = [
                    (origin, count, cost) for count in (counts[1:] if "occupied" in one.case else counts[:1])
                ]
                found[key] = tuple(sorted((*found.get(key, ()), *rows)))
        return offers

    @cached_property
    def _ways(self) -> Mapping[_Way, str]:
        """The different prices by origin and count, each with the name of the ways that have them."""
        ways = sorted({way for found in self._offers.values() for way in found.values()})
        return {way: f"way{number}" for number, way in enumerate(ways, start=1)}

    def way_of(self, pair: Pair, option: Put) -> str:
        """Name the way that puts one object on or into another."""
        return self._ways[self._offers[pair][option.state, "laden" in option.case]]

    def _relations(self) -> Iterator[Facts]:
        counts = COUNTS[: self.task.most_borne + 1]
        yield Facts("counting", tuple(("next", less, more) for less, more in pairwise(counts)))
        yield Facts("on or in what", tuple(("on", perch, name) for perch, name in self._perches.items()))
        puts: list[Atom] = [
            ("can-put-loaded" if laden else "can-put", target, self.perch(state, reference), self._ways[way])
            for (target, reference), found in self._offers.items()
            for (state, laden), way in found.items()
        ]
        yield Facts("what puts one thing on or into another", tuple(puts))
        fees: list[Atom] = [
            ("fee", name, *words, price_name(cost))
            for way, name in self._ways.items()
            for *words, cost in way
        ]
        yield Facts("what that costs, by where the one is from, and what the other bears", tuple(fees))

    # Cells

    def _leading(self, name: str) -> Iterator[Facts]:
        problem, names = self.task.problem, [cells.names for cells in self.grid]
        item, goal, moves = problem.object_named(name), problem.goals.get(name), self.moves[name]
        x, y, _ = anchor(self.grid, item.position)
        atoms: list[Atom] = [
            *(("by-cells", name), ("on-table", name)),
            *(("at-x", name, names[0][x]), ("at-y", name, names[1][y])),
        ]
        atoms += [(BEGUN_BY[move.kind][1], *words_of(name, move)) for move in moves]
        yield Facts(f"{name} lies at {in_metres(item.position)} m at first", tuple(atoms))
        if goal:
            region = self.regions[name]
            heights: list[Atom] = [("goal-on-table", name, zone_name(zone)) for zone in region.zones_at(0)]
            heights += [
                ("goal-lifted", name, motion_name(move), zone_name(zone))
                for move in moves
                if move.kind == "lift"
                for zone in region.zones_at(move.cells[2])
            ]
            cells = [
                ("goal-cell", name, names[0][x], names[1][y], zone_name(zone))
                for (x, y), zone in region.zone.items()
            ]
            yield Facts(f"and shall come to {in_metres(goal)} m", (*heights, *cells))

    def _steps(self, axis: int) -> list[int]:
        """Return all steps along an axis, in order."""
        return sorted({move.cells[axis] for moves in self.moves.values() for move in moves})

    def _sums(self) -> Iterator[Atom]:
        for axis, cells in enumerate(self.grid[: len(ALONG)]):
            for by in self._steps(axis):
                yield from sums(cells, Step(by), step_name(axis, by), self.margin if by else 0)


def _plain(state: PairState) -> str:
    return state.name.removesuffix(f"-{state.symbol}")


def in_metres(position: Iterable[float]) -> str:
    """Print a position."""
    return f"({', '.join(f'{value:.4f}' for value in position)})"


def _surest(moves: Sequence[Move]) -> set[str]:
    """Name the operators of moves, of those that lead an object alike only the cheapest."""
    downs = {move.operator.name: move.cells for move in moves if move.kind == "put-down"}
    best = dict[tuple[object, ...], Move]()
    for move in moves:
        case = (move.cells, downs.get(move.operator.name))
        if move.kind != "put-down" and (case not in best or move.cost < best[case].cost):
            best[case] = move
    return {move.operator.name for move in best.values()}
