"""The tour as it is taken: which card is shown, what its button does, and what came of that.

It knows nothing of a browser.
"""

import math
from collections.abc import Callable

from neurosym.explain.action_words import displacement_in_words
from neurosym.problems import Problem
from neurosym.studio.messages import Performed
from neurosym.studio.session import Session
from neurosym.studio.symbols import Promise
from neurosym.studio.tour import CARDS, Card, Deed
from neurosym.studio.words import paragraph, safe, table
from neurosym.wording import counted

DRAWN = 4
"""So many objects are drawn to compare their bits."""
FEW = 2
"""So many objects are planned for."""


class Guide:
    """Leads through the cards.

    Args:
        session: The page.
        chosen: Names the object that is chosen there; empty if there is none.

    Attributes:
        number: Number of the card, counted from 0.
    """

    def __init__(self, session: Session, chosen: Callable[[], str]):
        self.session, self._chosen = session, chosen
        self.number = 0
        self._done: Deed | None = None
        self._tried: tuple[str, Promise] | None = None
        self._draws, self._before = 0, session.problem

    @property
    def card(self) -> Card:
        """The card that is shown."""
        return CARDS[self.number]

    @property
    def is_busy(self) -> bool:
        """Whether something is at work, so that nothing else can be begun."""
        return self.session.running.is_active or self.session.is_planning

    @property
    def can_act(self) -> bool:
        """Whether the button of the card would do something."""
        planned = self.session.plan_shown
        has_plan = planned is not None and bool(planned.plan_file)
        return not self.is_busy and (has_plan or self.card.deed is not Deed.RUN)

    def turn(self, by: int) -> None:
        """Show another card, and on the table what it is about."""
        before, self.number = self.number, min(max(0, self.number + by), len(CARDS) - 1)
        if before == self.number:
            return
        self._done = None
        self.session.forget_run()
        if self.card.deed is Deed.PLAN and by > 0 and not self.is_busy:
            self._set_the_table()

    def act(self) -> None:
        """Do what the card speaks of."""
        self._done = self.card.deed
        session = self.session
        match self.card.deed:
            case Deed.EXPERIENCE:
                session.running.recall(session.library.telling_row("held"))
            case Deed.EFFECT:
                session.running.recall(session.library.telling_row("resting"))
            case Deed.BIT if name := self._chosen():
                session.flip(name)
            case Deed.CATEGORY:
                self._draws, self._before = self._draws + 1, session.problem
                session.draw(DRAWN, self._draws, "anywhere", goals=False)
            case Deed.PRIMITIVE | Deed.OPERATOR:
                self._try(surest=self.card.deed is Deed.PRIMITIVE)
            case Deed.PLAN:
                session.plan("fast-downward")
            case Deed.RUN:
                session.running.begin()

    def stop(self) -> None:
        """End what is at work."""
        self.session.stop_planning()
        self.session.running.stop()

    def told(self) -> str:
        """Say what came of what the button did, as HTML; nothing before it is pressed."""
        if self._done in (Deed.EXPERIENCE, Deed.EFFECT):
            return self._told_of_effect()
        if self._done is Deed.CATEGORY:
            return self._told_of_categories()
        if self._done in (Deed.PRIMITIVE, Deed.OPERATOR):
            return self._told_of_promise()
        if self._done is Deed.PLAN:
            return self._told_of_plan()
        return self._told_of_run() if self._done is Deed.RUN else ""

    def _try(self, *, surest: bool) -> None:
        """Perform what an object is surest to do as promised, or something less sure, on the table."""
        problem, safely = self.session.problem, self._stays_on_table
        names = sorted(problem.object_names, key=lambda name: name != self._chosen()) if problem else []
        known = [(name, [one for one in self.session.promises(name) if safely(name, one)]) for name in names]
        name, promises = next(((name, found) for name, found in known if len(found) > 1), ("", []))
        if not promises:
            self.session.say("Nothing is known of these objects; add another one.", is_bad=True)
            return
        promise = promises[0] if surest else min(promises, key=lambda one: one.chance)
        self._tried = name, promise
        primitive = self.session.library.grounding.primitive_of(promise.operator)
        self.session.running.perform(name, primitive.action)

    def _stays_on_table(self, name: str, promise: Promise) -> bool:
        assert self.session.problem is not None, "it has the object"
        item, limits = self.session.problem.object_named(name), self.session.library.grounding.table
        room = max(item.features[:2]) / 2
        ends = zip(item.position[:2], promise.effect[:2], (limits.x, limits.y), strict=True)
        return all(low + room <= at + by <= high - room for at, by, (low, high) in ends)

    def _set_the_table(self) -> None:
        """Put a problem of few objects there, for which a plan is short, and all of which must be moved."""
        known = [*self.session.library.problems()]
        few = [problem for problem in known if len(problem.objects) == FEW] or known[:1]
        if few:
            self.session.load(max(few, key=_least_way).name)

    def _told_of_effect(self) -> str:
        running = self.session.running
        if running.is_active:
            return paragraph("Watch the arm; then your table is back.")
        if (outcome := running.outcome) is None:
            return ""
        return paragraph(safe(f"The object {_ended(outcome)}."))

    def _told_of_categories(self) -> str:
        problem, grounding = self.session.problem, self.session.library.grounding
        if problem is self._before:
            return paragraph("They are being drawn; that takes some seconds.")
        rows = [
            (
                safe(item.name),
                f"<code>{safe(item.category)}</code>",
                safe(grounding.category(item.category).name),
            )
            for item in (problem.objects if problem else ())
        ]
        return table(("object", "bits", "category"), rows, label="categories of the objects")

    def _told_of_promise(self) -> str:
        if self._tried is None:
            return ""
        name, promise = self._tried
        held = "held " if promise.lifts else ""
        said = f"{promise.operator.name} promises {name} {held}{displacement_in_words(promise.effect)}"
        lines = [f"{said}. It is {promise.chance:.0%} sure."]
        if (outcome := self.session.running.outcome) is not None and not self.is_busy:
            lines.append(f"{name} {_ended(outcome)}.")
        return "".join(paragraph(safe(line)) for line in lines)

    def _told_of_plan(self) -> str:
        planned = self.session.plan_shown
        if self.session.is_planning:
            return paragraph("The planner is at work. It may take a while; Stop ends it.")
        if planned is None:
            return ""
        record = planned.record
        lines = [f"{number}. {step[0]} {step[1]}" for number, step in enumerate(record.steps, start=1)]
        sure = f" The chance that all go as promised is {record.chance:.0%}." if record.chance else ""
        head = f"The plan has {counted(len(record.steps), 'step')}.{sure} Turn to the next card to run it."
        return "".join(paragraph(safe(line)) for line in (head, *lines))

    def _told_of_run(self) -> str:
        running = self.session.running
        lines = [f"Planned anew before step {one.before_step}: {one.why}." for one in running.replannings]
        if running.is_active and running.left:
            operator, name, _ = running.left[0]
            lines.append(f"Step {running.number}: {operator} {name}. Stop ends it.")
        elif (run := running.run) is not None:
            ended = "The goal is reached" if run.reached else "The goal is missed"
            lines.append(f"{ended}, after {counted(len(run.steps), 'step')}. This was the tour.")
        return "".join(paragraph(safe(line)) for line in lines)


def _least_way(problem: Problem) -> float:
    """Return how far that object must be moved that is nearest to its goal [m]."""
    ways = [math.dist(problem.object_named(name).position, goal) for name, goal in problem.goals.items()]
    return min(ways, default=0.0)


def _ended(outcome: Performed) -> str:
    """Say how and where an object ended."""
    hows = {"held": "hangs from the hand", "lost": "fell off the table", "toppled": "fell over"}
    return f"{hows.get(outcome.kind, 'lies still')}: it moved {displacement_in_words(outcome.effect[:3])}"
