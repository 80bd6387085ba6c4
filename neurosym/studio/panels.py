"""The panels of a page: its head, `Table`, `Plan`, `Run` and `Symbols`; the panel `Tour` is in `tour`."""

from typing import Any, get_args

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.choices import DrawnTask, TaskKind
from neurosym.contract import limits_of
from neurosym.errors import counted
from neurosym.pddl.strips import page
from neurosym.pddl.strips_plan import action_for
from neurosym.planners.planner import PlanStatus
from neurosym.problems import Problem, RelationGoal
from neurosym.report.symbols import Promise, displacement_in_words, promises_for
from neurosym.studio import words
from neurosym.studio.desk import MOST_OBJECTS, Topic
from neurosym.studio.messages import Planned
from neurosym.studio.page import Panel, heard, set_content, set_options, set_value
from neurosym.studio.session import planners_here
from neurosym.studio.view import COLOURS
from neurosym.tasks.transition import PlanStep, validate

NOTHING = "(none)"
_PDDL = "font-size:11px;line-height:1.35;white-space:pre-wrap;max-height:260px;overflow:auto;margin:4px 0"


class AboutPanel(Panel):
    """What stands above the tabs: what the page says of itself, and what is wrong on the table."""

    def build(self) -> None:
        """Make it."""
        self._said = self.gui.add_html("")
        heard(self.gui.add_checkbox("Dark", False), self.page.set_dark)

    def refresh(self, topics: set[Topic]) -> None:
        """Say it anew."""
        if not topics - {"pose"}:
            return
        session, word = self.session, self.session.word
        name = session.problem.name if session.problem else "no object yet"
        lines = [words.paragraph(f"· {name}", head=session.library.name)]
        if word.text:
            said = words.paragraph(word.text, words.BAD if word.is_bad else words.GOOD)
            lines.append(f'<div role="status" aria-live="polite">{said}</div>')
        else:
            lines.append(
                words.paragraph("New here? The panel Tour shows in six cards what this robot learned.")
            )
        for ticket, what in ((session.planning, "plan"), (session.running.ticket, "run")):
            if ticket and (place := ticket.place):
                lines.append(words.paragraph(f"waiting in line: {counted(place, what)} with this one"))
        wrong = [*session.complaints().values(), *(f"damaged: {one}" for one in session.library.damage)]
        set_content(self._said, "".join([*lines, *(words.paragraph(why, words.BAD) for why in wrong)]))


_PAPER = "as in the paper"  # the kind of tasks that is drawn unless one is named
_TYPES = {0.0: "solid", 1.0: "open at the top", 2.0: "open at both ends"}
"""What the types of objects are called."""


