"""What panels have in common and are about, and the panels `Run` and `Tour` (six cards for a newcomer)."""

import threading
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import viser

from neurosym.problems import SceneObject
from neurosym.studio.desk import Topic, promises_for
from neurosym.studio.session import Session, usual_planner
from neurosym.studio.view import Overlays
from neurosym.studio.words import paragraph, replanning_list, run_summary, run_table, safe

DARK, LIGHT = (24, 26, 30), (245, 246, 248)


class Board:
    """What panels are about: a session, which of its objects is chosen, and what is drawn over the table.

    Args:
        server: Serves the page of this session and no other.
        session: What is shown.

    Attributes:
        overlays: Layers over the table.
        selected: Name of the object that the panels are about.
    """

    def __init__(self, server: viser.ViserServer, session: Session):
        self.server, self.session = server, session
        self.overlays = Overlays(server.scene)
        self.selected = session.problem.object_names[0] if session.problem else ""
        self._topics: set[Topic] = set()
        self._lock, self._has_changed = threading.Lock(), threading.Event()

    def hear(self, topic: Topic) -> None:
        """Have something drawn soon."""
        with self._lock:
            self._topics.add(topic)
        self._has_changed.set()

    def select(self, name: str) -> None:
        """Choose the object that the panels are about."""
        if self.session.problem and name in self.session.problem.object_names and name != self.selected:
            self.selected = name
            self.hear("scene")

    @property
    def item(self) -> SceneObject | None:
        """The object that the panels are about, if there is any."""
        problem = self.session.problem
        if problem is None:
            return None
        if self.selected not in problem.object_names:
            self.selected = problem.object_names[0]
        return problem.object_named(self.selected)

    def set_dark(self, is_dark: bool) -> None:
        """Show the page dark or light."""
        self.server.gui.configure_theme(
            dark_mode=is_dark, show_logo=False, show_share_button=False, control_width="large"
        )
        colour = DARK if is_dark else LIGHT
        self.server.scene.set_background_image(np.full((2, 2, 3), colour, dtype=np.uint8))


class Panel(ABC):
    """A part of the page beside the table.

    Args:
        page: What it is about.
    """

    def __init__(self, page: Board):
        self.page, self.session = page, page.session
        self.gui: viser.GuiApi = page.server.gui
        self.build()

    @abstractmethod
    def build(self) -> None:
        """Make the fields and buttons."""

    def refresh(self, topics: set[Topic]) -> None:  # noqa: B027 (some show nothing anew)
        """Show what has changed."""

    def button(
        self, label: str, act: Callable[[], object], hint: str = "", **options: Any
    ) -> viser.GuiButtonHandle:
        """Add a button that does something, and says a hint when the pointer is over it."""
        made = self.gui.add_button(label, hint=hint or None, **options)

        @made.on_click
        def clicked(_: Any) -> None:
            act()

        return made


def by_user(act: Callable[[Any], None]) -> Callable[[Any], None]:
    """Have something done with a field's value when a user changed it, and not when the page did."""

    def changed(event: Any) -> None:
        if event.client is not None:
            act(event.target.value)

    return changed


def set_value(field: Any, value: Any) -> None:
    """Change a field, unless it has that value already."""
    if field.value != value:
        field.value = value


def set_content(field: Any, content: str) -> None:
    """Change what is said, unless it is said already; it keeps from the edges, and scrolls if too wide."""
    if content:
        content = f'<div style="padding:0 12px;overflow-x:auto">{content}</div>'
    if field.content != content:
        field.content = content


def set_options(field: Any, options: tuple[str, ...], value: str) -> None:
    """Change what can be chosen, and what is."""
    if field.options != options:
        field.options = options
    if value in options:
        set_value(field, value)


_SPEEDS = {"half": 0.5, "as it is": 1.0, "double": 2.0, "fourfold": 4.0, "at once": 0.0}
"""How fast a run is shown; 0 is as fast as it is computed."""
_NO_RUN = "(no record)"


