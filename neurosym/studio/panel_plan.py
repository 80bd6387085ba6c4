"""The panel `Plan`: whom to ask, what was found, and the PDDL that says so."""

from neurosym.pddl.encoding_names import STRIPS
from neurosym.pddl.encodings import encoding_named
from neurosym.pddl.strips_plan import action_for
from neurosym.planners.result import PlanStatus
from neurosym.studio.desk import Topic
from neurosym.studio.messages import Planned
from neurosym.studio.panel import Panel, by_user, set_content, set_options
from neurosym.studio.session import planners_here, usual_planner
from neurosym.studio.view import COLOURS
from neurosym.studio.words import plan_summary, plan_table, preformatted
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.transition import validate

NOBODY = "(nobody)"


class PlanPanel(Panel):
    """Asks planners, and shows what they found."""

    def build(self) -> None:
        """Make the fields."""
        gui, session = self.gui, self.session
        self._drawn: Planned | None = None
        self._planner = gui.add_dropdown("Planner", planners_here(), initial_value=usual_planner())
        self._go = self.button("Plan", lambda: session.plan(self._planner.value), color="green")
        self._stop = self.button("Stop planning", session.stop_planning, disabled=True)
        self._text = gui.add_html("")
        self._choose = gui.add_dropdown("Show and run", (NOBODY,), visible=False)
        self._choose.on_update(by_user(session.choose))
        self._accept = self.button(
            "Accept the nearest goals", session.accept_nearest, visible=False, color="orange"
        )
        with gui.add_folder("PDDL of the step at hand", expand_by_default=False):
            self._step = gui.add_slider("Step", 1, 2, 1, 1)
            self._step.on_update(by_user(lambda _: self._show_pddl()))
            self._pddl = gui.add_html("")

    def refresh(self, topics: set[Topic]) -> None:
        """Show the plans."""
        session = self.session
        if topics & {"status", "plan"}:
            self._go.disabled = session.is_planning or session.running.is_active
            self._stop.disabled = not session.is_planning
        if topics & {"plan", "scene", "step", "run"}:
            set_content(self._text, self.text())
        if topics & {"plan", "scene"}:
            self._show_choice()
            self._show_pddl()
        if topics & {"plan", "scene", "step", "run"}:
            self._draw_paths()

    def text(self) -> str:
        """Return what the planners found, as HTML; the chosen plan in full."""
        session = self.session
        problem, grounding = session.problem, session.library.grounding
        if problem is None or not session.plans:
            return ""
        parts = [plan_summary(one.record) for one in session.plans.values()]
        chosen = session.plan_shown
        if chosen is not None and chosen.record.steps:
            number = session.running.number
            at = number - 1 if session.running.is_active and not session.running.replannings else None
            parts.append(plan_table(chosen.record, session.paired(), grounding, at))
        return "".join(parts)

    def _show_choice(self) -> None:
        session = self.session
        self._choose.visible = len(session.plans) > 1
        if session.plans:
            set_options(self._choose, tuple(session.plans), session.chosen)
        chosen = session.plan_shown
        self._accept.visible = chosen is not None and chosen.record.status is PlanStatus.NEAREST
        steps = len(chosen.record.steps) if chosen else 0
        self._step.max = max(2, steps)
        self._step.disabled = steps < 2

    def _show_pddl(self) -> None:
        chosen = self.session.plan_shown
        if chosen is None or not chosen.record.steps:
            set_content(self._pddl, "")
            return
        number = min(int(self._step.value), len(chosen.record.steps))
        name = chosen.record.steps[number - 1][0]
        set_content(self._pddl, preformatted(self._action(name)))

    def _action(self, name: str) -> str:
        """Return the text of the action on the page of PDDL that a step is an instance of."""
        grounding = self.session.library.grounding
        page = encoding_named(STRIPS).domain(grounding)
        return page.action(action_for(name, grounding)).text(costs=True)

    def _draw_paths(self) -> None:
        """Draw where the plan takes everything, while that is what is done or is to be done."""
        session, chosen, running = self.session, self.session.plan_shown, self.session.running
        is_other = running.is_active and (running.problem is None or bool(running.replannings))
        if chosen is None or not chosen.record.steps or is_other or running.run is not None:
            chosen = None
        if chosen is self._drawn:
            return
        self._drawn = chosen
        if chosen is None:
            self.page.overlays.clear("paths")
            return
        steps = [PlanStep(*step) for step in chosen.record.steps]
        found = validate(steps, session.paired(), session.library.grounding)
        self.page.overlays.paths(found.positions, COLOURS)
