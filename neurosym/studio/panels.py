"""The panels `Table` (the objects and their goals), `Symbols` (what can be done to one) and `Plan`."""

from functools import partial
from typing import Any, get_args

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.choices import DrawnTask, TaskKind
from neurosym.pddl.compiler import encoding_named
from neurosym.pddl.strips_plan import action_for
from neurosym.pddl.syntax import STRIPS
from neurosym.planners.planner import PlanStatus
from neurosym.problems import Problem, RelationGoal, SceneObject
from neurosym.report.symbol_words import displacement_in_words
from neurosym.studio.desk import MOST_OBJECTS, Promise, Topic, promises_for, rehearsal_dots
from neurosym.studio.messages import Planned
from neurosym.studio.panel import Panel, by_user, set_content, set_options, set_value
from neurosym.studio.session import planners_here, usual_planner
from neurosym.studio.view import COLOURS, related_names
from neurosym.studio.words import (
    DIM,
    bits_row,
    coloured,
    paragraph,
    plan_summary,
    plan_table,
    preformatted,
    relation_list,
    safe,
    table,
)
from neurosym.tasks.transition import PlanStep, validate

_PAPER = "as in the paper"
"""The kind of tasks that is drawn unless one is named."""
_TYPES = {0.0: "solid", 1.0: "open at the top", 2.0: "open at both ends"}
"""What the types of objects are called."""
NOTHING = "(none)"


class TablePanel(Panel):
    """Fields for all that can be dragged, and more."""

    def build(self) -> None:
        """Make the fields."""
        session, gui = self.session, self.gui
        self._choices: dict[str, RelationGoal] = {}
        names = session.library.problem_names() or (NOTHING,)
        self._problem = gui.add_dropdown("Problem", names, hint="Puts a problem of the domain on the table.")
        self._problem.on_update(by_user(self._load))
        self._object = gui.add_dropdown("Object", (NOTHING,), hint="Whom the fields below are about.")
        self._object.on_update(by_user(self.page.select))
        self._at = gui.add_vector2("Stands at x, y", (0.0, 0.0), step=0.005, hint="In metres.")
        self._at.on_update(by_user(lambda at: session.move(self.page.selected, *map(float, at))))
        self._goal = gui.add_vector3("Goal x, y, z", (0.0, 0.0, 0.0), step=0.005, hint="In metres.")
        self._goal.on_update(by_user(self._aim))
        self._toggle = self.button("Give it a goal", self._toggle_goal)
        has_relations = session.library.grounding.relations is not None
        self._relation = gui.add_dropdown(
            "Goal: on or in what",
            (NOTHING,),
            hint="The state that it shall come to with another object, as by dropping its ghost there.",
            visible=has_relations,
        )
        self._relation.on_update(by_user(self._relate))
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
            self._tolerance.on_update(by_user(lambda value: session.set_tolerance(float(value) / 1000)))
            self._name = gui.add_text("Name", "scene")
            self._name.on_update(by_user(session.rename))
            self.button("Save in the domain folder", session.save, disabled=session.library.is_shipped)
            upload = gui.add_upload_button("Open a scene file", mime_type="application/json")
            upload.on_upload(lambda event: session.open_file(event.target.value.content))
            gui.add_button("Take the scene as a file").on_click(self._take)

    def _build_sizes(self) -> None:
        library = self.session.library
        limits, names = library.limits, library.world.feature_names
        self._sizes: list[Any] = []
        with self.gui.add_folder("What it is"):
            for name, (low, high) in zip(names, limits.sizes if limits else (), strict=False):
                lows, highs = round(1000 * low), round(1000 * high)
                slider = self.gui.add_slider(
                    f"{name} [mm]", lows, highs, 1, lows, hint="A size of the object."
                )
                slider.on_update(by_user(lambda _: self._resize()))
                self._sizes.append(slider)
            types = tuple(_TYPES.get(kind, f"{kind:g}") for kind in (limits.types if limits else (0.0,)))
            self._type = self.gui.add_dropdown("type", types)
            self._type.on_update(by_user(lambda _: self._resize()))
            self._bits = self.gui.add_html("")

    def refresh(self, topics: set[Topic]) -> None:
        """Show the object that was chosen, and the problem."""
        problem, item = self.session.problem, self.page.item
        if problem is None or item is None or not topics & {"scene", "place", "status"}:
            return
        set_options(self._object, problem.object_names, item.name)
        if topics & {"scene", "status"}:  # the folder is not looked through while something is dragged
            names = self.session.library.problem_names()
            others = () if problem.name in names else (problem.name,)
            set_options(self._problem, (*others, *names), problem.name)
        set_value(self._at, (round(item.position[0], 3), round(item.position[1], 3)))
        goal = problem.goals.get(item.name)
        if goal is not None:
            set_value(self._goal, tuple(round(part, 3) for part in goal))
        self._goal.disabled = goal is None
        has_goal = goal is not None or item.name in related_names(problem)
        self._toggle.label = "Take its goal away" if has_goal else "Give it a goal"
        self._show_relations(problem, item.name)
        set_value(self._name, problem.name)
        set_value(self._tolerance, round(1000 * problem.tolerance, 3))
        if "scene" in topics:
            for slider, size in zip(self._sizes, item.features, strict=False):
                set_value(slider, round(1000 * size))
            kind = item.features[len(self._sizes)] if len(item.features) > len(self._sizes) else 0.0
            set_value(self._type, _TYPES.get(kind, f"{kind:g}"))
            set_content(self._bits, self.text_of(item))

    def text_of(self, item: SceneObject) -> str:
        """Return the bits of an object, as HTML."""
        library = self.session.library
        name = library.grounding.category(item.category).name
        bits = bits_row(item.category, library.margins(item.features))
        return paragraph(f"<b>{safe(item.category)}</b> {safe(name)}") + bits

    def _take(self, event: Any) -> None:
        if (problem := self.session.problem) is not None and event.client is not None:
            content = msgspec.json.encode(problem)
            event.client.send_file_download(f"{problem.name}.scene.json", content, save_immediately=True)

    def _load(self, name: str) -> None:
        if name in self.session.library.problem_names():
            self.session.load(name)

    def _aim(self, goal: tuple[float, float, float]) -> None:
        if self.session.problem and self.page.selected in self.session.problem.goals:
            self.session.aim(self.page.selected, *map(float, goal))

    def _toggle_goal(self) -> None:
        problem, name = self.session.problem, self.page.selected
        if problem is not None:
            has_goal = name in problem.goals or name in related_names(problem)
            act = self.session.remove_goal if has_goal else self.session.add_goal
            act(name)

    def _show_relations(self, problem: Problem, name: str) -> None:
        """Offer the goals by relation that the object can have, and list those of all objects."""
        asked = next((goal for goal in problem.related if goal[0] == name), None)
        found = {_choice_of(goal): goal for goal in (*self.session.goals_for(name), *filter(None, [asked]))}
        self._choices = found
        set_options(self._relation, (NOTHING, *found), _choice_of(asked) if asked else NOTHING)
        set_content(self._related, relation_list(problem.related))

    def _relate(self, choice: str) -> None:
        problem, name = self.session.problem, self.page.selected
        if choice in self._choices:
            self.session.relate(*self._choices[choice])
        elif problem is not None and name in related_names(problem):
            self.session.remove_goal(name)

    def _features(self) -> tuple[float, ...]:
        kinds = {label: kind for kind, label in _TYPES.items()}
        sizes = tuple(float(slider.value) / 1000 for slider in self._sizes)
        chosen = self._type.value
        return (*sizes, kinds[chosen] if chosen in kinds else float(chosen))

    def _resize(self) -> None:
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


