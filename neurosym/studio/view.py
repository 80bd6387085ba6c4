"""The table in three dimensions: arm, objects, goals, and what is drawn on the table beside them."""

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
import trimesh
import viser
from scipy.spatial.transform import Rotation

from neurosym.checks import Float
from neurosym.contract import Part, Pose, Posed
from neurosym.execution.record import StepRecord
from neurosym.operators import Vector, vector
from neurosym.problems import Problem, SceneObject
from neurosym.report.symbols import Promise
from neurosym.studio.library import Library
from neurosym.studio.messages import Seen, Tried
from neurosym.studio.scene_editor import ghost_spots
from neurosym.studio.shell import film_html
from neurosym.studio.words import step_in_words
from neurosym.tasks.task import understand
from neurosym.world import Colour, Palette

_Numbers = Sequence[float] | Float[np.ndarray, "N"]
_TABLE, _BORDER, _ARM, _BAD = (178, 160, 136), (110, 94, 74), (199, 204, 212), (220, 50, 47)
_WAYPOINTS, _WAY = ((62, 117, 196), (68, 158, 88), (201, 72, 76)), (90, 90, 90)
"""Blue the first, green the second, red the third, as in pictures; and the lines between them."""
_INK, _PALE, _MISSED = (38, 42, 50), (200, 195, 188), (250, 250, 250)
"""Of what is no object: arrows, the fainter the less likely, and tries; those that went otherwise."""
_THIN, _THICK = 0.0018, 0.004  # radius of the arrow of an operator that moves, and of one that lifts [m]
_OVER, _FLAT = 0.004, 0.0015  # how far above the table paths and outlines are drawn [m]
_KNOB, _PIN = 0.014, 0.07  # radius of what a goal is dragged by, and how far above the goal's top it is [m]
_ABOVE, _ABOVE_MOVING, LABEL = 0.03, 0.09, (0.33, 0.045)
"""How far a label stands above its object's top at least, and above the centre of one that moves; about its
width and height as seen from the front [m]."""
_EYE, _LOOK, _LENS = (1.6, 0.0, 1.66), (-0.02, 0.0, 0.56), 0.72
"""Where the camera is and looks at, from the middle of the table [m]; its angle of view [rad]."""
_CANNOT = "cannot be here"
_ARROWS = 0.05  # how far above their object arrows and dots are, so that nothing hides them [m]
_COMPASS = (-0.16, 0.05, 0.1)
"""How far beyond a corner of the table the axes are drawn, along x and y, and how long [m]."""
_BEFORE = 0.09  # how far before an object what is said of its effect stands [m]
_LEAST = 1e-3  # displacements below this have no arrow [m]
_SIDES = 20  # how many sides a cylinder is drawn with


