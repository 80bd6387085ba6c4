"""`world.toml`: which world a domain folder belongs to, and its options."""

import math
import tomllib
from collections.abc import Callable
from dataclasses import asdict, fields
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

import msgspec
import tomli_w

from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice
from neurosym.files import write_atomically
from neurosym.world import World

Config = TypeVar("Config")
WorldFactory = Callable[[], World]


def _tabletop(options: dict[str, Any]) -> World:
    from neurosym.sim.config import TabletopConfig
    from neurosym.sim.tabletop import Tabletop

    return Tabletop(configured(TabletopConfig, options))


def _toy(options: dict[str, Any]) -> World:
    from neurosym.toy_world import ToyConfig, ToyWorld

    return ToyWorld(configured(ToyConfig, options))


WORLDS: dict[str, Callable[[dict[str, Any]], World]] = {"tabletop": _tabletop, "toy": _toy}
"""The worlds that `world.toml` can name. A simulator is imported only when its world is made."""


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
        return msgspec.convert(options, kind)
    except msgspec.ValidationError as error:
        if isinstance(error.__cause__, InvalidValue):
            raise error.__cause__ from None
        raise InvalidValue(f"a value has the wrong type: {error}") from error


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
        name: One of `WORLDS`.
        options: The world's options, as they stand in `world.toml`.

    Raises:
        UnknownChoice: If there is no such world, or no such option.
        InvalidValue: If an option's value is impossible.
    """
    if name not in WORLDS:
        raise UnknownChoice("world", name, WORLDS)
    return WORLDS[name](options)


def read_world(path: Path) -> WorldFactory:
    """Read a `world.toml` and return a function that makes its world, in this process or another.

    Args:
        path: The file.

    Raises:
        InvalidFile: If the file is not TOML, or names an unknown world, option or value.
    """
    try:
        document = tomllib.loads(path.read_text())
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise InvalidFile(path, f"it is not TOML: {error}") from error
    name, options = document.pop("world", None), document.pop("options", {})
    if document or not isinstance(name, str) or not isinstance(options, dict):
        extra = f"; there is no place for {next(iter(document))!r}" if document else ""
        raise InvalidFile(path, f'it must hold world = "NAME" and a table [options]{extra}')
    try:
        make_world(name, options)
    except (UnknownChoice, InvalidValue) as error:
        raise InvalidFile(path, str(error).rstrip(".")) from error
    return partial(make_world, name, options)


def write_world(path: Path, name: str) -> None:
    """Write a `world.toml` with every option of a world at its default.

    Args:
        path: The file.
        name: One of `WORLDS`.

    Raises:
        UnknownChoice: If there is no such world.
    """
    config = getattr(make_world(name, {}), "config")  # noqa: B009  (worlds of ours have one; others need not)
    text = tomli_w.dumps({"world": name, "options": asdict(config)})
    write_atomically(path, f"# The world of this domain folder. Lengths in metres, times in seconds.\n{text}")
