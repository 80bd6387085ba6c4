"""The table in three dimensions: arm, objects, goals, and what is drawn on the table beside them."""

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
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
from neurosym.studio.library import Library
from neurosym.studio.messages import Seen
from neurosym.studio.scene_editor import ghost_spots
from neurosym.tasks.task import understand

_Numbers = Sequence[float] | Float[np.ndarray, "N"]
Colour = tuple[int, int, int]
"""Red, green and blue, 0 to 255."""
COLOURS: tuple[Colour, ...] = (
    (66, 135, 209), (92, 178, 92), (204, 84, 92), (148, 107, 191),
    (237, 191, 61), (89, 186, 191), (140, 102, 77), (115, 120, 128),
)  # fmt: skip
"""Blue, green, red, purple, yellow, turquoise, brown, grey: as in pictures, one for each object."""
_TABLE, _BORDER, _ARM, _BAD = (178, 160, 136), (110, 94, 74), (199, 204, 212), (220, 50, 47)
_WAYPOINTS, _WAY = ((62, 117, 196), (68, 158, 88), (201, 72, 76)), (90, 90, 90)
"""Blue the first, green the second, red the third, as in pictures; and the lines between them."""
_PUSH, _LIFT = (245, 166, 35), (123, 97, 255)
_OVER, _FLAT = 0.004, 0.0015  # how far above the table paths and outlines are drawn [m]
_KNOB, _PIN = 0.014, 0.07  # radius of what a goal is dragged by, and how far above the goal's top it is [m]
_ABOVE, _ABOVE_MOVING, LABEL = 0.03, 0.09, (0.16, 0.035)
"""How far a label stands above its object's top at least, and above the centre of one that moves; about its
width and height as seen from the front [m]."""
_EYE, _LOOK, _LENS = (1.15, 0.0, 1.05), (-0.08, 0.0, 0.08), 0.72
"""Where the camera is and looks at, from the middle of the table [m]; its angle of view [rad]."""
_SIDES = 20  # how many sides a cylinder is drawn with


class Overlays:
    """Layers over the table, each drawn anew as a whole."""

    def __init__(self, scene: viser.SceneApi):
        self._scene = scene
        self._layers: dict[str, list[Any]] = {}

    def clear(self, layer: str) -> list[Any]:
        """Take away what is on a layer, and return the layer for what comes instead."""
        for node in self._layers.get(layer, []):
            with suppress(RuntimeError, KeyError):  # it went with what it hung on
                node.remove()
        self._layers[layer] = []
        return self._layers[layer]

    def paths(self, positions: Float[np.ndarray, "steps M 3"], colours: Sequence[Colour]) -> None:
        """Draw the ways of objects, given their centres before a plan and after each step [m], with dots."""
        nodes = self.clear("paths")
        for number in range(positions.shape[1]):
            way, colour = positions[:, number] + [0.0, 0.0, _OVER], colours[number % len(colours)]
            moves = np.linalg.norm(np.diff(way, axis=0), axis=1) > 1e-4
            if moves.any():
                lines = np.stack([way[:-1][moves], way[1:][moves]], axis=1)
                path = f"/paths/{number}"
                nodes.append(self._scene.add_line_segments(path, lines, colour, thickness=0.006))
                nodes.append(self._cloud(f"{path}-dots", way[1:][moves], colour, 0.011))

    def arrows(self, start: Sequence[float], effects: Sequence[tuple[Sequence[float], bool]]) -> None:
        """Draw numbered arrows from above an object to where operators take it [m]; some of them lift."""
        nodes = self.clear("arrows")
        if not effects:
            return
        ends = np.array([np.add(start, effect) for effect, _ in effects])
        points = np.stack([np.broadcast_to(start, ends.shape), ends], axis=1)
        colours = np.array([_LIFT if lifts else _PUSH for _, lifts in effects], dtype=np.uint8)
        nodes.append(
            self._scene.add_arrows(
                "/arrows", points, colours, shaft_radius=0.002, head_radius=0.007, head_length=0.016
            )
        )
        for number, end in enumerate(ends, start=1):
            path, spot = f"/arrow-labels/{number}", tuple(end)
            nodes.append(self._scene.add_label(path, str(number), position=spot, font_screen_scale=0.8))

    def dots(self, points: Float[np.ndarray, "N 3"], colours: Float[np.ndarray, "N 3"]) -> None:
        """Draw dots, as of rehearsals around a promise: points [m], and colours from 0 to 255."""
        nodes = self.clear("dots")
        if len(points):
            nodes.append(self._cloud("/dots", points, colours.astype(np.uint8), 0.007))

    def waypoints(
        self,
        points: Float[np.ndarray, "3 3"],
        moved: Callable[[int, tuple[float, float, float]], None],
    ) -> None:
        """Draw the waypoints of an action [m]; `moved` hears which one, from 0, is dragged where to [m]."""
        nodes = self.clear("waypoints")
        nodes.append(self._scene.add_line_segments("/way", _segments(points), _WAY, thickness=0.003))

        def teller(number: int) -> Callable[[Any], Any]:
            async def tell(event: Any) -> None:
                x, y, z = (float(part) for part in event.target.position)
                moved(number, (x, y, z))

            return tell

        for number, point in enumerate(points):
            path, spot = f"/waypoints/{number}", tuple(point)
            nodes.append(self._scene.add_icosphere(path, 0.012, _WAYPOINTS[number], position=spot))
            path = f"/waypoint-handles/{number}"
            handle = self._scene.add_transform_controls(
                path, scale=0.07, position=spot, disable_rotations=True, disable_sliders=True
            )
            handle.on_update(teller(number))
            nodes.append(handle)

    def follow(self, points: Float[np.ndarray, "3 3"]) -> None:
        """Put the waypoints elsewhere, while one of them is dragged [m]."""
        if nodes := self._layers.get("waypoints"):
            nodes[0].points = _segments(points).astype(np.float32)
            for ball, point in zip(nodes[1::2], points, strict=True):
                ball.position = tuple(point)

    def _cloud(self, name: str, points: np.ndarray, colours: Any, size: float) -> Any:
        return self._scene.add_point_cloud(
            name, points, colours, point_size=size, point_shape="circle", precision="float32"
        )