class Leg(NamedTuple):
    """What one step of a plan does to one object."""

    ends: Float[np.ndarray, "2 3"]  # where its centre is before and after [m]
    colour: Colour
    said: str  # on a label
    is_at_hand: bool


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

    def paths(self, legs: Sequence[Leg]) -> None:
        """Draw where a plan takes objects, with the numbers of its steps; the step at hand is thicker."""
        nodes = self.clear("paths")
        for number, leg in enumerate(legs):
            path, ends = f"/paths/{number}", np.add(leg.ends, (0.0, 0.0, _OVER))
            thickness = 0.012 if leg.is_at_hand else 0.005
            nodes.append(self._scene.add_line_segments(path, ends[None], leg.colour, thickness=thickness))
            nodes.append(self._cloud(f"{path}-dot", ends[1:], leg.colour, 0.011))
            if leg.said:
                middle, size = tuple(ends.mean(0)), 1.0 if leg.is_at_hand else 0.8
                nodes.append(self._label(f"{path}-label", leg.said, middle, size))

    def arrows(self, start: Sequence[float], promises: Sequence[Promise]) -> None:
        """Draw numbered arrows from above an object [m] to where operators take it, thick if they lift it."""
        nodes = self.clear("arrows")
        for lifts, radius in ((False, _THIN), (True, _THICK)):
            own = [one for one in promises if one.lifts == lifts]
            points = np.array([(start, np.add(start, one.effect)) for one in own])
            colours = [
                np.add(np.multiply(one.chance, _INK), np.multiply(1 - one.chance, _PALE)) for one in own
            ]
            if own:
                nodes.append(_arrows(self._scene, f"/arrows/{lifts}", points, np.array(colours), radius))
        for number, one in enumerate(promises, start=1):
            spot = tuple(np.add(start, one.effect))
            nodes.append(self._label(f"/arrow-labels/{number}", str(number), spot))

    def dots(self, layer: str, ends: Sequence[tuple[Sequence[float], bool]], size: float = 0.007) -> None:
        """Draw where something ended [m]: dark dots where it was as promised, and pale diamonds otherwise."""
        nodes = self.clear(layer)
        for is_kept, colour in ((True, _INK), (False, _MISSED)):
            if own := [end for end, kept in ends if kept is is_kept]:
                path, wide = f"/{layer}/{is_kept}", size if is_kept else 1.3 * size
                shape = "circle" if is_kept else "diamond"
                nodes.append(self._cloud(path, np.array(own), colour, wide, shape))

    def effect(self, start: Sequence[float], effect: Sequence[float], said: str) -> None:
        """Draw an arrow above an object, from where it was to where it ended [m], and say something of it."""
        nodes = self.clear("effect")
        if np.linalg.norm(effect) > _LEAST:
            points = np.array([[start, np.add(start, effect)]])
            nodes.append(_arrows(self._scene, "/effect", points, np.array([_INK]), _THICK))
        spot = (start[0] + _BEFORE, start[1], 0.0)
        nodes.append(self._label("/effect-label", said, spot, 1.0, "top-center"))

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

    def _cloud(self, name: str, points: np.ndarray, colours: Any, size: float, shape: Any = "circle") -> Any:
        return self._scene.add_point_cloud(
            name, points, colours, point_size=size, point_shape=shape, precision="float32"
        )

    def _label(self, name: str, text: str, spot: Any, size: float = 0.8, anchor: Any = "top-left") -> Any:
        return self._scene.add_label(name, text, position=spot, font_screen_scale=size, anchor=anchor)


def _arrows(scene: viser.SceneApi, name: str, points: np.ndarray, colours: np.ndarray, radius: float) -> Any:
    wide, long = 3 * radius, 0.012 + 2 * radius
    return scene.add_arrows(
        name, points, colours.astype(np.uint8), shaft_radius=radius, head_radius=wide, head_length=long
    )


def box_edges(size: _Numbers) -> Float[np.ndarray, "12 2 3"]:
    """Return the edges of a box around the origin as lines, by its size [m]."""
    x, y, z = np.array(size[:3]) / 2
    corners = np.array([(x, y), (-x, y), (-x, -y), (x, -y)])
    posts = np.stack([np.column_stack([corners, np.full(4, end)]) for end in (-z, z)], axis=1)
    return np.concatenate([posts, rectangle(x, y, -z), rectangle(x, y, z)])


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


def over(at: Sequence[float], features: Sequence[float]) -> Vector:
    """Return where arrows begin or end that are about an object whose centre is at a point [m]."""
    return at[0], at[1], at[2] + features[2] / 2 + _ARROWS


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
    errors: list[Any]  # what is seen where it cannot be


