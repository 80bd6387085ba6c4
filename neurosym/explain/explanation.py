"""What the symbols of a domain mean, in sentences for a person: from the table of operators alone.

Action symbols: what the hand does, what that does to each category, which other symbol does the most similar
thing. Object symbols: which objects they hold, and to which other category the most similar things are done.
"""

from collections.abc import Callable, Sequence

from neurosym.errors import InvalidValue
from neurosym.explain.action_words import (
    AXES,
    action_in_words,
    displacement_in_words,
    distance_in_words,
    spread_in_words,
)
from neurosym.explain.comparison_words import (
    ENDS,
    category_in_words,
    competitor_in_words,
    sorting_in_words,
    verdict_in_words,
)
from neurosym.explain.explained import EffectRow, Explanation, SymbolExplanation
from neurosym.explain.likeness import Likenesses, Sorting
from neurosym.explain.object_words import objects_in_words
from neurosym.naming import CARRIED
from neurosym.operators import CONVERGED, TOLERANCE, Category, Mode, Operator, OperatorTable, Primitive
from neurosym.symbols import Symbol
from neurosym.wording import listed_briefly

WhyLeftOut = Callable[[Operator], str | None]
"""Says why an operator is not in the PDDL domain; None if it is."""


def explain(
    table: OperatorTable,
    *,
    feature_names: Sequence[str] = (),
    gripper: Sequence[bool] = (),
    why_left_out: WhyLeftOut | None = None,
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
    check_table(table)
    likenesses = Likenesses(table)
    sorting = likenesses.sort_out()
    sorted_out = sorting_in_words(sorting, len(table.symbols), _axes(table))
    summary = (*sorted_out, _measured(table), *_unused(table))
    actions = [
        _explain_action(table, symbol, likenesses, sorting, gripper, why_left_out) for symbol in table.symbols
    ]
    objects = [_explain_category(table, c, likenesses, feature_names) for c in table.categories]
    return Explanation(summary, tuple(actions), tuple(objects))


def check_table(table: OperatorTable) -> None:
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


def _explain_action(
    table: OperatorTable,
    symbol: Symbol,
    likenesses: Likenesses,
    sorting: Sorting,
    gripper: Sequence[bool],
    why_left_out: WhyLeftOut | None,
) -> SymbolExplanation:
    operators = [operator for operator in table.operators if operator.primitive == symbol]
    about = [
        *_actions_in_words(table, symbol, operators, gripper),
        *_held_in_words(operators, table.trials),
        *_never_tried(table, operators),
    ]
    nearest = likenesses.nearest_action(symbol)
    compared = [
        *verdict_in_words(symbol, sorting, _axes(table)),
        competitor_in_words(symbol, nearest, _names(table), _axes(table)),
    ]
    rows = [_row(operator, mode, why_left_out) for operator in operators for mode in operator.modes]
    title = _verbs(table, operators)
    return SymbolExplanation(symbol, title, " ".join(about), " ".join(compared), tuple(rows))


def _explain_category(
    table: OperatorTable, category: Category, likenesses: Likenesses, feature_names: Sequence[str]
) -> SymbolExplanation:
    nearest = likenesses.nearest_category(category.symbol)
    compared = category_in_words(nearest, _names(table), _axes(table)) if nearest else ""
    about = " ".join(objects_in_words(category, feature_names))
    return SymbolExplanation(category.symbol, category.name, about, compared)


def _row(operator: Operator, mode: Mode, why_left_out: WhyLeftOut | None) -> EffectRow:
    reason = why_left_out(operator) if why_left_out else None
    return EffectRow(
        operator=operator.name,
        trials=operator.trials,
        promised=operator.successes,
        share=mode.share,
        ends=ENDS[mode.kind],
        effect=displacement_in_words(mode.outcome) + _carried(mode),
        spread=spread_in_words(mode.scatter) if mode.count > 1 else "seen once",
        domain="" if why_left_out is None else f"no: {reason}" if reason else "yes",
    )


def _carried(mode: Mode) -> str:
    """Say how high an object was carried that rests again."""
    if mode.kind != "resting" or mode.peak_height <= CARRIED or len(mode.outcome) != AXES:
        return ""
    return f", carried {distance_in_words(mode.peak_height, AXES)} high on the way"


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


def _actions_in_words(
    table: OperatorTable, symbol: Symbol, operators: Sequence[Operator], gripper: Sequence[bool]
) -> tuple[str, ...]:
    """Say what the hand does, and for which categories if the symbol has several actions."""
    lines: list[str] = []
    of_symbol = [primitive for primitive in table.primitives if primitive.symbol == symbol]
    performed = [one for one in of_symbol if any(one.label == operator.label for operator in operators)]
    names = _names(table)
    for primitive in performed or of_symbol[:1]:
        if len(of_symbol) > 1:
            on = (names[operator.category] for operator in operators if operator.label == primitive.label)
            lines.append(f"{primitive.label} is for {', '.join(on) or 'no category'}.")
        lines += [*action_in_words(primitive.action, gripper), *_error_in_words(primitive)]
    return tuple(lines)


def _error_in_words(primitive: Primitive) -> tuple[str, ...]:
    if primitive.has_converged:
        return ()
    return (
        f"It hardly encodes to the symbol: its error is {primitive.code_error:.2g}, {CONVERGED} at most.",
    )


def _held_in_words(operators: Sequence[Operator], what: str) -> tuple[str, ...]:
    trials = sum(operator.trials for operator in operators)
    held = sum(mode.count for operator in operators for mode in operator.modes if mode.kind == "held")
    return (f"The object hangs from the hand in {held or 'none'} of {trials} {what}.",) if trials else ()


def _never_tried(table: OperatorTable, operators: Sequence[Operator]) -> tuple[str, ...]:
    met = {operator.category for operator in operators}
    missing = [c.name for c in table.categories if c.share and c.symbol not in met]
    return (f"It was never tried on {', '.join(missing)}.",) if missing else ()


def _names(table: OperatorTable) -> dict[Symbol, str]:
    return {category.symbol: category.name for category in table.categories}


def _axes(table: OperatorTable) -> int:
    return next((len(mode.effect) for operator in table.operators for mode in operator.modes), 0)
