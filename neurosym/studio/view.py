"""The table in three dimensions: arm, objects, goals, and what is drawn on the table beside them."""

import math
import threading
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from itertools import cycle
from types import MappingProxyType
from typing import Any

import numpy as np
import trimesh
import viser
from scipy.spatial.transform import Rotation

from neurosym.checks import Float
from neurosym.contract import Part, Pose, Posed
from neurosym.execution.record import StepRecord
from neurosym.operators import Vector, vector
from neurosym.problems import Problem, SceneObject
from neurosym.studio.desk import Library
from neurosym.studio.messages import Seen
from neurosym.studio.scene_editor import ghost_spots
from neurosym.tasks.task import understand

_WAYPOINTS = ((62, 117, 196), (68, 158, 88), (201, 72, 76))
"""Blue the first, green the second, red the third, as in pictures."""
PUSH, LIFT = (245, 166, 35), (123, 97, 255)
_OVER = 0.004


class Overlays:
    """Layers over the table, each drawn anew as a whole.

    Args:
        scene: Where they are drawn.
    """

    def __init__(self, scene: viser.SceneApi):
        self._scene = scene
        self._layers: dict[str, list[Any]] = {}

    def clear(self, layer: str) -> None:
        """Take a layer away."""
        for node in self._layers.pop(layer, []):
            with suppress(RuntimeError, KeyError):  # it went with what it hung on
                node.remove()

    def paths(
        self, positions: Float[np.ndarray, "steps M 3"], colours: Sequence[tuple[int, int, int]]
    ) -> None:
        """Draw the way of each object through a plan, with a dot for each step.

        The positions are centres of the objects before the first step and after each [m].
        """
        self.clear("paths")
        nodes = self._layers.setdefault("paths", [])
        for number in range(positions.shape[1]):
            way = positions[:, number] + [0.0, 0.0, _OVER]
            moves = np.linalg.norm(np.diff(way, axis=0), axis=1) > 1e-4
            if not moves.any():
                continue
            lines = np.stack([way[:-1][moves], way[1:][moves]], axis=1)
            colour = colours[number % len(colours)]
            nodes.append(self._scene.add_line_segments(f"/paths/{number}", lines, colour, thickness=0.006))
            nodes.append(self._cloud(f"/paths/{number}-dots", way[1:][moves], colour, 0.011))

    def _cloud(self, name: str, points: np.ndarray, colours: Any, size: float) -> Any:
        return self._scene.add_point_cloud(
            name, points, colours, point_size=size, point_shape="circle", precision="float32"
        )

    def arrows(self, start: Sequence[float], effects: Sequence[tuple[Sequence[float], bool]]) -> None:
        """Draw where operators take an object, each arrow with its number from 1.

        They begin above the object so that they stay visible. Start and effects are in metres; each effect
        comes with whether it lifts.
        """
        self.clear("arrows")
        ends = np.array([np.add(start, effect) for effect, _ in effects]).reshape(-1, 3)
        points = np.stack([np.tile(np.array(start, dtype=float), (len(ends), 1)), ends], axis=1)
        colours = np.array([LIFT if lifts else PUSH for _, lifts in effects], dtype=np.uint8)
        if not len(ends):
            return
        nodes: list[Any] = [
            self._scene.add_arrows(
                "/arrows", points, colours, shaft_radius=0.002, head_radius=0.007, head_length=0.016
            )
        ]
        for number, end in enumerate(ends, start=1):
            nodes.append(
                self._scene.add_label(
                    f"/arrow-labels/{number}", str(number), position=tuple(end), font_screen_scale=0.8
                )
            )
        self._layers["arrows"] = nodes

    def dots(
        self, points: Float[np.ndarray, "N 3"], colours: Float[np.ndarray, "N 3"], layer: str = "dots"
    ) -> None:
        """Draw dots, as of rehearsals around a promise.

        The points are in metres, and the colours from 0 to 255.
        """
        self.clear(layer)
        if len(points):
            self._layers[layer] = [self._cloud(f"/{layer}", points, colours.astype(np.uint8), 0.007)]

    def waypoints(
        self,
        points: Float[np.ndarray, "3 3"],
        moved: Callable[[int, tuple[float, float, float]], None],
    ) -> None:
        """Draw the waypoints of an action, each to be dragged.

        `moved` is called with the number of one, from 0, and where it was dragged to [m].
        """
        self.clear("waypoints")
        lines = np.stack([points[:-1], points[1:]], axis=1)
        nodes: list[Any] = [self._scene.add_line_segments("/way", lines, (90, 90, 90), thickness=0.003)]
        for number, point in enumerate(points):
            colour = _WAYPOINTS[number % len(_WAYPOINTS)]
            ball = self._scene.add_icosphere(f"/waypoints/{number}", 0.012, colour, position=tuple(point))
            handle = self._scene.add_transform_controls(
                f"/waypoint-handles/{number}",
                scale=0.07,
                disable_rotations=True,
                disable_sliders=True,
                position=tuple(point),
            )
            handle.on_update(_teller(number, moved))
            nodes += [ball, handle]
        self._layers["waypoints"] = nodes

    def follow(self, points: Float[np.ndarray, "3 3"]) -> None:
        """Put the waypoints elsewhere, while one of them is dragged [m]."""
        nodes = self._layers.get("waypoints", [])
        if nodes:
            nodes[0].points = np.stack([points[:-1], points[1:]], axis=1).astype(np.float32)
            for ball, point in zip(nodes[1::2], points, strict=True):
                ball.position = tuple(point)


