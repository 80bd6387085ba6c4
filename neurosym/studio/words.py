"""What a page says in tables, as HTML in which nothing from outside is markup.

Every function escapes what it is given, so that a name of a stranger's file stays a name. Colours suit light
and dark pages alike.
"""

from collections.abc import Iterable, Sequence
from html import escape

from neurosym.errors import counted, harmless
from neurosym.execution.record import Replanning, Run, StepRecord
from neurosym.grounding import Grounding
from neurosym.problems import Problem
from neurosym.report.symbols import displacement_in_words
from neurosym.stages.plan_records import PlanRecord
from neurosym.tasks.options import put_named
from neurosym.tasks.task import Task, understand
from neurosym.tasks.transition import PlanStep, apply, chance, cost, promise_of, start

GOOD, BAD, DIM = "#2a9d5c", "#d9534f", "#8a8a8a"
_FAR, _NEAR = "#3d8bfd", "#e08a00"
"""Of bars of bits: far from a flip, and near to one."""
_TABLE = "border-collapse:collapse;font-size:12px;width:100%"
_CELL = "padding:2px 5px;border-bottom:1px solid rgba(128,128,128,.3);vertical-align:top;text-align:left"
_HERE = ' style="background:rgba(255,190,60,.25);" aria-current="step"'
_WIDEST = 10.0  # margin of a bit, before it is squashed, that fills the bar


def safe(text: object) -> str:
    """Return a text such that a page shows it as it is."""
    return escape(harmless(str(text)))


def coloured(text: object, colour: str) -> str:
    """Return a text in a colour."""
    return f'<span style="color:{colour}">{safe(text)}</span>'


def paragraph(text: str, colour: str = "", *, head: str = "", more: str = "") -> str:
    """Return a paragraph of a text, in a colour if one is given, after a bold head and before more."""
    said = coloured(text, colour) if colour else safe(text)
    bold = f"<b>{safe(head)}</b> " if head else ""
    return f'<p style="margin:4px 0;font-size:13px">{bold}{said} {safe(more)}</p>'


def twofold(text: object, more: str) -> str:
    """Return a text, and more below it that is dim."""
    return f"{safe(text)}<br>{coloured(more, DIM)}"


def bullets(lines: Iterable[str]) -> str:
    """Return a list of texts; nothing if there are none."""
    items = "".join(f"<li>{safe(line)}</li>" for line in lines)
    return f'<ul style="margin:4px 0;font-size:12px;padding-left:18px">{items}</ul>' if items else ""


def table(head: Sequence[str], rows: Iterable[Sequence[str]], at: int | None = None, label: str = "") -> str:
    """Return a table of cells that are HTML; `at` is the row at hand, counted from 0."""
    heads = "".join(f'<th scope="col" style="{_CELL}">{safe(one)}</th>' for one in head)
    lines = []
    for number, row in enumerate(rows):
        cells = "".join(f'<td style="{_CELL}">{cell}</td>' for cell in row)
        lines.append(f"<tr{_HERE if number == at else ''}>{cells}</tr>")
    return f'<table aria-label="{safe(label)}" style="{_TABLE}"><tr>{heads}</tr>{"".join(lines)}</table>'


def plan_table(record: PlanRecord, problem: Problem, grounding: Grounding, at: int | None = None) -> str:
    """Return a plan in words, with bits, costs and chances; `at` is the step at hand, counted from 0."""
    task = understand(problem, grounding)
    now, rows = start(task), []
    for number, step in enumerate((PlanStep(*parts) for parts in record.steps), start=1):
        moves, bits = _told(step, task)
        told = twofold(step.operator, moves)
        sums = ("", "") if step.puts_down else (str(cost(task, now, step)), f"{chance(task, now, step):.0%}")
        rows.append((str(number), told, safe(step.object), f"<code>{safe(bits)}</code>", *sums))
        now = apply(task, now, step)
    return table(("", "step", "object", "bits", "cost", "chance"), rows, at, f"plan of {record.planner}")


