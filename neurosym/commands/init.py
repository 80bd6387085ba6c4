"""The command `neurosym init`: a new domain folder."""

from pathlib import Path
from typing import Annotated

from tyro.conf import arg

from neurosym.commands.options import Folder, opened
from neurosym.console import say, say_next
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import DIRECT_MODEL, GROUNDING, INTERACTIONS, MODEL, PRIMITIVES, WORLD
from neurosym.wording import quoted

WorldName = Annotated[
    str, arg(help="Which world, for a new folder: tabletop, toy, or your own as module:factory.")
]


def init(folder: Folder, world: WorldName = "tabletop") -> int:
    """Make a new domain folder with a `world.toml` that holds every option of its world."""
    if (folder / WORLD).exists():
        raise _exists(folder)
    make_folder(folder, world)
    say_next(f"neurosym {_next_step(opened(folder))} {quoted(folder)}")
    return 0


def _next_step(folder: DomainFolder) -> str:
    """Return the command that comes after what a folder holds besides its world."""
    from neurosym.operators import OperatorTable

    if not (folder / INTERACTIONS).is_file():
        return "explore"
    if not all((folder / model).is_file() for model in (MODEL, DIRECT_MODEL)) or folder.outdated((MODEL,)):
        return "train"
    try:
        table = OperatorTable.load(folder / PRIMITIVES)
    except InvalidFile:
        return "distill"
    if table.measured == "data" or folder.outdated((PRIMITIVES,)):  # there is a world to rehearse in now
        return "distill"
    return "new-problem" if (folder / GROUNDING).is_file() else "compile-domain"


def make_folder(folder: Path, world: str) -> None:
    """Make a domain folder with every option of its world."""
    from neurosym.files import make_folder as make
    from neurosym.files import write_new
    from neurosym.worlds.world_file import default_text

    if folder.exists() and not folder.is_dir():
        raise InvalidValue(f"{folder} is not a folder; name another.")
    text = default_text(world, folder)
    make(folder)
    if not write_new(folder / WORLD, text):
        raise _exists(folder)
    say(f"wrote {folder / 'world.toml'}")


def _exists(folder: Path) -> InvalidValue:
    said = f"{folder / WORLD} exists already; change it by hand, or name another folder."
    return InvalidValue(said)
