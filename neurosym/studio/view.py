"""The table in three dimensions: arm, objects, goals, and what is drawn on the table beside them."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import cycle
from types import MappingProxyType
from typing import Any

import numpy as np
import viser

from neurosym.arrays import Float
from neurosym.operators import Vector, vector
from neurosym.poses import Part, Pose, Posed
from neurosym.problems import Problem, SceneObject
from neurosym.studio.library import Library
from neurosym.studio.shapes import circle, mesh_of, rectangle, scalar_first

COLOURS = (
    (66, 135, 209), (92, 178, 92), (204, 84, 92), (148, 107, 191),
    (237, 191, 61), (89, 186, 191), (140, 102, 77), (115, 120, 128),
)  # fmt: skip
"""Blue, green, red, purple, yellow, turquoise, brown, grey: as in pictures, one for each object."""
TABLE, BORDER, ARM, BAD = (178, 160, 136), (110, 94, 74), (199, 204, 212), (220, 50, 47)
KNOB, PIN = 0.014, 0.07
"""Radius of what a goal is dragged by, and how far above the goal's top it is [m]."""
ABOVE, LABEL = 0.03, (0.16, 0.035)
"""How far above its object a label stands at least; about its width and height as seen from the front [m]."""
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
                same = [part for part in own if part.colour == colour]
                self._mesh(f"/robot/{link}/{number}", same, _shade(colour), flat_shading=False)
        self.rest()

    def rest(self) -> None:
        """Show the robot as it waits."""
        world = self._library.world
        if self._links and isinstance(world, Posed):
            self._pose_links(world.robot_at_rest())

    def show_problem(
        self,
        problem: Problem,
        ghosts: Mapping[str, Vector],
        complaints: Mapping[str, str] = MappingProxyType({}),
    ) -> None:
        """Draw a problem anew; see `place`."""
        for label in self._labels.values():
            label.remove()
        for thing in (*self._objects.values(), *self._goals.values()):
            for node in (*thing.nodes, *thing.outlines):
                node.remove()
        self._objects, self._goals, self._labels = {}, {}, {}
        for item, colour in zip(problem.objects, cycle(COLOURS), strict=False):
            self._objects[item.name] = self._object(item, colour)
            if item.name in ghosts:
                self._goals[item.name] = self._goal(item, colour, problem.tolerance)
            self._labels[item.name] = self._scene.add_label(
                f"/labels/{item.name}", f"{item.name} · {item.category}", anchor="bottom-center"
            )
        self.place(problem, ghosts, complaints)

    def place(self, problem: Problem, ghosts: Mapping[str, Vector], complaints: Mapping[str, str]) -> None:
        """Put objects and goals where they are, red where they cannot be.

        Args:
            problem: The problem, of the objects and goals that are drawn.
            ghosts: Where the ghost of each object with a goal stands [m].
            complaints: What is wrong, by `object NAME` and `goal NAME`.
        """
        related = related_names(problem)
        for item, colour in zip(problem.objects, cycle(COLOURS), strict=False):
            thing = self._objects[item.name]
            thing.frame.position, thing.frame.wxyz = item.position, scalar_first(item.orientation)
            thing.nodes[0].color = BAD if f"object {item.name}" in complaints else colour
            if (ghost := self._goals.get(item.name)) is not None:
                ghost.frame.position = ghosts[item.name]
                for node in ghost.nodes:
                    node.color = BAD if f"goal {item.name}" in complaints else colour
                for outline in ghost.outlines:
                    outline.position = (0.0, 0.0, -ghosts[item.name][2])
                ghost.outlines[1].visible = item.name not in related  # no tolerance belongs to it
        self._place_labels(problem.objects)

    def show(self, pose: Pose) -> None:
        """Put the robot and the objects where they are at one moment of a motion."""
        if len(pose.links):
            self._pose_links(pose.links)
        self.show_bodies(pose.positions, pose.orientations)

    def show_bodies(
        self, positions: Float[np.ndarray, "M 3"], orientations: Float[np.ndarray, "M 4"]
    ) -> None:
        """Put objects where they are now [m], in the order in which they were drawn."""
        for name, position, turn in zip(self._objects, positions, orientations, strict=False):
            frame = self._objects[name].frame
            x, y, z = frame.position = vector(np.round(position, 4))
            frame.wxyz = scalar_first(np.round(turn, 4).tolist())
            self._labels[name].position = (x, y, z + 0.09)

    def _pose_links(self, links: Float[np.ndarray, "L 7"]) -> None:
        for number, frame in self._links.items():
            frame.position = vector(np.round(links[number, :3], 4))
            frame.wxyz = scalar_first(np.round(links[number, 3:], 4).tolist())

    def _place_labels(self, items: Sequence[SceneObject]) -> None:
        """Put labels above their objects; the farther ones give way upwards, so that none covers another."""
        placed: list[tuple[float, float]] = []
        for item in sorted(items, key=lambda item: (item.position[0], item.name)):
            x, y, z = item.position
            farther, height = 0.7 * x, z + item.features[2] / 2 + ABOVE  # what is farther is seen higher
            while clash := [
                other
                for side, other in placed
                if abs(side - y) < LABEL[0] and abs(other - height - farther) < LABEL[1]
            ]:
                height = max(clash) + LABEL[1] - farther + 1e-6
            placed.append((y, height + farther))
            self._labels[item.name].position = (x, y, height)

    def _frame(self, path: str) -> viser.FrameHandle:
        """Return what is hung up there, and keep it: windows remember how one of that name was turned."""
        if path not in self._frames:
            self._frames[path] = self._scene.add_frame(path, show_axes=False)
        return self._frames[path]

    def _mesh(
        self, path: str, parts: Sequence[Part], colour: tuple[int, int, int], **options: Any
    ) -> viser.MeshHandle:
        body, options = mesh_of(parts), {"flat_shading": True} | options
        return self._scene.add_mesh_simple(path, body.vertices, body.faces, color=colour, **options)

    def _object(self, item: SceneObject, colour: tuple[int, int, int]) -> _Thing:
        frame = self._frame(f"/objects/{item.name}")
        node = self._mesh(f"/objects/{item.name}/body", self._library.object_parts(item.features), colour)
        if self._grabbed:
            node.on_drag("left")(self._grabbed("object", item.name))
        return _Thing(frame, [node], [])

    def _goal(self, item: SceneObject, colour: tuple[int, int, int], tolerance: float) -> _Thing:
        """Draw a ghost, the knob on its pin that it is dragged by, its footprint and its tolerance."""
        name, top = item.name, item.features[2] / 2
        frame = self._frame(f"/goals/{name}")
        parts = self._library.object_parts(item.features)
        ghost = self._mesh(f"/goals/{name}/ghost", parts, colour, opacity=0.35, cast_shadow=False)
        knob = self._scene.add_icosphere(f"/goals/{name}/knob", KNOB, colour, position=(0.0, 0.0, top + PIN))
        pin = self._scene.add_cylinder(
            f"/goals/{name}/pin", 0.003, PIN, colour, position=(0.0, 0.0, top + PIN / 2)
        )
        x, y = item.features[0] / 2, item.features[1] / 2
        footprint = self._scene.add_line_segments(
            f"/goals/{name}/footprint", rectangle(x, y, _FLAT), colour, thickness=0.004
        )
        ring = self._scene.add_line_segments(
            f"/goals/{name}/tolerance", circle(tolerance, 2 * _FLAT), colour, thickness=0.003
        )
        if self._grabbed:
            for node in (ghost, knob, pin):
                node.on_drag("left")(self._grabbed("goal", name))
        return _Thing(frame, [ghost, knob, pin], [footprint, ring])


def related_names(problem: Problem) -> tuple[str, ...]:
    """Name the objects whose goal is by relation."""
    return tuple(name for name, *_ in problem.related)


def _shade(colour: tuple[float, float, float] | None) -> tuple[int, int, int]:
    red, green, blue = colour or (one / 255 for one in ARM)
    return round(255 * red), round(255 * green), round(255 * blue)


def aim_camera(server: viser.ViserServer, library: Library) -> None:
    """Have new windows of a page look over the table of a domain at the robot."""
    x, y = library.middle
    server.initial_camera.position = (x + EYE[0], y + EYE[1], EYE[2])
    server.initial_camera.look_at = (x + LOOK[0], y + LOOK[1], LOOK[2])
    server.initial_camera.fov = LENS
