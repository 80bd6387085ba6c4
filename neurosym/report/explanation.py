"""What the symbols of a domain mean, in sentences for a person: from the tables of operators alone.

Action symbols: what the hand does, and what that does to each category. Object symbols: which objects they
hold. The same of actions that are aimed at places and at other objects, and of pairs of objects.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidFile, listed_briefly
from neurosym.formats import PairFile, PlaceFile
from neurosym.grounding import Grounding
from neurosym.operators import (
    CONVERGED,
    TOLERANCE,
    Category,
    Company,
    Mode,
    Operator,
    OperatorTable,
    Primitive,
    Symbol,
    names_of_features,
)
from neurosym.pair_operators import DESCRIPTION, NEVER_CARRIES, PairState, RelationOperators
from neurosym.pddl.compiler import with_every_outcome
from neurosym.report import symbols
from neurosym.report.symbols import AXES, EffectRow, Explanation, SymbolExplanation
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder
from neurosym.worlds.world_file import has_world, read_world


def explain(
    table: OperatorTable,
    *,
    feature_names: Sequence[str] = (),
    gripper: Sequence[bool] = (),
    why_left_out: Callable[[Operator], str | None] | None = None,
) -> Explanation:
    """Say what each symbol of a table means.

    Args:
        table: What each primitive does to each category.
        feature_names: What the object features are, as the world names them; empty if nobody knows.
        gripper: Which action parameters are gripper values, as the world says; empty if nobody knows.
        why_left_out: Says why an operator is not in the PDDL domain, if there is one; None if it is.
    """

    def domain(operator: Operator) -> str:
        reason = why_left_out(operator) if why_left_out else None
        return "" if why_left_out is None else f"no: {reason}" if reason else "yes"

    def told(operators: Sequence[Operator]) -> Iterator[str]:
        if trials := sum(operator.trials for operator in operators):
            held = sum(mode.count for one in operators for mode in one.outcomes if mode.kind == "held")
            yield f"The object hangs from the hand in {held or 'none'} of {trials} {table.trials}."
        met = {operator.subject for operator in operators}
        if missing := [one.name for one in table.categories if one.share and one.symbol not in met]:
            yield f"It was never tried on {', '.join(missing)}."

    actions = _symbols_of(
        table,
        action=lambda primitive: symbols.action_in_words(primitive.action, gripper),
        title=lambda operators: _verbs(table, operators),
        more=told,
        row=lambda operator, mode: symbols.effect_row(operator, mode, domain(operator)),
    )
    objects = tuple(
        SymbolExplanation(one.symbol, one.name, " ".join(symbols.objects_in_words(one, feature_names)))
        for one in table.categories
    )
    return Explanation(tuple(_summary(table)), actions, objects)


def explain_carrying(places: OperatorTable, gripper: Sequence[bool] = ()) -> tuple[SymbolExplanation, ...]:
    """Say what each action symbol does that is aimed at a place.

    `gripper` says which action parameters are gripper values; it is empty if nobody knows.
    """
    shares = {one.symbol: one.share for one in places.categories}

    def title(operators: Sequence[Operator]) -> str:
        share = sum(shares[one.subject] * one.successes / one.trials for one in operators if one.trials)
        return f"carries {share:.0%} of objects to a place" if share else "carries nothing"

    def among_others(operators: Sequence[Operator]) -> Iterator[str]:
        for how, others in _AMONG.items():
            found = [one.among(how) for one in operators]
            if trials := sum(one.trials for one in found):
                kept = sum(one.kept for one in found)
                yield f"With {others} it went as promised {kept} of {trials} times."

    def row(operator: Operator, mode: Mode) -> EffectRow:
        domain = "yes" if operator.successes else f"no: {NEVER_CARRIES}"
        return symbols.effect_row(operator, mode, domain, is_aimed=True)

    return _symbols_of(
        places,
        action=lambda primitive: symbols.aimed_action_in_words(primitive, gripper),
        title=title,
        more=among_others,
        row=row,
    )


def _symbols_of(
    table: OperatorTable,
    *,
    action: Callable[[Primitive], tuple[str, ...]],
    title: Callable[[Sequence[Operator]], str],
    more: Callable[[Sequence[Operator]], Iterable[str]],
    row: Callable[[Operator, Mode], EffectRow],
) -> tuple[SymbolExplanation, ...]:
    """Say what each action symbol of a table does: with what differs by what its actions are aimed at."""
    names, found = {one.symbol: one.name for one in table.categories}, []
    for symbol in table.symbols:
        operators = [one for one in table.operators if one.primitive == symbol]
        of_symbol = [one for one in table.primitives if one.symbol == symbol]
        labels, about = {one.label for one in operators}, list[str]()
        for primitive in [one for one in of_symbol if one.label in labels] or of_symbol[:1]:
            if len(of_symbol) > 1:
                on = ", ".join(names[one.subject] for one in operators if one.label == primitive.label)
                about.append(f"{primitive.label} is for {on or 'no category'}.")
            about += action(primitive)
            if not primitive.has_converged:
                error = f"its error is {primitive.code_error:.2g}, {CONVERGED} at most"
                about.append(f"It hardly encodes to the symbol: {error}.")
        about += more(operators)
        rows = tuple(row(one, mode) for one in operators for mode in one.outcomes)
        found.append(SymbolExplanation(symbol, title(operators), " ".join(about), rows))
    return tuple(found)


def _check_table(path: Path, table: OperatorTable) -> None:
    """Raise `InvalidFile` unless the parts of a table fit together."""
    for category in table.categories:
        if len(category.feature_means) != len(category.feature_spreads):
            raise InvalidFile(path, f"its category {category.name} has not a spread for each mean")
    labels = {primitive.label for primitive in table.primitives}
    categories = {category.symbol for category in table.categories}
    for operator in table.operators:
        if operator.label not in labels or operator.subject not in categories:
            raise InvalidFile(path, f"its operator {operator.name} is of an unknown primitive or category")


def _summary(table: OperatorTable) -> Iterator[str]:
    """Say how many symbols there are, how they were measured, and which codes are of nothing."""
    order = ", forward, left and up" if table.axes == AXES else ""
    yield (
        f"There are {len(table.symbols)} action symbols and {len(table.categories)} object symbols. ± is one "
        f"standard deviation{order}; an operator promises its most frequent end at rest or held."
    )
    aside = ", and not what the distilled parameters do" if table.measured == "data" else ""
    within = symbols.distance_in_words(TOLERANCE, table.axes)
    yield f"Effects are means over {table.trials}{aside}; as promised is what ended within {within} of them."
    if table.unreached:
        listed = listed_briefly(table.unreached)
        yield f"Action codes never reached, so that nothing was distilled: {listed}."
    if unseen := [category.name for category in table.categories if not category.share]:
        yield f"Object codes that no sampled object has: {', '.join(unseen)}."


def _verbs(table: OperatorTable, operators: Sequence[Operator]) -> str:
    """Say what a primitive does to which share of the objects, in the words of the operators' names."""
    categories = {category.symbol: category for category in table.categories}
    done_to: dict[str, set[Symbol]] = {}
    for operator in operators:
        verb = operator.name.removesuffix(f"-{operator.label}-{categories[operator.subject].name}")
        done_to.setdefault(verb, set()).add(operator.subject)
    shares = {verb: sum(categories[one].share for one in sorted(met)) for verb, met in done_to.items()}
    ordered = sorted(shares.items(), key=lambda entry: (-entry[1], entry[0]))
    return ", ".join(f"{verb} ({share:.0%} of objects)" for verb, share in ordered) or "never tried"


