"""The tour as it is taken: which card is shown, what its button does, and what came of that.

It knows nothing of a browser.
"""

import math
from collections.abc import Callable

from neurosym.explain.action_words import displacement_in_words
from neurosym.problems import Problem
from neurosym.studio.asking import usual_planner
from neurosym.studio.desk import NO_OBJECT
from neurosym.studio.messages import Performed
from neurosym.studio.session import Session
from neurosym.studio.setting import has_goals
from neurosym.studio.symbols import Promise
from neurosym.studio.telling import plan_lines, replanned, step_words
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
        self.number, self._draws = 0, 0
        self._forget()

    def _forget(self) -> None:
        """Forget what the button did, so that nothing is told of it any more."""
        self._done: Deed | None = None
        self._job: int | None = None
        self._tried: tuple[str, Promise] | None = None
        self._drawn: Problem | None = None

    @property
    def card(self) -> Card:
        """The card that is shown."""
        return CARDS[self.number]

    @property
    def is_busy(self) -> bool:
        """Whether something is at work, so that nothing else can be begun."""
        session = self.session
        return session.running.is_active or session.is_planning or session.is_drawing

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
        self._forget()
        self.session.forget_action()
        if self.card.deed is Deed.PLAN and not self.is_busy:
            self._set_the_table()

    def act(self) -> None:
        """Do what the card speaks of, unless something is at work."""
        session = self.session
        if self.is_busy:
            session.say("Something is at work; stop it, or wait for it.", is_bad=True)
            return
        self._forget()
        self._done = self.card.deed
        match self.card.deed:
            case Deed.EXPERIENCE:
                self._job = session.running.recall(session.library.telling_row("held"))
            case Deed.EFFECT:
                self._job = session.running.recall(session.library.telling_row("resting"))
            case Deed.BIT:
                session.flip(self._chosen())
            case Deed.CATEGORY:
                self._draws += 1
                session.draw(DRAWN, self._draws, "anywhere", goals=False, done=self._take_drawn)
            case Deed.PRIMITIVE | Deed.OPERATOR:
                self._try(surest=self.card.deed is Deed.PRIMITIVE)
            case Deed.PLAN:
                self._set_the_table()
                session.plan(usual_planner())
            case Deed.RUN:
                self._job = session.running.begin()

    def stop(self) -> None:
        """End what is at work."""
        self.session.stop_planning()
        self.session.stop_drawing()
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

    @property
    def _is_own(self) -> bool:
        """Whether what runs, or ran last, was begun by the button of this card."""
        return self._job is not None and self._job == self.session.running.job

    def _take_drawn(self, problem: Problem) -> None:
        self._drawn = problem

    def _try(self, *, surest: bool) -> None:
        """Perform what an object is surest to do as promised, or something less sure, on the table."""
        problem, safely = self.session.problem, self._stays_on_table
        if problem is None:
            self.session.say(NO_OBJECT, is_bad=True)
            return
        names = sorted(problem.object_names, key=lambda name: name != self._chosen())
        known = [(name, [one for one in self.session.promises(name) if safely(name, one)]) for name in names]
        enough = 1 if surest else 2
        name, promises = next(((name, found) for name, found in known if len(found) >= enough), ("", []))
        if not promises:
            which = "motion" if surest else "less sure motion"
            self.session.say(
                f"No {which} that is known keeps an object on the table; move one to the middle.", is_bad=True
            )
            return
        promise = promises[0] if surest else min(promises, key=lambda one: one.chance)
        self._tried = name, promise
        primitive = self.session.library.grounding.primitive_of(promise.operator)
        self._job = self.session.running.perform(name, primitive.action)

    def _stays_on_table(self, name: str, promise: Promise) -> bool:
        assert self.session.problem is not None, "it has the object"
        item, limits = self.session.problem.object_named(name), self.session.library.grounding.table
        room = max(item.features[:2]) / 2
        ends = zip(item.position[:2], promise.effect[:2], (limits.x, limits.y), strict=True)
        return all(low + room <= at + by <= high - room for at, by, (low, high) in ends)

    def _set_the_table(self) -> None:
        """If nothing has a goal, put a problem of few objects there, all of which must be moved."""
        if self.session.problem is not None and has_goals(self.session.problem):
            return
        known = [problem for problem in self.session.library.problems() if has_goals(problem)]
        few = [problem for problem in known if len(problem.objects) == FEW] or known[:1]
        if few:
            self.session.load(max(few, key=_least_way).name)

    def _told_of_effect(self) -> str:
        running = self.session.running
        if not self._is_own:
            return ""
        if running.is_active:
            return paragraph("Watch the arm; then your table is back.")
        if (outcome := running.outcome) is None:
            return ""
        return paragraph(safe(f"The object {_ended(outcome)}."))

    def _told_of_categories(self) -> str:
        if (drawn := self._drawn) is None:
            is_drawing = self.session.is_drawing
            return paragraph("They are being drawn; that takes some seconds.") if is_drawing else ""
        grounding = self.session.library.grounding
        rows = [
            (
                safe(item.name),
                f"<code>{safe(item.category)}</code>",
                safe(grounding.category(item.category).name),
            )
            for item in drawn.objects
        ]
        return table(("object", "bits", "category"), rows, label="categories of the objects")

    def _told_of_promise(self) -> str:
        if self._tried is None or not self._is_own:
            return ""
        name, promise = self._tried
        held = "held " if promise.lifts else ""
        said = f"{promise.operator.name} promises {name} {held}{displacement_in_words(promise.effect)}"
        lines = [f"{said}. It is {promise.chance:.0%} sure."]
        if (outcome := self.session.running.outcome) is not None:
            lines.append(f"{name} {_ended(outcome)}.")
        return "".join(paragraph(safe(line)) for line in lines)

    def _told_of_plan(self) -> str:
        planned = self.session.plan_shown
        if self.session.is_planning:
            return paragraph("The planner is at work. It may take a while; Stop ends it.")
        lines = list(plan_lines(planned)) if planned else []
        if planned and planned.record.steps:
            lines.append("Turn to the next card to run it.")
        return "".join(paragraph(safe(line)) for line in lines)

    def _told_of_run(self) -> str:
        running = self.session.running
        if not self._is_own:
            return ""
        lines = [f"{replanned(one)}." for one in running.replannings]
        if running.is_active and running.left:
            lines.append(f"Step {running.number}: {step_words(*running.left[0])}. Stop ends it.")
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
