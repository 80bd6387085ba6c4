"""An eye is taught in a domain folder: resumed, with any workers, and refused where it cannot be."""

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from command_line import neurosym

from neurosym.commands.learn import make_domain_folder
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidValue
from neurosym.files import digest
from neurosym.primitives import ledger
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder
from neurosym.stages.learning import OBJECTS, explored_for, train_stage
from neurosym.stages.seeing import _drawn, see_stage, seen_ledger
from neurosym.worlds.world_file import read_world

FEW = {"acted": 24, "looked": 12, "seed": 3}


def begun(path: Path, world: str = "camera") -> DomainFolder:
    make_domain_folder(path, world)
    return DomainFolder(path)


@pytest.fixture(scope="module")
def taught(tmp_path_factory: pytest.TempPathFactory) -> DomainFolder:
    folder = begun(tmp_path_factory.mktemp("seeing") / "one")
    folder.perform(see_stage(folder, workers=1, **FEW), again=False)
    return folder


def test_an_eye_is_the_same_interrupted_and_with_any_workers(taught, tmp_path, monkeypatch):
    folder = begun(tmp_path / "two")
    monkeypatch.setattr(ledger, "BLOCK", 8)
    write, calls = ledger.Ledger._write, []

    def interrupted(self: ledger.Ledger) -> None:
        write(self)
        calls.append(len(self))
        if len(calls) == 2:
            raise KeyboardInterrupt

    monkeypatch.setattr(ledger.Ledger, "_write", interrupted)
    with pytest.raises(KeyboardInterrupt):
        folder.perform(see_stage(folder, workers=2, **FEW), again=False)
    assert not (folder / layout.EYE).exists()
    assert 8 <= len(seen_ledger(folder)) < 24
    monkeypatch.setattr(ledger.Ledger, "_write", write)
    folder.perform(see_stage(folder, workers=2, **FEW), again=False)
    for name in (layout.EYE, layout.SEEN):
        assert digest(folder / name) == digest(taught / name)


def test_commands_work_on_what_is_seen_and_tell_a_damaged_eye(taught, capsys):
    assert neurosym("explore", str(taught.path), "--steps", "24", "--workers", "1") == 0
    manifest = DomainFolder(taught.path).manifest().stages
    assert manifest["explore"].inputs[layout.EYE] == digest(taught / layout.EYE)
    whole = (taught / layout.EYE).read_bytes()
    try:
        (taught / layout.EYE).write_bytes(whole[:-7])
        assert neurosym("explore", str(taught.path), "--steps", "48", "--workers", "1") == 2
        assert layout.EYE in capsys.readouterr().err
    finally:
        (taught / layout.EYE).write_bytes(whole)


def test_what_taught_the_eye_teaches_the_networks_as_it_is_seen(taught, tmp_path, capsys):
    folder = DomainFolder(shutil.copytree(taught.path, tmp_path / "copy"))
    seen, acted = Interactions.load(folder / layout.SEEN), seen_ledger(folder).interactions({})
    assert seen.effects == pytest.approx(acted.effects, abs=0.01)
    assert seen.actions.tobytes() == acted.actions.tobytes()
    world = read_world(folder / layout.WORLD)()
    begun = [world.seen(_drawn(world, FEW["seed"], number)[0]) for number in range(len(seen))]
    assert seen.features == pytest.approx(np.array([one.features[0] for one in begun]))
    assert neurosym("explore", str(folder.path), "--steps", "24", "--workers", "1") == 0
    assert len(explored_for(folder, OBJECTS)) == 24 + len(seen)
    assert layout.SEEN in train_stage(folder, seed=0, regime="quick").inputs
    narrow, other = {"features": seen.features[:, :3]}, {"origin": {**seen.origin, "eye": "another"}}
    for change in (
        {**narrow, "origin": {**seen.origin, "feature_names": ["a", "b", "c"], "unshown": []}},
        other,
    ):
        replace(seen, **change).save(folder / layout.SEEN)
        capsys.readouterr()
        assert neurosym("train", str(folder.path), "--regime", "quick") == 2
        assert "it is of another eye or world than interactions.npz" in capsys.readouterr().err


def test_what_is_seen_again_is_the_same_and_names_the_eye(taught, tmp_path):
    folder = DomainFolder(shutil.copytree(taught.path, tmp_path / "copy"))
    folder.perform(see_stage(folder, workers=1, **FEW), again=True)
    assert digest(folder / layout.SEEN) == digest(taught / layout.SEEN)
    folder.perform(see_stage(folder, workers=1, **{**FEW, "seed": 4}), again=True)
    assert Interactions.load(folder / layout.SEEN).origin["eye"] == digest(folder / layout.EYE)


def test_what_has_no_camera_or_no_eye_is_refused(tmp_path, capsys):
    plain = begun(tmp_path / "plain", "toy")
    with pytest.raises(InvalidValue, match="names a world that sees nothing"):
        plain.perform(see_stage(plain, workers=1, **FEW), again=False)
    blind = begun(tmp_path / "blind")
    assert neurosym("explore", str(blind.path), "--steps", "24") == 2
    assert f"neurosym see {blind.path}" in capsys.readouterr().err
