"""What the symbols of a domain mean, in sentences for a person: from the table of operators alone.

Action symbols: what the hand does, and what that does to each category. Object symbols: which objects they
hold. A table of operators is told in one way whatever its actions are aimed at; `_Words` says what differs.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidFile, InvalidValue, listed_briefly
from neurosym.grounding import FORMAT, Grounding
from neurosym.operators import (
    CARRIED,
    CONVERGED,
    TOLERANCE,
    Category,
    Mode,
    Operator,
    OperatorTable,
    Primitive,
    Symbol,
    names_of_features,
)
from neurosym.pair_operators import (
    DESCRIPTION,
    NEVER_CARRIES,
    Company,
    PairEnd,
    PairState,
    PlaceOperators,
    RelationOperator,
    RelationOperators,
)
from neurosym.pddl.compiler import CELL, with_every_outcome
from neurosym.report.symbol_words import (
    AXES,
    EffectRow,
    Explanation,
    SymbolExplanation,
    action_in_words,
    aimed_action_in_words,
    displacement_in_words,
    distance_in_words,
    objects_in_words,
    spread_in_words,
)
from neurosym.stages.compilation import operator_table
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import (
    GROUNDING,
    INTERACTIONS,
    PLACE_OPERATORS,
    PRIMITIVES,
    RELATION_OPERATORS,
    TABLE_FILES,
    WORLD,
)
from neurosym.world import OutcomeKind, World
from neurosym.worlds.world_file import read_world

_WhyLeftOut = Callable[[Operator], str | None]
"""Says why an operator is not in the PDDL domain; None if it is."""
_ENDS: dict[OutcomeKind, str] = {
    "resting": "at rest",
    "held": "held",
    "toppled": "on another face",
    "carried": "carried to the place",
    "missed": "not carried to the place",
    "lost": "off the table",
}


@dataclass(frozen=True)
class _Words:
    """What is said of a table of operators, by what its actions are aimed at.

    Attributes:
        title: Says what the operators of a symbol do to which share of objects.
        action: Says what the hand does.
        effect: Says where an object ends.
        more: Says what else is known of the operators of a symbol.
        domain: Says whether an operator is in the PDDL domain.
    """

    title: Callable[[OperatorTable, Sequence[Operator]], str]
    action: Callable[[Primitive, Sequence[bool]], tuple[str, ...]]
    effect: Callable[[Mode], str]
    more: Callable[[OperatorTable, Sequence[Operator]], Iterable[str]]
    domain: Callable[[Operator], str]

    def of(self, table: OperatorTable, gripper: Sequence[bool]) -> tuple[SymbolExplanation, ...]:
        """Say what each action symbol does."""
        told = []
        for symbol in table.symbols:
            operators = [one for one in table.operators if one.primitive == symbol]
            about = (*self._actions(table, symbol, operators, gripper), *self.more(table, operators))
            rows = tuple(self._row(one, mode) for one in operators for mode in one.modes)
            told.append(SymbolExplanation(symbol, self.title(table, operators), " ".join(about), rows))
        return tuple(told)

    def _actions(
        self, table: OperatorTable, symbol: Symbol, operators: Sequence[Operator], gripper: Sequence[bool]
    ) -> list[str]:
        """Say what the hand does, and for which categories if the symbol has several actions."""
        lines, names = [], _names(table)
        of_symbol = [primitive for primitive in table.primitives if primitive.symbol == symbol]
        performed = [one for one in of_symbol if any(one.label == operator.label for operator in operators)]
        for primitive in performed or of_symbol[:1]:
            if len(of_symbol) > 1:
                on = (names[operator.category] for operator in operators if operator.label == primitive.label)
                lines.append(f"{primitive.label} is for {', '.join(on) or 'no category'}.")
            lines += self.action(primitive, gripper)
            if not primitive.has_converged:
                error = f"its error is {primitive.code_error:.2g}, {CONVERGED} at most"
                lines.append(f"It hardly encodes to the symbol: {error}.")
        return lines

    def _row(self, operator: Operator, mode: Mode) -> EffectRow:
        return EffectRow(
            operator=operator.name,
            trials=operator.trials,
            promised=operator.successes,
            share=mode.share,
            ends=_ENDS[mode.kind],
            effect=self.effect(mode),
            spread=spread_in_words(mode.scatter) if mode.count > 1 else "seen once",
            domain=self.domain(operator),
        )


def explain(
    table: OperatorTable,
    *,
    feature_names: Sequence[str] = (),
    gripper: Sequence[bool] = (),
    why_left_out: _WhyLeftOut | None = None,
) -> Explanation:
    """Say what each symbol of a table means.

    Args:
        table: What each primitive does to each category.
        feature_names: What the object features are, as the world names them; empty if nobody knows.
        gripper: Which action parameters are gripper values, as the world says; empty if nobody knows.
        why_left_out: Says why an operator is not in the PDDL domain, if there is one.

    Raises:
        InvalidValue: If the table does not fit together.
    """
    _check_table(table)

    def domain(operator: Operator) -> str:
        reason = why_left_out(operator) if why_left_out else None
        return "" if why_left_out is None else f"no: {reason}" if reason else "yes"

    words = _Words(
        _verbs,
        lambda primitive, gripper: action_in_words(primitive.action, gripper),
        mode_in_words,
        lambda table, operators: (*_held(table, operators), *_never_tried(table, operators)),
        domain,
    )
    objects = tuple(
        SymbolExplanation(one.symbol, one.name, " ".join(objects_in_words(one, feature_names)))
        for one in table.categories
    )
    summary = (_counted(table), _measured(table), *_unused(table))
    return Explanation(summary, words.of(table, gripper), objects)


def explain_carrying(places: PlaceOperators, gripper: Sequence[bool] = ()) -> tuple[SymbolExplanation, ...]:
    """Say what each action symbol does that is aimed at a place.

    `gripper` says which action parameters are gripper values; it is empty if nobody knows.

    Raises:
        InvalidValue: If the table does not fit together.
    """
    _check_table(places.operators)
    words = _Words(
        _carried,
        aimed_action_in_words,
        lambda mode: mode_in_words(mode) if mode.kind == "carried" else "elsewhere",
        lambda _, operators: _among_others(places, operators),
        lambda operator: "yes" if operator.successes else f"no: {NEVER_CARRIES}",
    )
    return words.of(places.operators, gripper)


def summary_of(carrying: Sequence[SymbolExplanation]) -> str:
    """Say how many symbols carry something, of those that `explain_carrying` found."""
    able = sum(any(row.promised for row in one.effects) for one in carrying)
    return (
        f"Of {len(carrying)} symbols of actions aimed at a place, {able} carry objects there; as promised is "
        f"what stands within {distance_in_words(TOLERANCE, AXES)} of the promised spot beside the place."
    )


def mode_in_words(mode: Mode) -> str:
    """Say where an object ends: relative to where it stood, or to the place that it was to be carried to."""
    away = displacement_in_words(mode.outcome)
    if mode.kind == "carried":
        return "at the place" if away == "nowhere" else f"{away} of the place"
    if mode.kind != "resting" or mode.peak_height <= CARRIED or len(mode.outcome) != AXES:
        return away
    return f"{away}, carried {distance_in_words(mode.peak_height, AXES)} high on the way"


def _check_table(table: OperatorTable) -> None:
    """Raise `InvalidValue` unless the parts of a table fit together."""
    primitives, categories = table.symbols, tuple(_names(table))
    if not primitives or not categories:
        raise InvalidValue("it holds no primitives or no categories")
    for kind, symbols in (("primitive", primitives), ("category", categories)):
        widths = {len(symbol) for symbol in symbols}
        if len(widths) > 1 or not set("".join(symbols)) <= set("01"):
            raise InvalidValue(f"its {kind} symbols {', '.join(symbols)} are not codes of equally many bits")
    for category in table.categories:
        if len(category.feature_means) != len(category.feature_spreads):
            raise InvalidValue(f"its category {category.name} has not a spread for each mean")
    labels = {primitive.label for primitive in table.primitives}
    for operator in table.operators:
        if operator.label not in labels or operator.category not in categories:
            raise InvalidValue(f"its operator {operator.name} is of an unknown primitive or category")
    modes = [mode for operator in table.operators for mode in operator.modes]
    vectors = [v for m in modes for v in (m.effect, m.spread, m.resting_effect, m.resting_spread)]
    if len({len(vector) for vector in vectors}) > 1:
        raise InvalidValue("its effects have different numbers of axes")


def _counted(table: OperatorTable) -> str:
    order = ", forward, left and up" if _axes(table) == AXES else ""
    return (
        f"There are {len(table.symbols)} action symbols and {len(table.categories)} object symbols. ± is one "
        f"standard deviation{order}; an operator promises its most frequent end at rest or held."
    )


def _measured(table: OperatorTable) -> str:
    aside = ", and not what the distilled parameters do" if table.measured == "data" else ""
    tolerance = distance_in_words(TOLERANCE, _axes(table))
    means = f"Effects are means over {table.trials}{aside}"
    return f"{means}; as promised is what ended within {tolerance} of them."


def _unused(table: OperatorTable) -> tuple[str, ...]:
    """Name the action codes that were never reached and the object codes that no object has."""
    lines = []
    if table.unreached:
        listed = listed_briefly(table.unreached)
        lines.append(f"Action codes never reached, so that nothing was distilled: {listed}.")
    if unseen := [category.name for category in table.categories if not category.share]:
        lines.append(f"Object codes that no sampled object has: {', '.join(unseen)}.")
    return tuple(lines)


def _verbs(table: OperatorTable, operators: Sequence[Operator]) -> str:
    """Say what a primitive does to which share of the objects, in the words of the operators' names."""
    names = _names(table)
    weights = {category.symbol: category.share for category in table.categories}
    done_to: dict[str, set[Symbol]] = {}
    for operator in operators:
        verb = operator.name.removesuffix(f"-{operator.label}-{names[operator.category]}")
        done_to.setdefault(verb, set()).add(operator.category)
    shares = {verb: sum(weights[symbol] for symbol in sorted(symbols)) for verb, symbols in done_to.items()}
    ordered = sorted(shares.items(), key=lambda entry: (-entry[1], entry[0]))
    return ", ".join(f"{verb} ({share:.0%} of objects)" for verb, share in ordered) or "never tried"


