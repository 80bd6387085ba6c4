"""The table in three dimensions: arm, objects, goals, and what is drawn on the table beside them."""

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np
import viser

from neurosym.arrays import Float
from neurosym.poses import Posed
from neurosym.problems import Problem, SceneObject
from neurosym.studio.labels import label_heights
from neurosym.studio.library import Library
from neurosym.studio.messages import Seen
from neurosym.studio.shapes import circle, mesh_of, rectangle, scalar_first

COLOURS = (
    (66, 135, 209), (92, 178, 92), (204, 84, 92), (148, 107, 191),
    (237, 191, 61), (89, 186, 191), (140, 102, 77), (115, 120, 128),
)  # fmt: skip
"""Blue, green, red, purple, yellow, turquoise, brown, grey: as in pictures, one for each object."""
TABLE, BORDER, ARM, BAD = (178, 160, 136), (110, 94, 74), (199, 204, 212), (220, 50, 47)
KNOB, PIN = 0.014, 0.07
"""Radius of what a goal is dragged by, and how far above the goal's top it is [m]."""
_FLAT = 0.0015
EYE, LOOK, LENS = (1.15, 0.0, 1.05), (-0.08, 0.0, 0.08), 0.72
"""Where the camera is and looks at, from the middle of the table [m]; its angle of view [rad]."""
Grabbed = Callable[[str, str], Callable[[Any], Any]]
"""Gives what hears of a drag of an object or its goal: its kind and its name."""


@dataclass(slots=True)
class _Thing:
    """What is drawn of one object, or of one goal."""

    frame: viser.FrameHandle
    nodes: list[Any]
    outlines: list[Any]