class TablePanel(Panel):
    """Fields for all that can be dragged, and more."""

    def build(self) -> None:
        """Make the fields."""
        session, gui = self.session, self.gui
        self._choices: dict[str, RelationGoal] = {}
        names = session.library.folder.problem_names() or (NOTHING,)
        self._problem = gui.add_dropdown("Problem", names, hint="Puts a problem of the domain on the table.")
        heard(self._problem, self._load)
        self._object = gui.add_dropdown("Object", (NOTHING,), hint="Whom the fields below are about.")
        heard(self._object, self.page.select)
        self._at = gui.add_vector2("Stands at x, y", (0.0, 0.0), step=0.005, hint="In metres.")
        heard(self._at, lambda at: session.move(self.page.selected, *map(float, at)))
        self._goal = gui.add_vector3("Goal x, y, z", (0.0, 0.0, 0.0), step=0.005, hint="In metres.")
        heard(self._goal, self._aim)
        self._toggle = self.button("Give it a goal", self._toggle_goal)
        has_relations = session.library.grounding.relations is not None
        self._relation = gui.add_dropdown(
            "Goal: on or in what",
            (NOTHING,),
            hint="The state that it shall come to with another object, as by dropping its ghost there.",
            visible=has_relations,
        )
        heard(self._relation, self._relate)
        self._related = gui.add_html("")
        self._build_sizes()
        self.button("Add another like it", self._add)
        self.button("Take it away", lambda: session.remove(self.page.selected))
        with gui.add_folder("Draw a task", expand_by_default=False):
            kinds = get_args(DrawnTask if has_relations else TaskKind)
            self._kind = gui.add_dropdown("Kind", (_PAPER, *kinds))
            self._count = gui.add_slider("Objects", 1, MOST_OBJECTS, 1, 2)
            self._seed = gui.add_number("Seed", 0, min=0, step=1)
            self.button("Draw", self._draw)
        with gui.add_folder("Save and open", expand_by_default=False):
            self._tolerance = gui.add_number("Tolerance [mm]", 50.0, min=1.0, max=500.0, step=1.0)
            heard(self._tolerance, lambda value: session.set_tolerance(float(value) / 1000))
            self._name = heard(gui.add_text("Name", "scene"), session.rename)
            self.button("Save in the domain folder", session.save, disabled=session.library.is_shipped)
            upload = gui.add_upload_button("Open a scene file", mime_type="application/json")
            upload.on_upload(lambda event: session.open_file(event.target.value.content))
            gui.add_button("Take the scene as a file").on_click(self._take)

    def _build_sizes(self) -> None:
        world = self.session.library.world
        limits, self._sizes = limits_of(world), list[Any]()
        with self.gui.add_folder("What it is"):
            for name, bounds in zip(world.feature_names, limits.sizes if limits else (), strict=False):
                low, high = (round(1000 * bound) for bound in bounds)
                slider = self.gui.add_slider(f"{name} [mm]", low, high, 1, low, hint="A size of the object.")
                heard(slider, self._resize)
                self._sizes.append(slider)
            types = tuple(_TYPES.get(kind, f"{kind:g}") for kind in (limits.types if limits else (0.0,)))
            self._type = heard(self.gui.add_dropdown("type", types), self._resize)
            self._bits = self.gui.add_html("")

    def refresh(self, topics: set[Topic]) -> None:
        """Show the object that was chosen, and the problem."""
        session, problem, item = self.session, self.session.problem, self.page.item
        if problem is None or item is None or not topics & {"scene", "place", "status"}:
            return
        set_options(self._object, problem.object_names, item.name)
        if topics & {"scene", "status"}:  # the folder is not looked through while something is dragged
            names = session.library.folder.problem_names()
            set_options(self._problem, tuple(dict.fromkeys((*names, problem.name))), problem.name)
        set_value(self._at, (round(item.position[0], 3), round(item.position[1], 3)))
        goal = problem.goals.get(item.name)
        if goal is not None:
            set_value(self._goal, tuple(round(part, 3) for part in goal))
        self._goal.disabled = goal is None
        self._toggle.label = "Take its goal away" if self._has_goal(problem) else "Give it a goal"
        asked = next((goal for goal in problem.related if goal[0] == item.name), None)
        goals = (*session.goals_for(item.name), *filter(None, [asked]))
        self._choices = {f"{state} {reference}": goal for goal in goals for _, reference, state in [goal]}
        set_options(self._relation, (NOTHING, *self._choices), f"{asked[2]} {asked[1]}" if asked else NOTHING)
        set_content(
            self._related, words.bullets(f"Goal: {one} {state} {on}" for one, on, state in problem.related)
        )
        set_value(self._name, problem.name)
        set_value(self._tolerance, round(1000 * problem.tolerance, 3))
        if "scene" in topics:
            for slider, size in zip(self._sizes, item.features, strict=False):
                set_value(slider, round(1000 * size))
            kind = next(iter(item.features[len(self._sizes) :]), 0.0)
            set_value(self._type, _TYPES.get(kind, f"{kind:g}"))
            name = session.library.grounding.category(item.category).name
            head = words.paragraph(name, head=item.category)
            set_content(
                self._bits, head + words.bits_row(item.category, session.library.margins(item.features))
            )

    def _has_goal(self, problem: Problem) -> bool:
        return self.page.selected in (*problem.goals, *(name for name, *_ in problem.related))

    def _take(self, event: Any) -> None:
        if (problem := self.session.problem) is not None and event.client is not None:
            content = msgspec.json.encode(problem)
            event.client.send_file_download(f"{problem.name}.scene.json", content, save_immediately=True)

    def _load(self, name: str) -> None:
        if name in self.session.library.folder.problem_names():
            self.session.load(name)

    def _aim(self, goal: tuple[float, float, float]) -> None:
        if self.session.problem and self.page.selected in self.session.problem.goals:
            self.session.aim(self.page.selected, *map(float, goal))

    def _toggle_goal(self) -> None:
        if problem := self.session.problem:
            act = self.session.remove_goal if self._has_goal(problem) else self.session.add_goal
            act(self.page.selected)

    def _relate(self, choice: str) -> None:
        problem, name = self.session.problem, self.page.selected
        if choice in self._choices:
            self.session.relate(*self._choices[choice])
        elif problem is not None and any(goal[0] == name for goal in problem.related):
            self.session.remove_goal(name)

    def _features(self) -> tuple[float, ...]:
        kinds = {label: kind for kind, label in _TYPES.items()}
        sizes, chosen = (float(slider.value) / 1000 for slider in self._sizes), self._type.value
        return (*sizes, kinds[chosen] if chosen in kinds else float(chosen))

    def _resize(self, _: Any) -> None:
        if self.page.item is not None:
            self.session.resize(self.page.selected, self._features())

    def _add(self) -> None:
        self.session.add(self._features())
        if self.session.problem is not None:
            self.page.select(self.session.problem.object_names[-1])

    def _draw(self) -> None:
        kind: Any = None if self._kind.value == _PAPER else self._kind.value
        self.session.draw(int(self._count.value), int(self._seed.value), kind)
        set_value(self._seed, int(self._seed.value) + 1)


