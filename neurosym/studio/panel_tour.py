"""The panel `Tour`: six cards, from an experience to what went otherwise. Each has one thing to do."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from neurosym.studio.desk import Topic
from neurosym.studio.panel import Board, Panel, set_content
from neurosym.studio.session import usual_planner
from neurosym.studio.symbols import promises_for
from neurosym.studio.words import paragraph, safe

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
