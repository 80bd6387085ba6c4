"""What a page says in tables, as HTML in which nothing from outside is markup.

Every function escapes what it is given, so that a name of a stranger's file stays a name. Colours suit light
and dark pages alike.
"""

from collections.abc import Iterable, Sequence
from html import escape

from neurosym.errors import counted, harmless
from neurosym.execution.record import Replanning, Run, StepRecord
from neurosym.grounding import Grounding
from neurosym.problems import Problem, RelationGoal
from neurosym.report.symbol_words import displacement_in_words
from neurosym.stages.plan_records import PlanRecord
from neurosym.tasks.options import put_named
from neurosym.tasks.task import Task, understand
from neurosym.tasks.transition import PlanStep, apply, chance, cost, promise_of, start

GOOD, BAD, DIM = "#2a9d5c", "#d9534f", "#8a8a8a"
_TABLE = "border-collapse:collapse;font-size:12px;width:100%"
_CELL = "padding:2px 5px;border-bottom:1px solid rgba(128,128,128,.3);vertical-align:top;text-align:left"
_WIDEST = 10.0  # margin of a bit, before it is squashed, that fills the bar
_HERE = "background:rgba(255,190,60,.25);"


def safe(text: object) -> str:
    """Return a text such that a page shows it as it is."""
    return escape(harmless(str(text)))


def coloured(text: object, colour: str) -> str:
    """Return a text in a colour."""
    return f'<span style="color:{colour}">{safe(text)}</span>'


def paragraph(*parts: str) -> str:
    """Return a paragraph of what is HTML already."""
    return f'<p style="margin:4px 0;font-size:13px">{" ".join(parts)}</p>'


def table(head: Sequence[str], rows: Iterable[Sequence[str]], at: int | None = None, label: str = "") -> str:
    """Return a table.

    The cells are HTML, and `at` is the number of the row that is at hand, counted from 0.
    """
    heads = "".join(f'<th scope="col" style="{_CELL}">{safe(one)}</th>' for one in head)
    lines = []
    for number, row in enumerate(rows):
        cells = "".join(f'<td style="{_CELL}">{cell}</td>' for cell in row)
        here = f' style="{_HERE}" aria-current="step"' if number == at else ""
        lines.append(f"<tr{here}>{cells}</tr>")
    return f'<table aria-label="{safe(label)}" style="{_TABLE}"><tr>{heads}</tr>{"".join(lines)}</table>'


def plan_table(record: PlanRecord, problem: Problem, grounding: Grounding, at: int | None = None) -> str:
    """Return a plan in words, each step with its bits, what it costs, and its chance.

    `at` is the number of the step at hand, counted from 0.
    """
    task = understand(problem, grounding)
    now, rows = start(task), []
    for number, step in enumerate((PlanStep(*parts) for parts in record.steps), start=1):
        moves, bits = _told(step, task)
        told = f"{safe(step.operator)}<br>{coloured(moves, DIM)}"
        sums = (str(cost(task, now, step)), f"{chance(task, now, step):.0%}")
        sums = ("", "") if step.puts_down else sums
        rows.append((str(number), told, safe(step.object), f"<code>{safe(bits)}</code>", *sums))
        now = apply(task, now, step)
    return table(("", "step", "object", "bits", "cost", "chance"), rows, at, f"plan of {record.planner}")


def _told(step: PlanStep, task: Task) -> tuple[str, str]:
    """Tell what a step of a plan does in words, and its bits."""
    if put := put_named(step.operator, task.grounding):
        return (
            f"puts it {put.state.name} {step.place}",
            f"{put.operator.pair or 'any'} · {put.operator.label}",
        )
    operator = promise_of(step, task.problem, task.grounding)
    moves = displacement_in_words(operator.promise.outcome) if operator.promise else "nothing"
    moves = "puts it down" if step.puts_down else f"carries it to {step.place}" if step.place else moves
    return moves, f"{task.problem.object_named(step.object).category} · {operator.primitive}"


def plan_summary(record: PlanRecord) -> str:
    """Return how planning went, in a paragraph."""
    seconds = f"{record.seconds:.2f} s"
    if not record.steps:
        return paragraph(
            f"<b>{safe(record.planner)}</b>:",
            coloured(record.status.value, BAD),
            f"in {seconds}. ",
            safe(record.reason),
        )
    odds = "" if record.chance is None else f"All steps go as promised with a chance of {record.chance:.0%}"
    if record.chance_replanned is not None:
        odds += f", and {record.chance_replanned:.0%} if planned anew on the way"
    said = f"{record.primitives} primitives in {seconds}. {odds}."
    reason = safe(record.reason or record.misses)
    return paragraph(
        f"<b>{safe(record.planner)}</b>:", coloured(record.status.value, GOOD), safe(said), reason
    )