class PlanPanel(Panel):
    """Asks planners, and shows what they found."""

    def build(self) -> None:
        """Make the fields."""
        gui, session = self.gui, self.session
        self._drawn: Planned | None = None
        self._planner = gui.add_dropdown("Planner", planners_here())
        self._go = self.button("Plan", lambda: session.plan(self._planner.value), color="green")
        self._stop = self.button("Stop planning", session.stop_planning, disabled=True)
        self._text = gui.add_html("")
        self._choose = heard(gui.add_dropdown("Show and run", (NOTHING,), visible=False), session.choose)
        self._accept = self.button(
            "Accept the nearest goals", session.accept_nearest, visible=False, color="orange"
        )
        with gui.add_folder("PDDL of the step at hand", expand_by_default=False):
            self._step = heard(gui.add_slider("Step", 1, 2, 1, 1), lambda _: self._show_pddl())
            self._pddl = gui.add_html("")

    def refresh(self, topics: set[Topic]) -> None:
        """Show the plans."""
        session, chosen = self.session, self.session.plan_shown
        if topics & {"status", "plan"}:
            self._go.disabled = bool(session.planning) or session.is_running
            self._stop.disabled = not session.planning
        if topics & {"plan", "scene"}:
            self._choose.visible = len(session.plans) > 1
            if session.plans:
                set_options(self._choose, tuple(session.plans), session.chosen)
            self._accept.visible = chosen is not None and chosen.record.status is PlanStatus.NEAREST
            steps = len(chosen.record.steps) if chosen else 0
            self._step.max, self._step.disabled = max(2, steps), steps < 2
            self._show_pddl()
        if topics & {"plan", "scene", "step", "run"}:
            set_content(self._text, self.text())
            self._draw_paths()

    def text(self) -> str:
        """Return what the planners found, as HTML; the chosen plan in full."""
        session = self.session
        problem, moment, chosen = session.problem, session.running.moment, session.plan_shown
        if problem is None or not session.plans:
            return ""
        parts = [words.plan_summary(one.record) for one in session.plans.values()]
        if chosen is not None and chosen.record.steps:
            follows = session.is_running and not session.running.replannings
            at = moment.number - 1 if moment and follows else None
            parts.append(words.plan_table(chosen.record, session.paired(), session.library.grounding, at))
        return "".join(parts)

    def _show_pddl(self) -> None:
        """Show the action on the page of PDDL that a step is an instance of."""
        chosen, grounding = self.session.plan_shown, self.session.library.grounding
        said = ""
        if chosen is not None and (steps := chosen.record.steps):
            name = steps[min(int(self._step.value), len(steps)) - 1][0]
            action = page(grounding).action(action_for(name, grounding))
            text = words.safe(action.text(costs=True))
            said = f'<pre tabindex="0" aria-label="PDDL" style="{_PDDL}">{text}</pre>'
        set_content(self._pddl, said)

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


_SPEEDS = {"half": 0.5, "as it is": 1.0, "double": 2.0, "fourfold": 4.0, "at once": 0.0}
"""How fast a run is shown; 0 is as fast as it is computed."""


class RunPanel(Panel):
    """Runs the plan that is shown, or a record."""

    def build(self) -> None:
        """Make the buttons."""
        gui, running = self.gui, self.session.running
        self._go = self.button("Run", self._run, color="green")
        self._pause = self.button("Pause", self._toggle, disabled=True)
        self._step = self.button(
            "One step",
            lambda: running.steer(is_paused=True, one_step=True),
            hint="Goes on to the end of one step.",
        )
        self._stop = self.button("Stop", running.stop, disabled=True, color="red")
        heard(
            gui.add_dropdown("Speed", tuple(_SPEEDS), initial_value="as it is"),
            lambda name: running.steer(speed=_SPEEDS[name]),
        )
        self._anew = gui.add_checkbox(
            "Plan anew on the way", True, hint="Off: the plan is followed blindly to its end."
        )
        self._text = gui.add_html("")
        with gui.add_folder("Watch a run again", expand_by_default=False):
            record = gui.add_dropdown("Record", self.session.library.run_names() or (NOTHING,))
            self.button("Replay", lambda: running.replay(record.value))

    def refresh(self, topics: set[Topic]) -> None:
        """Show how the run stands."""
        if not topics & {"run", "step", "status", "plan", "scene"}:
            return
        running, planned = self.session.running, self.session.plan_shown
        self._go.disabled = running.is_active or planned is None or not planned.plan_file
        self._pause.disabled = self._stop.disabled = self._step.disabled = not running.is_active
        self._pause.label = "Go on" if running.controls.is_paused else "Pause"
        set_content(self._text, self.text())

    def text(self) -> str:
        """Return what was promised and what happened, as HTML."""
        running, moment = self.session.running, self.session.running.moment
        parts = [words.replanning_list(running.replannings)]
        if running.run is not None:
            parts.insert(0, words.run_summary(running.run))
        elif running.is_active and moment and moment.left:
            step = moment.left[0]
            told = " ".join(filter(None, (step.operator, step.object, step.place)))
            parts.insert(0, words.paragraph(f"step {moment.number}: {told}"))
        if running.records:
            parts.append(words.run_table(running.records))
        return "".join(parts)

    def _run(self) -> None:
        self.session.running.begin(replans=None if self._anew.value else 0)

    def _toggle(self) -> None:
        self.session.running.steer(is_paused=not self.session.running.controls.is_paused)


