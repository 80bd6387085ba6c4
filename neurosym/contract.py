"""What every world promises, checked at each of its answers; with its limits, motions and poses."""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any, Literal, Protocol, TypeVar, get_args, runtime_checkable

import numpy as np

from neurosym.checks import Float
from neurosym.choices import told
from neurosym.errors import InvalidValue, InvalidWorld, NeurosymError, counted
from neurosym.problems import LEGAL_NAME
from neurosym.world import (
    REQUIRED,
    ActionBox,
    Disturbance,
    Frame,
    FrameSink,
    Outcome,
    Reference,
    ReferenceKind,
    Scene,
    Table,
    World,
    WorldFactory,
    box_problem,
    is_world,
    relative_to,
)

# Worlds of somebody's own, such that whatever they do wrong is told in one sentence.
#
# Every call into a world that is not ours passes through `Guarded`: an error, `sys.exit`, or something that
# is no scene or outcome is an `InvalidWorld`, which names the world and what it did.

Result = TypeVar("Result")

OPTIONAL = ("picture", "images", "open_window")  # methods that a world may have besides
SETTABLE = ("wanted_pictures", "painter")  # attributes that others set, if a world has them
_DEEPEST = 10.0  # as high as anything may be in an image [m]
_ENDINGS: tuple[str, ...] = get_args(Disturbance)
_KINDS_OF_REFERENCE: tuple[str, ...] = get_args(ReferenceKind)


def attempt(
    name: str, what: str, call: Callable[[], Result], passed: type[NeurosymError] = InvalidWorld
) -> Result:
    """Call code of a world, and tell whatever it raises in one sentence.

    Args:
        name: Name of the world.
        what: What is called.
        call: Calls it.
        passed: Errors that it may raise, which stay as they are.

    Raises:
        InvalidWorld: If it raises anything else but Ctrl-C.
    """
    try:
        return call()
    except (passed, KeyboardInterrupt):
        raise
    except SystemExit as error:
        raise InvalidWorld(name, f"ends the program in {what} ({told(error)}); valid: an error") from error
    except BaseException as error:
        raise InvalidWorld(name, f"raises an error in {what}: {told(error)}") from error


