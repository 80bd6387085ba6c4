"""The panel `Symbols`: the categories and their colours, and what operators do to the object at hand.

Bits are on the panel `Table`, beside the sizes that decide them; here is what they lead to.
"""

from collections.abc import Sequence
from typing import Any

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.report.drawings import effect_drawing, is_body, scale_for
from neurosym.report.symbols import Promise, displacement_in_words, promises_for
from neurosym.studio import words
from neurosym.studio.desk import Topic
from neurosym.studio.page import Page, Panel, heard, set_content, set_options
from neurosym.studio.panels import NOTHING
from neurosym.studio.view import over

ARROWS = "an arrow is filled where the arm holds it at the end, and faint where that is unlikely."
_CELL = (76, 84)  # of the drawing of an effect [pixels]


def arrows(page: Page, promises: Sequence[Promise]) -> list[str]:
    """Draw what operators do to the object that is chosen as arrows on it, all to one scale, as HTML."""
    item, library = page.item, page.session.library
    if item is None:
        return []
    body = item.features if is_body(library.atlas.features) else ()
    look: dict[str, Any] = {"item": body, "colour": page.view.palette(item.category)}
    look |= {"width": _CELL[0], "height": _CELL[1]}
    look["scale"] = scale_for([(one.effect, body) for one in promises], _CELL[1])
    return [
        effect_drawing(
            one.effect, told=words.promise_in_words(one), chance=one.chance, is_held=one.lifts, **look
        )
        for one in promises
    ]