_OVER = 0.05  # how far above its object an arrow begins, so that nothing hides it [m]
_KEPT, _OTHERWISE = (42, 157, 92), (217, 83, 79)
"""Colours of rehearsals that ended as promised, and otherwise."""


class SymbolsPanel(Panel):
    """Bits are on the panel `Table`, beside the sizes that decide them; here is what they lead to."""

    def build(self) -> None:
        """Make the fields."""
        gui = self.gui
        self._promises: tuple[Promise, ...] = ()
        self._action: Float[np.ndarray, "A"] = np.zeros(0)
        self._arrows = gui.add_checkbox("Arrows: where operators take it", False)
        heard(self._arrows, lambda _: self._show_arrows())
        self._operator = gui.add_dropdown("Operator", (NOTHING,), hint="Shows its waypoints and rehearsals.")
        heard(self._operator, self._choose)
        self._said = gui.add_html("")
        self._expected = gui.add_html("")
        self._try = self.button("Try this motion", self.perform, visible=False)
        with gui.add_folder("All that was explored", expand_by_default=False):
            row = gui.add_number("Interaction", 0, min=0, step=1)
            self.button("See it happen", lambda: self.session.running.recall(int(row.value)))
        self._table = gui.add_html("")

    def refresh(self, topics: set[Topic]) -> None:
        """Show what operators do to the object that is chosen."""
        item = self.page.item
        if item is None or not topics & {"scene", "place"} or self.session.is_running:
            return
        if "scene" in topics:
            self._promises = promises_for(item, self.session.library.grounding)
            names = (NOTHING, *(one.operator.name for one in self._promises))
            if self._operator.options != names:
                set_options(self._operator, names, NOTHING)
                self._choose(NOTHING)
            set_content(self._table, self.text())
        self._show_arrows()
        if self._operator.value != NOTHING:
            self._draw_motion()

    def text(self) -> str:
        """Return what the operators promise for the object, as HTML."""
        rows = [
            (
                str(number),
                words.twofold(one.operator.name, displacement_in_words(one.effect)),
                f"<code>{words.safe(one.operator.primitive)}</code>",
                f"{one.chance:.0%}",
            )
            for number, one in enumerate(self._promises, start=1)
        ]
        head = words.paragraph(f"What can be done to {self.page.selected}:")
        return head + words.table(("", "operator", "bits", "chance"), rows, label="operators") if rows else ""

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
        """Take over the waypoints of an operator, and show as dots where its rehearsals ended."""
        grounding, item, overlays = self.session.library.grounding, self.page.item, self.page.overlays
        promise = next((one for one in self._promises if one.operator.name == name), None)
        self._try.visible = promise is not None and item is not None
        if promise is None or item is None:
            overlays.clear("waypoints")
            overlays.clear("dots")
            set_content(self._said, "")
            set_content(self._expected, "")
            return
        self._action = np.array(grounding.primitive_of(promise.operator).action)
        learned = grounding.operator_named(name)
        kind = learned.promise.kind if learned.promise else None
        points = np.array([np.add(item.position, one.outcome) for one in learned.rehearsals])
        colours = np.array([_KEPT if one.kind == kind else _OTHERWISE for one in learned.rehearsals])
        overlays.dots(points, colours)
        kept = f"{len(points)} rehearsals as dots: green as promised, red otherwise" if len(points) else ""
        bits = f"{item.category} · {promise.operator.primitive}"
        moves = displacement_in_words(promise.effect)
        set_content(
            self._said,
            words.paragraph(f"promises {moves}. {kept}", head=bits),
        )
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