class Guarded:
    """A world whose every answer is checked.

    What it returns are plain values of ours, with the same numbers, that another process can read. Messages
    call it by the name that is given, or its own.

    Raises:
        InvalidWorld: If it is no world; from its methods, if a call fails or gives what cannot be.
    """

    def __init__(self, world: Any, name: str | None = None):
        self._called = name or type(world).__name__
        self._refuse("its attributes", _attribute_problems(world))
        self._world, self._called = world, name or world.name
        self.name, self.lift_height = str(world.name), world.lift_height
        self.feature_names = tuple(map(str, world.feature_names))
        box = world.action_box
        self.action_box = ActionBox(np.array(box.low), np.array(box.high), np.array(box.gripper), box.mirrors)
        self.table = Table(world.table.x, world.table.y)
        if hasattr(world, "picture"):
            self.picture = self._picture
        if callable(getattr(world, "images", None)):
            self.images = self._images
        if hasattr(world, "open_window"):
            self.open_window = lambda: self._attempt("open_window", world.open_window)
        for name in SETTABLE:
            if hasattr(world, name):
                object.__setattr__(self, name, getattr(world, name))

    def sample_scene(self, rng: np.random.Generator, objects: int) -> Scene:
        """Draw a scene; see `World.sample_scene`."""
        scene = self._attempt("sample_scene", lambda: self._world.sample_scene(rng, objects))
        self._refuse("what it returns", _drawn_problems(self, scene, objects))
        return _plain_scene(scene)

    def interact(
        self,
        scene: Scene,
        action: Float[np.ndarray, "A"],
        target: int,
        *,
        put_down: bool = True,
        on_frame: FrameSink | None = None,
        ghosts: Float[np.ndarray, "M 3"] | None = None,
        reference: Reference | None = None,
    ) -> Outcome:
        """Perform an interaction; see `World.interact`."""
        before = bytes_of(scene)

        def interact() -> Any:
            aim = relative_to(self._world, reference)
            return self._world.interact(
                scene, action, target, put_down=put_down, on_frame=sink, ghosts=ghosts, **aim
            )

        def look(frame: Frame, phase: str) -> None:
            self._check_frame(frame, "on_frame")
            assert on_frame is not None, "else it is not called"
            on_frame(frame, str(phase))

        sink = None if on_frame is None else look
        outcome = self._attempt("interact", interact)
        if bytes_of(scene) != before:
            problem = "changes the scene that interact is given; it must return new ones"
            raise InvalidWorld(self._called, problem)
        self._refuse("what it returns", _outcome_problems(self, scene, target, outcome, reference))
        return _plain_outcome(outcome)

    def __getattr__(self, name: str) -> Any:
        """Give what else the world has, like its `object_limits`."""
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self._world, name)

    def __setattr__(self, name: str, value: Any) -> None:
        object.__setattr__(self, name, value)
        if name in SETTABLE:
            self._attempt(name, lambda: setattr(self._world, name, value))

    def _picture(self, scene: Scene, ghosts: Float[np.ndarray, "M 3"] | None = None) -> Frame:
        frame = self._attempt("picture", lambda: self._world.picture(scene, ghosts))
        self._check_frame(frame, "picture")
        return np.array(frame)

    def _images(self, scene: Scene) -> Float[np.ndarray, "M side side"]:
        before = bytes_of(scene)
        images = self._attempt("images", lambda: self._world.images(scene))
        if bytes_of(scene) != before:
            raise InvalidWorld(self._called, "changes the scene that images is given")
        self._refuse("what images returns", _image_problems(images, len(scene)))
        return np.array(images, dtype=np.float64)

    def _check_frame(self, frame: object, where: str) -> None:
        if not (isinstance(frame, np.ndarray) and frame.dtype == np.uint8 and frame.ndim == 3):
            shape = f"{frame.dtype} {frame.shape}" if isinstance(frame, np.ndarray) else type(frame).__name__
            problem = f"gives a picture of {shape} to {where}; valid: uint8 (height, width, 3)"
            raise InvalidWorld(self._called, problem)

    def _attempt(self, what: str, call: Callable[[], Any]) -> Any:
        return attempt(self._called, what, call, NeurosymError)

    def _refuse(self, what: str, problems: Iterator[str]) -> None:
        """Raise the first problem of the world: each look at it relies on those before."""
        if problem := attempt(self._called, what, lambda: next(problems, None)):
            raise InvalidWorld(self._called, problem)


def guarded(world: object) -> World:
    """Return a world such that it tells what it does wrong, ours as it is; `InvalidWorld` if it is none."""
    is_ours = not isinstance(world, type) and type(world).__module__.split(".")[0] == "neurosym"
    return world if is_ours and is_world(world) else Guarded(world)


def made(factory: WorldFactory) -> World:
    """Make a world, such that it tells what it does wrong.

    Raises:
        InvalidValue: If the factory is none.
        InvalidWorld: If it fails, or what it makes is no world.
    """
    if not callable(factory):
        instead = "a world itself" if is_world(factory) else f"a {type(factory).__name__}"
        raise InvalidValue(
            f"The factory of worlds is {instead}; valid: a function that makes one, like its class."
        )
    name = getattr(factory, "__name__", type(factory).__name__)
    return guarded(attempt(name, "the factory", factory, NeurosymError))


@contextmanager
def placed(place: str) -> Iterator[None]:
    """Add to what a world does wrong where that was, like `interaction 18`."""
    try:
        yield
    except InvalidWorld as error:
        raise error.at(place) from error


def bytes_of(scene: Scene) -> bytes:
    """Return what a scene holds, to be compared."""
    return b"".join(np.asarray(a).tobytes() for a in (scene.features, scene.positions, scene.orientations))


def is_number(value: Any) -> bool:
    """Say whether something is a finite number."""
    return isinstance(value, int | float | np.number) and math.isfinite(value)


def _plain_scene(scene: Scene) -> Scene:
    columns = (np.array(column) for column in (scene.features, scene.positions, scene.orientations))
    return Scene(*columns, unseen=np.array(scene.unseen))


