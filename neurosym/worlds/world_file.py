"""`world.toml`: which world a domain folder belongs to, and its options.

A world is one of ours by its name, or anybody's own as `module:factory` (`neurosym.worlds.own_world`). Data
of which there is no world say `world = "none"`, and along which axes their effects are.
"""

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, fields, is_dataclass
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any

import msgspec
import tomli_w

from neurosym.choices import ENGINES, is_factory
from neurosym.contract import ObjectLimits
from neurosym.data.axes import Axis, as_tables, axes_in
from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice, blaming, quoted, shortened, version_of
from neurosym.files import LARGEST_WHOLE, digest, read_toml
from neurosym.world import World
from neurosym.worlds.own_world import OwnFactory, describe_apart, make_own_world

WORLDS = {
    "tabletop": ("neurosym.sim.config:TabletopConfig", "neurosym.sim.tabletop:Tabletop"),
    "camera": ("neurosym.sim.camera_world:CameraTableConfig", "neurosym.sim.camera_world:CameraWorld"),
    "toy": ("neurosym.worlds.toy:ToyConfig", "neurosym.worlds.toy:ToyWorld"),
    "toy-relations": ("neurosym.worlds.toy:ToyConfig", "neurosym.worlds.toy_relations:ToyRelations"),
}
"""The worlds that can be named: what their options make, without a simulator, and what that makes."""

SIMULATED = ("tabletop", "camera")
"""Those whose physics an engine of choice simulates."""

_WITH_IMAGES = "neurosym.worlds.image_world:ImageWorld"


def _imported(name: str) -> Any:
    module, _, attribute = name.partition(":")
    return getattr(import_module(module), attribute)


def _configured(name: str, options: dict[str, Any]) -> Any:
    """Make the configuration of a world of ours from its options; what is not named keeps its default."""
    if name not in WORLDS:
        raise UnknownChoice("world", name, [*WORLDS, "your own as module:factory"])
    kind = _imported(WORLDS[name][0])
    _check_finite(options)
    try:
        made = msgspec.convert(options, kind)
    except msgspec.ValidationError as error:
        if isinstance(error.__cause__, InvalidValue):
            raise error.__cause__ from None
        raise InvalidValue(f"a value has the wrong type: {error}") from error
    _check_nested(options, made)
    return made


def _check_nested(given: Any, made: Any, place: str = "") -> None:
    """Refuse keys that went nowhere: msgspec passes over what a dataclass has no field for."""
    if isinstance(given, dict) and is_dataclass(made):
        known = [f"{place}{f.name}" for f in fields(made)]
        for key, value in given.items():
            if f"{place}{key}" not in known:
                raise UnknownChoice("option", f"{place}{key}", known)
            _check_nested(value, getattr(made, key), f"{place}{key}.")


def _check_finite(value: Any, name: str = "options") -> None:
    if isinstance(value, float) and not math.isfinite(value):
        raise InvalidValue(f"{name} = {value} must be a finite number.")
    if isinstance(value, int) and abs(value) > LARGEST_WHOLE:
        raise InvalidValue(f"{name} is a whole number beyond {LARGEST_WHOLE}.")
    entries = (
        value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    )
    for key, entry in entries:
        _check_finite(entry, str(key) if isinstance(value, dict) else name)


NONE = "none"
"""What a `world.toml` says where nothing can be performed, since there are only data."""


def has_world(path: Path) -> bool:
    """Say whether there is a `world.toml` that names a world with objects on a table."""
    return path.is_file() and _read(path)[0] != NONE and not read_axes(path)


def read_axes(path: Path) -> tuple[Axis, ...]:
    """Read from a `world.toml` along which axes effects are; nothing if it does not say.

    Raises:
        InvalidFile: If there can be no such axes.
    """
    if not path.is_file():
        return ()
    _read(path)
    with blaming(path):
        return axes_in(read_toml(path).get("axes", []))


def read_stepper(path: Path) -> tuple[str, dict[str, Any]] | None:
    """Read from a `world.toml` with axes what performs actions, and its options; None if nothing does."""
    if not read_axes(path):
        return None
    name, options = _read(path)
    _check_finite(options)
    return None if name == NONE else (name, options)


def axes_text(axes: Sequence[Axis]) -> str:
    """Return the text of a `world.toml` for data of which there is no world."""
    remark = (
        "# Data of which there is no world. What is not said of an axis (kind, unit, cell, low, high,\n"
        "# tolerance, period) is measured on the data by `neurosym compile-domain`.\n"
    )
    return remark + tomli_w.dumps({"world": NONE, "axes": as_tables(axes)})


SEEING = "camera"
"""The world whose objects are known by what a camera sees, and an eye tells."""
EYE = "eye.safetensors"
"""What the file of an eye is called, beside `world.toml`."""


def make_world(name: str, options: dict[str, Any], eye: Path | None = None) -> World:
    """Make a world by its name.

    Args:
        name: One of `WORLDS`, or `module:factory`.
        options: The world's options, as they stand in `world.toml`.
        eye: The file of the eye, of a world that sees.

    Raises:
        UnknownChoice: If there is no such world, or no such option.
        InvalidValue: If an option's value is impossible.
        InvalidWorld: If somebody's own world cannot be made.
    """
    if is_factory(name):
        _check_finite(options)
        return make_own_world(name, options)
    config = _configured(name, options)
    world: World = _imported(WORLDS[name][1])(config, *([eye] if eye else []))
    return world


