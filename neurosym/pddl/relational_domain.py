"""`relational`: objects stand at places or are borne by one another, and are put on or into one another.

A step has two actions. The first, free of cost, takes an object from where it is: `leave-place`, or `leave-`
and the state in which another object bears it. The second is the operator. So the ground actions of a domain
add up over where an object comes from and where it goes, and do not multiply.

What operators ask is what rehearsals with third objects showed (`relational.py`). STRIPS cannot say that no
third object rests on a reference, so it counts: `(bears ?r none)`, and `(next none one)`. The lifted variant
says `(not (exists ...))` instead. Both have types and action costs.
"""

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.operators import Operator
from neurosym.pddl.moves import LIFTED, RELATIONAL, Encoding
from neurosym.pddl.place_domain import LOOK, NOWHERE, REACH, about_carrier
from neurosym.pddl.printing import action_text, comment, guarantees, opening
from neurosym.pddl.relational_words import about_put, about_state, about_third
from neurosym.relation_operators import PairState
from neurosym.tasks.carriers import Actions, Carrier, actions_of
from neurosym.tasks.grades import GRADES, USUAL
from neurosym.tasks.puts import Put, bearing_states, left_out_puts

LEAVE = "leave-"
"""What the names of the actions begin with that take an object from where it is."""
LEAVE_PLACE = f"{LEAVE}place"
LADEN = "-laden"
"""What the name of an operator ends with where its target takes along what rests on it."""
FROM_PLACE, FROM_OBJECT = "from-place", "from-object"
"""Where an object in the hand comes from."""
NONE, ONE = "none", "one"
"""How many objects another one bears, to begin with."""
_GRADES = ", ".join(f"{grade} ({share:g})" for grade, share in [*GRADES.items()][::-1])
_FREE = "(increase (total-cost) 0)"


def relational_domain_text(
    grounding: Grounding, encoding: Encoding = RELATIONAL, actions: Actions | None = None
) -> str:
    """Print the domain.

    Args:
        grounding: The learned domain.
        encoding: `relational`, or `relational-lifted` with `not` and `exists`.
        actions: What it has actions for, if not for all that was learned.

    Raises:
        InvalidValue: If nothing in the domain puts objects in relations.
    """
    every = actions_of(grounding)
    if not every.puts:
        raise InvalidValue(f"Nothing in the domain {grounding.name} puts objects in relations.")
    actions, is_lifted = actions or every, encoding == LIFTED
    logic = " :negative-preconditions :existential-preconditions" if is_lifted else ""
    blocks = [
        _header(grounding, encoding),
        opening(grounding, encoding, f":strips :typing{logic} :action-costs"),
        _types(grounding, is_lifted),
        _predicates(actions, grounding, is_lifted),
        _functions(actions, grounding, is_lifted),
        *_taking(actions, grounding, is_lifted),
        *(_putting(put, grounding, is_lifted) for put in actions.puts),
        *(_carrying(one, grounding, is_lifted) for one in actions.carriers),
        *_noting(is_lifted),
        _left_out(grounding),
    ]
    return "\n\n".join(blocks) + ")\n"


def cost_function(name: str) -> str:
    """Name the function that says what an operator costs."""
    return f"cost-of-{name}"


def can_predicate(operator: str) -> str:
    """Name the predicate of the objects, or of the pairs, that an operator is likely to do its work with."""
    return f"can-{operator}"


def _header(grounding: Grounding, encoding: Encoding) -> str:
    count = (
        "What an object bears is asked for with `not` and `exists`."
        if encoding == LIFTED
        else "(bears ?r ?n): so many objects rest on or in ?r themselves; (next ?n ?more) counts on."
    )
    cost = (
        "Cost of a step: 1."
        if grounding.unit_costs
        else "Cost of a step: 1 + round(-100 ln p). Here p is (k + 1) / (n + 2) with k successes in n "
        "rehearsals, or the share that the grade of a pair stands for."
    )
    lines = [
        f"Learned domain {grounding.name}, encoding {encoding}. Printed by neurosym; do not edit.",
        "Every object stands at a place or is borne by another object. A step has two actions: leave-... "
        "takes an object from where it is, and the operator puts it elsewhere.",
        count,
        f"What spoiled more than half of what goes well otherwise is forbidden. {cost}",
        "(can-... ?t ?r ?g): an operator is likely to work with a pair; ?g says how surely. A problem tells "
        f"that of its pairs, as a network foresees it: {_GRADES}; or {USUAL}, as rehearsals showed.",
        *guarantees(encoding),
    ]
    return comment(lines, "")


