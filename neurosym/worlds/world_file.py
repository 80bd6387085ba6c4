"""`world.toml`: which world a domain folder belongs to, and its options.

A world is one of ours by its name, or anybody's own as `module:factory` (`neurosym.worlds.custom`).
"""

import json
import math
from collections.abc import Callable
from dataclasses import asdict, fields, is_dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import msgspec
import tomli_w

from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice, shortened
from neurosym.factories import is_factory
from neurosym.files import write_atomically
from neurosym.object_limits import ObjectLimits
from neurosym.reading import read_toml
from neurosym.wording import quoted
from neurosym.world import World
from neurosym.worlds.custom import make_own_world
from neurosym.worlds.hosted import OwnFactory, describe_apart

if TYPE_CHECKING:
    from neurosym.sim.config import TabletopConfig
    from neurosym.worlds.toy import ToyConfig

Config = TypeVar("Config")


def _tabletop(options: dict[str, Any]) -> World:
    from neurosym.sim.tabletop import Tabletop

    return Tabletop(_tabletop_config(options))


def _tabletop_config(options: dict[str, Any]) -> "TabletopConfig":
    from neurosym.sim.config import TabletopConfig

    return configured(TabletopConfig, options)


def _toy(options: dict[str, Any]) -> World:
    from neurosym.worlds.toy import ToyWorld

    return ToyWorld(_toy_config(options))


def _toy_relations(options: dict[str, Any]) -> World:
    from neurosym.worlds.toy_relations import ToyRelations

    return ToyRelations(_toy_config(options))


def _toy_config(options: dict[str, Any]) -> "ToyConfig":
    from neurosym.worlds.toy import ToyConfig

    return configured(ToyConfig, options)


WORLDS: dict[str, Callable[[dict[str, Any]], World]] = {
    "tabletop": _tabletop,
    "toy": _toy,
    "toy-relations": _toy_relations,
}
"""The worlds that `world.toml` can name. A simulator is imported only when its world is made."""
CONFIGS: dict[str, Callable[[dict[str, Any]], "TabletopConfig | ToyConfig"]] = {
    "tabletop": _tabletop_config,
    "toy": _toy_config,
    "toy-relations": _toy_config,
}
"""What their options make, without a simulator."""


def configured(kind: type[Config], options: dict[str, Any]) -> Config:
    """Make a world's configuration from its options.

    Args:
        kind: The configuration's dataclass.
        options: Values by the names of its fields; what is not named keeps its default.

    Raises:
        UnknownChoice: If an option is not a field.
        InvalidValue: If a value has the wrong type or is impossible.
    """
    known = [f.name for f in fields(kind)]  # type: ignore[arg-type]
    for name in options:
        if name not in known:
            raise UnknownChoice("option", name, known)
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
    if isinstance(given, list) and isinstance(made, list | tuple):
        for entry, result in zip(given, made, strict=True):
            _check_nested(entry, result, place)
    if isinstance(given, dict) and is_dataclass(made):
        known = [f"{place}{f.name}" for f in fields(made)]
        for key, value in given.items():
            if f"{place}{key}" not in known:
                raise UnknownChoice("option", f"{place}{key}", known)
            _check_nested(value, getattr(made, key), f"{place}{key}.")


def _check_finite(value: Any, name: str = "options") -> None:
    if isinstance(value, float) and not math.isfinite(value):
        raise InvalidValue(f"{name} = {value} must be a finite number.")
    entries = (
        value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    )
    for key, entry in entries:
        _check_finite(entry, str(key) if isinstance(value, dict) else name)


def make_world(name: str, options: dict[str, Any]) -> World:
    """Make a world by its name.

    Args:
        name: One of `WORLDS`, or `module:factory`.
        options: The world's options, as they stand in `world.toml`.

    Raises:
        UnknownChoice: If there is no such world, or no such option.
        InvalidValue: If an option's value is impossible.
        InvalidWorld: If somebody's own world cannot be made.
    """
    if is_factory(name):
        _check_finite(options)
        return make_own_world(name, options)
    if name not in WORLDS:
        raise _no_world(name)
    return WORLDS[name](options)


def read_world(path: Path) -> "partial[World] | OwnFactory":
    """Read a `world.toml` and return a function that makes its world, in this process or another.

    Args:
        path: The file.

    Raises:
        InvalidFile: If the file is not TOML, or names an unknown world, option or value.
    """
    name, options = _read(path)
    try:
        if is_factory(name):
            _check_finite(options)
            own = OwnFactory(name, options, path.parent)
            own()
            return own
        make_world(name, options)
    except (UnknownChoice, InvalidValue) as error:
        raise InvalidFile(path, str(error).rstrip(".")) from error
    return partial(make_world, name, options)


def read_limits(path: Path) -> ObjectLimits | None:
    """Read from a `world.toml` which objects its world makes, without making the world.

    Args:
        path: The file.

    Returns:
        What it makes; None for a world of one's own.

    Raises:
        InvalidFile: If the file is not TOML, or names an unknown world, option or value.
    """
    name, options = _read(path)
    if is_factory(name):
        return None
    try:
        if name not in CONFIGS:
            raise _no_world(name)
        return CONFIGS[name](options).object_limits
    except (UnknownChoice, InvalidValue) as error:
        raise InvalidFile(path, str(error).rstrip(".")) from error


def _read(path: Path) -> tuple[str, dict[str, Any]]:
    """Read the name of a world and its options."""
    remedy = f"; mend it, or remove it, and `neurosym init {quoted(path.parent)}` writes a new one"
    document = read_toml(path, remedy)
    name, options = document.pop("world", None), document.pop("options", {})
    if document or not isinstance(name, str) or not isinstance(options, dict):
        extra = f"; there is no place for {shortened(next(iter(document)))!r}" if document else ""
        raise InvalidFile(path, f'it must hold world = "NAME" and a table [options]{extra}')
    return name, options


def _no_world(name: str) -> UnknownChoice:
    return UnknownChoice("world", name, [*WORLDS, "your own as module:factory"])


def origin_of(factory: "partial[World] | OwnFactory") -> dict[str, Any]:
    """Return what identifies a world that was read, for the data made in it.

    Args:
        factory: What `read_world` returned.
    """
    name, options = factory.args
    if is_factory(name):
        plain = json.loads(json.dumps(options, default=str))  # TOML has dates, JSON has not
        return {"world": name, "world_options": plain}
    return {"world_options": asdict(getattr(factory(), "config"))}  # noqa: B009  (ours have one)


def default_text(name: str, folder: Path) -> str:
    """Return the text of a `world.toml` with every option of a world at its default.

    Args:
        name: One of `WORLDS`, or `module:factory`.
        folder: The domain folder that it is for.

    Raises:
        UnknownChoice: If there is no such world.
        InvalidWorld: If somebody's own world is no world.
    """
    if is_factory(name):
        remark, options = "It is made by code of yours: factory(**options).", describe_apart(name, folder)
    else:
        remark = "Lengths in metres, times in seconds."
        options = asdict(getattr(make_world(name, {}), "config"))  # noqa: B009  (ours have one)
    text = tomli_w.dumps({"world": name, "options": options})
    return f"# The world of this domain folder. {remark}\n{text}"


def write_world(path: Path, name: str) -> None:
    """Write a `world.toml` with every option of a world at its default.

    Args:
        path: The file.
        name: One of `WORLDS`, or `module:factory`.

    Raises:
        UnknownChoice: If there is no such world.
        InvalidWorld: If somebody's own world is no world.
    """
    write_atomically(path, default_text(name, path.parent))
