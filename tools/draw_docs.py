"""Draw the pictures that open pages of docs/, from what is shipped and measured."""

import json
import re
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from xml.sax.saxutils import escape

import numpy as np

from neurosym.colours import Palette
from neurosym.data.archives import read_tensors
from neurosym.grounding import Grounding
from neurosym.operators import signs
from neurosym.problems import Problem, SceneObject
from neurosym.report.symbols import displacement_in_words
from neurosym.stages.verdicts import wilson

ROOT = Path(__file__).parent.parent
PICTURES, RESULTS, DOMAIN = ROOT / "docs/images", ROOT / "docs/results", ROOT / "domains/tabletop"
TASK, ITEM, MOTION = "task-19", "item-08", "1010b"  # the step that the pictures show
OPERATORS = (
    "push-right-1010b-hollow-wide-01",
    "push-forward-1011-solid-00",
)  # a sure one, and one that is not
WIDTH = 760  # pixels
INK, SOFT, PALE = "#1d1d1d", "#555555", "#efefef"
MIDDLE, BOLD, MONO = 'text-anchor="middle"', 'font-weight="bold"', 'font-family="monospace"'
TIP = (
    '<defs><marker id="tip" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" markerHeight="7" '
    'orient="auto">'
    f'<path d="M0,0 L8,4 L0,8 z" fill="{INK}"/></marker></defs>'
)


def svg(height: int, title: str, parts: Iterable[str]) -> str:
    """Return a picture on a ground of its own, so that light and dark pages show it alike."""
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" '
        f'height="{height}" font-family="sans-serif" fill="{INK}" role="img"><title>{escape(title)}</title>'
    )
    ground = f'<rect width="{WIDTH}" height="{height}" rx="6" fill="#ffffff"/>'
    return "\n".join([head, TIP, ground, *parts, "</svg>"]) + "\n"


def text(x: float, y: float, said: str | Sequence[str], more: str = "", size: float = 14) -> str:
    """Write one line, or several below each other; `more` holds other attributes."""
    rows = [said] if isinstance(said, str) else said
    place = [f'x="{x:g}" y="{y + 1.4 * size * k:g}" font-size="{size:g}"' for k in range(len(rows))]
    return "\n".join(f"<text {at} {more}>{escape(one)}</text>" for at, one in zip(place, rows, strict=True))


def path(points: Sequence[tuple[float, float]], more: str = 'fill="none"') -> str:
    """Draw a line through points."""
    drawn = " L".join(f"{x:.4g},{y:.4g}" for x, y in points)
    return f'<path d="M{drawn}" stroke="{INK}" {more}/>'


def arrow(*points: tuple[float, float]) -> str:
    """Draw an arrow through points."""
    return path(points, 'fill="none" stroke-width="1.5" marker-end="url(#tip)"')


def circle(x: float, y: float, radius: float, more: str = 'fill="none"') -> str:
    """Draw a circle."""
    return f'<circle cx="{x:.5g}" cy="{y:.5g}" r="{radius:g}" stroke="{INK}" {more}/>'


def box(x: float, y: float, width: float, height: float, more: str = 'fill="none"') -> str:
    """Draw a box about its centre."""
    corner = f'x="{x - width / 2:.5g}" y="{y - height / 2:.5g}"'
    return f'<rect {corner} width="{width:.5g}" height="{height:.5g}" stroke="{INK}" {more}/>'


def shipped() -> tuple[Grounding, Problem, SceneObject, Palette]:
    """Read the domain, the task, the object that its plan moves, and the colours of categories."""
    grounding = Grounding.load(DOMAIN / "grounding.json")
    problem = Problem.load(DOMAIN / f"problems/{TASK}.scene.json")
    (item,) = [one for one in problem.objects if one.name == ITEM]
    return grounding, problem, item, Palette.of(grounding.operators.categories)