def _told(step: PlanStep, task: Task) -> tuple[str, str]:
    """Tell what a step of a plan does in words, and its bits."""
    if put := put_named(step.operator, task.grounding):
        bits = f"{put.operator.pair or 'any'} · {put.operator.label}"
        return f"puts it {put.state.name} {step.place}", bits
    operator = promise_of(step, task.problem, task.grounding)
    moves = displacement_in_words(operator.promise.outcome) if operator.promise else "nothing"
    moves = "puts it down" if step.puts_down else f"carries it to {step.place}" if step.place else moves
    return moves, f"{task.problem.object_named(step.object).category} · {operator.primitive}"


def plan_summary(record: PlanRecord) -> str:
    """Return how planning went, in a paragraph."""
    colour, reason = GOOD if record.steps else BAD, record.reason or record.misses
    said = f"in {record.seconds:.2f} s."
    if record.steps:
        said = f"{record.primitives} primitives {said}"
        if record.chance is not None:
            said += f" All steps go as promised with a chance of {record.chance:.0%}"
            if record.chance_replanned is not None:
                said += f", and {record.chance_replanned:.0%} if planned anew on the way"
            said += "."
    return paragraph(record.status.value, colour, head=f"{record.planner}:", more=f"{said} {reason}")


def run_table(records: Sequence[StepRecord]) -> str:
    """Return what each step promised beside what happened."""
    rows = []
    for number, record in enumerate(records, start=1):
        verdict = coloured("as promised", GOOD) if record.as_promised else coloured("otherwise", BAD)
        apart = "" if record.apart is None else f"<br>{1000 * record.apart:.0f} mm apart"
        if others := ", ".join(f"{name} {how}" for name, how in record.disturbed.items()):
            apart += f"<br>{coloured(others, BAD)}"
        whom, seen = f"{record.object} {record.place}", f" from {record.place}"
        if not record.promised_state:
            whom, seen = record.object, ""
        promised = displacement_in_words(record.promised_effect) if record.promised_effect else ""
        happened = displacement_in_words(record.effect) + seen * (record.happened == "carried")
        told = (
            twofold(record.operator, whom),
            twofold(record.promised_state or record.promised, promised + seen),
            twofold(record.state or record.happened, happened),
        )
        rows.append((str(number), *told, verdict + apart))
    return table(("", "step", "promised", "happened", ""), rows, label="promised and happened")


def run_summary(run: Run) -> str:
    """Return what became of a run, in a paragraph."""
    if not run.reached:
        return paragraph("goal missed", BAD, more=run.reason)
    misses = ", ".join(f"{name} {1000 * miss:.0f} mm" for name, miss in run.distances.items())
    said = f"from the goals: {misses}; " if misses else ""
    return paragraph(run.outcome, GOOD, more=f"{said}{run.credit}")


def replanning_list(replannings: Sequence[Replanning]) -> str:
    """Return why new plans were asked for."""
    lines = []
    for one in replannings:
        none = f"no new plan: {one.reason}" if one.reason else "nothing is left to be done"
        found = f"a new plan of {counted(len(one.plan), 'step')}" if one.plan else none
        lines.append(f"before step {one.before_step}: {one.why}; {found}")
    return bullets(lines)


def bits_row(symbol: str, margins: Sequence[float]) -> str:
    """Return the bits of an object, with the margins that they are the signs of, if these are known."""
    rows = []
    for number, bit in enumerate(symbol):
        known = margins[number : number + 1]
        bar, shown = "".join(map(_margin_bar, known)), "".join(f"{margin:+.1f}" for margin in known)
        rows.append((f"bit {number + 1}", f"<b>{safe(bit)}</b>", bar, shown))
    return table(("", "is", "how far from its flip", "before the step"), rows, label="bits of the object")


def _margin_bar(margin: float) -> str:
    """Return a bar that leaves the middle to one side, and is orange where a flip is near."""
    share = min(1.0, abs(margin) / _WIDEST) * 50
    colour = _NEAR if abs(margin) < _WIDEST / 5 else _FAR
    left = 50 if margin > 0 else 50 - share
    return (
        '<div style="position:relative;height:10px;width:120px;background:rgba(128,128,128,.25)">'
        f'<div style="position:absolute;left:{left:.1f}%;width:{share:.1f}%;'
        f'height:10px;background:{colour}"></div>'
        '<div style="position:absolute;left:50%;width:1px;height:10px;background:currentColor"></div></div>'
    )
