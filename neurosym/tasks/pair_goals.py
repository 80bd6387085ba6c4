"""Whether the goals by relation of a problem can be, by what was learned of its pairs."""

from collections.abc import Sequence

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.problems import Problem, RelationGoal
from neurosym.tasks.task import understand, unmet_relations


def relations_meant(goals: Sequence[RelationGoal], grounding: Grounding) -> tuple[RelationGoal, ...]:
    """Return goals by relation with the names of the states that are meant by name, symbol or a beginning.

    Raises:
        InvalidValue: If the domain knows nothing of relations, or several states may be meant.
        UnknownChoice: If no state is meant.
    """
    if not goals:
        return ()
    if grounding.relations is None:
        raise InvalidValue(
            "This domain has learned no relations; valid here: goals on the table, as item-01=0.60,0.10."
        )
    meant = grounding.relations.state_meant
    return tuple(dict.fromkeys((target, reference, meant(word).name) for target, reference, word in goals))


def check_relations(problem: Problem, grounding: Grounding) -> None:
    """Raise unless something leads to each goal by relation, or it is met already.

    Raises:
        InvalidValue: If nothing does, a kind of pairs is no code of this domain, or the domain knows nothing
            of relations.
        UnknownChoice: If there is no such state.
    """
    if grounding.relations and grounding.relations.pairs:
        one = grounding.relations.pairs[0].symbol
        for pair, code in sorted(problem.pairs.items()):
            if len(code) != len(one):
                said = f"pairs has the code {code!r} for {pair!r}"
                raise InvalidValue(f"{said}; valid: {len(one)} bits, like {one!r}, or no entry.")
    if problem.related and (reason := why_no_relation(problem, grounding)):
        raise InvalidValue(f"{reason}.")


def why_no_relation(problem: Problem, grounding: Grounding) -> str:
    """Say which goal by relation nothing leads to, and what would be valid; nothing if there is none.

    Raises:
        InvalidValue: If the domain knows nothing of relations.
        UnknownChoice: If there is no such state.
    """
    task = understand(problem, grounding)
    bearing = ", ".join(state.name for state in grounding.bearing_states) or "none was learned"
    for target, reference, name in problem.related:
        state = task.state_named(name)
        if not state.bears:
            return (
                f"{target} cannot be brought to {state.name} with {reference}, in which nothing is borne; "
                f"valid states: {bearing}"
            )
    for target, reference, name in unmet_relations(problem, grounding):
        state = task.state_named(name)
        if not any(put.state == state for put in task.puts[target, reference]):
            valid = valid_relations(problem, grounding, target)
            return f"no operator brings {target} to {state.name} with {reference}; {valid}"
    return why_too_many(problem, grounding)


def valid_relations(problem: Problem, grounding: Grounding, target: str) -> str:
    """Say what can be done with an object relative to others."""
    puts = understand(problem, grounding).puts
    others = [other for other in problem.object_names if other != target]
    ways = dict.fromkeys(f"{put.state.name} {other}" for other in others for put in puts[target, other])
    known = ", ".join(ways)
    return f"valid for {target}: {known}" if known else f"nothing puts {target} on or into any other object"


def why_too_many(problem: Problem, grounding: Grounding) -> str:
    """Say which object should bear several and cannot, or nothing."""
    puts, wanted = understand(problem, grounding).puts, dict[str, list[str]]()
    for target, reference, _ in problem.related:
        wanted.setdefault(reference, []).append(target)
    for reference, targets in wanted.items():
        every = (put for target in targets for put in puts[target, reference])
        if len(targets) > 1 and not any(put.operator.takes("occupied") for put in every):
            return (
                f"{reference} shall bear {' and '.join(targets)}, and rehearsals show that it bears one "
                "object at a time; leave one of the two out"
            )
    return ""
