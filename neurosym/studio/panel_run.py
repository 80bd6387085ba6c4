"""The panel `Run`: go, pause, step and stop, and what each step promised beside what happened."""

from neurosym.studio.desk import Topic
from neurosym.studio.panel import Panel, by_user, set_content
from neurosym.studio.words import paragraph, replanning_list, run_summary, run_table, safe

SPEEDS = {"half": 0.5, "as it is": 1.0, "double": 2.0, "fourfold": 4.0, "at once": 0.0}
"""How fast a run is shown; 0 is as fast as it is computed."""
NO_RUN = "(no record)"


class RunPanel(Panel):
    """Runs the plan that is shown, or a record."""

    def build(self) -> None:
        """Make the buttons."""
        gui, running = self.gui, self.session.running
        self._go = self.button("Run", self.run, color="green")
        self._pause = self.button("Pause", self._toggle, disabled=True)
        self._step = self.button("One step", running.one_step, hint="Goes on to the end of one step.")
        self._stop = self.button("Stop", running.stop, disabled=True, color="red")
        speed = gui.add_dropdown("Speed", tuple(SPEEDS), initial_value="as it is")
        speed.on_update(by_user(lambda name: running.set_speed(SPEEDS[name])))
        self._anew = gui.add_checkbox(
            "Plan anew on the way", True, hint="Off: the plan is followed blindly to its end."
        )
        self._text = gui.add_html("")
        with gui.add_folder("Watch a run again", expand_by_default=False):
            names = self.session.library.run_names() or (NO_RUN,)
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