def _choice_of(goal: RelationGoal) -> str:
    """Return what a goal by relation is called among the choices for its object: `rests-on-001 item-02`."""
    _, reference, state = goal
    return f"{state} {reference}"


_NONE = "(none)"
_OVER = 0.05  # how far above its object an arrow begins, so that nothing hides it [m]


class SymbolsPanel(Panel):
    """Bits are on the panel `Table`, beside the sizes that decide them; here is what they lead to."""

    def build(self) -> None:
        """Make the fields."""
        gui = self.gui
        self._promises: tuple[Promise, ...] = ()
        self._action: Float[np.ndarray, "A"] = np.zeros(0)
        self._arrows = gui.add_checkbox("Arrows: where operators take it", False)
        self._arrows.on_update(by_user(lambda _: self._show_arrows()))
        self._operator = gui.add_dropdown("Operator", (_NONE,), hint="Shows its waypoints and rehearsals.")
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
            self._row = gui.add_number("Interaction", 0, min=0, step=1)
            self.button("See it happen", lambda: self.session.running.recall(int(self._row.value)))
        self._table = gui.add_html("")

    def refresh(self, topics: set[Topic]) -> None:
        """Show what operators do to the object that is chosen."""
        item = self.page.item
        if item is None or not topics & {"scene", "place"} or self.session.running.is_active:
            return
        if "scene" in topics:
            self._promises = promises_for(item, self.session.library)
            names = (_NONE, *(one.operator.name for one in self._promises))
            if self._operator.options != names:
                set_options(self._operator, names, _NONE)
                self._choose(_NONE)
            set_content(self._table, self.text())
        self._show_arrows()
        if self._operator.value != _NONE:
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
        said = ""
        if expected := self.session.library.expect(item.features, self._action):
            symbol, bits, direct = expected[0], *map(displacement_in_words, expected[1:])
            told = f"This motion has the symbol {symbol}. By the bits the network expects: {bits}."
            said = paragraph(safe(told), coloured(f"Before the bits: {direct}.", DIM))
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


_NOBODY = "(nobody)"


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
        self._choose = gui.add_dropdown("Show and run", (_NOBODY,), visible=False)
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