def _teller(number: int, moved: Callable[[int, tuple[float, float, float]], None]) -> Callable[[Any], Any]:
    async def tell(event: Any) -> None:
        x, y, z = (float(part) for part in event.target.position)
        moved(number, (x, y, z))

    return tell


# Simple bodies as triangles, since a page draws and grabs each thing as one mesh

_SIDES = 20
"""How many sides a cylinder is drawn with."""


def mesh_of(parts: Sequence[Part]) -> Any:
    """Return one closed mesh of trimesh of several bodies, all in one frame, its faces seen from outside."""
    return trimesh.util.concatenate([_mesh(part) for part in parts])


def scalar_first(quaternion: Sequence[float]) -> tuple[float, float, float, float]:
    """Return a quaternion (x, y, z, w) as a page wants it: (w, x, y, z)."""
    x, y, z, w = (float(part) for part in quaternion)
    return w, x, y, z


def circle(radius: float, height: float, count: int = 48) -> Float[np.ndarray, "N 2 3"]:
    """Return a circle around the origin as lines, each from one point to the next [m]."""
    angles = np.linspace(0, 2 * math.pi, count + 1)
    points = np.column_stack([radius * np.cos(angles), radius * np.sin(angles), np.full(count + 1, height)])
    return np.stack([points[:-1], points[1:]], axis=1)


def rectangle(x: float, y: float, height: float) -> Float[np.ndarray, "4 2 3"]:
    """Return a rectangle around the origin as lines, by half its edges [m]."""
    points = np.array([[x, y, height], [-x, y, height], [-x, -y, height], [x, -y, height], [x, y, height]])
    return np.stack([points[:-1], points[1:]], axis=1)


def _mesh(part: Part) -> Any:
    if part.kind == "box":
        mesh = trimesh.creation.box(part.size)
    elif part.kind == "cylinder":
        mesh = trimesh.creation.cylinder(part.size[0], part.size[1], sections=_SIDES)
    else:
        mesh = trimesh.creation.icosphere(subdivisions=2, radius=part.size[0])
    place = np.eye(4)
    place[:3, :3] = Rotation.from_quat(part.orientation).as_matrix()
    place[:3, 3] = part.position
    return mesh.apply_transform(place)


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
_Grabbed = Callable[[str, str], Callable[[Any], Any]]
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

    def __init__(self, scene: viser.SceneApi, library: Library, grabbed: _Grabbed | None = None):
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

        Complaints say what is wrong, by `object NAME` and `goal NAME`.
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


