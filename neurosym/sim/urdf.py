"""A robot's file, read by PyBullet; what cannot be read is told in one sentence, with the reason."""

import re
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from xml.etree import ElementTree

from neurosym.errors import InvalidArm, InvalidFile
from neurosym.reading import read_text
from neurosym.sim.bullet import Client, overheard, pybullet

_HEADINGS = re.compile(r"b3\w+\[[^\]]*\]:\s*")
"""What PyBullet puts before each piece of what it says: where in its sources it says it."""
_MESH = re.compile(
    r"cannot find '(?P<lost>[^']+)' in any directory|cannot extract mesh from '(?P<broken>[^']+)'"
)


@contextmanager
def loaded(
    urdf: str,
    base: tuple[float, float, float] = (0.0, 0.0, 0.0),
    *,
    collides: bool = True,
    visible: bool = False,
) -> Iterator[tuple[Client, int]]:
    """Load a robot into a simulation that is used for nothing else, and yield that and the robot.

    Args:
        urdf: The file.
        base: Where the base stands in the world [m].
        collides: Whether collision shapes are loaded, too.
        visible: Whether its looks are loaded, too.

    Raises:
        InvalidArm: If the file cannot be read.
    """
    flags = pybullet.URDF_USE_INERTIA_FROM_FILE
    flags |= 0 if collides else pybullet.URDF_IGNORE_COLLISION_SHAPES
    flags |= 0 if visible else pybullet.URDF_IGNORE_VISUAL_SHAPES
    client = Client()
    try:
        client.setPhysicsEngineParameter(enableFileCaching=0)  # it may be mended
        yield client, _load(client, urdf, base, flags)
    finally:
        client.disconnect()


def _load(client: Client, urdf: str, base: tuple[float, float, float], flags: int) -> int:
    robot = _parsed(urdf)
    if problem := _tree_problem(robot):
        raise _unreadable(urdf, problem)  # PyBullet would crash
    said: list[str] = []
    try:
        with overheard(said):
            body = client.loadURDF(urdf, base, useFixedBase=True, flags=flags)
    except pybullet.error as error:
        raise _unreadable(urdf, _mesh_problem(robot, said[0]) or _plainly(said[0])) from error
    if problem := _mesh_problem(robot, said[0]):
        raise _unreadable(urdf, problem)
    return int(body)


def _parsed(urdf: str) -> ElementTree.Element:
    try:
        return ElementTree.fromstring(read_text(Path(urdf)))
    except InvalidFile as error:
        raise _unreadable(urdf, str(error).removeprefix(f"{Path(urdf)} cannot be used: ")) from error
    except ElementTree.ParseError as error:
        raise _unreadable(urdf, f"it is no whole XML ({error})") from error


def _tree_problem(robot: ElementTree.Element) -> str:
    """Say what keeps the links from being one tree, or nothing."""
    names = [str(link.get("name")) for link in robot.findall("link")]
    ends = [(joint.find("parent"), joint.find("child")) for joint in robot.findall("joint")]
    pairs = [
        (str(above.get("link")), str(below.get("link")))
        for above, below in ends
        if above is not None and below is not None
    ]
    if unknown := next((name for pair in pairs for name in pair if name not in names), None):
        return f"a joint names the link {unknown}, which it does not describe; valid: {', '.join(names)}"
    children = Counter(child for _, child in pairs)
    if twice := [name for name, count in children.items() if count > 1]:
        return f"the link {twice[0]} is the child of {children[twice[0]]} joints; valid: of one"
    roots = [name for name in names if name not in children]
    if len(roots) > 1:
        return f"the links {' and '.join(roots[:2])} are no joint's child; valid: one such link, the base"
    reached = found = set(roots)
    while found:
        found = {child for parent, child in pairs if parent in reached} - reached
        reached = reached | found
    if around := sorted(set(names) - reached):
        return f"its joints lead round in a circle at the link {around[0]}; valid: a tree"
    return ""


def _mesh_problem(robot: ElementTree.Element, said: str) -> str:
    """Tell which mesh PyBullet did not find or read, and of which link; or nothing."""
    if (match := _MESH.search(said)) is None:
        return ""
    name = match["lost"] or match["broken"]
    for link in robot.iter("link"):
        for mesh in link.iter("mesh"):
            written = mesh.get("filename", "")
            if written and Path(written).name == Path(name).name:
                name = f"{written} of the link {link.get('name')}"
    why = "is not found" if match["lost"] else "cannot be read"
    valid = "a path from the file's folder" if match["lost"] else "a whole .stl, .obj or .dae file"
    return f"the mesh {name} {why}; valid: {valid}"


def _plainly(said: str) -> str:
    """Say in one line what PyBullet said."""
    words = " ".join(_HEADINGS.sub(" ", said).split())
    return f"PyBullet says: {words}" if words else "it describes no robot"


def _unreadable(urdf: str, why: str) -> InvalidArm:
    return InvalidArm(f"cannot be read from {urdf}: {why.rstrip('.')}")