def learning() -> str:
    """Draw the network with its true sizes, and what it says of one action on one object."""
    weights, about = read_tensors(DOMAIN / "effect_model.safetensors", "neurosym-effect-model-3")
    trained = json.loads((DOMAIN / "training.json").read_text())
    grounding, _, item, palette = shipped()
    (primitive,) = [one for one in grounding.operators.primitives if one.label == MOTION]
    bits, hidden = (item.category, primitive.symbol), about["config"]["hidden"]
    layer = np.concatenate([signs(one) for one in bits])
    for number in (0, 3, 6, 9):
        layer = weights[f"decoder.{number}.weight"].reshape(-1, len(layer)) @ layer
        layer = layer + weights[f"decoder.{number}.bias"]
        layer = layer if number == 9 else np.maximum(layer, 0)
    effect = 1000 * (layer[:3] * weights["effect_std"] + weights["effect_mean"])
    sizes = [
        f"along x {1000 * item.features[0]:.0f} mm",
        f"along y {1000 * item.features[1]:.0f} mm",
        f"height {1000 * item.features[2]:.0f} mm",
        f"type {item.features[3]:g}",
    ]
    ways = [
        f"{1000 * x:+.0f}, {1000 * y:+.0f}, {1000 * z:+.0f} mm, {'open' if grip >= 0.5 else 'closed'}"
        for x, y, z, grip in np.array(primitive.action).reshape(-1, 4)
    ]
    parts = []
    for top, head, rows, code, colour in (
        (40, f"object: {len(item.features)} features", sizes, bits[0], palette.hex(item.category)),
        (200, f"action: {len(primitive.action)} numbers", ways, bits[1], SOFT),
    ):
        parts += [
            text(16, top, head, BOLD),
            text(16, top + 22, rows, size=13),
            arrow((178, top + 40), (206, top + 40)),
        ]
        parts += [
            path(
                [(208, top - 20), (208, top + 100), (318, top + 65), (318, top + 15), (208, top - 20)],
                f'fill="{PALE}"',
            ),
            text(262, top + 37, ["encoder", f"3 x {hidden}"], MIDDLE, 13),
        ]
        parts += [arrow((318, top + 40), (346, top + 40))]
        start = top + 40 - 15 * (len(code) - 1)
        for k, bit in enumerate(code):
            parts += [
                box(364, start + 30 * k, 26, 26, f'fill="none" style="stroke:{colour}" stroke-width="4"')
            ]
            parts += [text(364, start + 30 * k + 6, bit, f"{MIDDLE} {BOLD} {MONO}", 17)]
        parts += [arrow((380, top + 40), (410, top + 40), (438, 160 + (top - 120) / 4))]
    r2 = [f"{trained[key]:.2f}" for key in ("r2_through_codes", "r2_direct")]
    share = f"R2 on held-out interactions: {r2[0]} through the bits, {r2[1]} without a bottleneck"
    codes = f"{2 ** len(bits[0])} codes of objects x {2 ** len(bits[1])} of actions"
    return svg(
        368,
        "A network that predicts effects through a few bits",
        [
            *parts,
            path([(440, 125), (440, 195), (550, 225), (550, 95), (440, 125)], f'fill="{PALE}"'),
            text(495, 156, ["decoder", f"3 x {hidden}"], MIDDLE, 13),
            arrow((550, 160), (580, 160)),
            text(590, 126, "effect, predicted", BOLD),
            text(590, 150, [f"{a} {v:+.0f} mm" for a, v in zip("xyz", effect, strict=True)], size=13),
            text(590, 208, "and how sure of each", size=13),
            text(364, 18, "the bits are the symbols", f"{MIDDLE} {BOLD}"),
            text(WIDTH / 2, 335, [f"Nothing else passes: {codes}.", f"{share}."], MIDDLE, 13),
        ],
    )