def _plain_outcome(outcome: Outcome) -> Outcome:
    scenes = {id(scene): _plain_scene(scene) for scene in (outcome.start, outcome.lifted, outcome.end)}
    return Outcome(
        start=scenes[id(outcome.start)],
        lifted=scenes[id(outcome.lifted)],
        end=scenes[id(outcome.end)],
        target=int(outcome.target),
        held=bool(outcome.held),
        toppled=bool(outcome.toppled),
        lost=bool(outcome.lost),
        peak_height=float(outcome.peak_height),
        touched=tuple(map(int, outcome.touched)),
        disturbed=tuple((int(number), str(how)) for number, how in outcome.disturbed),  # type: ignore[misc]
        reference=outcome.reference,
        carried=bool(outcome.carried),
        contacts=tuple((int(one), int(other)) for one, other in outcome.contacts),
    )


def _attribute_problems(world: Any) -> Iterator[str]:
    if missing := [attribute for attribute in REQUIRED if not hasattr(world, attribute)]:
        yield f"is no World: {type(world).__name__} lacks {', '.join(missing)}"
    if isinstance(world, type):
        yield "is the class of a world; valid: a world, as the class makes one"
    if not (isinstance(world.name, str) and LEGAL_NAME.fullmatch(world.name)):
        yield f"has the name {world.name!r}; valid: a lower-case letter, then a-z, 0-9 and hyphens"
    features = world.feature_names
    if not (isinstance(features, tuple) and features and all(isinstance(entry, str) for entry in features)):
        yield f"has feature_names = {features!r}; valid: a tuple of one name or more"
    for name, kind in (("action_box", ActionBox), ("table", Table)):
        if not isinstance(getattr(world, name), kind):
            yield f"has {name} of type {type(getattr(world, name)).__name__}; valid: {kind.__name__}"
    if problem := box_problem(world.action_box):
        yield f"has an action_box with {problem}"
    if not (is_number(world.lift_height) and world.lift_height > 0):
        yield f"has lift_height = {world.lift_height!r}; valid: a length above 0 m"
    references = getattr(world, "references", ())
    if not isinstance(references, tuple) or any(kind not in _KINDS_OF_REFERENCE for kind in references):
        known = ", ".join(map(repr, _KINDS_OF_REFERENCE))
        yield f"has references = {references!r}; valid: a tuple of {known}, or none"
    for method in ("sample_scene", "interact"):
        if not callable(getattr(world, method)):
            yield f"has {method} = {getattr(world, method)!r}; valid: a method"


def _scene_problems(scene: Any, where: str, features: int, objects: int) -> Iterator[str]:
    """Tell why something is no scene of so many objects with so many features."""
    if not isinstance(scene, Scene):
        yield f"gives a {type(scene).__name__} as {where}; valid: a Scene"
    for column, width in {"features": features, "positions": 3, "orientations": 4}.items():
        array = getattr(scene, column)
        if not isinstance(array, np.ndarray):
            yield f"gives {column} of type {type(array).__name__} in {where}; valid: a numpy array"
        if array.shape != (objects, width):
            valid = f"valid for {counted(objects, 'object')}: ({objects}, {width})"
            yield f"gives {column} of shape {array.shape} in {where}; {valid}"
        if array.dtype.kind != "f" or not np.all(np.isfinite(array)):
            yield f"gives {column} in {where} that are not finite floats"


def _drawn_problems(world: World, scene: Any, objects: int) -> Iterator[str]:
    yield from _scene_problems(scene, "sample_scene", len(world.feature_names), objects)
    for position in scene.positions:
        if not world.table.contains(position):
            yield f"samples an object off its table, at {position.tolist()}"


def _image_problems(images: Any, objects: int) -> Iterator[str]:
    if not isinstance(images, np.ndarray) or images.dtype.kind != "f":
        yield f"gives images of type {getattr(images, 'dtype', type(images).__name__)}; valid: floats [m]"
    if images.ndim != 3 or len(images) != objects or images.shape[1] != images.shape[2] or images.size == 0:
        yield f"gives images of shape {images.shape} of {counted(objects, 'object')}; valid: (M, side, side)"
    if not np.all(np.isfinite(images)):
        yield "gives images that are not finite"
    if np.abs(images).max() > _DEEPEST:
        yield f"gives images with a height of {np.abs(images).max():g} m; valid: {_DEEPEST:g} m at most"


