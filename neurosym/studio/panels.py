"""The panels of a page: its head, `Table`, `Plan` and `Run`; the others have modules of their own."""

from collections.abc import Sequence
from typing import Any, get_args

import msgspec
import numpy as np

from neurosym.choices import DrawnTask, TaskKind
from neurosym.contract import limits_of
from neurosym.errors import InvalidValue, counted
from neurosym.pddl.strips_plan import action_for
from neurosym.planners.planner import PlanStatus
from neurosym.problems import Problem, RelationGoal
from neurosym.report.symbol_map import WORDS
from neurosym.studio import words
from neurosym.studio.desk import MOST_OBJECTS, Topic
from neurosym.studio.map_field import MapField, category_of, of_each
from neurosym.studio.page import Panel, heard, set_content, set_options, set_value
from neurosym.studio.plan_words import Line, lanes, lines_of, pddl_page, plan_list
from neurosym.studio.session import placed, planners_here
from neurosym.studio.view import Leg
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep, Steps, validate

NOTHING = "(none)"


class AboutPanel(Panel):
    """What stands above the tabs: what the page says of itself, and what is wrong on the table."""

    def build(self) -> None:
        """Make it."""
        self._said = self.gui.add_html("")
        self._back = self.button("Back to my table", self.session.reset, disabled=True)
        heard(self.gui.add_checkbox("Dark", False), self.page.set_dark)

    def refresh(self, topics: set[Topic]) -> None:
        """Say it anew."""
        if not topics - {"pose"}:
            return
        session, word = self.session, self.session.word
        self._back.disabled = not session.running.has_ended
        problem = session.problem
        lines = [
            words.paragraph(f"· {problem.name if problem else 'no object yet'}", head=session.library.name)
        ]
        if word.text:
            lines.append(words.paragraph(word.text, words.BAD if word.is_bad else words.GOOD))
        else:
            lines.append(words.paragraph("New here? The panel Tour shows what this robot learned."))
        for ticket, what in ((session.planning, "plan"), (session.running.ticket, "run")):
            if ticket and (place := ticket.place):
                lines.append(words.paragraph(f"waiting in line: {counted(place, what)} with this one"))
        wrong = [*session.complaints().values(), *(f"damaged: {one}" for one in session.library.damage)]
        lines += [words.paragraph(why, words.BAD) for why in wrong]
        seen = words.scene_in_words(problem, session.library.grounding) if problem else "An empty table."
        scene = f"<span hidden data-scene>{words.safe(seen)}</span>"  # read by the page's script
        set_content(self._said, f'<div class="head" data-said tabindex="0">{"".join(lines)}</div>{scene}')


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
        self._wrong = gui.add_html("")
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
        self.map = MapField(self.page)
        with gui.add_folder("Objects of each category", expand_by_default=False):
            gui.add_html("").content = of_each(self.page)
        self.button("Add another like it", self._add)
        self.button("Take it away", lambda: session.remove(self.page.selected))
        with gui.add_folder("Ask in words", expand_by_default=False):
            hint = "As item-01 x=0.4..0.6, all 10 y=0.., or item-01 next-to item-02. Goals are chosen for it."
            self._asked = gui.add_text("What shall hold", "", hint=hint)
            self.button("Choose goals for that", lambda: session.ask(self._asked.value))
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
                label = f"{WORDS.get(name, name)} [mm]"
                slider = self.gui.add_slider(label, low, high, 1, low, hint="A size of the object.")
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
        told = (session.complaints().get(f"{what} {item.name}") for what in ("object", "goal"))
        set_content(self._wrong, "".join(words.paragraph(why, words.BAD) for why in told if why))
        self._toggle.label = "Take its goal away" if self._has_goal(problem) else "Give it a goal"
        asked = next((goal for goal in problem.relations if goal[0] == item.name), None)
        goals = (*session.goals_for(item.name), *filter(None, [asked]))
        self._choices = {_as_option(goal): goal for goal in goals}
        set_options(self._relation, (NOTHING, *self._choices), _as_option(asked) if asked else NOTHING)
        set_content(self._related, words.goals_in_words(problem.relations))
        set_value(self._name, problem.name)
        set_value(self._tolerance, round(1000 * problem.tolerance, 3))
        self.map.refresh(topics)
        if "scene" in topics:
            set_value(self._asked, " and ".join(problem.conditions))
            for slider, size in zip(self._sizes, item.features, strict=False):
                set_value(slider, round(1000 * size))
            kind = next(iter(item.features[len(self._sizes) :]), 0.0)
            set_value(self._type, _TYPES.get(kind, f"{kind:g}"))
            bits = words.bits_row(item.category, session.library.margins(item.features))
            set_content(self._bits, category_of(self.page) + bits)

    def _has_goal(self, problem: Problem) -> bool:
        return self.page.selected in (*problem.goals, *(name for name, *_ in problem.relations))

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
        elif problem is not None and any(goal[0] == name for goal in problem.relations):
            self.session.remove_goal(name)

    def _features(self) -> tuple[float, ...]:
        kinds = {label: kind for kind, label in _TYPES.items()}
        sizes, chosen = (float(slider.value) / 1000 for slider in self._sizes), self._type.value
        return (*sizes, kinds[chosen] if chosen in kinds else float(chosen))

    def _resize(self, _: Any) -> None:
        if self.page.item is not None:
            self.session.resize(self.page.selected, self._features())

    def _add(self) -> None:
        if not self._sizes:
            raise InvalidValue("What a camera sees is drawn, and not made by hand; draw another scene.")
        self.session.add(self._features())
        if self.session.problem is not None:
            self.page.select(self.session.problem.object_names[-1])

    def _draw(self) -> None:
        kind: Any = None if self._kind.value == _PAPER else self._kind.value
        self.session.draw(int(self._count.value), int(self._seed.value), kind)
        set_value(self._seed, int(self._seed.value) + 1)


