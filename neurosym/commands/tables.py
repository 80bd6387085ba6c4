"""What was learned and done, as tables and sentences: models, operators, data, runs, explanations."""

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

import numpy as np

from neurosym.data.category_names import traits_of
from neurosym.data.interactions import Interactions
from neurosym.data.origin import FLAGS
from neurosym.errors import counted, harmless, listed_briefly
from neurosym.execution.record import Run
from neurosym.files import read_json
from neurosym.learning.training_report import TrainingReport, empty_codes, error_table
from neurosym.operators import CONVERGED, NO_EFFECT, Effect, OperatorTable, name_axes, names_of_features
from neurosym.pair_operators import OF_PAIRS, RelationOperators
from neurosym.report.symbols import EffectRow, Explanation, SymbolExplanation
from neurosym.stages.console import NARROW, folded, print_raw, say, show_table, width
from neurosym.stages.folder import DomainFolder
from neurosym.stages.value_stages import domain_of
from neurosym.stages.verdicts import Verdict, judge_training, judge_values
from neurosym.tasks.lying import SIDES
from neurosym.tasks.transition import PlanStep, primitives
from neurosym.values.domain import ValueDomain
from neurosym.values.value_execution import ValueRun


def show_training(path: Path, found: Interactions) -> None:
    """Print how well a model fits interactions it was not trained on, beside trivial predictors.

    Raises:
        InvalidFile: If the report cannot be read.
    """
    report = read_json(path, TrainingReport)
    errors = error_table(report, [axis["name"] for axis in found.origin.get("axes", ())])
    show_table(f"mean absolute error, {report.held_out} held-out interactions", *errors)
    is_none = report.share is None or report.r2_through_codes <= 0
    said = "no better than the mean effect, so there is nothing to share"
    say(
        f"R2 through the bits {report.r2_through_codes:.2f}, of a network without a bottleneck "
        f"{report.r2_direct:.2f}: {said if is_none else f'a share of {report.share:.2f}'}"
    )
    used = f"{len(report.action_symbols)} for actions, {len(report.object_symbols)} for objects"
    say(f"symbols used in the held-out interactions: {used}")
    if empty := empty_codes(report):
        say(empty)
    show_verdict(judge_training(report, found))


def show_verdict(verdict: Verdict) -> None:
    """Print whether something is good, weak or useless, and if it is not good, what may help."""
    for line in verdict.lines:
        say(line)


def show_operators(table: OperatorTable) -> None:
    """Print what each primitive does to each category."""
    is_rehearsed, unit = table.measured == "rehearsal", " [mm]" if table.axes == 3 else ""
    columns = ["operator", "rehearsals" if is_rehearsed else "rows", "as promised", "ends"]
    rows = []
    for operator in table.operators:
        row, promise = [operator.name, str(operator.trials)], operator.promise
        if promise:
            row += [str(operator.successes), f"{promise.kind} {promise.share:.0%}"]
            row += [_told(effect, in_mm=bool(unit)) for effect in (promise.outcome, promise.scatter)]
        else:
            row += ["0", "never at rest or held", "", ""]
        rows.append(row)
    title = "operators" if is_rehearsed else "operators, averaged from the data"
    show_table(title, [*columns, f"effect{unit}", f"spread{unit}"], rows)
    if table.unreached and table.categories:
        say(f"no action was found that encodes to {listed_briefly(table.unreached)}")
    for primitive in table.primitives:
        if not primitive.has_converged:
            say(
                f"{primitive.label} is done by an action that hardly encodes to it: "
                f"its mean squared error is {primitive.code_error:.2g}, and {CONVERGED} is the limit"
            )


def show_righting(table: OperatorTable) -> None:
    """Print what sets things upright that lie on a side, and for which sides nothing does."""
    if table.operators:
        show_operators(table)
    found = {one.subject for one in table.operators}
    if tops := [top for side, top in SIDES.items() if side not in found]:
        say(f"nothing was found that sets upright what lies with its top {' or '.join(tops)}")


def show_values(folder: DomainFolder) -> None:
    """Print the axes of a domain of values, what each operator does along them, and how good that is."""
    domain = domain_of(folder)
    axes = [
        [axis.name, axis.kind, str(cells), f"{axis.tolerance:.3g}" if axis.tolerance else "-"]
        for axis, cells in zip(domain.axes, domain.cells, strict=True)
    ]
    show_table("axes; world.toml says otherwise", ["axis", "kind", "cells", "as promised within"], axes)
    rows = [
        [one.name, f"{one.outcome.count} of {one.trials}", domain.in_words(one)] for one in domain.operators
    ]
    show_table("operators, told from the data", ["operator", "as promised", "does"], rows)
    show_verdict(judge_values(domain))


def show_kinds(domain: ValueDomain) -> None:
    """Print the categories of a domain of values, and what sets each apart."""
    traits = traits_of(domain.categories, domain.features)
    rows = [
        [one.name, f"{one.share:.0%}", ", ".join(map(str, traits[one.symbol]))]
        for one in domain.categories
        if one.share
    ]
    show_table("kinds of things", ["kind", "share", "what sets it apart"], rows)


