"""What a page says in tables, as HTML in which nothing from outside is markup.

Every function escapes what it is given, so that a name of a stranger's file stays a name. Colours suit light
and dark pages alike.
"""

import re
from collections.abc import Iterable, Sequence
from html import escape
from itertools import zip_longest
from pathlib import Path

from neurosym.errors import counted, harmless
from neurosym.execution.record import Replanning, Run, StepRecord
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE, by_share
from neurosym.problems import Problem, RelationGoal
from neurosym.report.symbols import Promise, displacement_in_words
from neurosym.stages.plan_records import PlanRecord
from neurosym.world import Palette

GOOD, BAD, DIM = "var(--good)", "var(--bad)", "var(--dim)"
"""Colours of the page's style, which suit light and dark."""
_FAR, _NEAR = "#3d8bfd", "#e08a00"
"""Of bars of bits: far from a flip, and near to one."""
_TABLE = "border-collapse:collapse;font-size:12px;width:100%"
_CELL = "padding:2px 5px;border-bottom:1px solid rgba(128,128,128,.3);vertical-align:top;text-align:left"
_LIT = "background:var(--lit);"
_PATH = re.compile(r"""(?<![\w/.<])(?:[A-Za-z]:)?[/\\](?:[^\s/\\'"<>:;,()]+[/\\])+""")
_WIDEST = 10.0  # margin of a bit, before it is squashed, that fills the bar


def here(is_at_hand: bool, style: str = "") -> str:
    """Return the attributes of something on a page that may be what is at hand."""
    return f' style="{style};{_LIT}" aria-current="step"' if is_at_hand else f' style="{style}"' * bool(style)


def nameless(text: str, *folders: Path) -> str:
    """Return a text in which paths are names of files: whose machine it is, is nobody's business."""
    for folder in folders:
        text = text.replace(f"{folder}/", "")
    return _PATH.sub("", text)


def safe(text: object) -> str:
    """Return a text such that a page shows it as it is, but for paths; see `nameless`."""
    return escape(nameless(harmless(str(text))))


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
        lines.append(f"<tr{here(number == at)}>{cells}</tr>")
    return f'<table aria-label="{safe(label)}" style="{_TABLE}"><tr>{heads}</tr>{"".join(lines)}</table>'


def three_numbers(effect: Sequence[float]) -> str:
    """Say an effect in three numbers, zeros, too: `57 mm forward, 90 mm right, 0 mm up`."""
    ways = zip(effect, (("back", "forward"), ("right", "left"), ("down", "up")), strict=True)
    millimetres = ((round(1000 * length), way) for length, way in ways)
    return ", ".join(f"{abs(far)} mm {way[far >= 0]}" for far, way in millimetres)


def plain_name(symbol: str, grounding: Grounding) -> str:
    """Return what most objects of a category are, which its name says: `mostly solid, low, narrow`."""
    categories = grounding.objects.categories
    name = next((one.name for one in categories if one.symbol == symbol), None)
    if name is None:
        return "of no known category"
    told = [word for word in name.removesuffix(symbol).split("-") if word not in ("", "any", "kind")]
    return f"mostly {', '.join(told)}" if told else "of all kinds"


_RELATIONS = {"rests-on": "on", "sits-in": "in", "leans-on": "leaning on", "lies-under": "under"}


def relation_in_words(state: str) -> tuple[str, str]:
    """Return how a state of a pair is said, `on` or `in`, and its bits."""
    name, _, bits = state.rpartition("-")
    return (_RELATIONS.get(name, name.replace("-", " ")), bits) if bits.isdigit() else (state, "")


def goals_in_words(goals: Iterable[RelationGoal]) -> str:
    """Return goals by relation as HTML: `Goal: item-01 on item-04`, and the bits of the state."""
    parts = ((name, other, *relation_in_words(state)) for name, other, state in goals)
    lines = (
        f"Goal: {safe(f'{name} {how} {other}')} {coloured(bits, DIM)}" for name, other, how, bits in parts
    )
    return "".join(f'<p style="margin:4px 0;font-size:13px">{line}</p>' for line in lines)


def scene_in_words(problem: Problem, grounding: Grounding) -> str:
    """Say what is seen of a table, for those who do not see it."""
    things = [
        f"{one.name}, {plain_name(one.category, grounding)} {one.category}, at x {one.position[0]:.2f}, "
        f"y {one.position[1]:.2f} m"
        for one in problem.objects
    ]
    goals = [f"{name} at x {x:.2f}, y {y:.2f} m" for name, (x, y, _) in problem.goals.items()]
    goals += [f"{name} {relation_in_words(state)[0]} {other}" for name, other, state in problem.relations]
    return f"A robot's arm at a table. On it: {'; '.join(things)}. Goals: {'; '.join(goals) or 'none'}."


