"""Worlds of your own: `module:factory` names the function or class that makes one.

A domain folder may come from a stranger, and its `world.toml` says what is called, and with which options.
So nothing is called that does not make worlds (`os:system`).
"""

import inspect
import json
import math
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, get_type_hints

from neurosym.errors import InvalidWorld
from neurosym.factories import admit, load_factory, told
from neurosym.guarded import Guarded
from neurosym.world import World
from neurosym.worlds.check import check_world

Factory = Callable[..., Any]


def make_own_world(name: str, options: dict[str, Any]) -> World:
    """Make a world of one's own.

    Args:
        name: `module:factory`; the module can be imported.
        options: What to call the factory with, by keyword.

    Raises:
        InvalidWorld: If there is no such factory, it rejects the options, or does not return a world.
    """
    factory = _load(name)
    _check_options(name, factory, options)
    try:
        world = factory(**options)
    except (InvalidWorld, KeyboardInterrupt):
        raise
    except BaseException as error:
        raise InvalidWorld(name, f"cannot be made with its options: {told(error)}") from error
    return Guarded(world, name)


def describe_own_world(name: str, folder: Path) -> dict[str, Any]:
    """Say which options a world of one's own has, as they stand in a TOML file, and check that it is a world.

    Args:
        name: `module:factory`.
        folder: The domain folder that it is for.

    Raises:
        InvalidWorld: If it is no world, as far as a few interactions tell. What needs an option is not made.
    """
    admit(name, folder, InvalidWorld)
    factory = _load(name)
    defaults = {name: p.default for name, p in _parameters(factory).items() if _is_plain(p.default)}
    options: dict[str, Any] = json.loads(json.dumps(defaults))
    if not _missing_options(factory, options):  # else they must be written into the file first
        check_world(make_own_world(name, options))
    return options


def _load(name: str) -> Factory:
    """Import the factory of a world."""
    factory = load_factory(name, InvalidWorld)
    if not callable(factory):
        kind = type(factory).__name__
        raise InvalidWorld(name, f"is not callable but of type {kind}; name a class or a function")
    if not _makes_worlds(factory):
        raise InvalidWorld(
            name,
            "is not known to make worlds; name a class that has the methods of World, or annotate -> World",
        )
    return factory  # type: ignore[no-any-return]


def _missing_options(factory: Factory, options: dict[str, Any]) -> list[str]:
    needed = [name for name, p in _parameters(factory).items() if p.default is inspect.Parameter.empty]
    return [name for name in needed if name not in options]


def _makes_worlds(factory: Any) -> bool:
    """Say whether a factory is a world's class, or is annotated with one, or stands in a module with one."""
    while isinstance(factory, partial):
        factory = factory.func
    if isinstance(factory, type):
        return _is_world_class(factory)
    try:
        returned = get_type_hints(factory).get("return")
    except Exception:  # annotations can hold anything
        returned = None
    beside = getattr(inspect.unwrap(factory), "__globals__", {}).values()
    return _is_world_class(returned) or any(_is_world_class(kind) for kind in beside if kind is not World)


def _is_world_class(kind: Any) -> bool:
    return isinstance(kind, type) and hasattr(kind, "sample_scene") and hasattr(kind, "interact")


def _check_options(name: str, factory: Factory, options: dict[str, Any]) -> None:
    known = _parameters(factory)
    takes_any = any(p.kind is p.VAR_KEYWORD for p in _signature(factory))
    for option in options:
        if option not in known and not takes_any:
            raise InvalidWorld(name, f"has no option {option!r}; valid: {', '.join(known) or 'none'}")
    if missing := _missing_options(factory, options):
        raise InvalidWorld(name, f"needs the option {missing[0]!r}, which has no default")


def _parameters(factory: Factory) -> dict[str, inspect.Parameter]:
    by_keyword = (inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.KEYWORD_ONLY)
    return {p.name: p for p in _signature(factory) if p.kind in by_keyword}


def _signature(factory: Factory) -> list[inspect.Parameter]:
    return list(inspect.signature(factory).parameters.values())


def _is_plain(value: Any) -> bool:
    if isinstance(value, list | tuple):
        return all(map(_is_plain, value))
    if isinstance(value, dict):
        return all(isinstance(key, str) and _is_plain(entry) for key, entry in value.items())
    return isinstance(value, bool | int | str) or (isinstance(value, float) and math.isfinite(value))