class RunPanel(Panel):
    """Runs the plan that is shown, or a record."""

    def build(self) -> None:
        """Make the buttons."""
        gui, running = self.gui, self.session.running
        self._go = self.button("Run", self.run, color="green")
        self._pause = self.button("Pause", self._toggle, disabled=True)
        self._step = self.button("One step", running.one_step, hint="Goes on to the end of one step.")
        self._stop = self.button("Stop", running.stop, disabled=True, color="red")
        speed = gui.add_dropdown("Speed", tuple(_SPEEDS), initial_value="as it is")
        speed.on_update(by_user(lambda name: running.set_speed(_SPEEDS[name])))
        self._anew = gui.add_checkbox(
            "Plan anew on the way", True, hint="Off: the plan is followed blindly to its end."
        )
        self._text = gui.add_html("")
        with gui.add_folder("Watch a run again", expand_by_default=False):
            names = self.session.library.run_names() or (_NO_RUN,)
            self._record = gui.add_dropdown("Record", names)
            self.button("Replay", lambda: running.replay(self._record.value))

    def run(self) -> None:
        """Run the plan that is shown."""
        self.session.running.begin(replans=None if self._anew.value else 0)

    def refresh(self, topics: set[Topic]) -> None:
        """Show how the run stands."""
        if not topics & {"run", "step", "status", "plan", "scene"}:
            return
        running, planned = self.session.running, self.session.plan_shown
        self._go.disabled = running.is_active or planned is None or not planned.plan_file
        self._pause.disabled = self._stop.disabled = not running.is_active
        self._step.disabled = not running.is_active
        self._pause.label = "Go on" if running.controls.is_paused else "Pause"
        set_content(self._text, self.text())

    def text(self) -> str:
        """Return what was promised and what happened, as HTML."""
        running = self.session.running
        parts = []
        if running.run is not None:
            parts.append(run_summary(running.run))
        elif running.left:
            parts.append(paragraph(safe(f"step {running.number}: {' '.join(filter(None, running.left[0]))}")))
        parts.append(replanning_list(running.replannings))
        if running.records:
            parts.append(run_table(running.records))
        return "".join(parts)

    def _toggle(self) -> None:
        running = self.session.running
        act = running.resume if running.controls.is_paused else running.pause
        act()


BEFORE, NEXT = "Card before", "Next card"


