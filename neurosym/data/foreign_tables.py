"""Tables as people have them, read as interactions: .csv, .npy, .npz, .safetensors and .pt.

Which columns are what, their names say, as `feature.mass`, `action.speed`, `choice.gear`, `effect.x` and
`after.x`, or a small file does. Where rows follow each other in an episode, the next one says what came of
one. Nothing of a table is ever unpickled or executed.
"""

import csv
import io
import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any
from warnings import catch_warnings

import msgspec
import numpy as np
from safetensors import SafetensorError
from safetensors.numpy import load

from neurosym.checks import Float
from neurosym.data.archives import read_arrays
from neurosym.data.axes import Axis, as_tables, axes_in, legal_name
from neurosym.data.interactions import Interactions
from neurosym.data.origin import file_problems
from neurosym.errors import InvalidData, InvalidFile, InvalidValue, blaming, listed_briefly, shortened
from neurosym.files import MOST_DATA, opened, read_bytes, read_toml

KINDS = (".csv", ".npy", ".npz", ".pt", ".safetensors")
"""What tables may be."""
_ROLES = {"feature": "features", "action": "actions", "choice": "choices", "effect": "effects"}
"""What names of columns may begin with."""
_ASKED = (*_ROLES.values(), "after", "episode")
"""What a TOML file may say of columns; if it says nothing of these, their names do."""
_TRUTH = {"true": 1.0, "false": 0.0, "yes": 1.0, "no": 0.0}
_PART = re.compile(r"(?P<name>.+)\[(?P<first>\d+)(?P<range>:(?P<last>\d+))?\]")
_TRACE = ("action", "plan_id")  # columns of a trace, as macq reads them; all others are bits
_MOST_CHOICES = 64  # of one column: each becomes a column of its own


