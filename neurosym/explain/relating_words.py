"""States and kinds of pairs, and what operates on them, in sentences for a person."""

from collections.abc import Sequence
from dataclasses import replace

from neurosym.explain.action_words import aimed_action_in_words
from neurosym.explain.explained import EffectRow, Explanation, SymbolExplanation
from neurosym.naming import names_of_features
from neurosym.operators import Category, Primitive
from neurosym.pair_states import DESCRIPTION
from neurosym.relation_operators import PairEnd, PairState, RelationOperator, RelationOperators
from neurosym.tasks.puts import left_out


def with_relations(
    told: Explanation, relations: RelationOperators, feature_names: Sequence[str], gripper: Sequence[bool]
) -> Explanation:
    """Say also what states of pairs look like, which pairs are of each kind, and what operates on them.

    Args:
        told: What is said of single objects and places.
        relations: What was learned of pairs.
        feature_names: What the object features are, as the world names them; empty if nobody knows.
        gripper: Which action parameters are gripper values, as the world says; empty if nobody knows.
    """
    states, kinds = relations.states, relations.pairs
    return replace(
        told,
        relating=tuple(_of_primitive(one, relations, gripper) for one in relations.primitives),
        states=tuple(SymbolExplanation(s.symbol, s.name, _about_state(s, relations)) for s in states),
        pairs=tuple(SymbolExplanation(k.symbol, k.name, _about_kind(k, feature_names)) for k in kinds),
    )


def summary_of_relations(relations: RelationOperators) -> str:
    """Say how many states, kinds and operators on pairs were learned."""
    bearing = [state.name for state in relations.states if state.bears]
    live = len(relations.operators) - len(left_out(relations))
    told = f"one object bears another in {', '.join(bearing)}" if bearing else "in none is anything borne"
    return (
        f"Pairs of objects are of {len(relations.pairs)} kinds and stand in {len(relations.states)} states; "
        f"{told}. Of {len(relations.operators)} operators on pairs, {live} are in the domain."
    )


def _of_primitive(
    primitive: Primitive, relations: RelationOperators, gripper: Sequence[bool]
) -> SymbolExplanation:
    operators = [one for one in relations.operators if one.label == primitive.label]
    reasons = left_out(relations)
    led_to = [relations.state_named(one.promise.state).name for one in operators if one.promise]
    title = f"brings pairs to {', '.join(dict.fromkeys(led_to)) or 'no state'}"
    about = aimed_action_in_words(primitive, gripper, "the other object")
    thirds = (line for one in operators for line in _with_a_third(one))
    rows = (_row(one, end, relations, reasons.get(one.name, "")) for one in operators for end in one.ends)
    return SymbolExplanation(primitive.label, title, " ".join((*about, *thirds)), tuple(rows))


def _about_state(state: PairState, relations: RelationOperators) -> str:
    numbers = ", ".join(f"{name} {value:.2f}" for name, value in zip(DESCRIPTION, state.centre, strict=False))
    borne = "The reference bears the target." if state.bears else "Nothing is borne."
    names = [one.name for one in relations.operators if one.promise and one.promise.state == state.symbol]
    led_to = f"Operators that lead to it: {', '.join(names)}." if names else "No operator leads to it."
    share = f"{state.share:.0%} of the pairs in fresh scenes are in it."
    return f"Typical of it: {numbers}. {borne} {share} {led_to}"


def _about_kind(kind: Category, feature_names: Sequence[str]) -> str:
    means = kind.feature_means
    if not means:
        return "No such pair was seen."
    half = len(means) // 2
    named = names_of_features(half, feature_names)
    told = [
        f"{who}: " + ", ".join(f"{name} {value:.3g}" for name, value in zip(named, part, strict=True))
        for who, part in (("target", means[:half]), ("reference", means[half:]))
    ]
    return f"{kind.share:.0%} of the pairs; on average {'; '.join(told)}."


def _with_a_third(operator: RelationOperator) -> list[str]:
    cases = (
        ("on the reference", operator.occupied),
        ("under the target", operator.borne),
        ("on the target", operator.laden),
    )
    return [
        f"{operator.name} with a third object {where}: {kept.kept} of {kept.trials} went so."
        for where, kept in cases
        if kept.trials
    ]


def _row(operator: RelationOperator, end: PairEnd, relations: RelationOperators, reason: str) -> EffectRow:
    promise = operator.promise
    x, y, z = end.offset
    return EffectRow(
        operator=operator.name,
        trials=operator.trials,
        promised=promise.count if promise else 0,
        share=end.share,
        ends=relations.state_named(end.state).name if end.state else "elsewhere",
        effect=f"({x:.2f}, {y:.2f}, {z:.2f}) touching units from the reference" if end.state else "",
        spread="± " + ", ".join(f"{value:.2f}" for value in end.spread) if end.state else "",
        domain=f"no: {reason}" if reason else "yes",
    )
