"""The domain folder: what is done is not done again, and what is missing is named."""

import pytest

from neurosym.errors import FolderNotFound, InvalidFile, InvalidValue, StageMissing, UnknownChoice
from neurosym.stages.folder import DomainFolder, Stage, _command
from neurosym.stages.learning import AIMS


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "world.toml").write_text('world = "toy"\n')
    return DomainFolder(tmp_path)


def counting_stage(folder: DomainFolder, **options: int) -> tuple[Stage, list[int]]:
    calls = []

    def work() -> None:
        calls.append(1)
        (folder / "interactions.npz").write_bytes(b"data")

    return Stage("explore", ("world.toml",), ("interactions.npz",), work, dict(options)), calls


@pytest.mark.parametrize(
    ("change", "again", "options", "times"),
    [
        (lambda _: None, False, {"seed": 1}, 1),
        (lambda _: None, True, {"seed": 1}, 2),
        (lambda _: None, False, {"seed": 2}, 2),
        (lambda folder: (folder / "world.toml").write_bytes(b"other"), False, {"seed": 1}, 2),
        (lambda folder: (folder / "interactions.npz").write_bytes(b"other"), False, {"seed": 1}, 2),
        (lambda folder: (folder / "interactions.npz").unlink(), False, {"seed": 1}, 2),
    ],
)
def test_stage_is_done_again_only_if_asked_or_if_something_has_changed(folder, change, again, options, times):
    stage, calls = counting_stage(folder, seed=1)
    assert folder.perform(stage, again=False)
    change(folder)
    other, more = counting_stage(folder, **options)
    assert folder.perform(other, again=again) == (times == 2)
    assert len(calls + more) == times


def test_missing_folder_or_a_file_in_its_place_is_named(tmp_path):
    with pytest.raises(FolderNotFound, match=r"no folder .*nowhere"):
        DomainFolder(tmp_path / "nowhere")
    (tmp_path / "notes").touch()
    with pytest.raises(FolderNotFound, match=r"notes is a file; name a domain folder"):
        DomainFolder(tmp_path / "notes")


def test_folder_in_place_of_a_file_is_refused_before_any_work(folder):
    stage, calls = counting_stage(folder, seed=1)
    (folder / "interactions.npz").mkdir()
    with pytest.raises(InvalidFile, match=r"interactions\.npz cannot be used: it is a folder"):
        folder.require("interactions.npz")
    with pytest.raises(InvalidFile, match=r"interactions\.npz cannot be used: it is a folder"):
        folder.perform(stage, again=True)
    assert not calls


def test_what_came_from_other_files_is_named_with_its_command(folder):
    remarks = []
    folder = DomainFolder(folder.path, notify=remarks.append)
    stage, _ = counting_stage(folder, seed=1)
    folder.perform(stage, again=False)
    assert folder.outdated(("interactions.npz",)) == []
    (folder / "world.toml").write_text("another")
    remark = f"interactions.npz came from another world.toml; `neurosym explore {folder.path}` makes it anew"
    assert folder.outdated(("interactions.npz",)) == [remark]
    folder.perform(Stage("train", ("interactions.npz",), (), lambda: None), again=True)
    assert remarks == [remark]
    (folder / "interactions.npz").write_text("of a user's own")
    assert folder.outdated(("interactions.npz",)) == []


def test_data_of_ones_own_need_a_world_of_ones_own(tmp_path):
    folder = DomainFolder(tmp_path)
    with pytest.raises(StageMissing, match=r"`neurosym init [^ ]*` writes it\.$"):
        folder.require("world.toml")
    (tmp_path / "interactions.npz").touch()
    with pytest.raises(StageMissing, match=r"--world module:factory` writes it for the world of your data"):
        folder.require("world.toml")


def test_problem_is_found_by_name_or_path_and_one_outside_of_the_folder_is_no_problem_of_it(
    folder, tmp_path_factory
):
    elsewhere, here = tmp_path_factory.mktemp("elsewhere"), folder / "problems" / "task-01.pddl"
    here.parent.mkdir()
    here.touch()
    assert folder.problem("task-01") == folder.problem(str(here)) == "task-01"
    for name in ("task-09", "x" * 5000 + ".json"):
        with pytest.raises(UnknownChoice, match=r"no problem .*; valid: task-01"):
            folder.problem(name)
    for name, command in (
        ("mine.json", r"mine\.json"),
        ("task-01.json", r"task-01\.json --name task-01"),
        ("task-01.scene.json", r"task-01\.scene\.json --name task-01"),
    ):
        (elsewhere / name).touch()
        with pytest.raises(InvalidValue, match=rf"outside of .* new-problem .* --scene \S*{command}$"):
            folder.problem(str(elsewhere / name))


@pytest.mark.parametrize("verb", ["explore", "train", "distill"])
def test_what_makes_it_anew_is_the_same_command_whatever_is_aimed_at(folder, verb):
    stages = [(aim.stage(verb), aim.file("training.json")) for aim in AIMS]
    assert len({*stages}) == len(AIMS)
    assert {_command(folder.path, *made) for made in stages} == {f"neurosym {verb} {folder.path}"}
