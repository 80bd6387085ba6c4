"""An eye is taught in a domain folder: resumed, with any workers, and refused where it cannot be."""

from pathlib import Path

import pytest
from command_line import neurosym

from neurosym.commands.learn import make_domain_folder
from neurosym.errors import InvalidValue
from neurosym.files import digest
from neurosym.primitives import ledger
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder
from neurosym.stages.seeing import see_stage, seen_ledger

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
    assert digest(folder / layout.EYE) == digest(taught / layout.EYE)


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


def test_what_has_no_camera_or_no_eye_is_refused(tmp_path, capsys):
    plain = begun(tmp_path / "plain", "toy")
    with pytest.raises(InvalidValue, match="without a camera"):
        plain.perform(see_stage(plain, workers=1, **FEW), again=False)
    blind = begun(tmp_path / "blind")
    assert neurosym("explore", str(blind.path), "--steps", "24") == 2
    assert f"neurosym see {blind.path}" in capsys.readouterr().err
