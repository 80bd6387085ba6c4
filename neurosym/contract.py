"""What worlds promise, part by part: their attributes, the scenes they draw and the outcomes they give."""

import math
from collections.abc import Callable
from typing import Any, TypeVar, get_args

import numpy as np

from neurosym.actions import ActionBox, box_problem
from neurosym.errors import InvalidWorld, NeurosymError
from neurosym.factories import told
from neurosym.problems import LEGAL_NAME
from neurosym.table import Reference, ReferenceKind, Table
from neurosym.world import REQUIRED, Disturbance, Outcome, Scene, World, is_world

Result = TypeVar("Result")

ENDINGS: tuple[str, ...] = get_args(Disturbance)
"""How a bystander may be disturbed."""
KINDS_OF_REFERENCE: tuple[str, ...] = get_args(ReferenceKind)
"""What a world may say that its actions can be relative to."""


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


def check_attributes(world: object, name: str | None = None) -> None:
    """Raise unless an object has what a world has, without acting in it.

    Args:
        world: The object.
        name: What messages call it, if not by its class.

    Raises:
        InvalidWorld: If something is missing or impossible.
    """
    called = name or type(world).__name__
    attempt(called, "its attributes", lambda: _check_attributes(world, called))


def _check_attributes(world: object, called: str) -> None:
    if not is_world(world):
        missing = [attribute for attribute in REQUIRED if not hasattr(world, attribute)]
        raise InvalidWorld(called, f"is no World: {type(world).__name__} lacks {', '.join(missing)}")
    if isinstance(world, type):
        raise InvalidWorld(called, "is the class of a world; valid: a world, as the class makes one")
    if not (isinstance(world.name, str) and LEGAL_NAME.fullmatch(world.name)):
        raise InvalidWorld(
            called, f"has the name {world.name!r}; valid: a lower-case letter, then a-z, 0-9 and hyphens"
        )
    features = world.feature_names
    if not (isinstance(features, tuple) and features and all(isinstance(entry, str) for entry in features)):
        raise InvalidWorld(called, f"has feature_names = {features!r}; valid: a tuple of one name or more")
    if not isinstance(world.action_box, ActionBox):
        kind = type(world.action_box).__name__
        raise InvalidWorld(called, f"has an action_box of type {kind}; valid: ActionBox")
    if problem := box_problem(world.action_box):
        raise InvalidWorld(called, f"has an action_box with {problem}")
    if not isinstance(world.table, Table):
        raise InvalidWorld(called, f"has a table of type {type(world.table).__name__}; valid: Table")
    if not (is_number(world.lift_height) and world.lift_height > 0):
        raise InvalidWorld(called, f"has lift_height = {world.lift_height!r}; valid: a length above 0 m")
    references = getattr(world, "references", ())
    if not isinstance(references, tuple) or any(kind not in KINDS_OF_REFERENCE for kind in references):
        known = ", ".join(map(repr, KINDS_OF_REFERENCE))
        raise InvalidWorld(called, f"has references = {references!r}; valid: a tuple of {known}, or none")
    for method in ("sample_scene", "interact"):
        if not callable(getattr(world, method)):
            raise InvalidWorld(called, f"has {method} = {getattr(world, method)!r}; valid: a method")


def check_scene(name: str, scene: object, where: str, *, features: int, objects: int) -> None:
    """Raise unless something is a scene of so many objects.

    Args:
        name: Name of the world.
        scene: What should be one.
        where: Where it comes from.
        features: How many features an object has.
        objects: How many objects there are.

    Raises:
        InvalidWorld: If it is none.
    """
    if not isinstance(scene, Scene):
        raise InvalidWorld(name, f"gives a {type(scene).__name__} as {where}; valid: a Scene")
    for column, width in {"features": features, "positions": 3, "orientations": 4}.items():
        array = getattr(scene, column)
        if not isinstance(array, np.ndarray):
            kind = type(array).__name__
            raise InvalidWorld(name, f"gives {column} of type {kind} in {where}; valid: a numpy array")
        if array.shape != (objects, width):
            counted = "one object" if objects == 1 else f"{objects} objects"
            raise InvalidWorld(
                name,
                f"gives {column} of shape {array.shape} in {where}; "
                f"valid for {counted}: ({objects}, {width})",
            )
        if array.dtype.kind != "f" or not np.all(np.isfinite(array)):
            raise InvalidWorld(name, f"gives {column} in {where} that are not finite floats")


