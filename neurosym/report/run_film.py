"""Runs as small films that need no script: objects in their colours, moved by styles from step to step."""

import re
from collections.abc import Sequence
from html import escape
from typing import Any

import numpy as np

from neurosym.checks import Float
from neurosym.errors import counted
from neurosym.execution.record import Run, StepRecord
from neurosym.operators import NO_EFFECT
from neurosym.problems import Problem
from neurosym.report.drawings import seen, solid
from neurosym.world import Palette, Table

_WIDTH, _HEIGHT, _TOP = 340, 250, 64  # of the picture, and the room above the table [pixels]
_STEP, _END = 2.6, 2.4  # how long a step is shown, and how it ended [s]
_RISE = 0.13  # how high over the table is carried [m]
_APPROACHES, _GRASPS, _RISES, _ARRIVES, _ENDS = 0.2, 0.3, 0.42, 0.72, 0.84
"""Shares of a step: when the hand is over the object, at it, risen, over the end, and at the end."""
_HAND = "M0-60V-26M-11-13V-24Q-11-27-8-27H8Q11-27 11-24V-13"
_Way = list[tuple[float, Float[np.ndarray, "3"]]]
"""When something is where: steps since the start, and the place [m]."""


def step_named(record: StepRecord) -> str:
    """Name a step as people do: lift item-04; item-02 rests on item-03."""
    found = re.match(r"[a-z-]+?(?=-[01]+)", record.operator)
    verb = (found[0] if found else record.operator).replace("-", " ")
    if not record.place:
        return f"{verb} {record.object}"
    if record.place in record.positions:
        return f"{record.object} {verb} {record.place}"
    return f"carry {record.object} to its goal"


def film_of_run(problem: Problem, run: Run, palette: Palette, table: Table, name: str) -> dict[str, Any]:
    """Draw a run from its record: what moved where, step by step.

    Args:
        problem: What the run was to solve; its objects have three sizes and a type.
        run: What became of the plan.
        palette: The colours of the categories.
        table: Where the table ends, which is drawn.
        name: Begins the names of the film's styles in the page.

    Returns:
        A title, the picture as SVG, and its styles, which move it.
    """
    records = [one for one in run.steps if one.happened != "not performed"]
    place, ground, scale = _view(table)
    ways, hand = _ways(problem, records)
    seconds, styles = _STEP * len(records) + _END, list[str]()

    def moved(part: str, key: str, way: _Way) -> str:
        """Have a part follow its way from where it begins."""
        if all(np.allclose(at, way[0][1]) for _, at in way):
            return f"<g>{part}</g>"
        frames = "".join(
            f"{100 * _STEP * when / seconds:.4g}%{{transform:translate({x:.1f}px,{y:.1f}px)}}"
            for when, at in way
            for x, y in [(place(at) - place(way[0][1])).tolist()]
        )
        styles.append(f"@keyframes {key}{{{frames}}} .{key}{{animation:{key} {seconds:g}s infinite linear}}")
        return f'<g class="{key}">{part}</g>'

    parts = [f'<path d="{ground}" fill="var(--fill)" stroke="var(--line)"/>']
    for item in problem.objects:
        if item.name in problem.goals:
            at = place(np.subtract(problem.goals[item.name], (0, 0, item.features[2] / 2)))
            drawn = solid(item.features, palette(item.category), tuple(at), scale)
            parts.append(f'<g opacity=".3">{drawn}</g>')
    for item in sorted(problem.objects, key=lambda one: _order(ways[one.name])):
        at = place(np.subtract(item.position, (0, 0, item.features[2] / 2)))
        drawn = solid(item.features, palette(item.category), tuple(at), scale)
        parts.append(moved(drawn, f"{name}-{problem.object_names.index(item.name)}", ways[item.name]))
    if hand:
        x, y = place(hand[0][1]).tolist()
        drawn = f'<path class="hand" transform="translate({x:.1f} {y:.1f})" d="{_HAND}"/>'
        parts.append(moved(drawn, f"{name}-hand", hand))
    end = f"goal {'reached' if run.reached else 'missed'}"
    told = [f"{number}. {step_named(one)}" for number, one in enumerate(records, 1)] + [end]
    for number, line in enumerate(told):
        key, begin = f"{name}-says-{number}", 100 * _STEP * number / seconds
        until = min(100.0, 100 * _STEP * (number + 1) / seconds) if number < len(records) else 100.0
        frames = f"0%{{opacity:0}} {begin:.4g}%{{opacity:1}} {until:.4g}%,100%{{opacity:0}}"
        styles.append(
            f"@keyframes {key}{{{frames}}} .{key}{{animation:{key} {seconds:g}s infinite step-end}}"
        )
        shown = int(number == len(records))
        middle = f'x="{_WIDTH / 2}" y="{_HEIGHT - 8}" text-anchor="middle"'
        parts.append(f'<text class="{key}" opacity="{shown}" {middle}>{escape(line)}</text>')
    title = f"{problem.name}: {end}, {counted(len(records), 'step')}"
    label = escape(f"Film of {title}. {'; '.join(told)}.")
    head = f'<svg viewBox="0 0 {_WIDTH} {_HEIGHT}" role="img" aria-label="{label}">'
    return {"title": title, "svg": f"{head}{''.join(parts)}</svg>", "styles": "\n".join(styles)}


