"""What the comments of the encoding `relational` say: what rehearsals showed, and what follows from that."""

from neurosym.grounding import Grounding
from neurosym.place_operators import Kept
from neurosym.relation_operators import PairState
from neurosym.tasks.puts import Put


def about_state(state: PairState) -> list[str]:
    """Say what is typical of a state in which a reference bears its target.

    Args:
        state: The state.
    """
    away, above, *_ = state.centre
    return [
        f"Take an object from another that bears it in the state {state.symbol}: it is typically {away:.2f} "
        f"touching units away from that, and {above:.2f} above it."
    ]


def about_put(put: Put, grounding: Grounding) -> list[str]:
    """Say what was seen of an operator on pairs, what it asks for that, and which motion it is.

    Args:
        put: The operator.
        grounding: The learned domain.
    """
    operator, end = put.operator, put.end
    x, y, z = end.offset
    of_kind = f"the kind {operator.pair} ({put.kind.name})" if put.kind else "all kinds it was rehearsed with"
    lines = [
        f"Primitive {operator.primitive} on pairs of {of_kind}: ends in the "
        f"state {put.state.symbol} ({put.state.name}) in {end.count} of {operator.trials} rehearsals, at "
        f"({x:.2f}, {y:.2f}, {z:.2f}) touching units from the reference: cost {put.cost(grounding)}."
    ]
    cases = (
        ("on the reference", operator.occupied, put.takes_occupied),
        ("under the target", operator.borne, put.takes_borne),
        *((("on the target", operator.laden, put.takes_laden),) if put.kind else ()),
    )
    lines += [about_third(where, kept, allowed) for where, kept, allowed in cases]
    assert grounding.relations is not None
    action = " ".join(f"{value:.4f}" for value in grounding.relations.primitive_of(operator).action)
    return [*lines, f"Action parameters: {action}"]


def about_third(where: str, kept: Kept, allowed: bool) -> str:
    """Say how an operator turned out where there was a third object.

    Args:
        where: Where that was.
        kept: How it turned out.
        allowed: Whether the domain allows it.
    """
    verdict = "allowed" if allowed else "forbidden"
    if not kept.trials:
        return f"With a third object {where}: never rehearsed, and {verdict}."
    return f"With a third object {where}: {kept.kept} of {kept.trials} went so, and it is {verdict}."
