"""Meeting objects: what they do when they are tried is kept by their names, and planned with."""

import json
import shutil
from pathlib import Path

import msgspec
import pytest
from command_line import contents, neurosym, refusal

from neurosym.grounding import Grounding, is_lift
from neurosym.problems import Trial
from neurosym.stages.folder import DomainFolder, load_scene
from neurosym.stages.past_files import load_past
from neurosym.tasks.transition import PlanStep, hand_problem

ROOT = Path(__file__).parents[2]
TASK = "anywhere-1-01"


@pytest.fixture
def folder(tmp_path) -> Path:
    place = tmp_path / "places"
    shutil.copytree(
        ROOT / "domains" / "places", place, ignore=shutil.ignore_patterns("runs", "interactions.npz")
    )
    return place


def past(folder: Path, name: str = "item-01") -> dict:
    return json.loads((folder / "pasts" / f"{name}.json").read_text())


def test_tries_go_on_where_they_ended_and_are_forgotten_on_demand(folder, tmp_path, capsys):
    other = tmp_path / "other"
    shutil.copytree(folder, other)
    assert neurosym("meet", folder, TASK, "--tries", 1) == 0
    assert neurosym("meet", folder, TASK, "--tries", 2) == 0
    assert neurosym("meet", other, TASK, "--tries", 2) == 0
    assert contents(folder / "pasts") == contents(other / "pasts")
    assert len(past(folder)["trials"]) == 2
    assert past(folder)["trials"][0]["motion"] != past(folder)["trials"][1]["motion"]
    capsys.readouterr()
    assert neurosym("meet", folder, TASK, "--tries", 2) == 0
    said = capsys.readouterr().out
    assert "item-01 looks like solid-low-10, and did as such objects do 2 of 2 times; it is best" in said
    assert "(2 motions with it so far)" in said
    assert "nothing is known" not in said
    assert contents(folder / "pasts") == contents(other / "pasts")
    assert neurosym("explain", folder) == 0
    assert "item-01 looks like" in capsys.readouterr().out
    assert neurosym("meet", folder, TASK, "--forget", "--tries", 0) == 0
    assert "nothing is known of what they did\n" in capsys.readouterr().out
    assert not (folder / "pasts" / "item-01.json").exists()


def test_plans_and_runs_of_what_was_met_go_by_its_past_and_add_to_it(folder, capsys):
    assert neurosym("meet", folder, TASK, "--tries", 1) == 0
    assert neurosym("plan", folder, TASK) == 0
    plan = folder / "plans" / f"{TASK}.fast-downward.plan"
    (tried,) = past(folder)["trials"]
    assert tried["kind"] == "carried"
    first = plan.read_text()
    for _ in range(2):  # what a run showed is known once, however often it is run
        assert neurosym("execute", folder, TASK, plan) == 0
        assert [one.get("run", "") for one in past(folder)["trials"]] == ["", f"{TASK}.fast-downward"]
        assert neurosym("replay", folder, f"{TASK}.fast-downward") == 0  # though more is known now
    assert neurosym("meet", folder, TASK, "--forget") == 0
    missed = [{**one, "kind": "missed"} for one in past(folder)["trials"]]
    assert len({one["motion"] for one in missed}) == 3
    (folder / "pasts" / "item-01.json").write_text(json.dumps({**past(folder), "trials": missed}))
    capsys.readouterr()
    neurosym("plan", folder, TASK)
    assert "is not as it was printed" not in capsys.readouterr().out
    neurosym("plan", folder, TASK)
    assert plan.read_text() != first if plan.exists() else True
    assert "carry-to" not in capsys.readouterr().out


def test_a_scene_that_somebody_put_there_is_printed_anew_and_a_plan_says_that_a_past_was_forgotten(
    folder, capsys
):
    scene = json.loads((folder / "problems" / f"{TASK}.scene.json").read_text())
    (folder / "problems" / "own.scene.json").write_text(json.dumps({**scene, "name": "own"}))
    assert neurosym("plan", folder, "own") == 0
    assert neurosym("meet", folder, "own", "--tries", 2) == 0
    for _ in range(2):
        capsys.readouterr()
        assert neurosym("plan", folder, "own") == 0
        assert "is not as it was printed" not in capsys.readouterr().out
    plan = folder / "plans" / "own.fast-downward.plan"
    assert neurosym("validate", folder, "own", plan) == 0
    assert "forgotten" not in capsys.readouterr().out
    assert neurosym("meet", folder, "own", "--forget", "--tries", 0) == 0
    neurosym("validate", folder, "own", plan)
    assert "came from pasts/item-01.json, which was forgotten" in capsys.readouterr().out