def _carried(table: OperatorTable, operators: Sequence[Operator]) -> str:
    shares = {one.symbol: one.share for one in table.categories}
    carried = sum(shares[one.category] * one.successes / one.trials for one in operators if one.trials)
    return f"carries {carried:.0%} of objects to a place" if carried else "carries nothing"


def _held(table: OperatorTable, operators: Sequence[Operator]) -> tuple[str, ...]:
    trials = sum(operator.trials for operator in operators)
    held = sum(mode.count for operator in operators for mode in operator.modes if mode.kind == "held")
    said = f"The object hangs from the hand in {held or 'none'} of {trials} {table.trials}."
    return (said,) if trials else ()


def _never_tried(table: OperatorTable, operators: Sequence[Operator]) -> tuple[str, ...]:
    met = {operator.category for operator in operators}
    missing = [c.name for c in table.categories if c.share and c.symbol not in met]
    return (f"It was never tried on {', '.join(missing)}.",) if missing else ()


_AMONG: dict[Company, str] = {
    "beside": "others close beside it",
    "occupied": "another object on the place",
}
_WITH_A_THIRD: dict[Company, str] = {
    "occupied": "on the reference",
    "borne": "under the target",
    "laden": "on the target",
}


def _among_others(places: PlaceOperators, operators: Sequence[Operator]) -> list[str]:
    said = []
    for how, others in _AMONG.items():
        found = [one for operator in operators if (one := places.company(operator.name).get(how))]
        if trials := sum(one.trials for one in found):
            kept = sum(one.kept for one in found)
            said.append(f"With {others} it went as promised {kept} of {trials} times.")
    return said