def _outcome_problems(
    world: World, scene: Scene, target: int, outcome: Any, reference: Reference | None
) -> Iterator[str]:
    if not isinstance(outcome, Outcome):
        yield f"gives a {type(outcome).__name__} from interact; valid: an Outcome"
    for moment in ("start", "lifted", "end"):
        seen, where = getattr(outcome, moment), f"outcome.{moment}"
        yield from _scene_problems(seen, where, len(world.feature_names), len(scene))
        if not np.array_equal(seen.features, scene.features):
            yield f"changes the features of an object in {where}"
    if not _is_index(outcome.target) or outcome.target != target:
        yield f"gives the target {outcome.target!r} when asked to act on object {target}"
    if outcome.reference != reference:
        yield f"gives the reference {outcome.reference!r} when asked for {reference!r}"
    for flag in ("held", "toppled", "lost", "carried"):
        if not isinstance(getattr(outcome, flag), bool | np.bool_):
            yield f"gives outcome.{flag} = {getattr(outcome, flag)!r}; valid: a bool"
    if outcome.carried and reference is None:
        yield "gives outcome.carried = True without a reference"
    if not is_number(outcome.peak_height):
        yield f"gives outcome.peak_height = {outcome.peak_height!r}; valid: metres"
    yield from _bystander_problems(outcome, len(scene))


def _bystander_problems(outcome: Outcome, count: int) -> Iterator[str]:
    def is_bystander(number: Any) -> bool:
        return _is_index(number, count) and number != outcome.target

    def is_ending(pair: Any) -> bool:
        return isinstance(pair, tuple) and len(pair) == 2 and is_bystander(pair[0]) and pair[1] in _ENDINGS

    def is_contact(pair: Any) -> bool:
        is_pair = isinstance(pair, tuple) and len(pair) == 2
        return is_pair and all(_is_index(number, count) for number in pair) and bool(pair[0] < pair[1])

    numbers = f"numbers from 0 to {count - 1}"
    for name, fits, valid in (
        ("touched", is_bystander, f"a tuple of {numbers}, without the target"),
        ("disturbed", is_ending, f"pairs of a bystander and one of {', '.join(_ENDINGS)}"),
        ("contacts", is_contact, f"a tuple of pairs of {numbers}, the smaller one first"),
    ):
        values = getattr(outcome, name)
        if not isinstance(values, tuple) or not all(map(fits, values)):
            yield f"gives outcome.{name} = {values!r}; valid: {valid}"


def _is_index(value: Any, count: float = math.inf) -> bool:
    is_whole = isinstance(value, int | np.integer) and not isinstance(value, bool)
    return is_whole and bool(0 <= value < count)


# Which objects a world makes, where it says so

_SLACK = 1e-9  # numbers that were written by hand may be off by so much
Range = tuple[float, float]


@dataclass(frozen=True, slots=True)
class ObjectLimits:
    """Which objects a world makes; all rest on a table whose top is at height 0."""

    feature_names: tuple[str, ...]  # what the features are called: sizes along x, y and z, and type
    sizes: tuple[Range, Range, Range]  # least and greatest size along each axis [m]
    types: tuple[float, ...]  # the types there are
    most: int | None = None  # how many one scene can be simulated with; None if there is no limit
    # least and greatest value of what no feature shows, by name; see `Scene.unseen`
    unseen: Mapping[str, Range] = field(default_factory=dict)

    def too_many(self, objects: int) -> str:
        """Say if there are more objects than can be simulated, or nothing."""
        if self.most is None or objects <= self.most:
            return ""
        return f"there are {objects} objects; the simulator takes at most {self.most}"

    def check(self, item: str, features: tuple[float, ...]) -> None:
        """Raise `InvalidValue` unless the world makes objects of such features; `item` is its name."""
        if len(features) != len(self.feature_names):
            named = ", ".join(self.feature_names)
            raise InvalidValue(f"{item} has {len(features)} features; valid: {named}.")
        *sizes, kind = zip(self.feature_names, features, strict=True)
        for (name, size), (least, greatest) in zip(sizes, self.sizes, strict=True):
            if not least - _SLACK <= size <= greatest + _SLACK:
                raise InvalidValue(f"{item} has {name} = {size:g} m; valid: {least:g} to {greatest:g} m.")
        name, number = kind
        if number not in self.types:
            valid = ", ".join(f"{known:g}" for known in self.types)
            raise InvalidValue(f"{item} has {name} = {number:g}; valid: {valid}.")

    def check_unseen(self, item: str, unseen: Sequence[float]) -> None:
        """Raise `InvalidValue` unless there are objects of which this is not seen; it may be nothing."""
        if unseen and len(unseen) != len(self.unseen):
            named = ", ".join(self.unseen) or "none"
            raise InvalidValue(f"{item} has {len(unseen)} unseen numbers; valid: {named}.")
        for (name, (least, greatest)), number in zip(self.unseen.items(), unseen, strict=False):
            if not least <= number <= greatest:
                raise InvalidValue(
                    f"{item} has unseen {name} = {number:g}; valid: {least:g} to {greatest:g}."
                )