def _as_option(goal: RelationGoal) -> str:
    """Say a goal by relation of an object that is known: `on item-04 · 011`."""
    said, bits = words.relation_in_words(goal[2])
    return f"{said} {goal[1]} · {bits}"


class PlanPanel(Panel):
    """Asks planners, and shows what they found."""

    def build(self) -> None:
        """Make the fields."""
        gui, session = self.gui, self.session
        self._planner = gui.add_dropdown("Planner", planners_here())
        self._go = self.button("Plan", lambda: session.plan(self._planner.value), color="green")
        self._stop = self.button("Stop planning", session.stop_planning, disabled=True)
        self._accept = self.button(
            "Accept the nearest goals", session.accept_nearest, visible=False, color="orange"
        )
        self._choose = heard(gui.add_dropdown("Show and run", (NOTHING,), visible=False), session.choose)
        self._text = gui.add_html("")
        self._steps = gui.add_button_group("Show step", ("1",), visible=False)
        self._steps.on_click(lambda event: self._pick(int(event.target.value)))
        self._at = 1  # the step that is shown, from 1
        with gui.add_folder("The page of PDDL", expand_by_default=False):
            self._pddl = gui.add_html("")

    def refresh(self, topics: set[Topic]) -> None:
        """Show the plans."""
        session, chosen = self.session, self.session.plan_shown
        if topics & {"status", "plan", "run"}:
            self._go.disabled = bool(session.planning) or session.is_running
            self._stop.disabled = not session.planning
        if not topics & {"plan", "scene", "step", "run"}:
            return
        self._choose.visible = len(session.plans) > 1
        if session.plans:
            set_options(self._choose, tuple(session.plans), session.chosen)
        self._accept.visible = chosen is not None and chosen.record.status is PlanStatus.NEAREST
        if (moment := session.running.moment) and session.is_running:
            self._at = moment.number
        plans = self._plans()
        lines = plans.get(session.chosen, ())
        self._at = max(1, min(self._at, len(lines)))
        numbers = tuple(str(number) for number in range(1, len(lines) + 1))
        self._steps.visible = len(lines) > 1
        if numbers and self._steps.options != numbers:
            self._steps.options = numbers
        set_content(self._text, self.text())
        set_content(self._pddl, self.pddl())
        self._draw_paths()

    def text(self) -> str:
        """Return what the planners found, as HTML: the chosen plan, or all side by side."""
        session, plans = self.session, self._plans()
        if session.problem is None or not session.plans:
            return ""
        palette, at = self.page.view.palette, None if session.running.replannings else self._at - 1
        parts = [words.plan_summary(one.record) for one in session.plans.values()]
        if len(plans) > 1:
            parts.append(lanes(plans, palette, session.chosen, at))
        else:
            parts += [plan_list(lines, palette, at) for lines in plans.values()]
        return "".join(parts)

    def _plans(self) -> dict[str, tuple[Line, ...]]:
        """Return the plans that were found, line by line, by planner."""
        if not self.session.plans:
            return {}
        task, found = self.session.task(), self.session.plans.items()
        every = {name: _steps_of(planned.record.steps) for name, planned in found}
        return {name: lines_of(steps, task) for name, steps in every.items() if steps}

    def _pick(self, number: int) -> None:
        """Show another step of the plan, as soon as the page is drawn."""
        self._at = number
        self.page.hear("plan")

    def pddl(self) -> str:
        """Return the page of PDDL as HTML; the action is marked that the step at hand is an instance of."""
        grounding, lines = self.session.library.grounding, self._plans().get(self.session.chosen, ())
        if not lines:
            return pddl_page(
                grounding, "", "", "Once there is a plan, the action of its step is marked here."
            )
        line = lines[self._at - 1]
        done = self.session.steps_in_pddl()[line.first : line.first + len(line.steps)]
        name = done[0][1:].split()[0] if done else action_for(line.steps[0].operator, grounding)
        return pddl_page(grounding, name, " ".join(done), f"step {self._at}: {line.said}")

    def _draw_paths(self) -> None:
        """Draw where the plan, or what is left of it, takes everything from where it is."""
        session, running = self.session, self.session.running
        chosen, moment, first = session.plan_shown, running.moment, 1
        if chosen is None or running.has_ended or (running.is_active and not running.problem):
            self.page.overlays.clear("paths")
            return
        steps, problem = _steps_of(chosen.record.steps), session.paired()
        if running.is_active and moment:
            steps, problem, first = moment.left, placed(problem, moment.scene), moment.number
        self.page.overlays.paths(self._legs(steps, problem, first))

    def _legs(self, steps: Sequence[PlanStep], problem: Problem, first: int) -> list[Leg]:
        """Return what each step of a plan does to each object; the first has a number."""
        grounding, legs = self.session.library.grounding, list[Leg]()
        task, ways = understand(problem, grounding), validate(steps, problem, grounding).positions
        for number, line in enumerate(lines_of(steps, task), start=first):
            until = min(line.first + len(line.steps), len(ways) - 1)
            for row, item in enumerate(problem.objects):
                ends, is_own = ways[[min(line.first, until), until], row], item.name == line.steps[0].object
                if np.linalg.norm(ends[1] - ends[0]) > _LEAST:
                    is_at = number == self._at
                    short = f"{number}: {line.said.partition(',')[0]}"
                    said = (short if is_at else str(number)) * is_own
                    legs.append(Leg(ends, self.page.view.palette(item.category), said, is_at))
        return legs


_LEAST = 1e-4  # displacements below this are none [m]


def _steps_of(named: Steps) -> tuple[PlanStep, ...]:
    return tuple(PlanStep(*parts) for parts in named)


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
        if running.run is not None and running.problem is not None:
            tolerance = running.run.tolerance or running.problem.tolerance
            parts.insert(0, words.run_summary(running.run, tolerance))
        elif running.is_active and moment and moment.left:
            line = lines_of(moment.left[:2], self.session.task())[0]
            parts.insert(0, words.paragraph(f"step {moment.number}: {line.said}"))
        if running.records:
            parts.append(words.run_table(running.records))
        return "".join(parts)

    def _run(self) -> None:
        self.session.running.begin(replans=None if self._anew.value else 0)

    def _toggle(self) -> None:
        self.session.running.steer(is_paused=not self.session.running.controls.is_paused)
