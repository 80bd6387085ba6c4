"""The panel `Symbols`: what operators and motions do to an object, and all that was explored."""

from functools import partial
from typing import Any

import numpy as np
import viser

from neurosym.arrays import Float
from neurosym.explain.action_words import displacement_in_words
from neurosym.studio.desk import Topic
from neurosym.studio.overlays import LIFT, PUSH
from neurosym.studio.panel import Panel, by_user, set_content, set_options, set_value
from neurosym.studio.symbols import Promise, promises_for, rehearsal_dots
from neurosym.studio.words import DIM, coloured, paragraph, safe, table

NONE = "(none)"
MOST_ROWS = 2000
"""So many interactions are drawn, evenly chosen among all."""
NEAR = 0.015
"""How near to the pointer's line an interaction must lie to be meant [m]."""
_OVER = 0.05  # how far above its object an arrow begins, so that nothing hides it [m]


class SymbolsPanel(Panel):
    """Bits are on the panel `Table`, beside the sizes that decide them; here is what they lead to."""

    def build(self) -> None:
        """Make the fields."""
        gui = self.gui
        self._promises: tuple[Promise, ...] = ()
        self._action: Float[np.ndarray, "A"] = np.zeros(0)
        self._cloud: Float[np.ndarray, "N 3"] = np.zeros((0, 3))
        self._rows: np.ndarray = np.zeros(0, dtype=int)
        self._arrows = gui.add_checkbox("Arrows: where operators take it", False)
        self._arrows.on_update(by_user(lambda _: self._show_arrows()))
        self._operator = gui.add_dropdown("Operator", (NONE,), hint="Shows its waypoints and rehearsals.")
        self._operator.on_update(by_user(self._choose))
        self._said = gui.add_html("")
        with gui.add_folder("Its waypoints", expand_by_default=True):
            self._points = [
                gui.add_vector3(f"Waypoint {number}", (0.0, 0.0, 0.0), step=0.005, visible=False)
                for number in (1, 2, 3)
            ]
            for number, field in enumerate(self._points):
                field.on_update(by_user(partial(self._moved, number)))
            self._expected = gui.add_html("")
            self._try = self.button("Try this motion", self.perform, visible=False)
        with gui.add_folder("All that was explored", expand_by_default=False):
            show = gui.add_checkbox(
                "Show the cloud of effects", False, hint="Click a point to see it happen."
            )
            show.on_update(by_user(self._show_cloud))
            self._row = gui.add_number("Interaction", 0, min=0, step=1)
            self.button("See it happen", lambda: self.session.running.recall(int(self._row.value)))
        self.page.server.scene.on_click()(self._clicked)
        self._table = gui.add_html("")

    def refresh(self, topics: set[Topic]) -> None:
        """Show what operators do to the object that is chosen."""
        item = self.page.item
        if item is None or not topics & {"scene", "place"} or self.session.running.is_active:
            return
        if "scene" in topics:
            self._promises = promises_for(item, self.session.library)
            names = (NONE, *(one.operator.name for one in self._promises))
            if self._operator.options != names:
                set_options(self._operator, names, NONE)
                self._choose(NONE)
            set_content(self._table, self.text())
        self._show_arrows()
        if self._operator.value != NONE:
            self._draw_motion()

    def text(self) -> str:
        """Return what the operators promise for the object, as HTML."""
        rows = [
            (
                str(number),
                f"{safe(one.operator.name)}<br>{coloured(displacement_in_words(one.effect), DIM)}",
                f"<code>{safe(one.operator.primitive)}</code>",
                f"{one.chance:.0%}",
            )
            for number, one in enumerate(self._promises, start=1)
        ]
        head = paragraph(safe(f"What can be done to {self.page.selected}:")) if rows else ""
        return head + (table(("", "operator", "bits", "chance"), rows, label="operators") if rows else "")

    def perform(self) -> None:
        """Try the motion as it is drawn."""
        self.session.running.perform(self.page.selected, tuple(map(float, self._action)))

    def _show_arrows(self) -> None:
        item = self.page.item
        if not self._arrows.value or item is None:
            self.page.overlays.clear("arrows")
            return
        x, y, z = item.position
        start = (x, y, z + item.features[2] / 2 + _OVER)
        self.page.overlays.arrows(start, [(one.effect, one.lifts) for one in self._promises])

    def _choose(self, name: str) -> None:
        """Take over the waypoints of an operator."""
        library, item = self.session.library, self.page.item
        promise = next((one for one in self._promises if one.operator.name == name), None)
        for field in (*self._points, self._try):
            field.visible = promise is not None and item is not None
        if promise is None or item is None:
            for layer in ("waypoints", "rehearsals"):
                self.page.overlays.clear(layer)
            for said in (self._said, self._expected):
                set_content(said, "")
            return
        self._action = np.array(library.grounding.primitive_of(promise.operator).action)
        points, colours = rehearsal_dots(promise.operator, item.position, library)
        self.page.overlays.dots(points, colours, "rehearsals")
        kept = f"{len(points)} rehearsals as dots: green as promised, red otherwise" if len(points) else ""
        bits = f"{item.category} · {promise.operator.primitive}"
        moves = displacement_in_words(promise.effect)
        set_content(self._said, paragraph(f"<code>{safe(bits)}</code>", safe(f"promises {moves}. {kept}")))
        self._draw_motion(anew=True)

    def _is_hand(self) -> bool:
        return len(self._action) == 12

    def _draw_motion(self, *, anew: bool = False) -> None:
        """Draw the waypoints, and say what the network expects of them."""
        item = self.page.item
        if item is None or not self._is_hand():
            return
        points = self._action.reshape(3, 4)[:, :3]
        for field, point in zip(self._points, points.tolist(), strict=True):
            set_value(field, tuple(round(part, 4) for part in point))
        drawn = points + np.array(item.position)
        if anew:
            self.page.overlays.waypoints(drawn, self._dragged)
        else:
            self.page.overlays.follow(drawn)
        said, motion = "", self.session.library.expect(item.features, self._action)
        if motion is not None:
            bits, direct = (displacement_in_words(one) for one in (motion.expected, motion.direct))
            symbol = f"This motion has the symbol {motion.symbol}. By the bits the network expects: {bits}."
            said = paragraph(safe(symbol), coloured(f"Before the bits: {direct}.", DIM))
        set_content(self._expected, said)

    def _dragged(self, number: int, at: tuple[float, float, float]) -> None:
        item = self.page.item
        if item is not None:
            self._moved(number, tuple(np.subtract(at, item.position).tolist()))

    def _moved(self, number: int, at: tuple[float, ...]) -> None:
        """Put a waypoint somewhere relative to the object [m], inside the box of actions."""
        if not self._is_hand():
            return
        box, columns = self.session.library.world.action_box, slice(4 * number, 4 * number + 3)
        action = self._action.copy()
        action[columns] = np.clip(at, box.low[columns], box.high[columns])
        self._action = action
        self._draw_motion()

    def _show_cloud(self, is_shown: bool) -> None:
        """Draw the effects of the data as points over the middle of the table."""
        self.page.overlays.clear("cloud")
        self._cloud = np.zeros((0, 3))
        data = self.session.library.interactions
        if not is_shown:
            return
        if data is None or data.effects.shape[1] != 3:
            self.session.say("This domain brings no data of where objects went.", is_bad=True)
            return
        self._rows = np.unique(np.linspace(0, len(data) - 1, min(len(data), MOST_ROWS)).astype(int))
        x, y = self.session.library.middle
        self._cloud = data.effects[self._rows].astype(float) + np.array([x, y, 0.05])
        kinds = data.held[self._rows][:, None]
        colours = np.where(kinds, np.array([LIFT]), np.array([PUSH]))
        self.page.overlays.dots(self._cloud, colours.astype(float), "cloud")

    def _clicked(self, event: viser.SceneClickEvent) -> None:
        row = self.row_at(event.ray_origin, event.ray_direction)
        if row is not None and not self.session.running.is_active:
            set_value(self._row, row)
            self.session.running.recall(row)

    def row_at(self, eye: Any, ray: Any) -> int | None:
        """Return which interaction of the cloud a line of sight meets, if any is near enough."""
        if not len(self._cloud):
            return None
        along = np.array(ray, dtype=float) / np.linalg.norm(ray)
        away = self._cloud - np.array(eye, dtype=float)
        apart = np.linalg.norm(away - np.outer(away @ along, along), axis=1)
        nearest = int(np.argmin(apart))
        return int(self._rows[nearest]) if apart[nearest] <= NEAR else None
