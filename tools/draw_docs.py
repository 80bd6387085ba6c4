"""Draw the pictures that open pages of docs/, from what is shipped and measured."""

import json
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cache, wraps
from textwrap import wrap
from xml.sax.saxutils import escape

import numpy as np

from neurosym.grounding import Grounding
from neurosym.learning.network import EffectModel
from neurosym.problems import Problem, SceneObject
from neurosym.report.symbol_map import atlas_of
from neurosym.report.symbol_sheet import symbol_sheet
from neurosym.report.symbols import displacement_in_words
from neurosym.stages.verdicts import wilson
from neurosym.world import Palette
from neurosym.worlds.world_file import read_world
from tools.benchmarks.options import ROOT

PICTURES, RESULTS, DOMAIN = ROOT / "docs/images", ROOT / "docs/results", ROOT / "domains/tabletop"
TASK, ITEM, MOTION = "task-19", "item-08", "1010b"  # the step that the pictures show
OPERATORS = "push-right-1010b-hollow-wide-01", "push-forward-1011-solid-00"  # a sure one, and one that is not
WIDTH = 760  # pixels
INK, SOFT, PALE = "#1d1d1d", "#555555", "#efefef"
MIDDLE, BOLD, MONO = 'text-anchor="middle"', 'font-weight="bold"', 'font-family="monospace"'
PRINTED, BARE = f"{MONO} xml:space='preserve'", 'fill="none"'
TIP = (
    '<defs><marker id="tip" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" markerHeight="7" '
    f'orient="auto"><path d="M0,0 L8,4 L0,8 z" fill="{INK}"/></marker></defs>'
)
Point = tuple[float, float]


def picture(height: int, title: str) -> Callable[[Callable[[], Iterable[str]]], Callable[[], str]]:
    """Put parts on a ground of their own, so that light and dark pages show the picture alike."""
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" '
        f'height="{height}" font-family="sans-serif" fill="{INK}" role="img"><title>{escape(title)}</title>'
    )
    ground = f'<rect width="{WIDTH}" height="{height}" rx="6" fill="#ffffff"/>'

    def drawn_by(parts: Callable[[], Iterable[str]]) -> Callable[[], str]:
        return wraps(parts)(lambda: "\n".join([head, TIP, ground, *parts(), "</svg>"]) + "\n")

    return drawn_by


def text(x: float, y: float, said: str | Sequence[str], more: str = "", size: float = 14) -> str:
    """Write one line, or several below each other; `more` holds other attributes."""
    rows = [said] if isinstance(said, str) else said
    place = [f'x="{x:g}" y="{y + 1.4 * size * k:g}" font-size="{size:g}"' for k in range(len(rows))]
    return "\n".join(f"<text {at} {more}>{escape(one)}</text>" for at, one in zip(place, rows, strict=True))


def path(points: Sequence[Point], more: str = BARE) -> str:
    """Draw a line through points."""
    drawn = " L".join(f"{x:.4g},{y:.4g}" for x, y in points)
    return f'<path d="M{drawn}" stroke="{INK}" {more}/>'


def arrow(*points: Point) -> str:
    """Draw an arrow through points."""
    return path(points, f'{BARE} stroke-width="1.5" marker-end="url(#tip)"')


def circle(x: float, y: float, radius: float, more: str) -> str:
    """Draw a circle."""
    return f'<circle cx="{x:.5g}" cy="{y:.5g}" r="{radius:g}" stroke="{INK}" {more}/>'


def box(x: float, y: float, width: float, height: float, more: str = BARE) -> str:
    """Draw a box about its centre."""
    corner = f'x="{x - width / 2:.5g}" y="{y - height / 2:.5g}"'
    return f'<rect {corner} width="{width:.5g}" height="{height:.5g}" stroke="{INK}" {more}/>'


def network(name: str, hidden: int, place: Point, *corners: Point) -> Iterator[str]:
    """Draw a network through its corners, with its name at a place."""
    yield path([*corners, corners[0]], f'fill="{PALE}"')
    yield text(*place, [name, f"3 x {hidden}"], MIDDLE, 13)


