"""The panel `Table`: which objects there are, where they stand, and where they shall go."""

from typing import Any, get_args

import msgspec

from neurosym.choices import DrawnTask, TaskKind
from neurosym.problems import Problem, SceneObject
from neurosym.relation_goals import RelationGoal
from neurosym.studio.desk import MOST_OBJECTS, Topic
from neurosym.studio.panel import Panel, by_user, set_content, set_options, set_value
from neurosym.studio.placing import reach_of
from neurosym.studio.view import related_names
from neurosym.studio.words import bits_row, paragraph, relation_list, safe

PAPER = "as in the paper"
"""The kind of tasks that is drawn unless one is named."""
TYPES = {0.0: "solid", 1.0: "open at the top", 2.0: "open at both ends"}
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
        self._reach = gui.add_checkbox("Show its reach", False, hint="Where three steps bring it.")
        self._reach.on_update(by_user(lambda _: self._show_reach()))
        with gui.add_folder("Draw a task", expand_by_default=False):
            kinds = get_args(DrawnTask if has_relations else TaskKind)
            self._kind = gui.add_dropdown("Kind", (PAPER, *kinds))
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
            types = tuple(TYPES.get(kind, f"{kind:g}") for kind in (limits.types if limits else (0.0,)))
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
            set_value(self._type, TYPES.get(kind, f"{kind:g}"))
            set_content(self._bits, self.text_of(item))
        if topics & {"scene", "place"}:
            self._show_reach()

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
        found = {choice_of(goal): goal for goal in (*self.session.goals_for(name), *filter(None, [asked]))}
        self._choices = found
        set_options(self._relation, (NOTHING, *found), choice_of(asked) if asked else NOTHING)
        set_content(self._related, relation_list(problem.related))

    def _relate(self, choice: str) -> None:
        problem, name = self.session.problem, self.page.selected
        if choice in self._choices:
            self.session.relate(*self._choices[choice])
        elif problem is not None and name in related_names(problem):
            self.session.remove_goal(name)

    def _features(self) -> tuple[float, ...]:
        kinds = {label: kind for kind, label in TYPES.items()}
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
        kind: Any = None if self._kind.value == PAPER else self._kind.value
        self.session.draw(int(self._count.value), int(self._seed.value), kind)
        set_value(self._seed, int(self._seed.value) + 1)

    def _show_reach(self) -> None:
        item = self.page.item
        if self._reach.value and item is not None:
            self.page.overlays.reach(
                reach_of(item, self.session.library.grounding), self.page.colour_of(item.name)
            )
        else:
            self.page.overlays.clear("reach")


def choice_of(goal: RelationGoal) -> str:
    """Return what a goal by relation is called among the choices for its object: `rests-on-001 item-02`."""
    _, reference, state = goal
    return f"{state} {reference}"