class View:
    """What is seen of a session; `grabbed` gives what hears of drags of an `object` or `goal` by its name."""

    def __init__(
        self,
        scene: viser.SceneApi,
        library: Library,
        grabbed: Callable[[str, str], Callable[[Any], Any]] | None = None,
    ):
        self._scene, self._library, self._grabbed = scene, library, grabbed
        self.palette = Palette.of(library.grounding.objects.categories)
        self._objects: dict[str, _Thing] = {}
        self._goals: dict[str, _Thing] = {}
        self._labels: dict[str, viser.LabelHandle] = {}
        self._links: dict[int, viser.FrameHandle] = {}
        self._frames: dict[str, viser.FrameHandle] = {}
        self._start: list[Any] = []
        self.items: Sequence[SceneObject] = ()
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
        corner = np.add((*middle, _FLAT), (x / 2 + _COMPASS[0], y / 2 + _COMPASS[1], 0.0))
        ends = np.stack([(corner, corner + _COMPASS[2] * way) for way in np.eye(3)[:2]])
        _arrows(self._scene, "/compass", ends, np.full((2, 3), _INK), _THICK)
        for word, (_, tip) in zip(("forward", "left"), ends, strict=True):
            self._scene.add_label(f"/compass/{word}", word, position=tuple(tip), font_screen_scale=0.8)

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
            for node in (*thing.nodes, *thing.outlines, *thing.errors):
                node.remove()
        for label in self._labels.values():
            label.remove()
        self._objects, self._goals, self._labels = {}, {}, {}
        self.items = problem.objects
        for item in problem.objects:
            name, body = item.name, self._library.object_parts(item)
            colour = self.palette(item.category)
            frame = self._frame(f"/objects/{name}")
            node = self._mesh(f"/objects/{name}/body", body, colour)
            self._objects[name] = self._draggable(
                "object", name, _Thing(frame, [node], [], self._errors(f"/objects/{name}", item))
            )
            if name in ghosts:
                ghost = self._ghost(item, colour, problem.tolerance)
                self._goals[name] = self._draggable("goal", name, ghost)
            self._labels[name] = self._scene.add_label(
                f"/labels/{name}", f"{name} · {item.category}", anchor="bottom-center"
            )
        self.place(problem, ghosts, complaints)

    def place(self, problem: Problem, ghosts: Mapping[str, Vector], complaints: Mapping[str, str]) -> None:
        """Put objects and goals where they are, framed where there is a complaint; see `Desk.complaints`."""
        related = {name for name, *_ in problem.relations}
        for item in problem.objects:
            name = item.name
            _put(self._objects[name].frame, item.position, item.orientation)
            for node in self._objects[name].errors:
                node.visible = f"object {name}" in complaints
            if (ghost := self._goals.get(name)) is not None:
                ghost.frame.position = ghosts[name]
                for node in ghost.errors:
                    node.visible = f"goal {name}" in complaints
                for outline in ghost.outlines:
                    outline.position = (0.0, 0.0, -ghosts[name][2])
                ghost.outlines[1].visible = name not in related  # no tolerance belongs to it
        self._place_labels(problem.objects)

    def at(self, name: str) -> Vector | None:
        """Return where the centre of an object is seen now [m]; None if it is not seen."""
        return vector(self._objects[name].frame.position) if name in self._objects else None

    def show_start(self, tried: Tried) -> None:
        """Draw a ghost of an object where a motion found it."""
        item = self.items[tried.target]
        parts, colour = self._library.object_parts(item), self.palette(item.category)
        frame = self._frame("/start")
        _put(frame, tried.start, tried.turn)
        self._start = [self._mesh("/start/ghost", parts, colour, opacity=0.35, cast_shadow=False)]

    def clear_start(self) -> None:
        """Take that ghost away."""
        for node in self._start:
            node.remove()
        self._start = []

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

    def _errors(self, path: str, item: SceneObject) -> list[Any]:
        """Draw a frame around what cannot be where it is, and words; they are seen when they are wanted."""
        lines = box_edges(np.add(item.features[:3], 0.012))
        frame = self._scene.add_line_segments(f"{path}/error", lines, _BAD, thickness=0.005, visible=False)
        label = self._scene.add_label(f"{path}/error-label", _CANNOT, anchor="center-center", visible=False)
        return [frame, label]

    def _ghost(self, item: SceneObject, colour: Colour, tolerance: float) -> _Thing:
        """Draw a ghost, the knob on its pin that it is dragged by, its footprint and its tolerance."""
        scene, path, (x, y, z) = self._scene, f"/goals/{item.name}", np.array(item.features[:3]) / 2
        frame, parts = self._frame(path), self._library.object_parts(item)
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
        return _Thing(frame, nodes, outlines, self._errors(path, item))


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
    names = {number: f"{number}: {step_in_words(step)}" for number, step in enumerate(steps, start=1)}
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
    content = film_html(film.as_html(), f"{library.name}: a run").encode()
    server.stop()
    return content