def test_what_was_met_is_told_of_as_it_lay_at_last(folder, capsys):
    assert neurosym("meet", folder, TASK, "--tries", 2) == 0
    on_a_side = [{**one, "lay": [0.5**0.5, 0.0, 0.0, 0.5**0.5]} for one in past(folder)["trials"]]
    (folder / "pasts" / "item-01.json").write_text(json.dumps({**past(folder), "trials": on_a_side}))
    capsys.readouterr()
    assert neurosym("explain", folder) == 0
    said = capsys.readouterr().out
    assert "item-01 looks like" in said
    assert "item-01 looks like solid-low-10" not in said


def test_a_past_of_another_object_is_refused_by_who_meets_and_left_aside_by_plans(folder, capsys):
    assert neurosym("meet", folder, TASK, "--tries", 1) == 0
    said = past(folder)
    said["features"][0] += 0.01
    (folder / "pasts" / "item-01.json").write_text(json.dumps(said))
    capsys.readouterr()
    found = refusal(capsys, "meet", folder, TASK, "--tries", 2)
    assert "it is the past of another object" in found
    assert "--forget" in found
    assert neurosym("plan", folder, TASK) == 0


def test_what_was_tried_is_kept_longer_than_what_was_seen_in_runs(folder):
    assert neurosym("meet", folder, TASK, "--tries", 1) == 0
    item = load_scene(folder / "problems" / f"{TASK}.scene.json").objects[0]
    domain = DomainFolder(folder)
    known = load_past(domain, item)
    grown = known.grown(domain, [msgspec.structs.replace(known.trials[0], run="one")] * 70, "one")
    assert len(grown.trials) == 64
    assert grown.trials[0] == known.trials[0]
    assert known.grown(domain, [], "one").trials == known.trials


def test_a_past_under_another_name_can_be_forgotten_though_it_cannot_be_read(folder, capsys):
    assert neurosym("meet", folder, TASK, "--tries", 1) == 0
    (folder / "pasts" / "item-01.json").write_text(json.dumps({**past(folder), "name": "item-02"}))
    assert "it is the past of item-02" in refusal(capsys, "meet", folder, TASK)
    assert neurosym("meet", folder, TASK, "--forget", "--tries", 0) == 0
    assert "tries" in refusal(capsys, "meet", folder, TASK, "--tries", 65)


def test_a_lift_that_failed_twice_is_still_put_down_in_a_plan(folder):
    learned = Grounding.load(folder / "grounding.json")
    task = load_scene(folder / "problems" / f"{TASK}.scene.json")
    (item,) = task.objects
    lift = next(one for one in learned.operators_on(item.category) if is_lift(one))
    failed = Trial(lift.label, "resting", (0.0,) * 3, (0.0,) * 3, (0.0, 0.0, 0.0, 1.0))
    after = msgspec.structs.replace(task, objects=(msgspec.structs.replace(item, past=(failed,) * 2),))
    down, other = PlanStep(f"put-down-{lift.name}", item.name), PlanStep(lift.name, item.name)
    for problem in (task, after):
        assert hand_problem([other, down], problem, learned) == ""
        assert "is not held" in hand_problem([down], problem, learned)
    assert "still holds" in hand_problem([other, other], task, learned)
    assert hand_problem([other, other], after, learned) == ""


@pytest.mark.parametrize(
    ("content", "said"),
    [("{}", "name"), ('{"format": "neurosym-past-9"}', "format"), ("nonsense", "JSON"), ("[1]", "array")],
)
def test_a_damaged_past_is_told_of_in_one_sentence(folder, capsys, content, said):
    (folder / "pasts").mkdir()
    (folder / "pasts" / "item-01.json").write_text(content)
    assert said in refusal(capsys, "plan", folder, TASK)


def test_what_cannot_be_met_is_told_of_in_one_sentence(folder, capsys):
    assert "item-09" in refusal(capsys, "meet", folder, TASK, "--object", "item-09")
    assert "no-such" in refusal(capsys, "meet", folder, "no-such")
    scene = folder / "problems" / f"{TASK}.scene.json"
    document = json.loads(scene.read_text())
    document["objects"][0]["position"][0] += 0.4
    document["goals"] = {"item-01": document["goals"]["item-01"]}
    scene.write_text(json.dumps(document))
    assert "off the table" in refusal(capsys, "meet", folder, TASK)
    assert not (folder / "pasts").exists()