def pddl() -> str:
    """Draw one step of a shipped plan in words, in PDDL and on the table."""
    grounding, problem, _, palette = shipped()
    run = json.loads((DOMAIN / f"runs/{TASK}.fast-downward.run.json").read_text())
    (at,) = [k for k, step in enumerate(run["steps"]) if step["object"] == ITEM]
    step, plan = run["steps"][at], (DOMAIN / f"plans/{TASK}.fast-downward.plan").read_text().splitlines()
    operator = grounding.operator_named(step["operator"])
    (schema,) = re.findall(
        r"\(:action push .*?\n(?=  \(:action)", (DOMAIN / "domain.pddl").read_text(), flags=re.S
    )
    schema = re.sub(r" - [\w-]+| ;.*", "", schema)
    printed = [
        row
        for line in schema.splitlines()
        for row in textwrap.wrap(
            re.sub(r"\([^():]*\)", lambda one: one[0].replace(" ", "\xa0"), line.strip()),
            38,
            break_on_hyphens=False,
            initial_indent="  " * (line[2] == " "),
            subsequent_indent="    ",
        )
    ]
    steps = [line for line in plan if line.split()[1] == ITEM and not line.startswith("(reach")]
    name = operator.name[: operator.name.index(f"-{operator.label}")].replace("-", " ")
    words = [
        f"{name}: {ITEM}",
        "",
        *textwrap.wrap(f"promised: {displacement_in_words(step['promised_effect'])}", 24),
        *textwrap.wrap(f"kept in {operator.successes} of {operator.trials} rehearsals", 24),
        "",
        *textwrap.wrap(f"{operator.label}: the action's bits, and which of its parameters", 24),
        *textwrap.wrap(
            f"category of {ITEM}: {operator.name.split(operator.label + '-')[1]}, with its bits", 24
        ),
        "",
        *textwrap.wrap(f"happened: {displacement_in_words(step['effect'])}", 24),
    ]
    before = (
        {one.name: one.position for one in problem.objects} if at == 0 else run["steps"][at - 1]["positions"]
    )
    start = before[ITEM]
    promised = [a + b for a, b in zip(start, step["promised_effect"], strict=True)]
    return svg(
        400,
        f"One step of the plan for {TASK}: in words, in PDDL, and on the table",
        [
            text(16, 28, "in words", BOLD),
            text(16, 54, words, size=13),
            text(206, 28, "in PDDL", BOLD),
            text(206, 54, steps, f"{MONO} xml:space='preserve'", 12.5),
            text(206, 112, "the first, as domain.pddl has it", f'fill="{SOFT}"', 13),
            text(206, 134, printed, f"{MONO} xml:space='preserve'", 12.5),
            text(530, 28, "on the table, from above", BOLD),
            *table(problem, before, grounding, palette, (665, 120), []),
            text(530, 120, "before", size=13),
            *table(problem, step["positions"], grounding, palette, (665, 300), [start, promised]),
            text(530, 300, "after", size=13),
        ],
    )


def table(
    problem: Problem,
    places: Mapping[str, Sequence[float]],
    grounding: Grounding,
    palette: Palette,
    centre: tuple[float, float],
    way: Sequence[Sequence[float]],
) -> Iterable[str]:
    """Draw the table from above, left to the left and forward up, with the object at hand and its way."""
    (low, high), (right, left) = grounding.table.x, grounding.table.y
    scale = 160 / (high - low)

    def seen(x: float, y: float) -> tuple[float, float]:
        return centre[0] - scale * (y - (right + left) / 2), centre[1] - scale * (x - (low + high) / 2)

    yield box(*centre, scale * (left - right), scale * (high - low), f'fill="{PALE}"')
    for one in problem.objects:
        spot, sizes = seen(*places[one.name][:2]), (scale * one.features[1], scale * one.features[0])
        more = 'stroke-width="2.5"' if one.name == ITEM else 'fill-opacity="0.45" stroke-opacity="0.5"'
        yield box(*spot, *sizes, f'fill="{palette.hex(one.category)}" {more}')
        if one.name == ITEM:
            yield text(spot[0], spot[1] - sizes[1] / 2 - 5, ITEM, MIDDLE, 12)
            yield box(*seen(*way[0][:2]), *sizes, 'fill="none" stroke-dasharray="4 3"') if way else ""
    if way:
        yield arrow(*(seen(*one[:2]) for one in way))


SERIES = (
    "carried to places, with replanning",
    "carried to places, followed blindly",
    "pushed and lifted, with replanning",
)