def _segments(points: Float[np.ndarray, "N 3"]) -> Float[np.ndarray, "N-1 2 3"]:
    """Return lines, each from one point to the next."""
    return np.stack([points[:-1], points[1:]], axis=1)


def circle(radius: float, height: float, count: int = 48) -> Float[np.ndarray, "N 2 3"]:
    """Return a circle around the origin as lines [m]."""
    angles = np.linspace(0, 2 * math.pi, count + 1)
    return _segments(
        np.stack([radius * np.cos(angles), radius * np.sin(angles), np.full_like(angles, height)], axis=1)
    )


def rectangle(x: float, y: float, height: float) -> Float[np.ndarray, "4 2 3"]:
    """Return a rectangle around the origin as lines, by half its edges [m]."""
    corners = ((x, y), (-x, y), (-x, -y), (x, -y), (x, y))
    return _segments(np.array([(*corner, height) for corner in corners]))


def mesh_of(parts: Sequence[Part]) -> Any:
    """Return one closed mesh of several bodies in one frame, as a page draws and grabs each thing."""
    meshes = []
    for part in parts:
        if part.kind == "box":
            mesh = trimesh.creation.box(part.size)
        elif part.kind == "cylinder":
            mesh = trimesh.creation.cylinder(part.size[0], part.size[1], sections=_SIDES)
        else:
            mesh = trimesh.creation.icosphere(subdivisions=2, radius=part.size[0])
        place = np.eye(4)
        place[:3, :3] = Rotation.from_quat(part.orientation).as_matrix()
        place[:3, 3] = part.position
        meshes.append(mesh.apply_transform(place))
    return trimesh.util.concatenate(meshes)


def _put(frame: viser.FrameHandle, position: _Numbers, turn: _Numbers) -> None:
    """Put something somewhere [m]; its orientation is (x, y, z, w), of which a page wants w first."""
    x, y, z, w = np.round(turn, 4).tolist()
    frame.position, frame.wxyz = vector(np.round(position, 4)), (w, x, y, z)


@dataclass(slots=True)
class _Thing:
    """What is drawn of one object, or of one goal."""

    frame: viser.FrameHandle
    nodes: list[Any]
    outlines: list[Any]