def _names(table: OperatorTable) -> dict[Symbol, str]:
    return {category.symbol: category.name for category in table.categories}


def _axes(table: OperatorTable) -> int:
    return next((len(mode.effect) for operator in table.operators for mode in operator.modes), 0)


def _with_relations(
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


def _summary_of_relations(relations: RelationOperators) -> str:
    """Say how many states, kinds and operators on pairs were learned."""
    bearing = [state.name for state in relations.states if state.bears]
    live = len(relations.operators) - len(relations.left_out)
    told = f"one object bears another in {', '.join(bearing)}" if bearing else "in none is anything borne"
    return (
        f"Pairs of objects are of {len(relations.pairs)} kinds and stand in {len(relations.states)} states; "
        f"{told}. Of {len(relations.operators)} operators on pairs, {live} are in the domain."
    )


def _of_primitive(
    primitive: Primitive, relations: RelationOperators, gripper: Sequence[bool]
) -> SymbolExplanation:
    operators = [one for one in relations.operators if one.label == primitive.label]
    reasons = relations.left_out
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
    return [
        f"{operator.name} with a third object {where}: {kept.kept} of {kept.trials} went so."
        for how, where in _WITH_A_THIRD.items()
        if (kept := operator.company[how]).trials
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


_NO_WORLD = f"There is no {WORLD} here to say what the parameters of actions are: they are plain numbers."
_ASSUMED = f"What is in the domain is said for cells of 5 mm; there is no {GROUNDING} yet."
_OTHER_TABLE = f"{GROUNDING} was compiled from another {PRIMITIVES}; compile-domain makes it fit."


def explain_folder(domain: DomainFolder) -> Explanation:
    """Explain the symbols of a domain folder, from whatever of it is there beside the table of operators.

    Raises:
        StageMissing: If there is no `primitives.json`.
        InvalidFile: If a file cannot be used.
    """
    path, table = domain.require(PRIMITIVES), operator_table(domain)
    world = read_world(domain / WORLD)() if (domain / WORLD).exists() else None
    gripper = world.action_box.gripper.tolist() if world else ()
    names = world.feature_names if world else _names_in_data(domain)
    grounding, remark = _grounding(domain, table, world)
    left_out = grounding.why_left_out if grounding else None
    with _fitting(path):
        told = explain(table, feature_names=names, gripper=gripper, why_left_out=left_out)
    remarks = []
    if (path := domain / PLACE_OPERATORS).is_file():
        with _fitting(path):
            told = replace(told, carrying=explain_carrying(PlaceOperators.load(path), gripper))
        remarks.append(summary_of(told.carrying))
    if (path := domain / RELATION_OPERATORS).is_file():
        relations = RelationOperators.load(path)
        told = _with_relations(told, relations, names, gripper)
        remarks.append(_summary_of_relations(relations))
    remarks += [_NO_WORLD] * (world is None) + [remark] * bool(remark)
    remarks += [f"{line}." for line in domain.outdated(TABLE_FILES)]
    return replace(told, summary=(*told.summary, *remarks))


@contextmanager
def _fitting(path: Path) -> Iterator[None]:
    """Name the file whose table does not fit together."""
    try:
        yield
    except InvalidValue as error:
        raise InvalidFile(path, str(error)) from error


def _names_in_data(domain: DomainFolder) -> tuple[str, ...]:
    """Return the names that data of a user's own give to features."""
    path = domain / INTERACTIONS
    return tuple(Interactions.load(path).origin.get("feature_names", ())) if path.is_file() else ()


def _grounding(
    domain: DomainFolder, table: OperatorTable, world: World | None
) -> tuple[Grounding | None, str]:
    """Return what knows which operators are in the domain, and a remark on how it knows."""
    if (domain / GROUNDING).exists():
        grounding = Grounding.load(domain / GROUNDING)
        fits = grounding.operators in (table, with_every_outcome(table))
        return (grounding, "") if fits else (None, _OTHER_TABLE)
    axes = {len(mode.effect) for operator in table.operators for mode in operator.modes}
    if world is None or axes != {3}:
        return None, ""
    return Grounding(FORMAT, world.name, CELL, world.table, world.lift_height, table), _ASSUMED