def _types(grounding: Grounding, is_lifted: bool) -> str:
    names = " ".join(sorted(category.name for category in grounding.operators.categories))
    count = "" if is_lifted else "count "
    counts = "" if is_lifted else f"    {NONE} {ONE} - count\n"
    return (
        f"  (:types\n    movable place {count}origin grade - object\n    {names} - movable)\n\n"
        f"  (:constants\n{counts}    {FROM_PLACE} {FROM_OBJECT} - origin\n    {NOWHERE} - place)"
    )


def _predicates(actions: Actions, grounding: Grounding, is_lifted: bool) -> str:
    lines = ["(hand-empty)", "(can-be-taken ?o - movable)", "(taken ?o - movable ?from - origin)"]
    lines += ["(stands ?o - movable ?p - place)", "(free ?p - place)"]
    lines += ["(goal-place ?o - movable ?p - place)", "(done ?o - movable)"]
    if is_lifted:
        lines += ["(may-stand ?o - movable ?p - place)", "(overlaps ?o - movable ?p ?other - place)"]
        lines += ["(rests-with ?t ?r - movable)"]
    else:
        lines += ["(room ?o - movable ?p ?so-far - place)"]
        lines += ["(look-next ?o - movable ?p ?here ?next - place)"]
        lines += ["(bears ?r - movable ?n - count)", "(next ?n ?more - count)"]
    lines += [f"({state.name} ?t ?r - movable)" for state in bearing_states(grounding)]
    lines += [f"({name} ?t ?r - movable)" for _, name in sorted(actions.kinds.items())]
    lines += [f"({can_predicate(put.name)} ?t ?r - movable ?g - grade)" for put in actions.puts]
    lines += [
        f"({can_predicate(one.name)} ?o - {_type(one.operator, grounding)})" for one in actions.carriers
    ]
    return "  (:predicates\n" + "\n".join(f"    {line}" for line in lines) + ")"


def _functions(actions: Actions, grounding: Grounding, is_lifted: bool) -> str:
    lines = ["(total-cost) - number"]
    for put in actions.puts:
        names = [put.name, *([put.name + LADEN] if put.takes_laden else [])]
        parts = " ".join(cost_parameters(put, is_lifted))
        lines += [f"({cost_function(name)} {parts}) - number" for name in names]
    lines += [
        f"({cost_function(one.name)} ?o - {_type(one.operator, grounding)} ?from - origin) - number"
        for one in actions.carriers
    ]
    return "  (:functions\n" + "\n".join(f"    {line}" for line in lines) + ")"


def cost_parameters(put: Put, is_lifted: bool) -> list[str]:
    """List what the cost of an operator on pairs depends on, as parameters.

    Args:
        put: The operator.
        is_lifted: Whether nothing is counted.
    """
    counted = put.takes_occupied and not is_lifted
    counts, origins = ["?n - count"] if counted else [], ["?from - origin"] if put.takes_borne else []
    return ["?g - grade", *counts, *origins]


def _taking(actions: Actions, grounding: Grounding, is_lifted: bool) -> list[str]:
    """Print the actions that take objects from where they are."""
    bare = [] if actions.takes_loads else [_bears_nothing("?o", is_lifted)]
    before = ["(hand-empty)", "(can-be-taken ?o)", *bare]
    after = ["(not (hand-empty))", "(not (done ?o))"]
    place = action_text(
        LEAVE_PLACE,
        "?o - movable ?p - place",
        [*before, "(stands ?o ?p)"],
        [*after, "(not (stands ?o ?p))", "(free ?p)", f"(taken ?o {FROM_PLACE})", _FREE],
    )
    said = comment(
        ["Take an object from the place where it stands; the next action puts it elsewhere."], "  "
    )
    return [
        f"{said}\n{place}",
        *(_leave(state, before, after, is_lifted) for state in bearing_states(grounding)),
    ]


def _leave(state: PairState, before: list[str], after: list[str], is_lifted: bool) -> str:
    parameters = "?o ?b - movable"
    asked, then = [f"({state.name} ?o ?b)"], [f"(not ({state.name} ?o ?b))"]
    if is_lifted:
        then += ["(not (rests-with ?o ?b))"]
    else:
        parameters += " ?less ?n - count"
        asked += ["(bears ?b ?n)", "(next ?less ?n)"]
        then += ["(not (bears ?b ?n))", "(bears ?b ?less)"]
    then += [f"(taken ?o {FROM_OBJECT})", _FREE]
    said = about_state(state)
    return (
        f"{comment(said, '  ')}\n{action_text(LEAVE + state.name, parameters, before + asked, after + then)}"
    )


def _putting(put: Put, grounding: Grounding, is_lifted: bool) -> str:
    """Print an operator on pairs, and again with a load if it takes one."""
    texts = [_put_action(put, is_lifted, laden=False)]
    if put.takes_laden:
        texts.append(_put_action(put, is_lifted, laden=True))
    return "\n".join([comment(about_put(put, grounding), "  "), *texts])