class View:
    """What is seen of a session; `grabbed` gives what hears of drags of an `object` or `goal` by its name."""

    def __init__(
        self,
        scene: viser.SceneApi,
        library: Library,
        grabbed: Callable[[str, str], Callable[[Any], Any]] | None = None,
    ):
        self._scene, self._library, self._grabbed = scene, library, grabbed
        self._objects: dict[str, _Thing] = {}
        self._goals: dict[str, _Thing] = {}
        self._labels: dict[str, viser.LabelHandle] = {}
        self._links: dict[int, viser.FrameHandle] = {}
        self._frames: dict[str, viser.FrameHandle] = {}
        self._draw_table()
        if isinstance(library.world, Posed):
            self._draw_robot(library.world.robot_parts())
        self.rest()

    def _draw_table(self) -> None:
        table, middle = self._library.grounding.table, self._library.middle
        x, y = (high - low for low, high in (table.x, table.y))
        self._scene.add_box("/table", _TABLE, (x + 0.5, y + 0.5, 0.04), position=(*middle, -0.0205))
        lines = rectangle(x / 2, y / 2, _FLAT)
        self._scene.add_line_segments("/border", lines, _BORDER, thickness=0.005, position=(*middle, 0.0))

    def _draw_robot(self, parts: Sequence[Part]) -> None:
        for link in sorted({part.link for part in parts}):
            self._links[link] = self._scene.add_frame(f"/robot/{link}", show_axes=False)
            own = [part for part in parts if part.link == link]
            for number, colour in enumerate(dict.fromkeys(part.colour for part in own)):
                same = [part for part in own if part.colour == colour]
                red, green, blue = np.round(np.multiply(colour, 255)).astype(int) if colour else _ARM
                path = f"/robot/{link}/{number}"
                self._mesh(path, same, (int(red), int(green), int(blue)), flat_shading=False)

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
        for thing in (*self._objects.values(), *self._goals.values()):
            for node in (*thing.nodes, *thing.outlines):
                node.remove()
        for label in self._labels.values():
            label.remove()
        self._objects, self._goals, self._labels = {}, {}, {}
        for item, colour in zip(problem.objects, cycle(COLOURS), strict=False):
            name, body = item.name, self._library.object_parts(item.features)
            frame = self._frame(f"/objects/{name}")
            node = self._mesh(f"/objects/{name}/body", body, colour)
            self._objects[name] = self._draggable("object", name, _Thing(frame, [node], []))
            if name in ghosts:
                ghost = self._ghost(item, colour, problem.tolerance)
                self._goals[name] = self._draggable("goal", name, ghost)
            said = f"{name} · {item.category}"
            self._labels[name] = self._scene.add_label(f"/labels/{name}", said, anchor="bottom-center")
        self.place(problem, ghosts, complaints)

    def place(self, problem: Problem, ghosts: Mapping[str, Vector], complaints: Mapping[str, str]) -> None:
        """Put objects and goals where they are, red where there is a complaint; see `Desk.complaints`."""
        related = {name for name, *_ in problem.related}
        for item, colour in zip(problem.objects, cycle(COLOURS), strict=False):
            name = item.name
            _put(self._objects[name].frame, item.position, item.orientation)
            self._objects[name].nodes[0].color = _BAD if f"object {name}" in complaints else colour
            if (ghost := self._goals.get(name)) is not None:
                ghost.frame.position = ghosts[name]
                for node in ghost.nodes:
                    node.color = _BAD if f"goal {name}" in complaints else colour
                for outline in ghost.outlines:
                    outline.position = (0.0, 0.0, -ghosts[name][2])
                ghost.outlines[1].visible = name not in related  # no tolerance belongs to it
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
            _put(self._objects[name].frame, position, turn)
            self._labels[name].position = vector(np.add(np.round(position, 4), (0.0, 0.0, _ABOVE_MOVING)))

    def _pose_links(self, links: Float[np.ndarray, "L 7"]) -> None:
        for number, frame in self._links.items():
            _put(frame, links[number, :3], links[number, 3:])

    def _place_labels(self, items: Sequence[SceneObject]) -> None:
        """Put labels above their objects; the farther ones give way upwards, so that none covers another."""
        placed: list[tuple[float, float]] = []
        for item in sorted(items, key=lambda item: (item.position[0], item.name)):
            x, y, z = item.position
            farther, height = 0.7 * x, z + item.features[2] / 2 + _ABOVE  # what is farther is seen higher
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

    def _mesh(self, path: str, parts: Sequence[Part], colour: Colour, **options: Any) -> viser.MeshHandle:
        body, options = mesh_of(parts), {"flat_shading": True} | options
        return self._scene.add_mesh_simple(path, body.vertices, body.faces, color=colour, **options)

    def _draggable(self, kind: str, name: str, thing: _Thing) -> _Thing:
        if self._grabbed:
            for node in thing.nodes:
                node.on_drag("left")(self._grabbed(kind, name))
        return thing

    def _ghost(self, item: SceneObject, colour: Colour, tolerance: float) -> _Thing:
        """Draw a ghost, the knob on its pin that it is dragged by, its footprint and its tolerance."""
        scene, path, (x, y, z) = self._scene, f"/goals/{item.name}", np.array(item.features[:3]) / 2
        frame, parts = self._frame(path), self._library.object_parts(item.features)
        nodes = [
            self._mesh(f"{path}/ghost", parts, colour, opacity=0.35, cast_shadow=False),
            scene.add_icosphere(f"{path}/knob", _KNOB, colour, position=(0.0, 0.0, z + _PIN)),
            scene.add_cylinder(f"{path}/pin", 0.003, _PIN, colour, position=(0.0, 0.0, z + _PIN / 2)),
        ]
        footprint, ring = rectangle(x, y, _FLAT), circle(tolerance, 2 * _FLAT)
        outlines = [
            scene.add_line_segments(f"{path}/footprint", footprint, colour, thickness=0.004),
            scene.add_line_segments(f"{path}/tolerance", ring, colour, thickness=0.003),
        ]
        return _Thing(frame, nodes, outlines)