def show_value_run(run: ValueRun, domain: ValueDomain) -> None:
    """Print for each step of a run with values what was promised and what happened."""
    rows = [
        [
            f"{step.operator} {step.thing}",
            *(f"{promised:g}: {came:g}" for promised, came in zip(step.promised, step.happened, strict=True)),
            "yes" if step.as_promised else "no",
        ]
        for step in run.steps
    ]
    names = [f"{axis.name}, promised: happened" for axis in domain.axes]
    show_table(f"{counted(len(run.steps), 'step')} of {run.problem}", ["step", *names, "as promised"], rows)
    anew = f", with {counted(run.replans, 'new plan')}" if run.replans else ""
    say(f"goal reached{anew}" if run.reached else f"goal missed{anew}: {run.reason}")


def show_relations(table: RelationOperators) -> None:
    """Print the states that pairs of objects can be in, and what brings pairs of each kind into them."""
    states = [
        [state.name, f"{state.share:.0%}", "yes" if state.bears else "", _told(state.centre)]
        for state in table.states
    ]
    show_table("states of pairs", ["state", "of fresh pairs", "borne", "typical"], states)
    rows = []
    for one in table.operators:
        if one.promise is not None:
            among = (f"{kept.kept} of {kept.trials}" for kept in map(one.among, OF_PAIRS))
            rows.append([one.name, f"{one.promise.count} of {one.trials}", *among])
    columns = ["operator", "ends so", "target borne", "reference occupied", "target laden"]
    show_table("operators on pairs", columns, rows)


def show_data(interactions: Interactions, path: Path) -> None:
    """Print what a data set holds: its size, the range of each column, and how much happens in it."""
    origin, columns = interactions.origin, interactions.columns
    grippers, of_actions = origin.get("gripper_columns", ()), range(columns["actions"].shape[1])
    plain = [f"gripper {n + 1}" if n in grippers else f"a{n + 1}" for n in of_actions]
    names = {
        "features": names_of_features(columns["features"].shape[1], origin.get("feature_names", ())),
        "actions": origin.get("action_names", plain),
        "effects": [one["name"] for one in origin.get("axes", ())] or name_axes(columns["effects"].shape[1]),
    }
    rows = []
    for array, named in names.items():
        for n, (name, values) in enumerate(zip(named, columns[array].astype(np.float64).T, strict=True)):
            figures = (values.min(), values.mean(), values.max(), values.std())
            rows.append([f"{array}[:, {n}]", name, *(f"{figure:.4g}" for figure in figures)])
    title = f"{path}: {len(interactions)} interactions"
    show_table(title, ["column", "name", "least", "mean", "greatest", "spread"], rows)
    if origin.get("axes"):
        return
    moved = np.mean(np.linalg.norm(interactions.effects, axis=1) > NO_EFFECT)
    shares = [f"{kind} {getattr(interactions, kind).mean():.0%}" for kind in FLAGS]
    say(f"with an effect above {NO_EFFECT:g}: {moved:.0%}; {', '.join(shares)}")


def show_run(run: Run) -> None:
    """Print for each step what was promised and what happened, and whether the goal was reached."""
    rows = []
    for number, step in enumerate(run.steps, 1):
        words = (step.operator, step.object, *([step.place or ""] if step.promised_state else []))
        promised, happened = step.promised_state or step.promised, step.state or step.happened
        effect = (
            f"{promised} {_told(step.promised_effect, in_mm=True)}" if step.promised_effect else "nothing"
        )
        apart = "" if step.apart is None else f"{1000 * step.apart:.0f}"
        seen, is_so = f"{happened} {_told(step.effect, in_mm=True)}", "yes" if step.as_promised else "no"
        rows.append([str(number), " ".join(words), effect, seen, apart, is_so])
    columns = ["", "step", "promised [mm]", "happened [mm]", "apart [mm]", "as promised"]
    show_table(f"run of {run.problem}: {run.credit}", columns, rows)
    if any(step.promised_state for step in run.steps):
        say("what is put on or into another object is seen from that")
    if any(step.place and not step.promised_state for step in run.steps):
        say("what is carried is seen from the point that the hand aimed at; all else from where it stood")
    for nudge in run.nudges:
        by = 1000 * math.hypot(*nudge.by)
        say(f"before step {nudge.before_step} {nudge.object} was nudged by {by:.0f} mm")
    if run.replannings:
        say(f"planned anew {counted(len(run.replannings), 'time')}")
    for new in run.replannings:
        count = counted(primitives(PlanStep(*step) for step in new.plan), "primitive")
        found = count if new.plan else new.reason or "nothing is left to do"
        say(f"new plan before step {new.before_step}, for {new.why}: {found}")
    for number, step in enumerate(run.steps, 1):
        if step.touched:
            say(f"in step {number} the robot touched {', '.join(step.touched)}")
        for name, how in step.disturbed.items():
            say(f"in step {number} {name} was {how}, though it was not acted upon")
    if run.reason:
        say(run.reason)
    far = ", ".join(f"{name} {1000 * distance:.0f} mm" for name, distance in run.distances.items())
    allowed = "" if run.tolerance is None else f", {1000 * run.tolerance:g} mm are allowed in this run"
    said = f": {far} from it{allowed}" if far else ""
    say(f"{run.outcome}{said}; {run.credit}")