def run_table(records: Sequence[StepRecord], at: int | None = None) -> str:
    """Return what each step promised beside what happened.

    `at` is the number of the step at hand, counted from 0.
    """
    rows = []
    for number, record in enumerate(records, start=1):
        verdict = coloured("as promised", GOOD) if record.as_promised else coloured("otherwise", BAD)
        apart = "" if record.apart is None else f"<br>{1000 * record.apart:.0f} mm apart"
        if others := ", ".join(f"{name} {how}" for name, how in record.disturbed.items()):
            apart += f"<br>{coloured(others, BAD)}"
        promised = displacement_in_words(record.promised_effect) if record.promised_effect else ""
        is_put = bool(record.promised_state)
        whom = f"{record.object} {record.place}" if is_put else record.object
        seen = f" from {record.place}" if is_put else ""
        seen_after = seen if record.happened == "carried" else ""
        rows.append(
            (
                str(number),
                f"{safe(record.operator)}<br>{coloured(whom, DIM)}",
                f"{safe(record.promised_state or record.promised)}<br>{coloured(promised + seen, DIM)}",
                f"{safe(record.state or record.happened)}<br>"
                f"{coloured(displacement_in_words(record.effect) + seen_after, DIM)}",
                verdict + apart,
            )
        )
    return table(("", "step", "promised", "happened", ""), rows, at, "promised and happened")


def run_summary(run: Run) -> str:
    """Return what became of a run, in a paragraph."""
    misses = ", ".join(f"{name} {1000 * miss:.0f} mm" for name, miss in run.distances.items())
    if run.reached:
        return paragraph(
            coloured(run.outcome, GOOD),
            safe(f"; from the goals: {misses}" if misses else "") + safe(f"; {run.credit}"),
        )
    return paragraph(coloured("goal missed", BAD), safe(f": {run.reason}"))


def relation_list(goals: Iterable[RelationGoal]) -> str:
    """Return goals by relation in words; nothing if there are none."""
    return _list(f"Goal: {target} {state} {reference}" for target, reference, state in goals)


def replanning_list(replannings: Sequence[Replanning]) -> str:
    """Return why new plans were asked for."""
    lines = []
    for one in replannings:
        none = f"no new plan: {one.reason}" if one.reason else "nothing is left to be done"
        found = f"a new plan of {counted(len(one.plan), 'step')}" if one.plan else none
        lines.append(f"before step {one.before_step}: {one.why}; {found}")
    return _list(lines)


def _list(lines: Iterable[str]) -> str:
    items = "".join(f"<li>{safe(line)}</li>" for line in lines)
    return f'<ul style="margin:4px 0;font-size:12px;padding-left:18px">{items}</ul>' if items else ""


def preformatted(text: str) -> str:
    """Return a text as it is laid out, as of PDDL."""
    style = "font-size:11px;line-height:1.35;white-space:pre-wrap;max-height:260px;overflow:auto;margin:4px 0"
    return f'<pre tabindex="0" aria-label="PDDL" style="{style}">{safe(text)}</pre>'


def bits_row(symbol: str, margins: Sequence[float]) -> str:
    """Return the bits of an object, each with how far it is from its flip.

    `margins` is what each bit is the sign of; empty if that is not known.
    """
    rows = []
    for number, bit in enumerate(symbol):
        margin = margins[number] if number < len(margins) else None
        bar = "" if margin is None else _margin_bar(margin)
        shown = "" if margin is None else f"{margin:+.1f}"
        rows.append((f"bit {number + 1}", f"<b>{safe(bit)}</b>", bar, shown))
    return table(("", "is", "how far from its flip", "before the step"), rows, label="bits of the object")


def _margin_bar(margin: float) -> str:
    """Return a bar that leaves the middle to one side, and is orange where a flip is near."""
    share = min(1.0, abs(margin) / _WIDEST) * 50
    colour = "#e08a00" if abs(margin) < _WIDEST / 5 else "#3d8bfd"
    left = 50 if margin > 0 else 50 - share
    return (
        '<div style="position:relative;height:10px;width:120px;background:rgba(128,128,128,.25)">'
        f'<div style="position:absolute;left:{left:.1f}%;width:{share:.1f}%;'
        f'height:10px;background:{colour}"></div>'
        '<div style="position:absolute;left:50%;width:1px;height:10px;background:currentColor"></div></div>'
    )