class SymbolsPanel(Panel):
    """What is known of symbols, to be tried."""

    def build(self) -> None:
        """Make the fields."""
        gui, running = self.gui, self.session.running
        self._promises: tuple[Promise, ...] = ()
        self._labels: dict[str, str] = {}  # names of operators, by what they are called here
        self._chosen = ""  # name of the operator that is shown
        self._action: Float[np.ndarray, "A"] = np.zeros(0)
        self._legend = gui.add_html("")
        self._arrows = gui.add_checkbox("Arrows: where operators take it", False)
        heard(self._arrows, lambda _: self._show_arrows())
        self._operator = gui.add_dropdown("Operator", (NOTHING,), hint="Shows its waypoints and rehearsals.")
        heard(self._operator, self._choose)
        self._said = gui.add_html("")
        self._try = self.button("Try this motion", self.perform, visible=False)
        self._often = self.button("Try it 10 times", self.try_ten, visible=False)
        self._stop = self.button("Stop trying", running.stop, visible=False, color="red")
        self._happened = gui.add_html("")
        self._expected = gui.add_html("")
        with gui.add_folder("What if a bit flipped?", expand_by_default=False):
            bits = len(next(iter(self.session.library.grounding.objects.categories)).symbol)
            self._flips = [gui.add_checkbox(f"Flip bit {number}", False) for number in range(1, bits + 1)]
            for flip in self._flips:
                heard(flip, lambda _: self._show_flips())
            self._flipped = gui.add_html("")
        with gui.add_folder("All that was explored", expand_by_default=False):
            row = gui.add_number("Interaction", 0, min=0, step=1)
            self.button("See it happen", lambda: running.recall(int(row.value)))
        self._table = gui.add_html("")

    def refresh(self, topics: set[Topic]) -> None:
        """Show what operators do to the object that is chosen."""
        item = self.page.item
        if item is None or not topics & {"scene", "place", "run", "step"}:
            return
        set_content(self._happened, self.happened())
        self._stop.visible = self.session.is_running
        self._try.disabled = self._often.disabled = self.session.is_running
        if self.session.is_running:
            return
        if "scene" in topics:
            self._promises = promises_for(item, self.session.library.grounding)
            self._labels = {
                f"{number}: {words.promise_in_words(one)}": one.operator.name
                for number, one in enumerate(self._promises, start=1)
            }
            label = next((label for label, name in self._labels.items() if name == self._chosen), NOTHING)
            set_options(self._operator, (NOTHING, *self._labels), label)
            palette = self.page.view.palette
            set_content(self._legend, words.legend(self.session.library.grounding, palette, item.category))
            set_content(self._table, self.text())
            self._show_flips()
        self._show_arrows()
        if topics & {"scene", "run"} and not self.session.running.tries:
            self._choose(str(self._operator.value))
        elif self._chosen:
            self._draw_motion()

    def text(self) -> str:
        """Return what the operators promise for the object, as HTML."""
        rows = [
            (
                str(number),
                drawn,
                words.twofold(words.promise_in_words(one), one.operator.name),
                f"<code>{words.safe(one.operator.primitive)}</code><br>{words.bar(one.chance)}",
            )
            for number, (one, drawn) in enumerate(
                zip(self._promises, arrows(self.page, self._promises), strict=True), start=1
            )
        ]
        head = words.paragraph(f"What can be done to {self.page.selected}: {ARROWS}")
        return (
            head + words.table(("", "", "operator", "bits, chance"), rows, label="operators") if rows else ""
        )

    def happened(self) -> str:
        """Return how the last motion turned out, or how often several did as promised, as HTML."""
        running = self.session.running
        if not running.tries:
            return ""
        if running.promise is None:
            tried = running.tries[-1]
            return words.paragraph(f"{tried.kind}, {words.three_numbers(tried.effect)}", head="it ended")
        kept = sum(one.keeps(running.promise) for one in running.tries) / len(running.tries)
        rows = [("promised", words.bar(running.promise.chance)), ("happened", words.bar(kept))]
        said = "Each dark dot is a try that went as promised, each pale diamond one that went otherwise."
        table = words.table(("", "as promised"), rows, label="promised and happened")
        return words.paragraph(running.tally()) + table + words.paragraph(said, words.DIM)

    def perform(self) -> None:
        """Try the motion as it is drawn."""
        self.session.running.perform(self.page.selected, tuple(map(float, self._action)))

    def try_ten(self) -> None:
        """Try the operator that is chosen ten times, and count how often it does as promised."""
        self.session.running.try_ten(self.page.selected, self._chosen)

    def _show_flips(self) -> None:
        """Show what is promised for the object as it is, and were it of the category with other bits."""
        item, grounding = self.page.item, self.session.library.grounding
        if item is None:
            return
        flips = [flip.value for flip in self._flips]
        bits = zip(item.category, flips, strict=True)
        other = "".join("10"[int(bit)] if flip else bit for bit, flip in bits)
        known = [one.symbol for one in grounding.objects.categories]
        sides = []
        for symbol, when in ((item.category, "as it is"), (other, "flipped"))[: 1 + any(flips)]:
            as_if = msgspec.structs.replace(item, category=symbol)
            promises = promises_for(as_if, grounding) if symbol in known else ()
            sides.append((f"{when}: {words.plain_name(symbol, grounding)} {symbol}", promises))
        set_content(self._flipped, words.what_if(sides))

    def _show_arrows(self) -> None:
        item = self.page.item
        if not self._arrows.value or item is None:
            self.page.overlays.clear("arrows")
            return
        self.page.overlays.arrows(over(item.position, item.features), self._promises)

    def _choose(self, label: str) -> None:
        """Take over the waypoints of an operator, and show as dots where its rehearsals ended."""
        grounding, item, overlays = self.session.library.grounding, self.page.item, self.page.overlays
        name = self._labels.get(label)
        promise = next((one for one in self._promises if one.operator.name == name), None)
        self._chosen = promise.operator.name if promise else ""
        self._try.visible = self._often.visible = promise is not None
        if promise is None or item is None:
            overlays.clear("waypoints")
            overlays.clear("rehearsals")
            set_content(self._said, "")
            set_content(self._expected, "")
            return
        self._action = np.array(grounding.primitive_of(promise.operator).action)
        learned = grounding.operator_named(promise.operator.name)
        kind = learned.promise.kind if learned.promise else None
        seen = learned.rehearsals
        spots = [over(np.add(item.position, one.outcome).tolist(), item.features) for one in seen]
        overlays.dots("rehearsals", [(at, one.kind == kind) for at, one in zip(spots, seen, strict=True)])
        kept = f"{len(seen)} rehearsals: dark dots ended so, pale diamonds otherwise" if seen else ""
        bits = f"{item.category} · {promise.operator.primitive}"
        moves = displacement_in_words(promise.effect)
        said = words.paragraph(f"promises {moves} in {promise.chance:.0%}. {kept}", head=bits)
        set_content(self._said, said + words.paragraph(promise.operator.name, words.DIM))
        self._draw_motion(anew=True)

    def _draw_motion(self, *, anew: bool = False) -> None:
        """Draw the waypoints of a hand, and say what the network expects of them."""
        item = self.page.item
        if item is None or len(self._action) != 12:
            return
        points = self._action.reshape(3, 4)[:, :3] + np.array(item.position)
        if anew:
            self.page.overlays.waypoints(points, self._dragged)
        else:
            self.page.overlays.follow(points)
        said = ""
        if expected := self.session.library.expect(item.features, self._action):
            symbol, bits, direct = expected[0], *map(displacement_in_words, expected[1:])
            told = f"This motion has the symbol {symbol}. By the bits the network expects: {bits}."
            said = words.paragraph(told) + words.paragraph(f"Before the bits: {direct}.", words.DIM)
        set_content(self._expected, said)

    def _dragged(self, number: int, at: tuple[float, float, float]) -> None:
        """Put a waypoint somewhere [m], as far as the box of actions reaches from the object."""
        if (item := self.page.item) is not None:
            box, columns = self.session.library.world.action_box, slice(4 * number, 4 * number + 3)
            spot = np.subtract(at, item.position)
            self._action = self._action.copy()
            self._action[columns] = np.clip(spot, box.low[columns], box.high[columns])
            self._draw_motion()
