"""The domain folder: what is done is not done again, and what is missing is named."""

import pytest

from neurosym.errors import FolderNotFound, InvalidFile, InvalidValue, StageMissing, UnknownChoice
from neurosym.stages.folder import DomainFolder, Stage
from neurosym.stages.layout import MANIFEST


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


def test_stage_that_is_done_is_not_done_again(folder):
    stage, calls = counting_stage(folder, seed=1)
    assert folder.perform(stage, again=False)
    assert not folder.perform(stage, again=False)
    assert len(calls) == 1


def test_stage_is_done_again_when_asked_to(folder):
    stage, calls = counting_stage(folder)
    folder.perform(stage, again=False)
    folder.perform(stage, again=True)
    assert len(calls) == 2


@pytest.mark.parametrize("changed", ["world.toml", "interactions.npz"])
def test_stage_is_done_again_when_a_file_has_changed(folder, changed):
    stage, calls = counting_stage(folder)
    folder.perform(stage, again=False)
    (folder / changed).write_bytes(b"other")
    folder.perform(stage, again=False)
    assert len(calls) == 2


def test_stage_is_done_again_when_its_output_is_gone(folder):
    stage, calls = counting_stage(folder)
    folder.perform(stage, again=False)
    (folder / "interactions.npz").unlink()
    folder.perform(stage, again=False)
    assert len(calls) == 2


def test_stage_is_done_again_with_other_options(folder):
    stage, _ = counting_stage(folder, seed=1)
    folder.perform(stage, again=False)
    other, calls = counting_stage(folder, seed=2)
    folder.perform(other, again=False)
    assert len(calls) == 1


def test_record_tells_options_digests_and_versions(folder):
    stage, _ = counting_stage(folder, seed=1)
    folder.perform(stage, again=False)
    record = folder.manifest().stages["explore"]
    assert record.options == {"seed": 1}
    assert set(record.inputs) == {"world.toml"}
    assert len(record.outputs["interactions.npz"]) == 64
    assert "torch" in record.versions


def test_missing_folder_is_named(tmp_path):
    with pytest.raises(FolderNotFound, match=r"no folder .*nowhere"):
        DomainFolder(tmp_path / "nowhere")


def test_file_in_place_of_a_folder_is_named(tmp_path):
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


def test_outdated_problem_is_named_with_the_command_that_names_it(folder):
    (folder / "world.toml").write_text("one")

    def draw() -> None:
        (folder / "one.pddl").write_text("drawn")

    folder.perform(Stage("new-problem one", ("world.toml",), ("one.pddl",), draw), again=False)
    (folder / "world.toml").write_text("another")
    command = f"neurosym new-problem {folder.path} --name one"
    remark = f"one.pddl came from another world.toml; `{command}` makes it anew"
    assert folder.outdated(("one.pddl",)) == [remark]
    scene = folder / "problems/one.scene.json"
    scene.parent.mkdir()
    scene.touch()  # the task stays the same
    assert folder.outdated(("one.pddl",)) == [remark.replace(command, f"{command} --scene {scene}")]


def test_missing_stage_is_named_with_its_command(folder):
    with pytest.raises(StageMissing, match=r"primitives\.json is missing; `neurosym distill"):
        folder.require("primitives.json")


def test_data_of_ones_own_need_a_world_of_ones_own(tmp_path):
    folder = DomainFolder(tmp_path)
    with pytest.raises(StageMissing, match=r"`neurosym init [^ ]*` writes it\.$"):
        folder.require("world.toml")
    (tmp_path / "interactions.npz").touch()
    with pytest.raises(StageMissing, match=r"--world module:factory` writes it for the world of your data"):
        folder.require("world.toml")


def test_problem_is_found_by_name_or_path_and_else_the_valid_ones_are_named(folder):
    (folder / "problems").mkdir()
    (folder / "problems" / "task-01.pddl").touch()
    assert folder.problem("task-01") == "task-01"
    assert folder.problem(str(folder / "problems" / "task-01.pddl")) == "task-01"
    with pytest.raises(UnknownChoice, match="no problem 'task-09'; valid: task-01"):
        folder.problem("task-09")


def test_file_outside_of_the_folder_is_no_problem_of_it_before_it_is_taken_over(folder, tmp_path_factory):
    elsewhere = tmp_path_factory.mktemp("elsewhere")
    (folder / "problems").mkdir()
    (folder / "problems" / "task-01.pddl").touch()
    for name, command in (("mine.json", r"mine\.json"), ("task-01.json", r"task-01\.json --name task-01")):
        (elsewhere / name).touch()
        with pytest.raises(InvalidValue, match=rf"outside of .* new-problem .* --scene \S*{command}$"):
            folder.problem(str(elsewhere / name))
    other = elsewhere / "task-01.scene.json"
    other.touch()
    with pytest.raises(InvalidValue, match=r"outside of .*--name task-01$"):
        folder.problem(str(other))
    with pytest.raises(UnknownChoice, match="no problem"):
        folder.problem("x" * 5000 + ".json")


def test_corrupt_manifest_is_refused(folder):
    (folder / MANIFEST).write_text("{")
    with pytest.raises(InvalidFile, match=r"manifest\.json"):
        folder.manifest()