class View:
    """What is seen of one session; all of its windows show the same.

    Args:
        scene: Where it is drawn.
        library: The domain.
        grabbed: Hears what is dragged.
    """

    def __init__(self, scene: viser.SceneApi, library: Library, grabbed: Grabbed | None = None):
        self._scene, self._library, self._grabbed = scene, library, grabbed
        self._objects: dict[str, _Thing] = {}
        self._goals: dict[str, _Thing] = {}
        self._labels: dict[str, viser.LabelHandle] = {}
        self._names: tuple[str, ...] = ()
        self._links: dict[int, viser.FrameHandle] = {}
        self._frames: dict[str, viser.FrameHandle] = {}
        self._draw_table()
        self._draw_robot()

    def _draw_table(self) -> None:
        table = self._library.grounding.table
        (near, far), (right, left) = table.x, table.y
        middle = (sum(table.x) / 2, sum(table.y) / 2)
        size = (far - near + 0.5, left - right + 0.5, 0.04)
        self._scene.add_box("/table", TABLE, size, position=(*middle, -0.0205))
        lines = rectangle((far - near) / 2, (left - right) / 2, _FLAT)
        self._scene.add_line_segments("/border", lines, BORDER, thickness=0.005, position=(*middle, 0.0))

    def _draw_robot(self) -> None:
        parts = self._library.robot_parts()
        for link in sorted({part.link for part in parts}):
            self._links[link] = self._scene.add_frame(f"/robot/{link}", show_axes=False)
            own = [part for part in parts if part.link == link]
            for number, colour in enumerate({part.colour: None for part in own}):
                corners, faces = mesh_of([part for part in own if part.colour == colour])
                shade = _shade(colour)
                self._scene.add_mesh_simple(
                    f"/robot/{link}/{number}", corners, faces, color=shade, flat_shading=False
                )
        self.rest()

    def rest(self) -> None:
        """Show the robot as it waits."""
        world = self._library.world
        if self._links and isinstance(world, Posed):
            self._pose_links(world.robot_at_rest())

    def show_problem(
        self,
        problem: Problem,
        ghosts: Mapping[str, tuple[float, float, float]],
        complaints: Mapping[str, str] = MappingProxyType({}),
    ) -> None:
        """Draw a problem anew.

        Args:
            problem: The problem.
            ghosts: Where the ghost of each object with a goal stands [m].
            complaints: What is wrong, by `object NAME` and `goal NAME`.
        """
        self.show_objects(problem.objects, ghosts)
        self.set_tolerance(problem.tolerance)
        self.place(problem.objects, ghosts, complaints, related_names(problem))

    def show_objects(
        self, items: tuple[SceneObject, ...], goals: Mapping[str, tuple[float, float, float]]
    ) -> None:
        """Draw all objects and goals anew.

        Args:
            items: The objects.
            goals: Where the centre of an object shall come to be [m], by name.
        """
        for label in self._labels.values():
            label.remove()
        for thing in (*self._objects.values(), *self._goals.values()):
            for node in (*thing.nodes, *thing.outlines):
                node.remove()
        self._objects, self._goals, self._labels = {}, {}, {}
        self._names = tuple(item.name for item in items)
        for number, item in enumerate(items):
            colour = COLOURS[number % len(COLOURS)]
            self._objects[item.name] = self._object(item, colour)
            if item.name in goals:
                self._goals[item.name] = self._goal(item, colour)
            self._labels[item.name] = self._scene.add_label(
                f"/labels/{item.name}", f"{item.name} · {item.category}", anchor="bottom-center"
            )
        self.place(items, goals, {})

    def place(
        self,
        items: tuple[SceneObject, ...],
        goals: Mapping[str, tuple[float, float, float]],
        complaints: Mapping[str, str],
        related: Collection[str] = (),
    ) -> None:
        """Put objects and goals where they are, red where they cannot be.

        Args:
            items: The objects.
            goals: Where the centre of an object shall come to be [m], by name.
            complaints: What is wrong, by `object NAME` and `goal NAME`.
            related: Names of the objects whose goal is by relation, to which no tolerance belongs.
        """
        for number, item in enumerate(items):
            colour, thing = COLOURS[number % len(COLOURS)], self._objects[item.name]
            thing.frame.position, thing.frame.wxyz = item.position, scalar_first(item.orientation)
            thing.nodes[0].color = BAD if f"object {item.name}" in complaints else colour
            if item.name in self._goals:
                x, y, z = goals[item.name]
                ghost = self._goals[item.name]
                ghost.frame.position = (x, y, z)
                for node in ghost.nodes:
                    node.color = BAD if f"goal {item.name}" in complaints else colour
                for outline in ghost.outlines:
                    outline.position = (0.0, 0.0, -z)
                ghost.outlines[1].visible = item.name not in related
        self._place_labels({item.name: (item.position, item.features[2]) for item in items})

    def show(self, seen: Seen) -> None:
        """Put the robot and the objects where they are at one moment of a motion."""
        if len(seen.links):
            self._pose_links(seen.links)
        for name, position, orientation in zip(self._names, seen.positions, seen.orientations, strict=False):
            self.show_object(name, position, orientation)

    def show_object(
        self, name: str, position: Float[np.ndarray, "3"], orientation: Float[np.ndarray, "4"] | None = None
    ) -> None:
        """Put one object where it is now [m]."""
        frame = self._objects[name].frame
        frame.position = tuple(np.round(position, 4))
        if orientation is not None:
            frame.wxyz = scalar_first(np.round(orientation, 4).tolist())
        x, y, _ = frame.position
        self._labels[name].position = (float(x), float(y), float(position[2]) + 0.09)

    def _pose_links(self, links: Float[np.ndarray, "L 7"]) -> None:
        for number, frame in self._links.items():
            frame.position = tuple(np.round(links[number, :3], 4))
            frame.wxyz = scalar_first(np.round(links[number, 3:], 4).tolist())

    def _place_labels(self, spots: Mapping[str, tuple[tuple[float, float, float], float]]) -> None:
        for name, height in label_heights(spots).items():
            (x, y, _), _ = spots[name]
            self._labels[name].position = (x, y, height)

    def _frame(self, path: str) -> viser.FrameHandle:
        """Return what is hung up there, and keep it: windows remember how one of that name was turned."""
        if path not in self._frames:
            self._frames[path] = self._scene.add_frame(path, show_axes=False)
        return self._frames[path]

    def _object(self, item: SceneObject, colour: tuple[int, int, int]) -> _Thing:
        frame = self._frame(f"/objects/{item.name}")
        corners, faces = mesh_of(self._library.object_parts(item.features))
        node = self._scene.add_mesh_simple(
            f"/objects/{item.name}/body", corners, faces, color=colour, flat_shading=True
        )
        if self._grabbed:
            node.on_drag("left")(self._grabbed("object", item.name))
        return _Thing(frame, [node], [])

    def _goal(self, item: SceneObject, colour: tuple[int, int, int]) -> _Thing:
        """Draw a ghost, the knob on its pin that it is dragged by, its footprint and its tolerance."""
        name, top = item.name, item.features[2] / 2
        frame = self._frame(f"/goals/{name}")
        corners, faces = mesh_of(self._library.object_parts(item.features))
        ghost = self._scene.add_mesh_simple(
            f"/goals/{name}/ghost",
            corners,
            faces,
            color=colour,
            opacity=0.35,
            flat_shading=True,
            cast_shadow=False,
        )
        knob = self._scene.add_icosphere(f"/goals/{name}/knob", KNOB, colour, position=(0.0, 0.0, top + PIN))
        pin = self._scene.add_cylinder(
            f"/goals/{name}/pin", 0.003, PIN, colour, position=(0.0, 0.0, top + PIN / 2)
        )
        x, y = item.features[0] / 2, item.features[1] / 2
        footprint = self._scene.add_line_segments(
            f"/goals/{name}/footprint", rectangle(x, y, _FLAT), colour, thickness=0.004
        )
        ring = self._scene.add_line_segments(
            f"/goals/{name}/tolerance", circle(1.0, 2 * _FLAT), colour, thickness=0.003
        )
        if self._grabbed:
            for node in (ghost, knob, pin):
                node.on_drag("left")(self._grabbed("goal", name))
        return _Thing(frame, [ghost, knob, pin], [footprint, ring])

    def set_tolerance(self, tolerance: float) -> None:
        """Draw how near objects must come to their goals [m]."""
        for thing in self._goals.values():
            thing.outlines[1].points = circle(tolerance, 2 * _FLAT).astype(np.float32)


def related_names(problem: Problem) -> tuple[str, ...]:
    """Name the objects whose goal is by relation.

    Args:
        problem: The problem.
    """
    return tuple(name for name, *_ in problem.related)


def _shade(colour: tuple[float, float, float] | None) -> tuple[int, int, int]:
    red, green, blue = colour or (one / 255 for one in ARM)
    return round(255 * red), round(255 * green), round(255 * blue)


def aim_camera(server: viser.ViserServer, library: Library) -> None:
    """Have new windows look over the table at the robot.

    Args:
        server: The server of the page.
        library: The domain, for its table.
    """
    x, y = library.middle
    server.initial_camera.position = (x + EYE[0], y + EYE[1], EYE[2])
    server.initial_camera.look_at = (x + LOOK[0], y + LOOK[1], LOOK[2])
    server.initial_camera.fov = LENS