@cache
def shipped() -> tuple[Grounding, Problem, SceneObject, Palette]:
    """Read the domain, the task, the object that its plan moves, and the colours of categories."""
    grounding = Grounding.load(DOMAIN / "grounding.json")
    problem = Problem.load(DOMAIN / f"problems/{TASK}.scene.json")
    return grounding, problem, problem.object_named(ITEM), Palette.of(grounding.objects.categories)


@picture(368, "A network that predicts effects through a few bits")
def learning() -> Iterator[str]:
    """Draw the network with its true sizes, and what it says of one action on one object."""
    model, trained = EffectModel.load(DOMAIN / "effect_model.safetensors"), DOMAIN / "training.json"
    grounding, _, item, palette = shipped()
    (primitive,) = [one for one in grounding.objects.primitives if one.label == MOTION]
    bits, hidden = (item.category, primitive.symbol), model.config.hidden
    effect = 1000 * model.branching_table(np.array([item.features]), [primitive.symbol])[0, 0]
    named = zip(("along x", "along y", "height"), item.features, strict=False)
    sizes = [*(f"{name} {1000 * size:.0f} mm" for name, size in named), f"type {item.features[3]:g}"]
    ways = [
        f"{1000 * x:+.0f}, {1000 * y:+.0f}, {1000 * z:+.0f} mm, {'open' if grip >= 0.5 else 'closed'}"
        for x, y, z, grip in np.array(primitive.action).reshape(-1, 4)
    ]
    for top, head, rows, code, colour in (
        (40, f"object: {len(item.features)} features", sizes, bits[0], palette.hex(item.category)),
        (200, f"action: {len(primitive.action)} numbers", ways, bits[1], SOFT),
    ):
        yield text(16, top, head, BOLD)
        yield text(16, top + 22, rows, size=13)
        yield arrow((178, top + 40), (206, top + 40))
        corners = (208, top - 20), (208, top + 100), (318, top + 65), (318, top + 15)
        yield from network("encoder", hidden, (262, top + 37), *corners)
        yield arrow((318, top + 40), (346, top + 40))
        for k, bit in enumerate(code, -len(code) + 1):
            y = top + 40 + 15 * (len(code) - 1) + 30 * k
            yield box(364, y, 26, 26, f'{BARE} style="stroke:{colour}" stroke-width="4"')
            yield text(364, y + 6, bit, f"{MIDDLE} {BOLD} {MONO}", 17)
        yield arrow((380, top + 40), (410, top + 40), (438, 160 + (top - 120) / 4))
    yield from network("decoder", hidden, (495, 156), (440, 125), (440, 195), (550, 225), (550, 95))
    yield arrow((550, 160), (580, 160))
    yield text(590, 126, "effect, predicted", BOLD)
    yield text(590, 150, [f"{a} {v:+.0f} mm" for a, v in zip("xyz", effect, strict=True)], size=13)
    yield text(590, 208, "and how sure of each", size=13)
    yield text(364, 18, "the bits are the symbols", f"{MIDDLE} {BOLD}")
    codes = f"{2 ** len(bits[0])} codes of objects x {2 ** len(bits[1])} of actions"
    r2 = [f"{json.loads(trained.read_text())[key]:.2f}" for key in ("r2_through_codes", "r2_direct")]
    share = f"R2 on held-out interactions: {r2[0]} through the bits, {r2[1]} without a bottleneck"
    yield text(WIDTH / 2, 335, [f"Nothing else passes: {codes}.", f"{share}."], MIDDLE, 13)


