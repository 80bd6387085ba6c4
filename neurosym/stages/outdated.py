"""What was made from other files than are there now, and what to type to make it anew."""

from pathlib import Path

from neurosym.files import digests
from neurosym.stages.layout import COMMANDS, GROUNDING, MODEL, PLAN, PLANS, STEPS, WORLD, scene_file
from neurosym.stages.manifest import Manifest
from neurosym.wording import quoted


def remarks_on_outdated(folder: Path, manifest: Manifest, names: tuple[str, ...]) -> list[str]:
    """Say which of some files were made from others than those that are there now, if any are.

    Args:
        folder: The domain folder.
        manifest: How its files came about.
        names: Files, relative to the folder.
    """
    remarks = []
    for stage, record in manifest.stages.items():
        made = {name: made for name, made in record.outputs.items() if name in names}
        if not made or made != _digests(folder, made):
            continue
        now = _digests(folder, record.inputs)
        if changed := [name for name, digested in now.items() if digested != record.inputs[name]]:
            files, others = " and ".join(made), " and ".join(changed)
            command = _command(folder, stage, next(iter(made)))
            remarks.append(f"{files} came from another {others}; `{command}` makes it anew")
    return remarks


def refuse_damaged(folder: Path, names: tuple[str, ...]) -> None:
    """Raise `InvalidFile` if one of some files that decide most can no longer be read.

    Args:
        folder: The domain folder.
        names: Files, relative to the folder.
    """
    from neurosym.grounding import Grounding
    from neurosym.worlds.world_file import read_world

    for name, read in ((WORLD, read_world), (GROUNDING, Grounding.load), (MODEL, _read_model)):
        if name in names and (folder / name).is_file():
            read(folder / name)


def _command(folder: Path, stage: str, made: str) -> str:
    """Return what to type to perform a stage once more.

    Args:
        folder: The domain folder.
        stage: What the stage is called.
        made: One of its files.
    """
    command, *of = stage.split()
    typed = f"neurosym {COMMANDS.get(made, command)} {quoted(folder)}"
    if command == "new-problem":
        scene = folder / scene_file(of[0])  # taken over as it is, so that the task stays the same
        return f"{typed} --name {of[0]}" + (f" --scene {quoted(scene)}" if scene.exists() else "")
    if command == "execute":
        plans = (folder / PLANS / f"{of[0]}{ending}" for ending in (PLAN, STEPS))
        plan = next((quoted(plan) for plan in plans if plan.exists()), "PLAN")
        return f"{typed} {of[0].split('.')[0]} {plan}"
    return typed


def _read_model(path: Path) -> None:
    from neurosym.learning.effect_model import EffectModel

    EffectModel.load(path)


def _digests(folder: Path, names: dict[str, str]) -> dict[str, str]:
    return digests({name: folder / name for name in names})
