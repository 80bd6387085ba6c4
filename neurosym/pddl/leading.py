"""`stepwise` where objects have steps of their own: operators begin moves, and three actions make them.

The action of an operator takes the lock `(ready)` and says which move of which object begins. `move-z`,
`move-x` and `move-y` are the same for all moves: each leads the object by the step that the problem names for
this move and this object along its axis, and hands on to the next; the last gives the lock back. What lifts
and puts down begins with z, other moves with x.

Moves are constants of PDDL, and not predicates each: readers look for facts that exclude each other, which
takes them time that grows with the square of the number of predicates.
"""

from neurosym.pddl.grid import AXES
from neurosym.pddl.moves import CARRIED, MOVE, carried, carrier, cost_name, move_constant
from neurosym.pddl.own_steps import has_cost
from neurosym.pddl.printing import action_text, comment
from neurosym.tasks.moves import Move


def predicates() -> list[str]:
    """List the predicates that say how far a move has come, and which lift holds an object."""
    moving = [f"(moving-{AXES[axis]} ?m - move ?o - movable)" for axis in CARRIED]
    return ["(held ?m - move ?o - movable)", *moving]


def beginning(move: Move) -> str:
    """Print the action that begins a move."""
    name, lifted = move_constant(move), f"(held {MOVE}{move.operator.name} ?o)"
    begun = f"(moving-{AXES[carried(move)[0]]} {name} ?o)"
    before = ["(ready)", *([lifted] if move.kind == "put-down" else ["(hand-empty)", f"(can {name} ?o)"])]
    hand = {
        "rest": [],
        "lift": ["(not (hand-empty))", lifted],
        "put-down": [f"(not {lifted})", "(hand-empty)"],
    }[move.kind]
    cost = f"({cost_name(move)} ?o)" if has_cost(move) else "0"
    after = ["(not (ready))", begun, *hand, "(not (done ?o))", f"(increase (total-cost) {cost})"]
    return action_text(move.name, f"?o - {move.category}", before, after)


def carriers() -> str:
    """Print the three actions that lead objects along the axes, in their order."""
    about = ["Lead an object along an axis, by the step that the problem names for its move."]
    locks = [f"(moving-{AXES[axis]} ?m ?o)" for axis in CARRIED]
    blocks = [comment(about, "  ")]
    for axis, taken, left in zip(CARRIED, locks, [*locks[1:], "(ready)"], strict=True):
        at, to = f"(at-{AXES[axis]} ?o ?from)", f"(at-{AXES[axis]} ?o ?to)"
        asked = [taken, at, f"({AXES[axis]}-of ?m ?o ?s)", f"({AXES[axis]}-leads ?s ?from ?to)"]
        parameters = f"?m - move ?o - movable ?s - {AXES[axis]}-step ?from ?to - {AXES[axis]}-cell"
        done = [f"(not {taken})", left, f"(not {at})", to, "(increase (total-cost) 0)"]
        blocks.append(action_text(carrier(axis), parameters, asked, done))
    return "\n".join(blocks)
