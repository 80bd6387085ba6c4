"""Several processes in one domain folder: some share it, some have it for themselves; no record is lost."""

import json
import os
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from command_line import contents, refusal

from neurosym import files
from neurosym.commands.tasks import new_problem
from neurosym.errors import CannotWrite, FolderTaken, InvalidFile
from neurosym.files import write_atomically
from neurosym.stages.compilation import compile_stage
from neurosym.stages.folder import Claim, DomainFolder, Stage
from neurosym.stages.planning import load_problem


@pytest.fixture(autouse=True)
def ask_once(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(files, "_TRIES", 1)


def stage(folder: DomainFolder, name: str, *, claim: Claim = Claim.SHARED) -> Stage:
    """A stage that writes a file of its name."""
    return Stage(name, (), (name,), lambda: write_atomically(folder / name, name), claim=claim)


ALLOWED = {(Claim.SHARED, Claim.SHARED), *((claim, Claim.NONE) for claim in Claim)}


@pytest.mark.parametrize("held", Claim)
@pytest.mark.parametrize("wanted", Claim)
def test_folder_is_had_together_only_by_those_who_share_or_look(tmp_path: Path, held: Claim, wanted: Claim):
    first, second = DomainFolder(tmp_path), DomainFolder(tmp_path)
    with first.claimed(held):
        if (held, wanted) in ALLOWED or held is Claim.NONE:
            assert second.perform(stage(second, "mine", claim=wanted), again=True)
        else:
            with pytest.raises(FolderTaken, match=rf"Process {os.getpid()} works in .*; wait until it has"):
                second.perform(stage(second, "mine", claim=wanted), again=True)
            assert list(tmp_path.iterdir()) == []


def test_claim_is_given_back_whatever_happens(tmp_path: Path):
    def fail() -> None:
        raise KeyboardInterrupt

    first, second = DomainFolder(tmp_path), DomainFolder(tmp_path)
    with pytest.raises(KeyboardInterrupt):
        first.perform(Stage("fails", (), ("a",), fail, claim=Claim.ALONE), again=True)
    assert second.perform(stage(second, "mine", claim=Claim.ALONE), again=True)


def at_the_same_time(work: Callable[[int], object], count: int) -> None:
    """Have threads do something with their numbers, all at once."""
    together = threading.Barrier(count)
    with ThreadPoolExecutor(count) as pool:
        [*pool.map(lambda number: (together.wait(), work(number)), range(count))]


def test_no_record_of_stages_at_the_same_time_is_lost(tmp_path: Path):
    names = [f"stage-{number}" for number in range(12)]

    def perform(number: int) -> None:
        folder = DomainFolder(tmp_path)
        folder.perform(stage(folder, names[number]), again=True)

    at_the_same_time(perform, 12)
    assert sorted(DomainFolder(tmp_path).manifest().stages) == sorted(names)
    assert {path.name for path in tmp_path.iterdir()} == {*names, "manifest.json"}


def test_stage_that_fails_while_it_writes_changes_nothing(tmp_path: Path, monkeypatch):
    folder = DomainFolder(tmp_path)
    folder.perform(stage(folder, "a"), again=True)
    before = contents(tmp_path)

    def fail() -> None:
        write_atomically(folder / "a", "another")
        write_atomically(folder / "gone" / "b", "in a folder that is not there")

    with pytest.raises(CannotWrite, match="gone/b cannot be written: No such file or directory"):
        folder.perform(Stage("a", (), ("a",), fail), again=True)
    assert contents(tmp_path) == before

    def full(path: Path, _: object) -> None:
        raise CannotWrite(path, OSError(28, "No space left on device"))

    monkeypatch.setattr("neurosym.stages.folder.write_json", full)
    work = lambda: write_atomically(folder / "a", "another")  # noqa: E731
    with pytest.raises(CannotWrite, match=r"manifest\.json cannot be written: No space left"):
        folder.perform(Stage("a", (), ("a",), work), again=True)
    assert contents(tmp_path) == before


def test_folder_in_which_another_learns_is_refused_in_a_sentence(folder: Path, capsys):
    with DomainFolder(folder).claimed(Claim.ALONE):
        for command in (
            ["plan", folder, "task-01"],
            ["train", folder],
            ["new-problem", folder],
            ["compare", folder, "--tasks", 1, "--workers", 1],
            ["run", folder, "--steps", 1024, "--regime", "quick", "--strategy", "random", "--seed", 3],
        ):
            assert f"Process {os.getpid()} works in {folder}" in refusal(capsys, *command)


def test_problems_made_at_the_same_time_get_names_of_their_own(folder: Path, capsys):
    before = set(DomainFolder(folder).problem_names())
    at_the_same_time(lambda seed: new_problem(folder, seed=seed), 4)
    made = set(DomainFolder(folder).problem_names()) - before
    assert len(made) == 4
    said = capsys.readouterr().out
    assert all(f"wrote {folder}/problems/{name}.pddl" in said for name in made)
    seeds = {json.loads((folder / f"problems/{name}.scene.json").read_text())["provenance"] for name in made}
    assert len(seeds) == 4


def test_scenes_of_other_names_keep_to_their_own_files_or_are_refused(folder: Path):
    domain, problems = DomainFolder(folder), folder / "problems"
    (problems / "other.scene.json").write_bytes((problems / "task-01.scene.json").read_bytes())
    before = {path.name: path.read_bytes() for path in problems.glob("task-*")}
    for cell in (0.01, 0.005):
        domain.perform(compile_stage(domain, cell=cell), again=True)
    assert {path.name: path.read_bytes() for path in problems.glob("task-*")} == before
    assert "(problem other)" in (problems / "other.pddl").read_text()
    assert load_problem(domain, "other").name == "other"
    (problems / "other.scene.json").rename(problems / "My scene.scene.json")
    everything = contents(folder)
    with pytest.raises(InvalidFile, match=r"My scene\.scene\.json cannot be used: 'My scene' is not a legal"):
        domain.perform(compile_stage(domain, cell=0.01), again=True)
    assert contents(folder) == everything