def verb_of(operator: str) -> str:
    """Return what an operator does, by the first word of its name."""
    return operator.split("-")[0]


def step_in_words(step: StepRecord) -> str:
    """Say what a step was to do: `lift item-04, 47 mm left`."""
    if step.promised_state:
        return f"put {step.object} {relation_in_words(step.promised_state)[0]} {step.place}"
    to = f" to {step.place}" if step.place else ""
    if step.promised_effect and not to:
        to = f", {displacement_in_words(step.promised_effect)}"
    return f"{verb_of(step.operator)} {step.object}{to}"


def _end_in_words(step: StepRecord, state: object, kind: str | None, effect: Sequence[float] | None) -> str:
    """Return how an object was to end, or ended: in a state of a pair, with its bits, or otherwise."""
    where = displacement_in_words(effect) if effect else ""
    if kind == "carried":  # seen from what it was carried to, which says nothing of a mere place
        where = f"{where} from {step.place}" if step.promised_state else ""
    said, bits = relation_in_words(str(state)) if state else (kind or "", "")
    return twofold(said, " · ".join(filter(None, (bits, where))))


def swatch(colour: str) -> str:
    """Return a small square in a colour, which is one of the page's own."""
    return (
        f'<span style="display:inline-block;width:12px;height:12px;vertical-align:-1px;background:{colour};'
        'border:1px solid rgba(128,128,128,.6)"></span>'
    )


def bar(share: float) -> str:
    """Return a small bar that is filled by a share, and the share in percent."""
    return (
        '<span style="white-space:nowrap"><span style="display:inline-block;width:44px;height:8px;'
        'background:rgba(128,128,128,.3)"><span style="display:block;height:8px;opacity:.7;'
        f'background:currentColor;width:{share:.0%}"></span></span> {share:.0%}</span>'
    )


def legend(grounding: Grounding, palette: Palette, here: str = "") -> str:
    """Return the categories with their colours, codes, names and shares; `here` is the one at hand."""
    every = by_share(grounding.objects.categories)
    rows = [
        (
            swatch(palette.hex(one.symbol)),
            f"<code>{safe(one.symbol)}</code>",
            safe(plain_name(one.symbol, grounding)),
            f"{one.share:.0%}",
        )
        for one in every
    ]
    at = next((number for number, one in enumerate(every) if one.symbol == here), None)
    return table(("", "bits", "category", "of all objects"), rows, at, "colours of categories")


def what_if(sides: Sequence[tuple[str, Sequence[Promise]]], most: int = 4) -> str:
    """Return side by side what the surest operators promise for each of some kinds of objects."""
    columns = [
        [f"{safe(promise_in_words(one))}<br>{bar(one.chance)}" for one in promises[:most]]
        or ["nothing is known to be done to it"]
        for _, promises in sides
    ]
    return table([head for head, _ in sides], zip_longest(*columns, fillvalue=""), label="before and after")


def promise_in_words(promise: Promise) -> str:
    """Say what an operator promises: `lift, 22 mm back, 236 mm up`."""
    return f"{verb_of(promise.operator.name)}, {displacement_in_words(promise.effect)}"


def plan_summary(record: PlanRecord) -> str:
    """Return how planning went, in a paragraph."""
    colour, reason = GOOD if record.steps else BAD, record.reason or record.misses
    said = f"in {record.seconds:.2f} s."
    if record.steps:
        said = f"{counted(record.primitives, 'primitive')} {said}"
        if record.chance is not None:
            said += (
                f" The chance that all goes as promised, and ends within the goals, is {record.chance:.0%}"
            )
            if record.chance_replanned is not None:
                said += (
                    f"; planned anew where it does not, the goal is reached in {record.chance_replanned:.0%}"
                )
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
        step, _, _ = step_in_words(record).partition(",")
        told = (
            twofold(step, " · ".join(re.findall(r"\b[01]+[a-z]*\b", record.operator))),
            _end_in_words(record, record.promised_state, record.promised, record.promised_effect),
            _end_in_words(record, record.state, record.happened, record.effect),
        )
        rows.append((str(number), *told, verdict + apart))
    meant = paragraph(f"As promised: it ended so, at most {1000 * TOLERANCE:.0f} mm apart.", DIM)
    return table(("", "step", "promised", "happened", ""), rows, label="promised and happened") + meant


def run_summary(run: Run, tolerance: float) -> str:
    """Return what became of a run, in a paragraph; objects had to come so near to their goals [m]."""
    if not run.reached:
        return paragraph("goal missed", BAD, more=run.reason)
    misses = ", ".join(f"{name} {1000 * miss:.0f} mm" for name, miss in run.distances.items())
    said = f"from the goals: {misses}; at most {1000 * tolerance:.0f} mm are asked for. " if misses else ""
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
    return table(("bit", "is", "margin", "its value"), rows, label="bits of the object")


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
