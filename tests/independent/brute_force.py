"""Breadth-first search over every position that objects can come to: exact, slow, and nothing of neurosym.

Lengths are whole numbers here, so that equal positions are equal, and a scene is looked at once.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal

from independent.replay import PUT_DOWN, Json, Step, Tabletop, displacement, domain_operators, lifts, settled

UNIT = 10**6
"""Lengths are counted in micrometres."""
MOST_STATES = 2_000_000

Spot = tuple[int, int]
State = tuple[Spot, ...]


@dataclass(frozen=True)
class Move:
    """What one primitive does to one object."""

    name: str
    lifts: bool
    up: tuple[int, int, int]
    down: Spot


@dataclass(frozen=True)
class Answer:
    """What the search says: the fewest primitives, or that there is no plan, or how deep it looked."""

    fewest: int | None  # primitives; None if no plan was found
    is_exact: bool  # whether everything that can be reached was looked at, or a plan was found
    depth: int  # all plans of so many primitives were looked at
    steps: tuple[Step, ...] = ()


class Search:
    """All that can be done in a scene."""

    def __init__(self, grounding: Json, scene: Json, most_states: int = MOST_STATES) -> None:
        top = Tabletop(grounding, scene)
        self.names = [item["name"] for item in scene["objects"]]
        self.most_states = most_states
        live = domain_operators(grounding)
        fitting = ([one for one in live if one["category"] == item["category"]] for item in scene["objects"])
        self.moves = [list(map(_move, operators)) for operators in fitting]
        sizes = [tuple(whole(size) for size in item["features"][:2]) for item in scene["objects"]]
        self.twice_apart = [
            [
                (0, 0) if (name, other) in top.in_each_other else (one[0] + two[0], one[1] + two[1])
                for other, two in zip(self.names, sizes, strict=True)
            ]
            for name, one in zip(self.names, sizes, strict=True)
        ]
        self.heights = [whole(item["position"][2]) for item in scene["objects"]]
        self.start: State = tuple(tuple(map(whole, item["position"][:2])) for item in scene["objects"])
        self.rooms = [[tuple(map(whole, axis)) for axis in top.room(name)] for name in self.names]
        goals = scene["goals"]
        self.goals = [tuple(map(whole, goals[name])) if name in goals else None for name in self.names]
        self.near = whole(scene["tolerance"]) ** 2

    def solve(self) -> Answer:
        """Find a plan with the fewest primitives."""
        if all(self._rests_right(self.start, row) for row in range(len(self.start))):
            return Answer(0, True, 0)
        level: dict[State, tuple[Step, ...]] = {self.start: ()}
        seen, depth = {self.start}, 0
        while level:
            depth += 1
            following: dict[State, tuple[Step, ...]] = {}
            for state, steps in level.items():
                wrong = [row for row in range(len(state)) if not self._rests_right(state, row)]
                for row, move, held, then in self._children(state, wrong):
                    done = (*steps, (move.name, self.names[row]))
                    if held:
                        return Answer(depth, True, depth, done)
                    if then is None or then in seen:
                        continue
                    done += ((PUT_DOWN + move.name, self.names[row]),) if move.lifts else ()
                    if all(self._rests_right(then, other) for other in {*wrong, row}):
                        return Answer(depth, True, depth, done)
                    seen.add(then)
                    following[then] = done
                if len(seen) > self.most_states:
                    return Answer(None, False, depth - 1)
            level = following
        return Answer(None, True, depth)

    def _children(self, state: State, wrong: list[int]) -> Iterator[tuple[int, Move, bool, State | None]]:
        """List what can be done: with what, whether all goals are met in the air, and where it ends."""
        for row, moves in enumerate(self.moves):
            x, y = state[row]
            for move in moves:
                if not self._on_table(row, up := (x + move.up[0], y + move.up[1])):
                    continue
                above = (*up, self.heights[row] + move.up[2])
                held = move.lifts and not {*wrong} - {row} and self._meets(row, above)
                down = (x + move.down[0], y + move.down[1])
                fits = self._on_table(row, down) and self._is_free(state, row, down)
                if held or fits:
                    yield row, move, held, (*state[:row], down, *state[row + 1 :]) if fits else None

    def _on_table(self, row: int, spot: Spot) -> bool:
        (x_low, x_high), (y_low, y_high) = self.rooms[row]
        return x_low <= spot[0] <= x_high and y_low <= spot[1] <= y_high

    def _is_free(self, state: State, row: int, spot: Spot) -> bool:
        return not any(
            other != row and 2 * abs(x - spot[0]) < apart_x and 2 * abs(y - spot[1]) < apart_y
            for other, ((x, y), (apart_x, apart_y)) in enumerate(
                zip(state, self.twice_apart[row], strict=True)
            )
        )

    def _rests_right(self, state: State, row: int) -> bool:
        return self._meets(row, (*state[row], self.heights[row]))

    def _meets(self, row: int, place: tuple[int, ...]) -> bool:
        goal = self.goals[row]
        return goal is None or sum((a - b) ** 2 for a, b in zip(place, goal, strict=True)) <= self.near


def whole(length: Decimal) -> int:
    """Return a length [m] as a whole number of micrometres, which it must be."""
    counted = length * UNIT
    assert counted == int(counted), f"{length} m is no whole number of micrometres"
    return int(counted)


def _move(operator: Json) -> Move:
    x, y, z = map(whole, displacement(operator))
    down_x, down_y, _ = map(whole, settled(operator))
    return Move(operator["name"], lifts(operator), (x, y, z), (down_x, down_y))
