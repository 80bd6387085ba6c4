"""The panel `Tour`: cards for a newcomer, each with what it speaks of to be tried."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from neurosym.contract import limits_of
from neurosym.report.symbols import Promise, promises_for
from neurosym.studio.desk import Topic
from neurosym.studio.map_field import MapField, category_of, of_each
from neurosym.studio.page import Page, Panel, set_content
from neurosym.studio.panels import PlanPanel, RunPanel
from neurosym.studio.session import planners_here
from neurosym.studio.symbols_panel import ARROWS, SymbolsPanel, arrows
from neurosym.studio.words import DIM, paragraph, relation_in_words, safe, verb_of

_WIDTH, _WIDER = 1, 0.005  # which size is the width, and in what steps it grows [m]
_CELL = "display:inline-block;text-align:center;font-size:12px;margin:0 3px"
_FEW = 8  # operators of which arrows are shown
BEFORE, NEXT = "Card before", "Next card"


def _recall(page: Page, number: int) -> None:
    """Have an interaction happen again in which an object went far, each time another one."""
    data, row = page.session.library.interactions, 0
    if data is not None:
        far = np.where(data.toppled | data.lost, -1.0, np.linalg.norm(data.effects, axis=1))
        row = int(np.argsort(far)[-1 - (len(far) // 50 + number) % len(far)])
    page.session.running.recall(row)


def _widen(page: Page, _: int) -> None:
    """Make the chosen object wider until a bit of it flips, or else narrower; or else another one."""
    session, limits, chosen = page.session, limits_of(page.session.library.world), page.item
    if chosen is None or limits is None or session.problem is None:
        session.say("Nothing here can be made wider.", is_bad=True)
        return
    items = sorted(session.problem.objects, key=lambda one: one.name != chosen.name)
    low, high = limits.sizes[_WIDTH]
    for item in items:
        for step, end, way in ((_WIDER, high, "wider"), (-_WIDER, low, "narrower")):
            widths = np.arange(item.features[_WIDTH] + step, end, step)
            sizes = np.tile(item.features, (len(widths), 1))
            sizes[:, _WIDTH] = widths
            codes = session.library.categorise(sizes) if len(widths) else ()
            row = next((row for row, code in enumerate(codes) if code != item.category), None)
            if row is not None:
                page.select(item.name)
                session.resize(item.name, tuple(sizes[row].tolist()))
                told = f"{item.name} is {1000 * abs(widths[row] - item.features[_WIDTH]):.0f} mm {way} now"
                session.say(
                    f"{told}, {1000 * widths[row]:.0f} mm: it turns from {item.category} to {codes[row]}"
                )
                return
    session.say("However wide or narrow they are, no bit of these objects flips; draw others.", is_bad=True)


def _known(page: Page) -> list[Promise]:
    """List what can be done to the chosen object: the surest of each verb, then the next of each."""
    promises = promises_for(page.item, page.session.library.grounding) if page.item else ()
    verbs = [verb_of(one.operator.name) for one in promises]
    ranks = [verbs[:number].count(verb) for number, verb in enumerate(verbs)]
    return [promises[number] for number in np.argsort(ranks, kind="stable")]


def _perform(page: Page, number: int) -> None:
    """Try what can be done to the chosen object, one after another."""
    if promises := _known(page):
        primitive = page.session.library.grounding.primitive_of(promises[number % len(promises)].operator)
        page.session.running.perform(page.selected, primitive.action)
    else:
        page.session.say("Nothing is known to be done to this object; choose another one.", is_bad=True)


def _run(page: Page, _: int) -> None:
    """Run the plan that is shown, or plan first."""
    if page.session.plan_shown:
        page.session.running.begin()
    else:
        page.session.plan(planners_here()[0])


def _doubt(page: Page, _: int) -> None:
    """Try ten times what is least sure of all that can be done to any object."""
    session, names = page.session, page.session.problem.object_names if page.session.problem else ()
    known = [(one, name) for name in names if (one := session.unsure(name))]
    if not known:
        session.say("Nothing is known to be done to these objects; draw others.", is_bad=True)
        return
    promise, name = min(known, key=lambda one: abs(one[0].chance - 0.5))
    page.select(name)
    session.running.try_ten(name, promise.operator.name)


def _draw(page: Page, number: int) -> None:
    """Draw a task for three objects: to places on the table, where the domain knows of them."""
    page.session.draw(3, number + 1, "anywhere" if page.session.library.grounding.places else None)


def _stack(page: Page, number: int) -> None:
    """Ask for a tower, and at first for nothing else: each time for another goal by relation."""
    session = page.session
    for name in () if number else session.ghosts():
        session.remove_goal(name)
    problem = session.problem
    goals = [goal for name in (problem.object_names if problem else ()) for goal in session.goals_for(name)]
    if goals := [goal for goal in goals if problem and goal not in problem.relations]:
        session.relate(*goals[number % len(goals)])
    else:
        session.say("Nothing on this table can be put on anything else; draw others.", is_bad=True)


def _arrows(page: Page) -> str:
    """Draw what can be done to the chosen object."""
    promises = _known(page)[:_FEW]
    told = (f"{one.operator.primitive}: {verb_of(one.operator.name)}, {one.chance:.0%}" for one in promises)
    pairs = zip(arrows(page, promises), told, strict=True)
    drawn = (f'<span style="{_CELL}">{arrow}<br>{safe(said)}</span>' for arrow, said in pairs)
    return f"{category_of(page)}{''.join(drawn)}{paragraph(ARROWS.capitalize(), DIM)}"


def _told(page: Page, *kinds: type[PlanPanel | RunPanel]) -> str:
    """Return what some other panels say."""
    return "".join(panel.text() for panel in page.panels if isinstance(panel, kinds))


def _planned(page: Page) -> str:
    """Return the plans, and the page of PDDL where the step at hand is marked."""
    pages = (panel.pddl() for panel in page.panels if isinstance(panel, PlanPanel))
    return _told(page, PlanPanel) + "".join(pages) * bool(page.session.plans)


def _happened(page: Page) -> str:
    """Return what was promised and what happened, in a run or in tries."""
    tries = (panel.happened() for panel in page.panels if isinstance(panel, SymbolsPanel))
    return _told(page, RunPanel) + "".join(tries)


@dataclass(frozen=True, slots=True)
class Card:
    """One card: what it says, and what its buttons do, given how often it was pressed before."""

    title: str
    sentences: tuple[str, ...]  # words in braces are numbers of the domain
    button: str
    act: Callable[[Page, int], object]
    more: str = ""  # what the other button is called, if there is one
    act_more: Callable[[Page, int], object] = lambda *_: None
    has_map: bool = False  # whether the map of symbols stands below
    picture: Callable[[Page], str] = lambda _: ""  # HTML below it


CARDS = (
    Card(
        "an experience and its effect",
        (
            "The robot begins without words. It moves its hand through three points near an object, opens "
            "or closes it at each, and looks what happens. It did so {interactions} times. Press the button "
            "to see one of them happen again; Back to my table ends that.",
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
            "The map shows which sizes have which bits. Drag its dot over a border, or press the button, and "
            "see a bit flip. From then on the robot expects other effects.",
        ),
        "Change its width until bits flip",
        _widen,
        has_map=True,
        picture=_arrows,
    ),
    Card(
        "a category",
        (
            "Objects with the same bits are one category. The robot expects the same of all of them.",
            "Nobody told it the {categories} categories that there are here. Their names were made "
            "afterwards, and say what most of their objects are. Draw objects, and compare the bits above "
            "them.",
        ),
        "Draw three objects",
        _draw,
        picture=of_each,
    ),
    Card(
        "an action symbol and an operator",
        (
            "Motions get bits, too: {action_bits} of them. Such a pattern is an action symbol: it stands for "
            "all motions with like effects, and there are {symbols}. For each, the robot keeps the motions "
            "that do best, its primitives; {primitives} in all.",
            "What a primitive does to a category is an operator. Each was tried many times, so it is known "
            "where an object ends, and how surely. The {operators} that keep their promise often enough "
            "are planned with.",
            "Each arrow is one operator of the object that is chosen, with its chance. See the first happen, "
            "and press again for the next.",
        ),
        "Perform a primitive",
        _perform,
        picture=_arrows,
    ),
    Card(
        "a plan",
        (
            "Operators are printed as PDDL, a language that planners read. A planner is a program that knows "
            "nothing of arms. It finds which operators lead to the goal, one after another.",
            "The see-through objects are goals: there things are to stand at the end. Drag a goal by the "
            "ball above it if you like, and press the button. The first step stands below in PDDL, too.",
        ),
        "Plan to the goal",
        lambda page, _: page.session.plan(planners_here()[0]),
        picture=_planned,
    ),
    Card(
        "a run, and what goes otherwise",
        (
            "Now the arm does it. What each step promised stands below, beside what happened.",
            "A step can go otherwise than promised, since an operator speaks of a whole category. This "
            "object is only one of it, and stands a little elsewhere. A chance counts objects: of 50 %, half "
            "do as promised nearly always, and the others hardly ever. See which kind this one is, tried ten "
            "times: dark dots went as promised, pale diamonds did not.",
            "Where the goal would be missed, the robot plans anew. Take an object by its body while it runs, "
            "and drag it elsewhere: before the next step it is there.",
        ),
        "Run the plan",
        _run,
        "Try what is unsure 10 times",
        _doubt,
        picture=_happened,
    ),
)
RELATIONS = Card(
    "a relation",
    (
        "Pairs of objects have bits, too: one object can be on another, or in it. Nobody told the robot "
        "these kinds of pairs either: {states}. It put things on things, and looked how they stood then.",
        "Drag the see-through goal of an object over another object and let go: that asks for a tower. Or "
        "press the button. Then plan it, and run the plan.",
    ),
    "Ask for a tower",
    _stack,
    "Plan it, then run it",
    _run,
    picture=lambda page: _told(page, PlanPanel, RunPanel),
)
"""A card for domains that know relations."""


class TourPanel(Panel):
    """Shows one card at a time, and does what it speaks of."""

    def build(self) -> None:
        """Make the card and its buttons; what turns cards stays at one place."""
        self.number, self._presses = 0, 0
        self.cards = (*CARDS, RELATIONS) if self.session.library.grounding.relations else CARDS
        turn = self.gui.add_button_group("Card", (BEFORE, NEXT))
        turn.on_click(lambda event: self.turn(1 if event.target.value == NEXT else -1))
        self._do = self.button(self.cards[0].button, self.act, color="green")
        self._stop = self.button("Stop", self.stop, color="red", disabled=True)
        self._text, self.map = self.gui.add_html(""), MapField(self.page)
        self._picture = self.gui.add_html("")
        self._more = self.button("More", lambda: self.act(is_more=True), color="green", visible=False)

    def turn(self, by: int) -> None:
        """Show another card, as soon as the page is drawn: two threads that draw would cross each other."""
        self.number, self._presses = min(max(0, self.number + by), len(self.cards) - 1), 0
        self.session.say("")
        if self.session.running.scene is not None:
            self.session.reset()  # what happened again is not on the table that the other card speaks of
        self.page.hear("status")

    def act(self, *, is_more: bool = False) -> None:
        """Do what the card speaks of."""
        card = self.cards[self.number]
        (card.act_more if is_more else card.act)(self.page, self._presses)
        self._presses += 1

    def stop(self) -> None:
        """End what is at work."""
        self.session.stop_planning()
        self.session.running.stop()

    def text(self) -> str:
        """Return the card, with the numbers of the domain, as HTML."""
        grounding, data = self.session.library.grounding, self.session.library.interactions
        table, card = grounding.objects, self.cards[self.number]
        states = grounding.relations.states if grounding.relations else ()
        values = {
            "interactions": f"{len(data):,}" if data else "many",
            "object_bits": len(table.categories[0].symbol) if table.categories else "some",
            "action_bits": len(table.symbols[0]) if table.symbols else "some",
            "categories": sum(1 for one in table.categories if one.share),
            "symbols": len(table.symbols),
            "primitives": len(table.primitives),
            "operators": len(grounding.live),
            "states": ", ".join(dict.fromkeys(relation_in_words(one.name)[0] for one in states)),
        }
        head = f"{self.number + 1} of {len(self.cards)}: {card.title}"
        parts = [f'<h3 style="margin:4px 0">{safe(head)}</h3>']
        return "".join((*parts, *(paragraph(text.format(**values)) for text in card.sentences)))

    def refresh(self, topics: set[Topic]) -> None:
        """Show the card, and let nothing be begun while something runs."""
        if topics & {"run", "step", "status", "plan", "scene"}:
            card, is_busy = self.cards[self.number], self.session.is_running or bool(self.session.planning)
            self._do.label, self._more.label = card.button, card.more or "More"
            self._more.visible = bool(card.more)
            self._do.disabled, self._more.disabled = is_busy, is_busy
            self._stop.disabled = not is_busy
            set_content(self._text, self.text())
            set_content(self._picture, card.picture(self.page))
            self.map.show(card.has_map)
            self.map.refresh(topics)