def planning() -> str:
    """Draw the share of goals that are reached by the number of objects, with Wilson intervals."""
    carried = json.loads((RESULTS / "places.json").read_text())["table"]
    pushed = json.loads((RESULTS / "planning.json").read_text())
    cells = {n: carried[f"all {n}"] for n in (1, 2, 4, 8)}
    shares = [
        {n: (float(np.mean(cell[how])), cell["tasks"]) for n, cell in cells.items()}
        for how in ("replanned", "blind")
    ]
    shares += [
        {int(n): (share, pushed["far_details"][n]["tasks"]) for n, share in pushed["far_goals"].items()}
    ]

    def seen(n: int, share: float) -> tuple[float, float]:
        return 90 + 150 * (n.bit_length() - 1), 310 - 260 * share

    parts = [
        text(16, 28, "goals anywhere on the table: share reached within 50 mm", BOLD),
        text(315, 358, "objects", MIDDLE, 13),
    ]
    for k in range(0, 101, 25):
        parts += [path([(70, seen(1, k / 100)[1]), (560, seen(1, k / 100)[1])], 'stroke-opacity="0.15"')]
        parts += [text(62, seen(1, k / 100)[1] + 5, f"{k} %", 'text-anchor="end"', 13)]
    parts += [text(seen(n, 0)[0], 332, str(n), MIDDLE) for n in cells]
    for k, (name, series, dash) in enumerate(zip(SERIES, shares, ("none", "7 4", "2 4"), strict=True)):
        parts += [
            path(
                [seen(n, share) for n, (share, _) in series.items()],
                f'fill="none" stroke-width="2" stroke-dasharray="{dash}"',
            )
        ]
        for n, (share, tasks) in series.items():
            (x, y), ends = seen(n, share), wilson(round(share * tasks), tasks)
            parts += [
                path(
                    [(x + 4 * k - 4, seen(n, end)[1]) for end in ends],
                    'stroke-width="1.2" stroke-opacity="0.6"',
                )
            ]
            parts += [circle(x, y, 4, f'fill="{(INK, "#ffffff", SOFT)[k]}"')]
        (x, y), share = seen(max(series), series[max(series)][0]), series[max(series)][0]
        place = (x + 14, y + (5 if k < 2 else 36)) if k < 2 else (398, 138)
        parts += [
            text(
                *place,
                [f"{share:.0%}".replace("%", " %"), *textwrap.wrap(name, 20)]
                if k < 2
                else textwrap.wrap(name, 12),
                size=13,
            )
        ]
    return svg(372, "Share of goals reached by the number of objects", parts)


def world() -> str:
    """Draw what two operators promise, and where their rehearsals ended."""
    grounding, _, _, palette = shipped()
    parts = []
    for middle, name in zip((190, 570), OPERATORS, strict=True):
        operator = grounding.operator_named(name)
        rehearsals, promise = operator.rehearsals[: operator.trials], operator.promise
        assert promise is not None

        def seen(effect: Sequence[float], middle: float = middle) -> tuple[float, float]:
            return middle - 1500 * effect[1], 235 - 1500 * effect[0]

        there, start = seen(promise.outcome), seen((0, 0))
        parts += [
            text(middle, 28, name, f"{MIDDLE} {BOLD}"),
            circle(*there, 75, f'fill="{PALE}" stroke-dasharray="5 4"'),
        ]
        parts += [
            box(*start, 12, 12),
            text(start[0] - 14, start[1] + 28, "start", size=13),
            arrow(start, there),
        ]
        for one in rehearsals:
            kept = (
                one.kind == promise.kind and np.linalg.norm(np.subtract(one.outcome, promise.outcome)) <= 0.05
            )
            x, y = seen(one.outcome)
            mark = circle(x, y, 3.5, f'fill="{palette.hex(operator.category)}"')
            parts += [
                mark
                if kept
                else path([(x - 4, y - 4), (x + 4, y + 4)]) + path([(x - 4, y + 4), (x + 4, y - 4)])
            ]
        told = f"promise kept in {operator.successes} of {operator.trials} rehearsals"
        parts += [text(middle, 322, [told, displacement_in_words(promise.outcome)], MIDDLE, 13)]
    note = "dashed: 50 mm about the promise; dots: rehearsals that ended there; crosses: those that did not"
    return svg(
        390,
        "Promises of two operators, and how their rehearsals ended",
        [*parts, text(WIDTH / 2, 374, note, MIDDLE, 13)],
    )


DRAWINGS = (learning, pddl, planning, world)


if __name__ == "__main__":
    for draw in DRAWINGS:
        (PICTURES / f"{draw.__name__}.svg").write_text(draw())