def limits_of(world: World) -> ObjectLimits | None:
    """Return which objects a world makes (its `object_limits`), or None if it does not say."""
    limits = getattr(world, "object_limits", None)
    return limits if isinstance(limits, ObjectLimits) else None


# How the hand moves in the simulator: how fast, and how high it carries things.
#
# A straight way begins and ends at rest, by a quintic profile whose peak speed is 1.875 times its mean
# speed.

PEAK_SPEED = 0.45  # greatest speed of the hand [m/s]; faster pushes make objects coast on
LOWERING_SPEED = 0.25  # greatest speed of a held object on its way down [m/s]
FINGER_SPEED = 0.25  # greatest speed of a finger [m/s]
CLEARANCE = 0.005  # the hand starts at least this far above whatever it would otherwise touch [m]
GRASP_TEST = 0.03
"""How far the hand rises to find whether the target hangs from it, before it carries it away [m]."""
TRANSIT_CLEARANCE = 0.02  # what is carried passes at least this far above everything else [m]
_PEAK_OVER_MEAN = 1.875


def way_seconds(metres: float, peak_speed: float = PEAK_SPEED) -> float:
    """Return how long a straight way [m] takes from rest to rest [s], with a greatest speed [m/s]."""
    return metres * _PEAK_OVER_MEAN / peak_speed


# Poses: where every part of the robot and every object is while a motion happens.
#
# Pictures show a motion from one side. A page in a browser draws it from any side, and asks a world for
# poses instead. A world need not know them; one that does is `Posed`.

PartKind = Literal["box", "cylinder", "sphere"]
"""The kind of a part: its size is its edges [m], its radius and length [m], or its radius [m]."""
POSE_SECONDS = 1 / 30  # time of the simulation between two poses [s]


@dataclass(frozen=True, slots=True, eq=False)
class Pose:
    """Where everything is at one moment of an interaction, in the world frame."""

    seconds: float  # time of the simulation since the interaction began [s]
    phase: str  # name of the phase of the motion, as `FrameSink` is given it
    # of each link of the robot, its base first: position [m], and orientation as (x, y, z, w)
    links: Float[np.ndarray, "L 7"]
    positions: Float[np.ndarray, "M 3"]  # centre of each object [m]
    orientations: Float[np.ndarray, "M 4"]  # orientation of each object, as a quaternion (x, y, z, w)


PoseSink = Callable[[Pose], None]  # takes a pose as soon as it is there; the motion goes on when it returns


@dataclass(frozen=True, slots=True)
class Part:
    """One simple body that a link of the robot, or an object, is drawn with."""

    kind: PartKind  # see `PartKind`
    size: tuple[float, ...]  # its size, as its kind says [m]
    # its centre in the frame of the link or the object [m]
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    # its orientation there, as a quaternion (x, y, z, w); a cylinder lies along its z axis
    orientation: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)
    link: int = 0  # number of the link, the base being 0; 0 for an object
    # red, green and blue from 0 to 1; None where nothing is said
    colour: tuple[float, float, float] | None = None


@runtime_checkable
class Posed(Protocol):
    """A world that says where everything is while it moves, and what it looks like.

    Attributes:
        on_pose: Called with a pose each `POSE_SECONDS` of an interaction, if set; it changes nothing.
    """

    on_pose: PoseSink | None

    def robot_parts(self) -> tuple[Part, ...]:
        """Return what the robot is drawn with."""

    def robot_at_rest(self) -> Float[np.ndarray, "L 7"]:
        """Return the poses of the robot's links while it waits; see `Pose.links`."""

    def object_parts(self, features: Float[np.ndarray, "F"], *unseen: Sequence[float]) -> tuple[Part, ...]:
        """Return what an object of such features is drawn with; given is what is not seen, if anything is."""
