"""A plan as a page tells it: a line for each primitive, a lane for each planner, and the page of PDDL."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from neurosym.grounding import Grounding
from neurosym.pddl.strips import page
from neurosym.report.symbols import displacement_in_words
from neurosym.studio.words import (
    DIM,
    bar,
    coloured,
    here,
    paragraph,
    relation_in_words,
    safe,
    swatch,
    verb_of,
)
from neurosym.tasks.options import put_named
from neurosym.tasks.task import Task
from neurosym.tasks.transition import PlanStep, apply, chance, cost, promise_of, start
from neurosym.world import Palette

STEPS = ("push", "lift", "put-down", "put-at", "put", "put-loaded")
"""Actions of the page of which each is one step of a plan."""
_PRE = "font-size:11px;line-height:1.35;white-space:pre-wrap;overflow-wrap:anywhere;margin:4px 0"
_MARK = "background:var(--lit);color:inherit"
_LINE = "padding:3px 4px;font-size:13px;border-bottom:1px solid rgba(128,128,128,.3)"


class Line(NamedTuple):
    """One primitive of a plan, with the put-down of what it lifts."""

    steps: tuple[PlanStep, ...]
    first: int  # which step of the plan is its first, counted from 0
    said: str  # what it does
    category: str
    chance: float
    codes: str  # bits and costs


def lines_of(steps: Sequence[PlanStep], task: Task) -> tuple[Line, ...]:
    """Tell a plan primitive by primitive."""
    now, lines = start(task), list[Line]()
    for number, step in enumerate(steps):
        if step.puts_down and lines:
            both = (*lines[-1].steps, step)
            lines[-1] = lines[-1]._replace(steps=both, said=_said(both, task))
        else:
            category, one = task.problem.object_named(step.object).category, (step,)
            codes = f"{_bits(step, category, task)}, costs {cost(task, now, step)}"
            lines.append(Line(one, number, _said(one, task), category, chance(task, now, step), codes))
        now = apply(task, now, step)
    return tuple(lines)


def _said(steps: Sequence[PlanStep], task: Task) -> str:
    """Say what a primitive does, and where what it lifted is put down again."""
    step = steps[0]
    if put := put_named(step.operator, task.grounding):
        return f"put {step.object} {relation_in_words(put.state.name)[0]} {step.place}"
    verb, promise = verb_of(step.base), promise_of(step, task.problem, task.grounding).promise
    if step.place:
        return f"{verb} {step.object} to {step.place}"
    if promise is None:
        return f"{verb} {step.object}"
    if step.puts_down:
        return f"put {step.object} down"
    if len(steps) == 1:
        return f"{verb} {step.object}, {displacement_in_words(promise.outcome)}"
    return f"{verb} {step.object}, put it down {displacement_in_words((*promise.resting_effect[:2], 0.0))}"


def _bits(step: PlanStep, category: str, task: Task) -> str:
    """Return the bits of a category, or of a kind of pairs, and those of a primitive."""
    if put := put_named(step.operator, task.grounding):
        return f"{put.operator.subject or 'any'} · {put.operator.label}"
    return f"{category} · {promise_of(step, task.problem, task.grounding).primitive}"


def plan_list(lines: Sequence[Line], palette: Palette, at: int | None = None) -> str:
    """Return a plan, a line each; `at` is the line at hand, counted from 0."""
    return "".join(_line(number, line, palette, number == at) for number, line in enumerate(lines))


def _line(number: int, line: Line, palette: Palette, is_at_hand: bool) -> str:
    """Return a line that unfolds to what its operators are called."""
    names = "".join(paragraph(step.operator, DIM) for step in line.steps)
    return (
        f"<details{here(is_at_hand, _LINE)}>"
        f"<summary>{number + 1}. {swatch(palette.hex(line.category))} {safe(line.said)} {bar(line.chance)}"
        f"</summary>{names}{paragraph(line.codes, DIM)}</details>"
    )


def lanes(plans: Mapping[str, Sequence[Line]], palette: Palette, chosen: str, at: int | None = None) -> str:
    """Return plans side by side, whose first steps are told once as long as all planners take the same."""
    every, wide = list(plans.values()), len(plans)
    shared = 0
    while all(len(one) > shared for one in every) and len({one[shared].steps for one in every}) == 1:
        shared += 1
    longest = max(map(len, every))
    told = f"they part at step {shared + 1}" if shared < longest else "they are the same"
    rows = [
        _cells([_line(number, every[0][number], palette, number == at)], wide) for number in range(shared)
    ]
    rows.append(_cells([f"<b>{told}</b>"], wide))
    for number in range(shared, longest):
        cells = [
            _line(number, one[number], palette, number == at and name == chosen) if number < len(one) else ""
            for name, one in plans.items()
        ]
        rows.append(_cells(cells))
    head = "".join(f'<th scope="col" style="text-align:left">{safe(name)}</th>' for name in plans)
    style = "border-collapse:collapse;width:100%;table-layout:fixed;font-size:13px"
    return f'<table aria-label="plans side by side" style="{style}"><tr>{head}</tr>{"".join(rows)}</table>'


def _cells(cells: Sequence[str], wide: int = 1) -> str:
    style = "vertical-align:top;padding:0 6px 0 0"
    return "".join(
        ("<tr>", *(f'<td colspan="{wide}" style="{style}">{cell}</td>' for cell in cells), "</tr>")
    )


def pddl_page(grounding: Grounding, name: str, ground: str, said: str) -> str:
    """Return the page of PDDL with an action marked; what stands before and after it unfolds.

    `ground` is the step at hand as the plan has it, and `said` the same in words. Without a name none is.
    """
    domain = page(grounding)
    text = domain.text()
    action = domain.action(name).text(costs=True) if name else text
    before, _, after = text.partition(action)
    marked = f"<mark style='{_MARK}'>{safe(action)}</mark>" if name else safe(action)
    step = f"<p style='margin:4px 0;font-size:12px'>{safe(said)}<br><code>{safe(ground)}</code></p>"
    return (
        f'{step}<div tabindex="0" role="region" aria-label="PDDL" style="max-height:340px;overflow:auto">'
        f"{_folded(before, 'before it')}<pre style='{_PRE}'>{marked}</pre>"
        f"{_folded(after, 'after it')}</div>"
    )


def _folded(text: str, where: str) -> str:
    """Return a part of the page that unfolds, if there is any."""
    head = coloured(f"{text.count(chr(10))} lines of the page {where}", DIM)
    folded = f"<pre style='{_PRE}'>{safe(text)}</pre>"
    return f"<details style='font-size:12px'><summary>{head}</summary>{folded}</details>" * bool(text)
