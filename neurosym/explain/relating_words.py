"""States and kinds of pairs, and what operates on them, in sentences for a person."""

from collections.abc import Sequence

from neurosym.explain.carrying_words import aimed_action_in_words
from neurosym.explain.explained import EffectRow, SymbolExplanation
from neurosym.naming import names_of_features
from neurosym.operators import Category
from neurosym.pair_states import DESCRIPTION
from neurosym.place_operators import Kept
from neurosym.relation_operators import PairEnd, PairState, RelationOperator, RelationOperators
from neurosym.tasks.puts import left_out

_CARRIED_ELSEWHERE = "elsewhere"


def explain_states(relations: RelationOperators) -> tuple[SymbolExplanation, ...]:
    """Say what each state of pairs looks like, and which operators lead to it.

    Args:
        relations: What was learned of pairs.
    """
    return tuple(
        SymbolExplanation(state.symbol, state.name, _about_state(state), _led_to(state, relations))
        for state in relations.states
    )


def explain_pairs(
    relations: RelationOperators, feature_names: Sequence[str] = ()
) -> tuple[SymbolExplanation, ...]:
    """Say which pairs are of each kind.

    Args:
        relations: What was learned of pairs.
        feature_names: What the object features are, as the world names them; empty if nobody knows.
    """
    return tuple(
        SymbolExplanation(kind.symbol, kind.name, _about_kind(kind, feature_names), "")
        for kind in relations.pairs
    )


def explain_relating(
    relations: RelationOperators, gripper: Sequence[bool] = ()
) -> tuple[SymbolExplanation, ...]:
    """Say what each action symbol does that is aimed at another object.

    Args:
        relations: What was learned of pairs.
        gripper: Which action parameters are gripper values, as the world says; empty if nobody knows.
    """
    reasons = left_out(relations)
    return tuple(
        SymbolExplanation(
            primitive.label,
            _title(primitive.label, relations),
            " ".join(aimed_action_in_words(primitive, gripper, "the other object")),
            " ".join(line for one in _of(primitive.label, relations) for line in _with_a_third(one)),
            tuple(
                _row(one, end, relations, reasons.get(one.name, ""))
                for one in _of(primitive.label, relations)
                for end in one.ends
            ),
        )
        for primitive in relations.primitives
    )


def summary_of_relations(relations: RelationOperators) -> str:
    """Say how many states, kinds and operators there are.

    Args:
        relations: What was learned of pairs.
    """
    bearing = [state.name for state in relations.states if state.bears]
    live = len(relations.operators) - len(left_out(relations))
    told = f"one object bears another in {', '.join(bearing)}" if bearing else "in none is anything borne"
    return (
        f"Pairs of objects are of {len(relations.pairs)} kinds and stand in {len(relations.states)} states; "
        f"{told}. Of {len(relations.operators)} operators on pairs, {live} are in the domain."
    )


def _of(label: str, relations: RelationOperators) -> tuple[RelationOperator, ...]:
    return tuple(one for one in relations.operators if one.label == label)


def _title(label: str, relations: RelationOperators) -> str:
    found = [relations.state_named(one.promise.state).name for one in _of(label, relations) if one.promise]
    return f"brings pairs to {', '.join(dict.fromkeys(found))}" if found else "brings pairs to no state"


def _about_state(state: PairState) -> str:
    numbers = ", ".join(f"{name} {value:.2f}" for name, value in zip(DESCRIPTION, state.centre, strict=False))
    borne = "The reference bears the target." if state.bears else "Nothing is borne."
    return f"Typical of it: {numbers}. {borne} {state.share:.0%} of the pairs in fresh scenes are in it."


def _led_to(state: PairState, relations: RelationOperators) -> str:
    names = [one.name for one in relations.operators if one.promise and one.promise.state == state.symbol]
    return f"Operators that lead to it: {', '.join(names)}." if names else "No operator leads to it."


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
    return [_said(operator.name, where, kept) for where, kept in cases if kept.trials]


def _said(name: str, where: str, kept: Kept) -> str:
    return f"{name} with a third object {where}: {kept.kept} of {kept.trials} went so."


def _row(operator: RelationOperator, end: PairEnd, relations: RelationOperators, reason: str) -> EffectRow:
    promise = operator.promise
    x, y, z = end.offset
    return EffectRow(
        operator=operator.name,
        trials=operator.trials,
        promised=promise.count if promise else 0,
        share=end.share,
        ends=relations.state_named(end.state).name if end.state else _CARRIED_ELSEWHERE,
        effect=f"({x:.2f}, {y:.2f}, {z:.2f}) touching units from the reference" if end.state else "",
        spread="± " + ", ".join(f"{value:.2f}" for value in end.spread) if end.state else "",
        domain=f"no: {reason}" if reason else "yes",
    )
