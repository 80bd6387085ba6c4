"""What sets things upright that lie on a side: of random actions, the best for each side is rehearsed.

No network is asked, since few actions do so at all.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from neurosym.checks import Float, check_count, check_seed
from neurosym.errors import Progress
from neurosym.operators import MIN_CHANCE, TABLE_FORMAT, Operator, OperatorTable, Primitive, Rehearsal, Symbol
from neurosym.pair_operators import extent
from neurosym.primitives.ledger import Ledger
from neurosym.primitives.rehearsal import rounded, sort_into_modes
from neurosym.primitives.sampling import draw_scene, perform_each
from neurosym.tasks.lying import SIDES, righted, side_of
from neurosym.world import ActionBox, Outcome, Scene, WorldFactory
from neurosym.worlds.workers import Task

ROUNDS = ((16, 4), (64, 1))
"""On how many others what set one thing upright is tried, and how many of the best for a side go on then:
successive halving (Karnin, Koren and Somekh, 2013)."""
_TRIED, _REHEARSED, _AUDITIONED = 0x757000, 0x757001, 0x757002  # keep these draws apart from others
_MEASURED = "effect", "resting_effect", "peak_height"
_Trial = tuple[Symbol, Float[np.ndarray, "A"], Sequence[int]]  # a side, an action, and numbers of objects


def find_uprighting(
    world_factory: WorldFactory,
    *,
    tries: int,
    objects: int,
    seed: int,
    ledger: Ledger,
    progress: Progress | None = None,
) -> OperatorTable:
    """Find what sets objects upright that lie on a side: an operator for each side, as far as there is any.

    What works on one side works in the mirror on the opposite one, in worlds that look the same there.

    Args:
        world_factory: Builds the world; must survive pickling if the ledger has more than one worker.
        tries: How many random actions are tried, each on an object of its own.
        objects: On how many objects the best action for each side is rehearsed.
        seed: Where all draws start.
        ledger: What performs, and knows what was performed before.
        progress: Called after each performance.
    """
    check_count("tries", tries)
    check_count("objects", objects)
    check_seed(seed)
    world, sides = world_factory(), [*SIDES]

    def perform(trials: Sequence[_Trial], stream: int) -> list[list[Outcome]]:
        """Perform actions on objects that lie on a side; those are left out that do not stay on it."""
        tasks = [
            [Task(laid(draw_scene(world, seed, stream, number), side), action) for number in numbers]
            for side, action, numbers in trials
        ]
        done = perform_each(ledger, world_factory, tasks, "upright", progress)
        return [
            [one for one in some if side_of(one.start.orientations[one.target], turned=False) == side]
            for (side, *_), some in zip(trials, done, strict=True)
        ]

    drawn = world.action_box.sample(np.random.default_rng([seed, _TRIED]), tries)
    tried: list[_Trial] = [(sides[n % len(sides)], action, (n,)) for n, action in enumerate(drawn)]
    good = [one[:2] for one, some in zip(tried, perform(tried, _TRIED), strict=True) if _share(some)]
    good = [
        (side[1] == "1" and _in_mirror(side, action, world.action_box)) or (side, action)
        for side, action in good
    ]
    for stream, (times, most) in enumerate(ROUNDS, _AUDITIONED):
        shares = map(_share, perform([(*one, range(times)) for one in good], stream))
        ranked = sorted(zip(shares, good, strict=True), key=lambda one: -one[0])
        of_side = [[one for share, one in ranked if one[0] == side and share > MIN_CHANCE] for side in sides]
        good = [one for some in of_side for one in some[:most]]
    mirrored = (_in_mirror(side, action, world.action_box) for side, action in good)
    found = dict(one for one in mirrored if one) | dict(good)
    chosen: list[_Trial] = [(side, found[side], range(objects)) for side in sides if side in found]
    rehearsed = perform(chosen, _REHEARSED)
    return OperatorTable(
        categories=(),
        primitives=tuple(Primitive(side, tuple(action.tolist()), 0.0) for side, action, _ in chosen),
        operators=tuple(
            _operator(side, some) for (side, *_), some in zip(chosen, rehearsed, strict=True) if _share(some)
        ),
        format=TABLE_FORMAT,
    )


def laid(scene: Scene, side: Symbol) -> Scene:
    """Return a scene whose one object lies on a side."""
    orientation, positions = np.zeros((1, 4)), scene.positions.copy()
    axis, is_along = int(side[0]), side in ("00", "11")
    orientation[0, [1 - axis, 3]] = np.sqrt(0.5) * (1 if is_along else -1), np.sqrt(0.5)
    positions[0, 2] = extent(replace(scene, positions=positions, orientations=orientation), 0)[2] / 2
    return replace(scene, positions=positions, orientations=orientation)


def _in_mirror(
    side: Symbol, action: Float[np.ndarray, "A"], box: ActionBox
) -> tuple[Symbol, Float[np.ndarray, "A"]] | None:
    """Return the opposite side, and the action in the mirror; None if the world may look otherwise there."""
    for mirror in box.mirrors:
        if mirror.effects == (int(side[0]),):
            signs = np.ones(len(action))
            signs[[*mirror.actions]] = -1
            return side[0] + "10"[int(side[1])], action * signs
    return None


def _share(outcomes: Sequence[Outcome]) -> float:
    """Return in how many of some performances the object stood in the end, as a share."""
    return sum(righted(one) == "resting" for one in outcomes) / max(1, len(outcomes))


def _operator(side: Symbol, outcomes: Sequence[Outcome]) -> Operator:
    rehearsals = tuple(
        Rehearsal(
            righted(one),
            rounded(one.effect),
            rounded(one.resting_effect),
            rounded([one.peak_height])[0],
            round(one.turn, 3),
        )
        for one in outcomes
    )
    numbers = (np.array([getattr(one, name) for one in rehearsals]) for name in _MEASURED)
    return Operator(
        name=f"set-upright-{SIDES[side]}-{side}",
        subject=side,
        primitive=side,
        trials=len(outcomes),
        outcomes=sort_into_modes([*map(righted, outcomes)], *numbers),
        promised="resting",
        rehearsals=rehearsals,
        objects=tuple(rounded(one.start.features[one.target]) for one in outcomes),
        frame="side",
    )