@picture(400, f"One step of the plan for {TASK}: in words, in PDDL, and on the table")
def pddl() -> Iterator[str]:
    """Draw one step of a shipped plan in words, in PDDL and on the table."""
    grounding, problem, *_ = shipped()
    run = json.loads((DOMAIN / f"runs/{TASK}.fast-downward.run.json").read_text())
    (at,) = [k for k, step in enumerate(run["steps"]) if step["object"] == ITEM]
    step, plan = run["steps"][at], (DOMAIN / f"plans/{TASK}.fast-downward.plan").read_text().splitlines()
    operator = grounding.operator_named(step["operator"])
    name, _, kind = operator.name.partition(f"-{operator.label}-")
    words = [
        f"promised: {displacement_in_words(step['promised_effect'])}",
        f"kept in {operator.successes} of {operator.trials} rehearsals",
        f"{operator.label}: the action's bits, and which of its parameters",
        f"category of {ITEM}: {kind}, with its bits",
        f"happened: {displacement_in_words(step['effect'])}",
    ]
    promised, kept, label, category, happened = (wrap(one, 24) for one in words)
    rows = [f"{name.replace('-', ' ')}: {ITEM}", "", *promised, *kept, "", *label, *category, "", *happened]
    yield text(16, 28, "in words", BOLD)
    yield text(16, 54, rows, size=13)
    yield text(206, 28, "in PDDL", BOLD)
    shown = [line for line in plan if line.split()[1] == ITEM and not line.startswith("(reach")]
    yield text(206, 54, shown, PRINTED, 12.5)
    yield text(206, 112, "the first, as domain.pddl has it", f'fill="{SOFT}"', 13)
    yield text(206, 134, _schema("push"), PRINTED, 12.5)
    yield text(530, 28, "on the table, from above", BOLD)
    start = {one.name: one.position for one in problem.objects}
    before = run["steps"][at - 1]["positions"] if at else start
    promise = np.add(before[ITEM], step["promised_effect"])
    yield from table(before, (665, 120))
    yield text(530, 120, "before", size=13)
    yield from table(step["positions"], (665, 300), before[ITEM], promise)
    yield text(530, 300, "after", size=13)


def _schema(action: str) -> list[str]:
    """Return an action as the domain has it, without types and comments, in short lines."""
    printed = (DOMAIN / "domain.pddl").read_text()
    (schema,) = re.findall(rf"\(:action {action} .*?\n(?=  \(:action)", printed, flags=re.S)
    rows = list[str]()
    for line in re.sub(r" - [\w-]+| ;.*", "", schema).splitlines():
        whole = re.sub(r"\([^():]*\)", lambda one: one[0].replace(" ", "\xa0"), line.strip())
        begin = "  " * (line[2] == " ")
        rows += wrap(whole, 38, break_on_hyphens=False, initial_indent=begin, subsequent_indent="    ")
    return rows


def table(places: Mapping[str, Sequence[float]], centre: Point, *way: Sequence[float]) -> Iterable[str]:
    """Draw the table from above, left to the left and forward up, with the object at hand and its way."""
    grounding, problem, _, palette = shipped()
    (low, high), (right, left) = grounding.table.x, grounding.table.y
    scale = 160 / (high - low)

    def seen(x: float, y: float) -> Point:
        return centre[0] - scale * (y - (right + left) / 2), centre[1] - scale * (x - (low + high) / 2)

    yield box(*centre, scale * (left - right), scale * (high - low), f'fill="{PALE}"')
    for one in problem.objects:
        spot, sizes = seen(*places[one.name][:2]), (scale * one.features[1], scale * one.features[0])
        more = 'stroke-width="2.5"' if one.name == ITEM else 'fill-opacity="0.45" stroke-opacity="0.5"'
        yield box(*spot, *sizes, f'fill="{palette.hex(one.category)}" {more}')
        if one.name == ITEM:
            yield text(spot[0], spot[1] - sizes[1] / 2 - 5, ITEM, MIDDLE, 12)
            yield box(*seen(*way[0][:2]), *sizes, f'{BARE} stroke-dasharray="4 3"') if way else ""
    if way:
        yield arrow(*(seen(*one[:2]) for one in way))