_LEVEL = 1e-6


class Grab:
    """One thing that is dragged: it keeps the offset from where it was grabbed.

    Args:
        eye: Where the camera is [m].
        point: Where the thing was grabbed [m].
        centre: Where the thing is [m].
    """

    def __init__(self, eye: Sequence[float], point: Sequence[float], centre: Sequence[float]):
        self._eye, self._height = np.array(eye, dtype=float), float(point[2])
        self._offset = np.subtract(centre, point)[:2]

    def to(self, point: Sequence[float]) -> tuple[float, float] | None:
        """Return where the centre comes to be, x and y [m], if the pointer is over a point at any distance.

        That is where the line of sight through the point meets the level of the grab; None if it does not.
        """
        ray = np.array(point, dtype=float) - self._eye
        if abs(ray[2]) < _LEVEL:
            return None
        share = (self._height - self._eye[2]) / ray[2]
        if not (np.isfinite(share) and share > 0):
            return None
        x, y = ((self._eye + share * ray)[:2] + self._offset).tolist()
        return x, y


_PACE = 1 / 15
"""Time between two poses that are kept, of a motion as it is [s]."""
_PAUSE = 0.4
"""How long the end of a step is shown [s]."""
_RECORDED_FROM = 0.55
"""How high above the middle of the table the name of a step stands [m]."""
_LOCK = threading.Lock()


def film_of(
    library: Library,
    problem: Problem,
    seen: Sequence[Seen],
    steps: Sequence[StepRecord] = (),
) -> bytes:
    """Return what was seen of a run as one HTML file that needs nothing else.

    Steps are named while they are seen, as far as it is known at which step that was.
    """
    with _LOCK:
        server = _server()
        server.scene.reset()
        server.scene.set_up_direction("+z")
        aim_camera(server, library)
        view = View(server.scene, library)
        view.show_problem(problem, ghost_spots(understand(library.paired(problem), library.grounding)))
        view.show(seen[0].pose)
        names = step_labels(steps)
        label = server.scene.add_label("/step", "", position=(*library.middle, _RECORDED_FROM), visible=False)
        film = server.get_scene_serializer()
        last = -_PACE
        for one in seen:
            if one.pose.seconds < last:  # another motion begins
                film.insert_sleep(_PAUSE)
                last = -_PACE
            if label.text != (name := names.get(one.step, "")):
                label.text, label.visible = name, bool(name)
            if one.pose.seconds - last >= _PACE * 0.99:
                film.insert_sleep(min(one.pose.seconds - last, _PACE * 4) if last >= 0 else 0.0)
                view.show(one.pose)
                last = one.pose.seconds
        view.show(seen[-1].pose)
        film.insert_sleep(2 * _PAUSE)
        return film.as_html().encode()


def step_labels(steps: Sequence[StepRecord]) -> dict[int, str]:
    """Return what a film shows above the table at each step, by its number."""
    return {
        number: f"{number}: {step.operator} {step.object} {step.place or ''}".rstrip()
        for number, step in enumerate(steps, start=1)
    }


class Reel:
    """A run is seen and kept, for a film of it; see `Way`."""

    def __init__(self) -> None:
        self.seen: list[Seen] = []

    def send(self, message: Any, /) -> None:
        """Keep what is seen."""
        if isinstance(message, Seen):
            self.seen.append(message)

    def poll(self, seconds: float = 0.0, /) -> bool:  # noqa: ARG002  (a `Way`)
        """Say that nobody says anything."""
        return False

    def recv(self) -> Any:
        """Return nothing."""
        return None


@cache
def _server() -> viser.ViserServer:
    """Return a server that nobody looks at, in which films are made, one after another."""
    return viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
