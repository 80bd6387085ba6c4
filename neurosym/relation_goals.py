"""Goals by relation: which object shall stand to which other one in which state of pairs."""

from collections.abc import Collection, Iterable, Sequence

from neurosym.errors import InvalidValue

RelationGoal = tuple[str, str, str]
"""Names of the target and of the reference, and the name or symbol of the state of the pair."""

FORMER_SUFFIX = "-any-pair"
"""What operators for pairs of any kind were called with in earlier versions, whose files are still read."""


def pair_key(target: str, reference: str) -> str:
    """Return what a pair of objects is called where their kinds are kept.

    Args:
        target: Name of the target.
        reference: Name of the reference.
    """
    return f"{target} {reference}"


def check_pair_keys(what: str, keys: Iterable[str], names: Sequence[str]) -> None:
    """Raise `InvalidValue` unless what is told of pairs is told of pairs of objects that there are.

    Args:
        what: What is told.
        keys: What the pairs are called there, as `pair_key` calls them.
        names: Names of the objects.
    """
    for key in keys:
        pair = key.split(" ")
        if len(pair) != 2 or pair[0] == pair[1] or not set(pair) <= set(names):
            raise InvalidValue(
                f"{what} has an entry for {key!r}; valid: the names of two objects with a blank between, of "
                f"{', '.join(names)}."
            )


def check_relation_goals(
    goals: Sequence[RelationGoal], names: Sequence[str], placed: Collection[str]
) -> None:
    """Raise `InvalidValue` unless goals by relation can all be met at once, as far as names tell.

    Args:
        goals: The goals.
        names: Names of the objects.
        placed: Names of the objects that have a goal on the table or above it.
    """
    listed = ", ".join(names)
    over, states = dict[str, str](), dict[str, str]()
    for target, reference, state in goals:
        for name in (target, reference):
            if name not in names:
                raise InvalidValue(
                    f"There is a relation of {name}, which is not in the scene; objects: {listed}."
                )
        if target == reference:
            others = ", ".join(name for name in names if name != target) or "a second object, which lacks"
            raise InvalidValue(f"{target} cannot be {state} of itself; valid references: {others}.")
        if over.setdefault(target, reference) != reference:
            raise InvalidValue(
                f"{target} shall be with {over[target]} and with {reference}; give it one reference."
            )
        if states.setdefault(target, state) != state:
            raise InvalidValue(
                f"{target} shall be {states[target]} and {state} {reference}; a pair is in one state at a "
                "time, so give it one."
            )
        if target in placed:
            raise InvalidValue(
                f"{target} has a goal and a relation to {reference}; give the goal to what is to stand "
                "on the table."
            )
    for target in over:
        _check_chain(target, over)


def _check_chain(target: str, over: dict[str, str]) -> None:
    """Refuse relations that lead from an object back to it."""
    chain, here = [target], over.get(target)
    while here is not None and here not in chain:
        chain.append(here)
        here = over.get(here)
    if here == target:
        said = ", ".join(f"{one} with {over[one]}" for one in chain)
        raise InvalidValue(f"The relations {said} lead round in a circle; leave one of them out.")