def _put_action(put: Put, is_lifted: bool, *, laden: bool) -> str:
    name = put.name + (LADEN if laden else "")
    parameters, before, after = "?t ?r - movable", list[str](), ["(hand-empty)"]
    before += [f"({put.kind.name} ?t ?r)"] if put.kind else []
    before += [f"({can_predicate(put.name)} ?t ?r ?g)"]
    origin = "?from" if put.takes_borne else FROM_PLACE
    before += [f"(taken ?t {origin})"]
    after += [f"(not (taken ?t {origin}))", f"({put.state.name} ?t ?r)"]
    if laden:  # what is borne stands at no place, so that nothing is put on what it bears itself
        parameters += " ?p - place" + ("" if is_lifted else " ?less ?load - count")
        some = ["(exists (?x - movable) (rests-with ?x ?t))"]
        before += ["(stands ?r ?p)", *(some if is_lifted else ["(bears ?t ?load)", "(next ?less ?load)"])]
    else:
        before += [_bears_nothing("?t", is_lifted)]
    if is_lifted:
        before += [] if put.takes_occupied else [_bears_nothing("?r", is_lifted)]
        after += ["(rests-with ?t ?r)"]
    else:
        now, more = ("?n", "?more") if put.takes_occupied else (NONE, ONE)
        parameters += " ?n ?more - count" if put.takes_occupied else ""
        before += [f"(bears ?r {now})", *(["(next ?n ?more)"] if put.takes_occupied else [])]
        after += [f"(not (bears ?r {now}))", f"(bears ?r {more})"]
    parameters += f"{' ?from - origin' if put.takes_borne else ''} ?g - grade"
    named = [part.split()[0] for part in cost_parameters(put, is_lifted)]
    after += [f"(increase (total-cost) ({' '.join([cost_function(name), *named])}))"]
    return action_text(name, parameters, before, after)


def _bears_nothing(name: str, is_lifted: bool) -> str:
    return f"(not (exists (?x - movable) (rests-with ?x {name})))" if is_lifted else f"(bears {name} {NONE})"


def _carrying(carrier: Carrier, grounding: Grounding, is_lifted: bool) -> str:
    operator = carrier.operator
    origin = "?from" if carrier.takes_borne else FROM_PLACE
    parameters = f"?o - {_type(operator, grounding)} ?to - place"
    parameters += " ?from - origin" if carrier.takes_borne else ""
    before = [f"({can_predicate(operator.name)} ?o)", f"(taken ?o {origin})", "(free ?to)"]
    before += [] if carrier.takes_laden else [_bears_nothing("?o", is_lifted)]
    before += [_has_room() if is_lifted else f"(room ?o ?to {NOWHERE})"]
    before[3:3] = ["(may-stand ?o ?to)"] if is_lifted else []
    after = ["(hand-empty)", f"(not (taken ?o {origin}))", "(stands ?o ?to)", "(not (free ?to))"]
    after += [f"(increase (total-cost) ({cost_function(operator.name)} ?o {origin}))"]
    said = [
        *about_carrier(operator, grounding),
        about_third("under the object", carrier.borne, carrier.takes_borne),
        about_third("on the object", carrier.laden, carrier.takes_laden),
    ]
    return f"{comment(said, '  ')}\n{action_text(operator.name, parameters, before, after)}"


def _has_room() -> str:
    return "(not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p))))"


def _noting(is_lifted: bool) -> list[str]:
    """Print the actions that note something, at no cost."""
    look = action_text(
        LOOK,
        "?o - movable ?p ?here ?next - place",
        ["(room ?o ?p ?here)", "(free ?here)", "(look-next ?o ?p ?here ?next)"],
        ["(room ?o ?p ?next)", _FREE],
    )
    reach = action_text(
        REACH, "?o - movable ?p - place", ["(stands ?o ?p)", "(goal-place ?o ?p)"], ["(done ?o)", _FREE]
    )
    looked = f"{comment(['Note that a place is free that another overlaps.'], '  ')}\n{look}"
    reached = f"{comment(['Note that an object stands where its goal is.'], '  ')}\n{reach}"
    return [reached] if is_lifted else [looked, reached]


def _left_out(grounding: Grounding) -> str:
    lines = [f"{name}: {reason}." for name, reason in sorted(left_out_puts(grounding).items())]
    return comment(["Left out:", *lines] if lines else ["No operator is left out."], "  ") + "\n"


def _type(operator: Operator, grounding: Grounding) -> str:
    return grounding.category(operator.category).name
