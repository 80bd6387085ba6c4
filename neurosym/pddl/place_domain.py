"""`places`: operators carry objects to places; what can only be pushed is led over cells, as in `stepwise`.

An object stands at a place, and it can be carried to another that is free: to that of its goal, or to one
to park on. Where another object stood at the start may overlap a place; it must be free, too, and `look-on`
notes so, one after another. Places that objects start from are never gone back to, so that what was seen to
be free stays so. Everything is positive STRIPS with types and action costs.
"""

from neurosym.grounding import Grounding
from neurosym.operators import Operator
from neurosym.pddl.moves import MOVE
from neurosym.pddl.printing import action_text, comment, millimetres
from neurosym.tasks.carriers import carriers_of

NOWHERE = "nowhere"
LOOK, REACH, LEAVE = "look-on", "reach-place", "leave-start"
"""Actions, free of cost, that note something: no step of a plan in the world."""
NOTES = (LOOK, REACH, LEAVE)


def constants(grounding: Grounding) -> list[str]:
    """List the constants that stand for operators that carry, and the place after the last."""
    names = " ".join(f"{MOVE}{one.name}" for one in carriers_of(grounding))
    return [*([f"    {names} - move"] if names else []), f"    {NOWHERE} - place"]


def predicates() -> list[str]:
    """List the predicates of places."""
    return [
        "(stands ?o - movable ?p - place)",
        "(free ?p - place)",
        "(goal-place ?o - movable ?p - place)",
        "(led ?o - movable)",
        "(room ?o - movable ?p ?so-far - place)",
        "(look-next ?o - movable ?p ?here ?next - place)",
    ]


def functions(grounding: Grounding) -> list[str]:
    """List the functions that say what it costs to have an object carried."""
    return [f"(cost-of-{one.name} ?o - {_type(one, grounding)}) - number" for one in carriers_of(grounding)]


def actions(grounding: Grounding) -> list[str]:
    """Print the actions that carry objects, each with a comment, and those that note something."""
    return [*(_carry(one, grounding) for one in carriers_of(grounding)), *_notes()]


def _carry(operator: Operator, grounding: Grounding) -> str:
    category = _type(operator, grounding)
    before = [
        "(ready)",
        "(hand-empty)",
        f"(can {MOVE}{operator.name} ?o)",
        "(stands ?o ?from)",
        "(free ?to)",
        f"(room ?o ?to {NOWHERE})",
    ]
    after = [
        "(not (stands ?o ?from))",
        "(free ?from)",
        "(stands ?o ?to)",
        "(not (free ?to))",
        "(not (done ?o))",
        f"(increase (total-cost) (cost-of-{operator.name} ?o))",
    ]
    text = action_text(operator.name, f"?o - {category} ?from ?to - place", before, after)
    return f"{comment(about_carrier(operator, grounding), '  ')}\n{text}"


def about_carrier(operator: Operator, grounding: Grounding) -> list[str]:
    """Say what was seen of an operator that carries, and which motion it is.

    Args:
        operator: The operator.
        grounding: The learned domain.
    """
    promise = operator.promise
    assert promise is not None
    assert grounding.places is not None
    x, y, _ = promise.resting_spread
    trials = f"{operator.trials} rehearsals"
    occupied, beside = (
        {one.name: one for one in table}.get(operator.name)
        for table in (grounding.places.occupied, grounding.places.beside)
    )
    action = " ".join(f"{value:.4f}" for value in grounding.primitive_of(operator).action)
    lines = [
        f"Primitive {operator.primitive} on category {operator.category} ({_type(operator, grounding)}): "
        f"carries to the place in {promise.count} of {trials}, "
        f"spread ({millimetres(x)}, {millimetres(y)}) mm.",
    ]
    if beside and beside.trials:
        lines.append(
            f"With others close beside the object, {beside.kept} of {beside.trials} went so, and moved none."
        )
    if occupied and occupied.trials:
        lines.append(
            f"With another object on the place it stood there in {occupied.kept} of {occupied.trials}; the "
            "place must be free."
        )
    return [*lines, f"Action parameters: {action}"]


def _notes() -> list[str]:
    free = "(increase (total-cost) 0)"
    said = {
        LOOK: "Note that a place is free that another overlaps.",
        REACH: "Note that an object stands where its goal is.",
        LEAVE: "Note that an object that was led to its goal has left where it started.",
    }
    look = action_text(
        LOOK,
        "?o - movable ?p ?here ?next - place",
        ["(ready)", "(room ?o ?p ?here)", "(free ?here)", "(look-next ?o ?p ?here ?next)"],
        ["(room ?o ?p ?next)", free],
    )
    reach = action_text(
        REACH,
        "?o - movable ?p - place",
        ["(ready)", "(stands ?o ?p)", "(goal-place ?o ?p)"],
        ["(done ?o)", free],
    )
    leave = action_text(
        LEAVE,
        "?o - movable ?p - place",
        ["(ready)", "(done ?o)", "(led ?o)", "(stands ?o ?p)"],
        ["(not (stands ?o ?p))", "(free ?p)", free],
    )
    pairs = ((LOOK, look), (REACH, reach), (LEAVE, leave))
    return [f"{comment([said[name]], '  ')}\n{text}" for name, text in pairs]


def _type(operator: Operator, grounding: Grounding) -> str:
    return grounding.category(operator.category).name