class Roles(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Which columns of a table are what; an array is all its columns, and `array[0:2]` some of them."""

    features: tuple[str, ...] = ()  # what the thing was like that was acted upon
    actions: tuple[str, ...] = ()  # numbers that say what was done
    choices: tuple[str, ...] = ()  # the same by whole numbers or words of which one is chosen
    effects: tuple[str, ...] = ()  # what was added along each axis, or became of what is set
    after: tuple[str, ...] | dict[str, str] = ()  # or what features became: all in order, or some by name
    episode: str = ""  # or the column of episodes, in which the next row says what features became
    axes: tuple[dict[str, Any], ...] = ()  # what effects are along; see `Axis`
    names: dict[str, tuple[str, ...]] = {}  # names of the columns of an array
    origin: dict[str, Any] = {}  # what else is known, as docs/data.md has it


Table = Mapping[str, np.ndarray]
"""Columns (N,) and arrays (N, C) by name; a column of a .csv file may hold words."""


IMAGES = "images"
"""The array (N, side, side) that shows what was acted upon."""
_LEAST_SIDE = 8  # pixels of an image
_TOLD = "v"  # columns of what an eye tells of images


def read_images(path: Path) -> Float[np.ndarray, "N side side"] | None:
    """Read the images of a table; None if it has none.

    Raises:
        InvalidFile: If a file cannot be read, or what is called so is no images.
    """
    if path.suffix.lower() in KINDS[:2] or IMAGES not in (table := _arrays(path)):
        return None
    found = table[IMAGES]
    if (
        found.ndim != 3
        or found.shape[1] != found.shape[2]
        or found.shape[1] < _LEAST_SIDE
        or not len(found)
        or found.dtype.kind not in "fiub"
    ):
        raise InvalidFile(
            path,
            f"its images are {found.dtype} {found.shape}; valid: numbers (N, side, side), of at least "
            f"{_LEAST_SIDE} pixels a side",
        )
    with np.errstate(all="ignore"):
        images = found.astype(np.float64)
    if bad := np.argwhere(~np.isfinite(images)).tolist():
        raise InvalidFile(path, f"images{bad[0]} is not finite")
    if not np.ptp(images):
        raise InvalidFile(path, f"its images are empty: every pixel is {images.flat[0]:g}")
    return images


def read_interactions(
    path: Path,
    columns: Path | None = None,
    note: Callable[[str], None] = lambda _: None,
    *,
    told: Float[np.ndarray, "N numbers"] | None = None,
) -> Interactions:
    """Read a table as interactions.

    Args:
        path: The table; one of `KINDS`.
        columns: A TOML file that says which columns are what, if their names do not, and what axes are.
        note: Is told what should be known of how the table was read.
        told: What an eye tells of its images: features beside those that it has, if any.

    Raises:
        InvalidFile: If a file cannot be read.
        InvalidData: If what the table holds cannot be learned from; all problems are told.
    """
    table, mapping = _read(path), _mapping(columns) if columns else Roles()
    if told is not None:
        rows, names = (
            len(next(iter(table.values()))),
            [f"feature.{_TOLD}{n + 1}" for n in range(told.shape[1])],
        )
        if rows != len(told):
            raise InvalidFile(path, f"it has {len(told)} images and {rows} rows; valid: one for each")
        if taken := next((name for name in names if name in table), None):
            raise InvalidFile(path, f"a column is called {taken}, as what is told of its images; rename it")
        table = {**table, **{f"feature.{_TOLD}{n}": column for n, column in enumerate(told.T, start=1)}}
    if not any(getattr(mapping, role) for role in _ASKED):
        given = {"axes": mapping.axes, "names": mapping.names, "origin": mapping.origin}
        mapping = msgspec.structs.replace(_by_names(path, table), **given)
    elif told is not None:
        seen = tuple(f"feature.{_TOLD}{n}" for n in range(1, told.shape[1] + 1))
        mapping = msgspec.structs.replace(mapping, features=(*mapping.features, *seen))
    if told is not None and mapping.episode:
        raise InvalidFile(path, "it has images, and episodes in place of effects; valid: effects")
    with blaming(columns or path):
        arrays, origin = _gathered(*_paired(table, mapping))
    if unread := [shortened(name) for name in table if name not in _read_by(mapping)]:
        note(f"columns that are left out: {listed_briefly(unread)}")
    if problems := file_problems(arrays, origin):
        raise InvalidData(path, problems)
    return Interactions.filled(arrays, origin)


def _mapping(columns: Path) -> Roles:
    try:
        return msgspec.convert(read_toml(columns), Roles)
    except msgspec.ValidationError as error:
        raise InvalidFile(columns, str(error).rstrip(".")) from error


def _read_by(mapping: Roles) -> set[str]:
    """Name the columns and arrays that a mapping reads."""
    after = mapping.after.values() if isinstance(mapping.after, dict) else mapping.after
    named = (*mapping.features, *mapping.actions, *mapping.choices, *mapping.effects, *after, mapping.episode)
    return {*named, *(found["name"] for one in named if (found := _PART.fullmatch(one)))}


def _read(path: Path) -> dict[str, np.ndarray]:
    """Read the columns and arrays of a table."""
    table = _arrays(path)
    rows = {name: len(column) for name, column in table.items() if column.ndim in (1, 2)}
    if not rows:
        raise InvalidFile(path, "it holds no column of numbers")
    return {name: column for name, column in table.items() if name in rows}


def _arrays(path: Path) -> dict[str, np.ndarray]:
    """Read a table by what its name ends with."""
    readers = dict(zip(KINDS, (_read_csv, _read_npy, _read_npz, _read_pt, _read_tensors), strict=True))
    if path.suffix.lower() not in readers:
        raise InvalidFile(path, f"it is none of the tables that are read; valid: {', '.join(KINDS)}")
    return readers[path.suffix.lower()](path)


def _read_csv(path: Path) -> dict[str, np.ndarray]:
    """Read a text table with a header; columns in which all is a number or a truth value become numbers."""
    text = read_bytes(path, MOST_DATA).decode("utf-8-sig", errors="replace")
    delimiter = max(",;\t", key=text.partition("\n")[0].count)
    try:
        rows = [row for row in csv.reader(io.StringIO(text), delimiter=delimiter) if any(map(str.strip, row))]
    except csv.Error as error:
        raise InvalidFile(path, f"it is no text table: {error}") from error
    header = [name.strip() for name in rows[0]] if rows else []
    if len(rows) < 2 or not all(header):
        raise InvalidFile(path, "it has no header that names each column, and rows below it")
    if doubled := next((name for name in header if header.count(name) > 1), None):
        raise InvalidFile(path, f"two columns are called {doubled}; give each a name of its own")
    for number, row in enumerate(rows[1:], start=2):
        if len(row) != len(header):
            raise InvalidFile(
                path, f"row {number} has {len(row)} entries; valid: {len(header)}, as the header"
            )
    columns = zip(*rows[1:], strict=True)
    return {name: _as_numbers(entries) for name, entries in zip(header, columns, strict=True)}


def _as_numbers(entries: Sequence[str]) -> np.ndarray:
    words = [entry.strip() for entry in entries]
    try:
        return np.array([_TRUTH.get(word.lower(), word) for word in words]).astype(np.float64)
    except ValueError:
        return np.array(words)


def _is_number(word: str) -> bool:
    try:
        return isinstance(float(word), float)
    except ValueError:
        return False


def _read_npy(path: Path) -> dict[str, np.ndarray]:
    """Read one array: its fields if it has names for them, else all of it as `table`."""
    try:
        with opened(path, MOST_DATA) as file:
            array = np.load(file, allow_pickle=False)
    except (ValueError, EOFError) as error:
        raise InvalidFile(path, "it is no .npy file of plain numbers; nothing is unpickled") from error
    return {name: array[name] for name in array.dtype.names} if array.dtype.names else {"table": array}


def _read_npz(path: Path) -> dict[str, np.ndarray]:
    _, given, _ = read_arrays(path, ())
    arrays, _, problems = read_arrays(path, given)
    if problems:
        raise InvalidData(path, problems)
    return arrays


def _read_pt(path: Path) -> dict[str, np.ndarray]:
    """Read plain tensors by name; weights only, so that no code of the file runs."""
    import torch

    try:
        with opened(path, MOST_DATA) as file, catch_warnings(action="ignore"):
            found = torch.load(file, map_location="cpu", weights_only=True)
    except InvalidFile:
        raise
    except Exception as error:  # torch and pickle raise all kinds
        raise InvalidFile(path, "it is no .pt file of plain tensors; nothing else is unpickled") from error
    named = found if isinstance(found, dict) else {"table": found}
    return {str(name): one.numpy() for name, one in named.items() if isinstance(one, torch.Tensor)}


def _read_tensors(path: Path) -> dict[str, np.ndarray]:
    try:
        found: dict[str, np.ndarray] = load(read_bytes(path, MOST_DATA))
    except (SafetensorError, LookupError, MemoryError, TypeError, ValueError) as error:
        raise InvalidFile(path, "it is not a safetensors file, or it is damaged") from error
    return found


def _by_names(path: Path, table: Table) -> Roles:
    """Tell by their names what columns are: `feature.mass`, or arrays called `features` and so on.

    Traces as learners of action models read them have a column `action`, one `plan_id`, and bits.
    """
    if {*_TRACE} < {*table}:  # bits that never change tell nothing
        bits = [name for name in table if name not in _TRACE and len(np.unique(table[name])) > 1]
        return Roles(tuple(bits), choices=_TRACE[:1], episode=_TRACE[1])
    roles: dict[str, list[str]] = {role: [role] for role in _ROLES.values() if role in table}
    after = dict[str, str]()
    for column in table:
        role, dot, name = column.partition(".")
        if dot and name and role in _ROLES:
            roles.setdefault(_ROLES[role], []).append(column)
        elif dot and name and role == "after":
            after[name] = column
    given: dict[str, Any] = {role: tuple(names) for role, names in roles.items()}
    if "features" not in given:
        raise InvalidFile(
            path,
            f"its columns are called {listed_briefly([*map(shortened, table)])}; valid: names such as "
            "feature.mass, action.speed, choice.gear, effect.x and after.mass, or --columns FILE",
        )
    is_told = "effects" in given or after
    return Roles(**given, after=after, episode="episode" if "episode" in table and not is_told else "")


def _chosen(
    table: Table, mapping: Roles, wanted: Sequence[str]
) -> tuple[list[str], Float[np.ndarray, "N C"]]:
    """Take columns of numbers from a table, as they are named in a mapping; return their names, and these."""
    names, parts = list[str](), [np.zeros((len(next(iter(table.values()))), 0))]
    for one in wanted:
        found = _column(table, one)
        if found.dtype.kind not in "fiub":
            row, text = next((n, str(one)) for n, one in enumerate(found.flat) if not _is_number(str(one)))
            if not text:
                raise InvalidValue(f"The column {shortened(one)} has no value in row {row} (from 0)")
            raise InvalidValue(
                f"The column {shortened(one)} is text, as {shortened(text)!r}; valid: numbers, a column of 0 "
                "and 1 for each word of a feature, or name it as one of the choices if it says what was done"
            )
        if (rows := len(parts[0])) != len(found):
            raise InvalidValue(
                f"{shortened(one)} has {len(found)} rows, and others have {rows}; valid: as many"
            )
        if (is_wrong := ~np.isfinite(found.astype(np.float64))).any():
            row = int(np.argwhere(is_wrong)[0][0])
            raise InvalidValue(
                f"The column {shortened(one)} holds {found[is_wrong][0]:g} in row {row} (from 0); valid: "
                "finite numbers"
            )
        part = _PART.fullmatch(one) if one not in table else None
        array = part["name"] if part else one
        first = int(part["first"]) if part else 0
        given = mapping.names.get(array, ())
        plain = one.partition(".")[2] if one.partition(".")[0] in (*_ROLES, "after") else one
        for number in range(found.shape[1]):
            own = given[first + number : first + number + 1]
            is_single = found.shape[1] == 1 and not part
            names.append(own[0] if own else plain if is_single else f"{array}{first + number}")
        parts.append(found.astype(np.float64))
    return names, np.concatenate(parts, axis=1)


def _column(table: Table, name: str) -> np.ndarray:
    """Return a column, an array, or some columns of one, as (N, C)."""
    part = _PART.fullmatch(name) if name not in table else None
    array = part["name"] if part else name
    if array not in table:
        raise InvalidValue(
            f"There is no column {shortened(name)}; there are: {listed_briefly([*map(shortened, table)])}"
        )
    found = table[array] if table[array].ndim == 2 else table[array][:, None]
    if part is None:
        return found
    first = int(part["first"])
    last = int(part["last"]) if part["range"] else first + 1
    if not first < last <= found.shape[1]:
        raise InvalidValue(f"{name} are no columns of {array}, which has {found.shape[1]}")
    return found[:, first:last]


def _paired(table: Table, mapping: Roles) -> tuple[Table, Roles]:
    """Set beside each row that is followed by one of its episode what features are in that."""
    if not mapping.episode:
        return table, mapping
    if mapping.effects or mapping.after:
        raise InvalidValue(
            "It names an episode, whose next row says what came of it; leave out effects and after"
        )
    of = _column(table, mapping.episode)[:, 0]
    followed = np.flatnonzero(of[1:] == of[:-1])
    if not len(followed):
        raise InvalidValue(f"No row follows another one with the same {shortened(mapping.episode)}")
    paired = {name: column[followed] for name, column in table.items()}
    paired |= {f"next {name}": column[followed + 1] for name, column in table.items()}
    after = tuple(f"next {name}" for name in mapping.features)
    return paired, msgspec.structs.replace(mapping, after=after, episode="")


def _gathered(table: Table, mapping: Roles) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
    """Return the arrays of interactions, and their origin."""
    if not mapping.features:
        raise InvalidValue("It names no features; valid: columns that say what a thing was like")
    if not (mapping.actions or mapping.choices):
        raise InvalidValue("It names no actions; valid: columns of actions, or of choices")
    if bool(mapping.effects) == bool(mapping.after):
        raise InvalidValue(
            "It must name effects, or else after or an episode, by which features became others"
        )
    feature_names, features = _chosen(table, mapping, mapping.features)
    names, actions = _chosen(table, mapping, mapping.actions)
    columns = [actions]
    for one in mapping.choices:
        words, marks = _marked(_column(table, one), one)
        names += words
        columns.append(marks)
    if mapping.effects:
        effect_names, effects = _chosen(table, mapping, mapping.effects)
        named = mapping.axes or [{"name": legal_name(name)} for name in effect_names]
        axes = axes_in(named, effects.shape[1])
    else:
        axes, effects = _changed(table, mapping, feature_names, features)
    arrays = {"features": features, "actions": np.concatenate(columns, axis=1), "effects": effects}
    origin: dict[str, Any] = {
        "feature_names": feature_names,
        "action_names": names,
        "axes": as_tables(axes),
        **({"choices": list(range(actions.shape[1], len(names)))} if mapping.choices else {}),
        **mapping.origin,
    }
    return {name: array.astype(np.float32) for name, array in arrays.items()}, origin


def _marked(column: np.ndarray, name: str) -> tuple[list[str], np.ndarray]:
    """Return a column for each choice that a column holds, which is 1 where that was chosen."""
    if column.shape[1] != 1:
        raise InvalidValue(f"{name} has {column.shape[1]} columns; valid: one that holds what was chosen")
    choices, rows = np.unique(column[:, 0], return_inverse=True)
    if "" in choices:
        row = int(np.flatnonzero(column[:, 0] == "")[0])
        raise InvalidValue(f"The column {name} has no value in row {row} (from 0)")
    if choices.dtype.kind == "f" and (part := choices[choices % 1 != 0]).size:
        raise InvalidValue(f"{name} holds {part[0]:g}; valid: whole numbers, or words")
    if len(choices) > _MOST_CHOICES:
        raise InvalidValue(f"{name} holds {len(choices)} choices; valid: at most {_MOST_CHOICES}")
    plain = name.removeprefix("choice.")
    how = "g" if choices.dtype.kind in "fiub" else ""
    return [f"{plain}={choice:{how}}" for choice in choices], np.eye(len(choices))[rows]


def _changed(
    table: Table, mapping: Roles, feature_names: Sequence[str], features: Float[np.ndarray, "N F"]
) -> tuple[tuple[Axis, ...], Float[np.ndarray, "N E"]]:
    """Return the axes of what became of features, and the effects along them."""
    named = mapping.after if isinstance(mapping.after, dict) else {}
    names, after = _chosen(table, mapping, [*(named.values() if named else mapping.after)])
    is_known = {*names} <= {*feature_names}  # else they are all features, in their order
    before = [*named] or (names if is_known else feature_names)
    if missing := next((name for name in named if name not in feature_names), None):
        raise InvalidValue(
            f"after names {missing}, which is no feature; features: {', '.join(feature_names)}"
        )
    if after.shape[1] != len(before):
        raise InvalidValue(f"after has {after.shape[1]} columns; valid: {len(before)}, one for each feature")
    now = features[:, [feature_names.index(name) for name in before]]
    known = {axis.name: axis for axis in (axes_in(mapping.axes, None) if mapping.axes else ())}
    if strange := next((name for name in known if name not in map(legal_name, before)), None):
        raise InvalidValue(f"There is an axis {strange}, which `after` does not name")
    kinds = {legal_name(str(one.get("name"))): one.get("kind") for one in mapping.axes}
    axes, keep = list[Axis](), list[int]()
    for number, name in enumerate(map(legal_name, before)):
        both = np.stack([now[:, number], after[:, number]])
        if name in known or np.any(both[0] != both[1]):
            keep.append(number)
            axis = known.get(name) or Axis(name)
            is_flag = not kinds.get(name) and np.isin(both, (0, 1)).all()
            axes.append(msgspec.structs.replace(axis, kind="flag") if is_flag else axis)
    if not keep:
        raise InvalidValue("Nothing differs between the features and what they became")
    effects = [axis.difference(after[:, n], now[:, n]) for axis, n in zip(axes, keep, strict=True)]
    return tuple(axes), np.stack(effects, axis=1)
