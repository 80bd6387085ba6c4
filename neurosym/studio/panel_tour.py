"""The panel `Tour`: eight cards, from an experience to what went otherwise."""

from neurosym.studio.panel import Panel, set_content
from neurosym.studio.session import Topic
from neurosym.studio.tour import CARDS, Card, Deed, numbers_of
from neurosym.studio.words import paragraph, safe


class TourPanel(Panel):
    """Shows one card at a time, and does what it speaks of."""

    def build(self) -> None:
        """Make the card and its buttons."""
        self._number = 0
        self._text = self.gui.add_html("")
        self._do = self.button("Show me", self.act, color="green")
        self._next = self.button("Next card", lambda: self.turn(1))
        self._back = self.button("Card before", lambda: self.turn(-1))
        self.turn(0)

    @property
    def card(self) -> Card:
        """The card that is shown."""
        return CARDS[self._number]

    def turn(self, by: int) -> None:
        """Show another card."""
        self._number = min(max(0, self._number + by), len(CARDS) - 1)
        self._back.disabled = self._number == 0
        self._next.disabled = self._number == len(CARDS) - 1
        self._do.label = self.card.button
        set_content(self._text, self.text())

    def text(self) -> str:
        """Return the card, as HTML."""
        library = self.session.library
        head = f"{self._number + 1} of {len(CARDS)}: {self.card.title}"
        parts = [f'<h3 style="margin:4px 0">{safe(head)}</h3>']
        values = numbers_of(library)
        parts += [paragraph(safe(text.format(**values))) for text in self.card.sentences]
        return "".join(parts)

    def act(self) -> None:
        """Do what the card speaks of."""
        DEEDS[self.card.deed](self)

    def refresh(self, topics: set[Topic]) -> None:
        """Let nothing be begun while something runs."""
        if topics & {"run", "status"}:
            self._do.disabled = self.session.running.is_active or self.session.is_planning


def _experience(panel: TourPanel) -> None:
    panel.session.running.recall(panel.session.library.telling_row("held"))


def _effect(panel: TourPanel) -> None:
    panel.session.running.recall(panel.session.library.telling_row("resting"))


def _bit(panel: TourPanel) -> None:
    """Make the object another one, whose first bit that can be flipped by its size is flipped."""
    item = panel.page.item
    if item is not None:
        panel.session.flip(item.name)


def _category(panel: TourPanel) -> None:
    panel.session.draw(4, 1, "anywhere")


def _primitive(panel: TourPanel) -> None:
    session, item = panel.session, panel.page.item
    if item is not None and (promises := session.promises(item.name)):
        primitive = session.library.grounding.primitive_of(promises[0].operator)
        session.running.perform(item.name, primitive.action)


def _operator(panel: TourPanel) -> None:
    session, item = panel.session, panel.page.item
    if item is not None and len(promises := session.promises(item.name)) > 1:
        primitive = session.library.grounding.primitive_of(promises[-1].operator)
        session.running.perform(item.name, primitive.action)


def _plan(panel: TourPanel) -> None:
    session, item = panel.session, panel.page.item
    if session.problem is not None and item is not None:
        if not session.ghosts():
            session.add_goal(item.name)
        session.plan("fast-downward")


def _run(panel: TourPanel) -> None:
    panel.session.running.begin()


DEEDS = {
    Deed.EXPERIENCE: _experience,
    Deed.EFFECT: _effect,
    Deed.BIT: _bit,
    Deed.CATEGORY: _category,
    Deed.PRIMITIVE: _primitive,
    Deed.OPERATOR: _operator,
    Deed.PLAN: _plan,
    Deed.RUN: _run,
}