def sees(path: Path) -> bool:
    """Say whether a `world.toml` names a world whose objects are known by what an eye tells of them."""
    if not has_world(path):
        return False
    name, _ = _read(path)
    return name == SEEING or (is_factory(name) and "eye" in getattr(read_world(path), "keywords", {}))


def read_world(path: Path) -> "partial[World] | OwnFactory":
    """Read a `world.toml` and return a function that makes its world, in this process or another.

    Raises:
        InvalidFile: If the file is not TOML, or names an unknown world, option or value.
    """
    name, options = _read(path)
    if name == NONE or read_axes(path):
        said = f'it says world = "{name}", and names axes, so it is no world with a table and an arm'
        raise InvalidFile(path, said)
    eye = path.absolute().with_name(EYE)
    with blaming(path):
        if is_factory(name):
            _check_finite(options)
            own = OwnFactory(name, options, path.parent)
            if not callable(getattr(own(), "images", None)):
                return own
            seeing: partial[World] = partial(_imported(_WITH_IMAGES), own, eye=eye)
        elif make_world(name, options).name != SEEING:
            return partial(make_world, name, options)
        else:
            seeing = partial(make_world, name, options, eye=eye)
    if eye.is_file():
        world: Any = seeing()
        assert world.eye, "a damaged one is told of before anything is learned"
    return seeing


def asked_of(factory: "partial[World] | OwnFactory") -> tuple[str, dict[str, Any]]:
    """Return the name and the options of a world that was read."""
    name, options = factory.args[0].args if isinstance(factory.args[0], OwnFactory) else factory.args
    return name, options


def read_limits(path: Path) -> ObjectLimits | None:
    """Read from a `world.toml` which objects its world makes, without making the world.

    Returns:
        What it makes; None for a world of one's own.

    Raises:
        InvalidFile: If the file is not TOML, or names an unknown world, option or value.
    """
    name, options = _read(path)
    if is_factory(name) or name == NONE:
        return None
    with blaming(path):
        limits: ObjectLimits | None = _configured(name, options).object_limits
        return limits


def _read(path: Path) -> tuple[str, dict[str, Any]]:
    """Read the name of a world and its options."""
    remedy = f"; mend it, or remove it, and `neurosym init {quoted(path.parent)}` writes a new one"
    document = read_toml(path, remedy)
    name, options = document.pop("world", None), document.pop("options", {})
    if name == NONE or (isinstance(name, str) and is_factory(name)):
        document.pop("axes", None)
    if isinstance(name, str) and "axes" in document:
        said = f"it has axes, and world = {shortened(name)!r}; valid beside axes: {NONE}, or module:factory"
        raise InvalidFile(path, said)
    if document or not isinstance(name, str) or not isinstance(options, dict):
        extra = f"; there is no place for {shortened(next(iter(document)))!r}" if document else ""
        raise InvalidFile(path, f'it must hold world = "NAME" and a table [options]{extra}')
    return name, options


def origin_of(factory: "partial[World] | OwnFactory") -> dict[str, Any]:
    """Return what identifies a world that was read, for the data made in it.

    Args:
        factory: What `read_world` returned.
    """
    name, options = asked_of(factory)
    eye = factory.keywords.get("eye") if isinstance(factory, partial) else None
    known = {"eye": digest(eye)} if eye and eye.is_file() else {}
    if is_factory(name):
        plain = json.loads(json.dumps(options, default=str))  # TOML has dates, JSON has not
        return {"world": name, "world_options": plain, **known}
    given = asdict(_configured(name, options))
    if (engine := given.pop("engine", ENGINES[0])) != ENGINES[0]:  # data older than the choice name none
        given["engine"] = f"{engine} {version_of(f'{engine}-core')}"
    return {"world_options": given, **known}


def changed_option(origin: Mapping[str, Any], now: Mapping[str, Any]) -> tuple[str, Any, Any] | None:
    """Name an option that two worlds of one name both have, and with other values; None if there is none.

    Args:
        origin: What identified the world when data were made (see `origin_of`).
        now: What identifies it now.
    """
    options = (json.loads(json.dumps(one.get("world_options", {}))) for one in (origin, now))
    kept, asked = ({"engine": ENGINES[0], **one} for one in options)
    differing = (name for name in kept if name in asked and kept[name] != asked[name])
    return next(((name, kept[name], asked[name]) for name in differing), None)


def default_text(name: str, folder: Path, engine: str | None = None) -> str:
    """Return the text of a `world.toml` with every option of a world at its default.

    Args:
        name: One of `WORLDS`, or `module:factory`.
        folder: The domain folder that it is for.
        engine: What simulates it, if not the default.

    Raises:
        UnknownChoice: If there is no such world.
        InvalidValue: If nothing simulates it, or that engine is not installed.
        InvalidWorld: If somebody's own world is no world.
    """
    if engine and name not in SIMULATED:
        raise InvalidValue(f"The world {shortened(name)} has no --engine; {' and '.join(SIMULATED)} have.")
    if is_factory(name):
        remark, options = "It is made by code of yours: factory(**options).", describe_apart(name, folder)
    else:
        remark = "Lengths in metres, times in seconds."
        options = asdict(_configured(name, {"engine": engine} if engine else {}))
    text = tomli_w.dumps({"world": name, "options": options})
    return f"# The world of this domain folder. {remark}\n{text}"