def _recall(page: Board, number: int) -> None:
    """Have an interaction happen again in which an object went far, each time another one."""
    data, row = page.session.library.interactions, 0
    if data is not None:
        far = np.where(data.toppled | data.lost, -1.0, np.linalg.norm(data.effects, axis=1))
        row = int(np.argsort(far)[-1 - (len(far) // 50 + number) % len(far)])
    page.session.running.recall(row)


def _perform(page: Board, number: int) -> None:
    """Try what the chosen object is surest to do as promised, and then what it is less sure to do."""
    if promises := promises_for(page.item, page.session.library) if page.item else ():
        primitive = page.session.library.grounding.primitive_of(promises[number % len(promises)].operator)
        page.session.running.perform(page.selected, primitive.action)
    else:
        page.session.say("Nothing is known to be done to this object; choose another one.", is_bad=True)


@dataclass(frozen=True, slots=True)
class Card:
    """One card.

    Attributes:
        title: What it is about.
        sentences: What it says; words in braces are numbers of the domain (`TourPanel.numbers`).
        button: What stands on its button, if it has one.
        act: What the button does on a page, given how often it was pressed before.
    """

    title: str
    sentences: tuple[str, ...]
    button: str = ""
    act: Callable[[Board, int], object] = lambda *_: None


CARDS = (
    Card(
        "an experience and its effect",
        (
            "The robot begins without words. It moves its hand through three points near an object, opens "
            "or closes it at each, and looks what happens. It did so {interactions} times. Press the button "
            "to see one of them happen again; then your table is back.",
            "Of each experience three numbers are kept: how far the object moved forward, to the left and "
            "up. That is the effect. It stands above the panels when the motion is over.",
        ),
        "See an experience",
        _recall,
    ),
    Card(
        "a bit",
        (
            "A program that learns from examples, a neural network, predicts effects. But all that it may "
            "use of an object is {object_bits} bits, each 0 or 1. So it must choose what matters.",
            "On the panel Table, change the size of an object with the sliders until one bit flips. The bars "
            "show how far each bit is from its flip.",
        ),
    ),
    Card(
        "a category",
        (
            "Objects with the same bits are one category. The robot expects the same of all of them.",
            "Nobody told it the {categories} categories that there are here. Their names were made "
            "afterwards, from what was measured. Draw objects, and others, and compare the bits above them.",
        ),
        "Draw two objects",
        lambda page, number: page.session.draw(2, number, None),
    ),
    Card(
        "a primitive and an operator",
        (
            "Motions get bits, too: {action_bits} of them. For each pattern of bits the robot finds a motion "
            "that stands for it, a primitive; there are {primitives}. What a primitive does to a category "
            "is an operator, of which it has {operators}. Each was tried many times, so it is known where "
            "an object ends, and how surely.",
            "On the panel Symbols, arrows show where operators take the object that is chosen. See what is "
            "surest, and press again to see what is less sure.",
        ),
        "Perform a primitive",
        _perform,
    ),
    Card(
        "a plan",
        (
            "Operators are printed as PDDL, a language that planners read. A planner is a program that knows "
            "nothing of arms. It finds which operators lead to the goal, one after another.",
            "The see-through objects are goals: so shall things stand. Drag a goal by the ball above it if "
            "you like, and press the button. The panel Plan shows each step.",
        ),
        "Plan to the goal",
        lambda page, _: page.session.plan(usual_planner()),
    ),
    Card(
        "what went otherwise",
        (
            "Now the arm does it. The panel Run compares what each step promised with what happened.",
            "Where they part so far that the goal would be missed, the robot plans anew. Take an object by "
            "its body while it runs, and drag it elsewhere: before the next step it is there.",
        ),
        "Run the plan",
        lambda page, _: page.session.running.begin(),
    ),
)


class TourPanel(Panel):
    """Shows one card at a time, and does what it speaks of."""

    def build(self) -> None:
        """Make the card and its buttons; what turns cards stays at one place."""
        self.number, self._presses = 0, 0
        turn = self.gui.add_button_group("Card", (BEFORE, NEXT))
        turn.on_click(lambda event: self.turn(1 if event.target.value == NEXT else -1))
        self._text = self.gui.add_html("")
        self._do = self.button("Show me", self.act, color="green")
        self.button("Stop", self.stop, color="red")
        self._show()

    def turn(self, by: int) -> None:
        """Show another card, as soon as the page is drawn: two threads that draw would cross each other."""
        self.number, self._presses = min(max(0, self.number + by), len(CARDS) - 1), 0
        self.page.hear("status")

    def act(self) -> None:
        """Do what the card speaks of."""
        CARDS[self.number].act(self.page, self._presses)
        self._presses += 1

    def stop(self) -> None:
        """End what is at work."""
        self.session.stop_planning()
        self.session.running.stop()

    def numbers(self) -> dict[str, object]:
        """Return the numbers of the domain that cards name."""
        grounding, data = self.session.library.grounding, self.session.library.interactions
        table = grounding.operators
        return {
            "interactions": f"{len(data):,}" if data else "many",
            "object_bits": len(table.categories[0].symbol) if table.categories else "some",
            "action_bits": len(table.symbols[0]) if table.symbols else "some",
            "categories": sum(1 for one in table.categories if one.share),
            "primitives": len(table.symbols),
            "operators": len(grounding.live),
        }

    def text(self) -> str:
        """Return the card, as HTML."""
        card, values = CARDS[self.number], self.numbers()
        head = f"{self.number + 1} of {len(CARDS)}: {card.title}"
        parts = [f'<h3 style="margin:4px 0">{safe(head)}</h3>']
        parts += [paragraph(safe(text.format(**values))) for text in card.sentences]
        return "".join(parts)

    def refresh(self, topics: set[Topic]) -> None:
        """Let nothing be begun while something runs."""
        if topics & {"run", "status", "plan", "scene"}:
            self._show()

    def _show(self) -> None:
        button = CARDS[self.number].button
        self._do.label, self._do.visible = button or "Show me", bool(button)
        self._do.disabled = self.session.running.is_active or self.session.is_planning
        set_content(self._text, self.text())
