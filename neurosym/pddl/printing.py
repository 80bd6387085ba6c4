"""What the encodings print alike: headers, comments, actions, and what they ask of the hand."""

import math
import textwrap
from functools import lru_cache

from neurosym.grounding import Grounding
from neurosym.operators import Effect, Operator
from neurosym.pddl.moves import BY_RELATIONS, DURATIVE, PLACES, Encoding, domain_name
from neurosym.tasks.moves import Move

TURNED = math.radians(15)
"""An object that is turned by more than this moves otherwise when the same is done again [rad]."""


_STEPS = "the hand can begin each step"
_UNSEEN = "`neurosym validate` replays a plan and finds objects that end in each other."
_LED = (
    "What is led over cells meets no condition for others: a valid plan may push it through an object, or "
    f"leave it in one. {_UNSEEN}"
)
_GUARANTEES: dict[str, tuple[str, ...]] = {
    PLACES: (
        f"What a valid plan guarantees: {_STEPS}; what is carried comes to free places, where it overlaps "
        "nothing that stands at a place; goals are met, by what is led up to the rounding of cells.",
        _LED,
    ),
    DURATIVE: (
        "What a valid plan guarantees: the hand carries one object at a time, to a free place, where no "
        "object stands in another.",
    ),
    **dict.fromkeys(
        BY_RELATIONS,
        (
            f"What a valid plan guarantees: {_STEPS}; each object comes to a free place or is borne by the "
            "one named, as its goal says. It does not say where in metres what is borne ends up; "
            "`neurosym validate` replays that.",
        ),
    ),
}
_GUARANTEES_ON_GRID = (
    f"What a valid plan guarantees: {_STEPS}; each object stays on the table and meets its goal, up to the "
    "rounding of positions.",
    _LED,
)


def guarantees(encoding: str) -> tuple[str, ...]:
    """Say what a valid plan of a printed domain guarantees, and what only its replay sees, in sentences.

    Args:
        encoding: Name of the encoding.
    """
    return _GUARANTEES.get(encoding, _GUARANTEES_ON_GRID)


def header(grounding: Grounding, encoding: Encoding, about: list[str]) -> str:
    """Print the comment that a domain begins with.

    Args:
        grounding: The learned domain.
        encoding: Name of the encoding.
        about: What is to be said about the encoding, one sentence a line.
    """
    trials = grounding.operators.trials
    lines = [
        f"Learned domain {grounding.name}, encoding {encoding}. Printed by neurosym; do not edit.",
        *about,
        "After a lift the hand is full: only the put-down of that lift applies.",
        "Cost of a step: 1."
        if grounding.unit_costs
        else f"Cost of a step: 1 + round(-100 ln((k + 1) / (n + 2))), k successes in n {trials}.",
        *guarantees(encoding),
    ]
    if grounding.operators.measured == "data":
        lines.append("Nothing was rehearsed: effects are averages over rows of the data.")
    return comment(lines, "")


def opening(grounding: Grounding, encoding: str, requirements: str) -> str:
    """Print how a domain opens: its name in an encoding, and what it asks of planners."""
    return f"(define (domain {domain_name(grounding, encoding)})\n  (:requirements {requirements})"


def hand_before(move: Move) -> tuple[list[str], list[str]]:
    """Say what the hand must be like for a move to begin, and what it no longer is from then on."""
    if move.kind == "put-down":
        holding = f"(held-by-{move.operator.name} ?o)"
        return [holding], [f"(not {holding})"]
    return ["(hand-empty)"], ["(not (hand-empty))"] if move.kind == "lift" else []


def hand_after(move: Move) -> list[str]:
    """Say what the hand is like once a move is done and was not before."""
    held = f"(held-by-{move.operator.name} ?o)"
    return {"rest": [], "lift": [held], "put-down": ["(hand-empty)"]}[move.kind]


def held_predicates(moves: tuple[Move, ...]) -> list[str]:
    """List the predicates that say which lift holds an object."""
    return [f"(held-by-{move.operator.name} ?o - {move.category})" for move in moves if move.kind == "lift"]


def action_text(name: str, parameters: str, before: list[str], after: list[str]) -> str:
    """Print an action, with its preconditions and effects."""
    return "\n".join(
        [
            f"  (:action {name}",
            f"    :parameters ({parameters})",
            f"    :precondition (and {' '.join(before)})",
            f"    :effect (and {' '.join(after)}))",
        ]
    )


def about_move(move: Move, grounding: Grounding) -> str:
    """Print the comment above the actions of a move: what was seen, and which motion it is."""
    operator, promise = move.operator, move.operator.promise
    if move.kind == "put-down":
        return comment([f"Put down what {operator.name} lifted."], "  ")
    assert promise is not None
    trials = f"{operator.trials} {grounding.operators.trials}"
    action = " ".join(f"{value:.4f}" for value in grounding.primitive(operator.label).action)
    lines = [
        f"Primitive {operator.primitive} on category {operator.category} ({move.category}); ends "
        f"{'held' if move.kind == 'lift' else 'at rest'} in {promise.count} of {trials} "
        f"({promise.share:.0%}).",
        f"Effect {_vector(promise.outcome)} mm, spread {_vector(promise.scatter)} mm; "
        f"{operator.successes} of {trials} as promised: cost {move.cost}.",
        f"Action parameters: {action}",
    ]
    return comment([*lines, *_about_rehearsals(operator, trials)], "  ")


def _about_rehearsals(operator: Operator, trials: str) -> list[str]:
    """Say what is known beside the mean, where rehearsals are kept."""
    if not operator.rehearsals:
        return []
    turned = sum(abs(row.turn) > TURNED for row in operator.rehearsals[: operator.trials])
    said = [f"It turned the object by over {math.degrees(TURNED):.0f} degrees in {turned} of {trials}."]
    return [*(said if turned else []), "What it promises for an object stands in the problem."]


def left_out(grounding: Grounding) -> str:
    """Print the comment that a domain ends with: which operators it does not have, and why."""
    lines = [f"{name}: {reason}." for name, reason in grounding.left_out.items()]
    return comment(["Left out:", *lines] if lines else ["No operator is left out."], "  ") + "\n"


def comment(lines: list[str], indent: str) -> str:
    """Print a comment, wrapped."""
    wrapped = [part for line in lines for part in _wrapped(line, 106 - len(indent))]
    return "\n".join(f"{indent}; {line}" for line in wrapped)


@lru_cache(maxsize=4096)
def _wrapped(line: str, columns: int) -> tuple[str, ...]:
    return tuple(textwrap.wrap(line, columns))


def millimetres(value: float) -> str:
    """Print a length [m] in mm."""
    return f"{round(value * 1000, 1) + 0.0:g}"


def _vector(vector: Effect) -> str:
    return "(" + ", ".join(millimetres(value) for value in vector) + ")"