def _view(table: Table) -> tuple[Any, str, float]:
    """Say where places [m] are in the picture, draw the table, and return the scale [pixels per m]."""
    corners = np.array(
        [(x, y, 0.0) for x, y in zip(np.repeat(table.x, 2), (*table.y, *table.y[::-1]), strict=True)]
    )
    flat = seen(corners)
    low, high = flat.min(0), flat.max(0)
    scale = float(min((_WIDTH - 8) / (high - low)[0], (_HEIGHT - _TOP - 32) / (high - low)[1]))
    shift = np.array([_WIDTH / 2, _TOP]) - scale * np.array([(low + high)[0] / 2, low[1]])

    def place(point: Float[np.ndarray, "3"]) -> Float[np.ndarray, "2"]:
        return np.asarray(shift + scale * seen(np.atleast_2d(point))[0])

    path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in (shift + scale * flat).tolist()) + "Z"
    return place, path, scale


def _order(way: _Way) -> tuple[float, float]:
    """Order what is drawn: what comes to rest later over the rest, and what is near over what is far."""
    rests = max(
        (when for (when, at), (_, before) in zip(way[1:], way, strict=False) if not np.allclose(at, before)),
        default=0.0,
    )
    return rests, float(seen(np.atleast_2d(way[0][1] * (1, 1, 0)))[0, 1])


def _ways(problem: Problem, records: Sequence[StepRecord]) -> tuple[dict[str, _Way], _Way]:
    """Say when each object is where, and the hand, which comes to the top of what it moves."""
    ways: dict[str, _Way] = {one.name: [(0.0, np.array(one.position))] for one in problem.objects}
    hand = _Way()
    up = np.array([0, 0, _RISE])
    for number, record in enumerate(records):
        start, end = ways[record.object][-1][1], np.array(record.positions[record.object])
        rises = up if record.happened in ("held", "carried") else 0 * up
        for name, way in ways.items():
            here, there = way[-1][1], np.array(record.positions[name])
            if np.linalg.norm(there - here) > NO_EFFECT or name == record.object:
                along = rises if np.linalg.norm(there - here - (end - start)) < _RISE / 10 else 0 * up
                route = ((_GRASPS, here), (_RISES, here + along), (_ARRIVES, there + along), (_ENDS, there))
                way += [(number + when, at) for when, at in route]
        top = np.array([0, 0, problem.object_named(record.object).features[2] / 2])
        hand += [(number, start + top + up)] if not hand else []
        hand += [(number + _APPROACHES, start + top + up)]
        hand += [(when, at + top) for when, at in ways[record.object][-4:]]
        hand += [(number + 1, end + top + up)]
    last = len(records) + _END / _STEP
    for way in (*ways.values(), hand):
        if way:
            way.append((last, way[-1][1]))
    return ways, hand
