"""What one takes away from a page: files for planners, the record of a run, a link that holds a scene."""

import base64
import io
import zipfile
import zlib
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

from neurosym.errors import InvalidValue
from neurosym.problems import Problem
from neurosym.reading import decode_json, read_bytes
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import (
    DOMAIN,
    NUMERIC_DOMAIN,
    plan_files,
    problem_files,
    scene_file,
    steps_file,
)
from neurosym.stages.scenes import scene_stage

if TYPE_CHECKING:
    from neurosym.studio.session import Session

OPEN = "/open/"
"""What the path of a link begins with."""
MOST_LINK = 16_000
"""Characters of a scene in a link."""
MOST_SCENE = 200_000
"""Bytes of the scene that a link holds, unpacked."""
_WHEN = (1980, 1, 1, 0, 0, 0)  # so that the same files make the same bytes


def zip_of(session: "Session") -> bytes:
    """Return domain, problem, plans and run of a page as a zip; its problem is printed first.

    Args:
        session: The page.
    """
    problem, room = session.problem, session.room.path
    if problem is None:
        return b""
    folder, file = DomainFolder(room), room / "taken.json"
    problem.save(file)
    folder.perform(scene_stage(folder, file, name=problem.name), again=True)
    names = [DOMAIN, NUMERIC_DOMAIN]
    names += [*problem_files(problem.name)]
    names += [scene_file(problem.name)]
    for planner in session.plans:
        plan_file, record_file = plan_files(problem.name, planner)
        names += [plan_file, steps_file(plan_file), record_file]
    names += [session.running.file] if session.running.file else []
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in names:
            if (room / name).is_file():
                archive.writestr(zipfile.ZipInfo(name, _WHEN), read_bytes(room / name), zipfile.ZIP_DEFLATED)
    return buffer.getvalue()


def record_of(session: "Session") -> bytes:
    """Return the record of the last run of a page; nothing if there is none."""
    file = session.running.file
    return read_bytes(session.room.path / file) if file else b""


def link_of(problem: Problem) -> str:
    """Return the path of a link that holds a scene.

    Args:
        problem: The scene and its goals.
    """
    packed = zlib.compress(msgspec.json.encode(problem), 9)
    return OPEN + base64.urlsafe_b64encode(packed).decode().rstrip("=")


def scene_of(link: str) -> Problem:
    """Return the scene that a link holds.

    Args:
        link: The path of the link, or only what stands after `OPEN`.

    Raises:
        InvalidValue: If it holds none.
    """
    text = link.removeprefix(OPEN)
    if len(text) > MOST_LINK:
        raise InvalidValue(f"The link has {len(text):,} characters; a scene takes at most {MOST_LINK:,}.")
    try:
        packed = base64.b64decode(text + "=" * (-len(text) % 4), altchars=b"-_", validate=True)
        unpacking = zlib.decompressobj()
        content = unpacking.decompress(packed, MOST_SCENE)
    except (ValueError, zlib.error) as error:
        raise InvalidValue("The link holds no scene; copy it whole from the panel Take away.") from error
    if unpacking.unconsumed_tail or not unpacking.eof:
        raise InvalidValue(f"The link holds no scene, or one of more than {MOST_SCENE:,} bytes.")
    return decode_json(Path("the link"), content, Problem)