def aim_camera(server: viser.ViserServer, library: Library) -> None:
    """Have new windows of a page look over the table of a domain at the robot."""
    x, y = library.middle
    server.initial_camera.position = (x + _EYE[0], y + _EYE[1], _EYE[2])
    server.initial_camera.look_at = (x + _LOOK[0], y + _LOOK[1], _LOOK[2])
    server.initial_camera.fov = _LENS


_LEVEL = 1e-6


class Grab:
    """A thing with a centre that was grabbed at a point, seen from an eye [m]; it keeps the offset."""

    def __init__(self, eye: Sequence[float], point: Sequence[float], centre: Sequence[float]):
        self._eye, self._height = np.array(eye, dtype=float), float(point[2])
        self._offset = np.subtract(centre, point)[:2]

    def to(self, point: Sequence[float]) -> tuple[float, float] | None:
        """Return where the line of sight through a point brings the centre at the level of the grab [m]."""
        ray = np.array(point, dtype=float) - self._eye
        if abs(ray[2]) < _LEVEL:
            return None
        share = (self._height - self._eye[2]) / ray[2]
        if not (np.isfinite(share) and share > 0):
            return None
        x, y = ((self._eye + share * ray)[:2] + self._offset).tolist()
        return x, y


_PACE = 1 / 15  # time between two poses that are kept, of a motion as it is [s]
_PAUSE = 0.4  # how long the end of a step is shown [s]
_TITLE_HEIGHT = 0.55  # how high above the middle of the table the name of a step stands [m]


def film_of(
    library: Library, problem: Problem, seen: Sequence[Seen], steps: Sequence[StepRecord] = ()
) -> bytes:
    """Return what was seen of a run as one HTML file that needs nothing else.

    Args:
        library: The domain.
        problem: What the run was for.
        seen: The poses.
        steps: Its steps, which are named while they are seen.
    """
    server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)  # at which nobody looks
    server.scene.set_up_direction("+z")
    aim_camera(server, library)
    view = View(server.scene, library)
    view.show_problem(problem, ghost_spots(understand(library.paired(problem), library.grounding)))
    view.show(seen[0].pose)
    names = {
        number: f"{number}: {step.operator} {step.object} {step.place or ''}".rstrip()
        for number, step in enumerate(steps, start=1)
    }
    label = server.scene.add_label("/step", "", position=(*library.middle, _TITLE_HEIGHT), visible=False)
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
    content = film.as_html().encode()
    server.stop()
    return content