@picture(372, "Share of goals reached by the number of objects")
def planning() -> Iterator[str]:
    """Draw the share of goals that are reached by the number of objects, with Wilson intervals."""
    carried = json.loads((RESULTS / "places.json").read_text())["table"]
    pushed = json.loads((RESULTS / "planning.json").read_text())
    cells, tasks = {n: carried[f"all {n}"] for n in (1, 2, 4, 8)}, pushed["far_details"]
    replanned, blind = (
        {n: (float(np.mean(cell[how])), cell["tasks"]) for n, cell in cells.items()}
        for how in ("replanned", "blind")
    )
    led = {int(n): (share, tasks[n]["tasks"]) for n, share in pushed["far_goals"].items()}

    def seen(n: int, share: float) -> Point:
        return 90 + 150 * (n.bit_length() - 1), 310 - 260 * share

    yield text(16, 28, "goals anywhere on the table: share reached within 50 mm", BOLD)
    yield text(315, 358, "objects", MIDDLE, 13)
    for k in range(0, 101, 25):
        y = seen(1, k / 100)[1]
        yield path([(70, y), (560, y)], 'stroke-opacity="0.15"')
        yield text(62, y + 5, f"{k} %", 'text-anchor="end"', 13)
    for n in cells:
        yield text(seen(n, 0)[0], 332, str(n), MIDDLE)
    for k, (name, series, dash, fill) in enumerate(
        (
            ("carried to places, with replanning", replanned, "none", INK),
            ("carried to places, followed blindly", blind, "7 4", "#ffffff"),
            ("pushed and lifted, with replanning", led, "2 4", SOFT),
        )
    ):
        points = [seen(n, share) for n, (share, _) in series.items()]
        yield path(points, f'{BARE} stroke-width="2" stroke-dasharray="{dash}"')
        for n, (share, of) in series.items():
            (x, y), ends = seen(n, share), wilson(round(share * of), of)
            interval = [(x + 4 * k - 4, seen(n, end)[1]) for end in ends]
            yield path(interval, 'stroke-width="1.2" stroke-opacity="0.6"')
            yield circle(x, y, 4, f'fill="{fill}"')
        (x, y), share = points[-1], series[max(series)][0]
        if series is led:
            yield text(398, 138, wrap(name, 12), size=13)
        else:
            yield text(x + 14, y + 5, [f"{100 * share:.0f} %", *wrap(name, 20)], size=13)


@picture(390, "Promises of two operators, and how their rehearsals ended")
def world() -> Iterator[str]:
    """Draw what two operators promise, and where their rehearsals ended."""
    grounding, _, _, palette = shipped()
    for middle, name in zip((190, 570), OPERATORS, strict=True):
        operator = grounding.operator_named(name)
        promise = operator.promise
        assert promise is not None

        def seen(effect: Sequence[float], middle: float = middle) -> Point:
            return middle - 1500 * effect[1], 235 - 1500 * effect[0]

        there, start = seen(promise.outcome), seen((0, 0))
        yield text(middle, 28, name, f"{MIDDLE} {BOLD}")
        yield circle(*there, 75, f'fill="{PALE}" stroke-dasharray="5 4"')
        yield box(*start, 12, 12)
        yield text(start[0] - 14, start[1] + 28, "start", size=13)
        yield arrow(start, there)
        for one in operator.rehearsals[: operator.trials]:
            x, y = seen(one.outcome)
            off = np.linalg.norm(np.subtract(one.outcome, promise.outcome))
            if one.kind == promise.kind and off <= 0.05:
                yield circle(x, y, 3.5, f'fill="{palette.hex(operator.subject)}"')
            else:
                slopes = [path([(x - 4, y - 4 * up), (x + 4, y + 4 * up)]) for up in (1, -1)]
                yield "".join(slopes)
        told = f"promise kept in {operator.successes} of {operator.trials} rehearsals"
        yield text(middle, 322, [told, displacement_in_words(promise.outcome)], MIDDLE, 13)
    note = "dashed: 50 mm about the promise; dots: rehearsals that ended there; crosses: those that did not"
    yield text(WIDTH / 2, 374, note, MIDDLE, 13)


def symbols() -> str:
    """Draw the symbols as `neurosym show --symbols` does."""
    categorise = EffectModel.load(DOMAIN / "effect_model.safetensors").object_symbols
    atlas = atlas_of(read_world(DOMAIN / "world.toml")(), categorise)
    return symbol_sheet(atlas, Grounding.load(DOMAIN / "grounding.json"))


DRAWINGS = (learning, pddl, planning, symbols, world)


if __name__ == "__main__":
    for draw in DRAWINGS:
        (PICTURES / f"{draw.__name__}.svg").write_text(draw())