_AMONG: dict[Company, str] = {
    "beside": "others close beside it",
    "occupied": "another object on the place",
}
_WITH_A_THIRD: dict[Company, str] = {
    "occupied": "on the reference",
    "borne": "under the target",
    "laden": "on the target",
}


def _summary_of_relations(relations: RelationOperators) -> str:
    """Say how many states, kinds and operators on pairs were learned."""
    bearing = [state.name for state in relations.states if state.bears]
    live = len(relations.operators) - len(relations.left_out)
    told = f"one object bears another in {', '.join(bearing)}" if bearing else "in none is anything borne"
    return (
        f"Pairs of objects are of {len(relations.pairs)} kinds and stand in {len(relations.states)} states; "
        f"{told}. Of {len(relations.operators)} operators on pairs, {live} are in the domain."
    )


def _relating(
    primitive: Primitive, relations: RelationOperators, gripper: Sequence[bool]
) -> SymbolExplanation:
    """Say what an action does that is aimed at another object."""
    operators = [one for one in relations.operators if one.label == primitive.label]
    led_to = [relations.state_named(one.promise.kind).name for one in operators if one.promise]
    about = [*symbols.aimed_action_in_words(primitive, gripper, "the other object")]
    about += [
        f"{one.name} with a third object {where}: {kept.kept} of {kept.trials} went so."
        for one in operators
        for how, where in _WITH_A_THIRD.items()
        if (kept := one.among(how)).trials
    ]
    title = f"brings pairs to {', '.join(dict.fromkeys(led_to)) or 'no state'}"
    rows = (_pair_row(one, end, relations) for one in operators for end in one.outcomes)
    return SymbolExplanation(primitive.label, title, " ".join(about), tuple(rows))