def _told(effect: Effect, *, in_mm: bool = False) -> str:
    """Write a vector, which is in metres if it is to be told in millimetres."""
    return f"({', '.join(f'{1000 * value:.0f}' if in_mm else f'{value:.3g}' for value in effect)})"


_WIDEST = 110  # columns of running text
_KINDS = {
    "actions": "Action",
    "carrying": "Carrying",
    "relating": "Relating",
    "states": "Pair state",
    "pairs": "Pair",
    "objects": "Object",
}


_MOST_OBJECTS, _MOST_ACTIONS = 8, 16
"""Symbols of which one screen tells."""
_BRIEFLY = (
    (r" ± [\d.e+-]+", ""),
    ("mm from back to front", "mm deep"),
    ("mm from right to left", "wide"),
    (r"mm high\b", "high"),
    (r", v1 \S+, v2 \S+, v3 \S+, v4 \S+, v5 [-\d.e+]*\d", ""),  # for what an eye tells there are no words
    (r"open at both ends \(rings\)", "rings"),
    (r"\. Of them, (\d+%|all) are (\w+).*", r", \1 \2"),  # the most frequent kind
)
"""What is said of the objects of a category, and how one screen says it."""


def show_screen(explanation: Explanation) -> None:
    """Print in one screen what was learned: categories, what each action symbol does, and more."""
    actions, objects = explanation.actions, explanation.objects
    kept, trials = _promises(actions)
    known = f"{counted(len(actions), 'action symbol')}, {counted(len(objects), 'object symbol')}"
    print_raw(f"{known}; {kept} of {trials} trials ended as promised.")
    alike, done = list[list[str]](), list[list[str]]()
    for one in objects:
        share, _, about = one.about.partition(" of the objects have this symbol")
        for long, short in _BRIEFLY:
            about = re.sub(long, short, about)
        alike.append([one.symbol, one.title, *([share, about.strip(" :.")] if about else ["0%", ""])])
    for one in actions:
        kept, trials = _promises([one])
        does = re.sub(r"\((\d+%) of objects\)", r"\1", one.title)
        done.append([one.symbol, does, f"{kept / trials:.0%}" if trials else "-"])
    does = "what the action does, to which share of objects"
    for most, columns, rows in (
        (_MOST_OBJECTS, ["code", "objects", "share", "on average"], alike),
        (_MOST_ACTIONS, ["code", does, "as promised"], done),
    ):
        show_table("", columns, rows[:most], most=NARROW)
        if len(rows) > most:
            print_raw(f"and {len(rows) - most} more")
    for line in folded("\n".join(["", *explanation.summary[1:]]), min(width(), NARROW)):
        print_raw(line)


def _promises(symbols: Iterable[SymbolExplanation]) -> tuple[int, int]:
    """Count how often operators did what they promise, and how often they were tried."""
    rows = {row.operator: row for one in symbols for row in one.effects}.values()
    return sum(row.promised for row in rows), sum(row.trials for row in rows)


def show_explanation(explanation: Explanation) -> None:
    """Print all of an explanation for a terminal."""
    lines = [*explanation.summary]
    for name, symbols in explanation.parts.items():
        for symbol in symbols:
            lines += ["", f"{_KINDS[name]} symbol {symbol.symbol}: {symbol.title}"]
            lines += [f"  {line}" for line in (symbol.about, *_effects(symbol.effects)) if line]
    for line in folded("\n".join(lines), min(width(), _WIDEST)):
        print_raw(line)


def explanation_page(explanation: Explanation, title: str) -> str:
    """Return an explanation as a page of Markdown."""
    blocks = [f"# What the symbols of {title} mean", *explanation.summary]
    for name, symbols in explanation.parts.items():
        blocks.append(f"## {_KINDS[name]} symbols")
        for symbol in symbols:
            effects = "\n".join(_effects(symbol.effects))
            blocks += [f"### {symbol.symbol}: {symbol.title}", symbol.about, effects]
    text = "\n\n".join(filter(None, blocks)) + "\n"
    return harmless(text).replace("<", "&lt;")  # names in data of a user's own may hold anything


def _effects(effects: Sequence[EffectRow]) -> Iterator[str]:
    """Yield a line for each operator, whole so that its name can be copied, and one for each of its modes."""
    before = ""
    for row in effects:
        if row.operator != before:
            domain = f", in the domain{row.domain.removeprefix('yes')}" if row.domain else ""
            if row.domain.startswith("no"):
                domain = f", not in the domain{row.domain.removeprefix('no')}"
            yield f"- {row.operator} ({row.trials} trials, {row.promised} as promised{domain})"
        before = row.operator
        effect = f": {row.effect} ({row.spread})" if row.effect else ""
        yield f"    - {row.share:.0%} {row.ends}{effect}"