def check_drawn(world: World, scene: object, objects: int, name: str | None = None) -> None:
    """Raise unless something is a scene as a world may draw it.

    Args:
        world: The world.
        scene: What it drew.
        objects: How many objects were asked for.
        name: What messages call the world, if not by its own name.

    Raises:
        InvalidWorld: If it is none, or an object is no object or stands off the table.
    """
    called = name or world.name
    check_scene(called, scene, "sample_scene", features=len(world.feature_names), objects=objects)
    for position in scene.positions:  # type: ignore[attr-defined]  # checked above
        if not world.table.contains(position):
            raise InvalidWorld(called, f"samples an object off its table, at {position.tolist()}")


def check_outcome(
    world: World,
    scene: Scene,
    target: int,
    outcome: object,
    name: str | None = None,
    reference: Reference | None = None,
) -> None:
    """Raise unless something is an outcome of an interaction.

    Args:
        world: The world that gave it.
        scene: The scene that it was given.
        target: The object that it was to act upon.
        outcome: What should be one.
        name: What messages call the world, if not by its own name.
        reference: What the action was relative to besides the target.

    Raises:
        InvalidWorld: If it is none.
    """
    name, count = name or world.name, len(scene.features)
    if not isinstance(outcome, Outcome):
        raise InvalidWorld(name, f"gives a {type(outcome).__name__} from interact; valid: an Outcome")
    for moment in ("start", "lifted", "end"):
        seen = getattr(outcome, moment)
        check_scene(name, seen, f"outcome.{moment}", features=len(world.feature_names), objects=count)
        if not np.array_equal(seen.features, scene.features):
            raise InvalidWorld(name, f"changes the features of an object in outcome.{moment}")
    if not _is_index(outcome.target) or outcome.target != target:
        raise InvalidWorld(name, f"gives the target {outcome.target!r} when asked to act on object {target}")
    if outcome.reference != reference:
        raise InvalidWorld(name, f"gives the reference {outcome.reference!r} when asked for {reference!r}")
    for flag in ("held", "toppled", "lost", "carried"):
        if not isinstance(getattr(outcome, flag), bool | np.bool_):
            raise InvalidWorld(name, f"gives outcome.{flag} = {getattr(outcome, flag)!r}; valid: a bool")
    if outcome.carried and reference is None:
        raise InvalidWorld(name, "gives outcome.carried = True without a reference")
    if not is_number(outcome.peak_height):
        raise InvalidWorld(name, f"gives outcome.peak_height = {outcome.peak_height!r}; valid: metres")
    _check_bystanders(name, outcome, count)
    _check_contacts(name, outcome, count)


def _check_contacts(name: str, outcome: Outcome, count: int) -> None:
    pairs = outcome.contacts
    if not isinstance(pairs, tuple) or not all(
        isinstance(pair, tuple)
        and len(pair) == 2
        and all(map(_is_index, pair))
        and 0 <= pair[0] < pair[1] < count
        for pair in pairs
    ):
        raise InvalidWorld(
            name,
            f"gives outcome.contacts = {pairs!r}; valid: a tuple of pairs of numbers from 0 to {count - 1}, "
            "the smaller one first",
        )


def _check_bystanders(name: str, outcome: Outcome, count: int) -> None:
    valid = f"a tuple of numbers from 0 to {count - 1}, without the target"

    def is_bystander(number: Any) -> bool:
        return _is_index(number) and 0 <= number < count and number != outcome.target

    if not isinstance(outcome.touched, tuple) or not all(map(is_bystander, outcome.touched)):
        raise InvalidWorld(name, f"gives outcome.touched = {outcome.touched!r}; valid: {valid}")
    disturbed = outcome.disturbed
    if not isinstance(disturbed, tuple) or not all(
        isinstance(pair, tuple) and len(pair) == 2 and is_bystander(pair[0]) and pair[1] in ENDINGS
        for pair in disturbed
    ):
        known = ", ".join(ENDINGS)
        raise InvalidWorld(
            name, f"gives outcome.disturbed = {disturbed!r}; valid: pairs of a bystander and one of {known}"
        )


def is_number(value: Any) -> bool:
    """Say whether something is a finite number."""
    return isinstance(value, int | float | np.number) and math.isfinite(value)


def _is_index(value: Any) -> bool:
    return isinstance(value, int | np.integer) and not isinstance(value, bool)