def _pair_row(operator: Operator, end: Mode, relations: RelationOperators) -> EffectRow:
    reason, (x, y, z) = relations.left_out.get(operator.name), end.effect
    return EffectRow(
        operator=operator.name,
        trials=operator.trials,
        promised=operator.successes,
        share=end.share,
        ends=relations.state_named(end.kind).name if end.is_promising else "elsewhere",
        effect=f"({x:.2f}, {y:.2f}, {z:.2f}) touching units from the reference" if end.is_promising else "",
        spread="± " + ", ".join(f"{value:.2f}" for value in end.spread) if end.is_promising else "",
        domain=f"no: {reason}" if reason else "yes",
    )


def _about_state(state: PairState, relations: RelationOperators) -> str:
    numbers = ", ".join(f"{name} {value:.2f}" for name, value in zip(DESCRIPTION, state.centre, strict=False))
    borne = "The reference bears the target." if state.bears else "Nothing is borne."
    names = [one.name for one in relations.operators if one.promise and one.promise.kind == state.symbol]
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


def explain_folder(domain: DomainFolder) -> Explanation:
    """Explain the symbols of a domain folder, from whatever of it is there beside the table of operators.

    Raises:
        StageMissing: If there is no `primitives.json`.
        InvalidFile: If a file cannot be used.
    """
    path, remarks = domain.require(layout.PRIMITIVES), list[str]()
    table = OperatorTable.load(path)
    world = read_world(domain / layout.WORLD)() if has_world(domain / layout.WORLD) else None
    gripper = world.action_box.gripper.tolist() if world else ()
    names = world.feature_names if world else ()
    if world is None and (data := domain / layout.INTERACTIONS).is_file():
        names = tuple(Interactions.load(data).origin.get("feature_names", ()))  # of data of a user's own
    grounding = Grounding.load(file) if (file := domain / layout.GROUNDING).exists() else None
    is_other = grounding and grounding.objects not in (table, with_every_outcome(table))
    left_out = grounding.why_left_out if grounding and not is_other else None
    _check_table(path, table)
    told = explain(table, feature_names=names, gripper=gripper, why_left_out=left_out)
    if (path := domain / layout.PLACE_OPERATORS).is_file():
        places = PlaceFile.load(path).table()
        _check_table(path, places)
        told = replace(told, carrying=explain_carrying(places, gripper))
        able = sum(any(row.promised for row in one.effects) for one in told.carrying)
        remarks.append(
            f"Of {len(told.carrying)} symbols of actions aimed at a place, {able} carry objects there; as "
            f"promised is what stands within {1000 * TOLERANCE:.0f} mm of the promised spot beside the place."
        )
    if (path := domain / layout.RELATION_OPERATORS).is_file():
        found = PairFile.load(path).table()
        told = replace(
            told,
            relating=tuple(_relating(one, found, gripper) for one in found.primitives),
            states=tuple(SymbolExplanation(s.symbol, s.name, _about_state(s, found)) for s in found.states),
            pairs=tuple(SymbolExplanation(k.symbol, k.name, _about_kind(k, names)) for k in found.pairs),
        )
        remarks.append(_summary_of_relations(found))
    remarks += [_NO_WORLD] * (world is None) + [_OTHER_TABLE] * bool(is_other)
    remarks += [f"{line}." for line in domain.outdated((layout.PRIMITIVES,))]
    return replace(told, summary=(*told.summary, *remarks))


_NO_WORLD = (
    f"There is no {layout.WORLD} here to say what the parameters of actions are: they are plain numbers."
)
_OTHER_TABLE = (
    f"{layout.GROUNDING} was compiled from another {layout.PRIMITIVES}; compile-domain makes it fit."
)
