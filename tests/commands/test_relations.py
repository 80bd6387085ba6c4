"""Commands on a domain with relations; and records that are run again, of here, of elsewhere, of old."""

import json
from pathlib import Path

import msgspec
import pytest
import toy_domain
from command_line import neurosym, refusal
from toy_relations import LIE, PUT_ON, REST, grounding, relations, sorting, tower, tower_at_place

from neurosym.execution.record import this_machine
from neurosym.formats import PairFile, PlaceFile
from neurosym.pddl.compiler import problem_text
from neurosym.problems import Problem


@pytest.fixture
def bare(bare: Path) -> Path:
    """The same with a domain of relations."""
    (bare / "world.toml").write_text('world = "toy-relations"\n')
    grounding().save(bare / "grounding.json")
    return bare


def made(folder: Path, problem: Problem) -> str:
    file = folder.parent / f"{problem.name}.json"
    problem.save(file)
    assert neurosym("new-problem", folder, "--scene", file) == 0
    return problem.name


@pytest.mark.parametrize("problem", [tower(), tower_at_place(), sorting()], ids=lambda problem: problem.name)
def test_scene_by_hand_is_planned_executed_and_replayed(bare, problem, capsys):
    name = made(bare, problem)
    said = capsys.readouterr().out
    target, other, state = problem.relations[0]
    assert f"goal: {target} {state} {other}" in said
    stored = Problem.load(bare / f"problems/{name}.scene.json")
    assert (bare / f"problems/{name}.pddl").read_text() == problem_text(stored, grounding())
    assert not (bare / f"problems/{name}.numeric.pddl").exists()
    assert neurosym("plan", bare, name) == 0
    plan_file = bare / f"plans/{name}.fast-downward.plan"
    assert "likely to go as promised" in capsys.readouterr().out
    if name == "sorting":  # by what rests where
        record = json.loads(plan_file.with_suffix(".json").read_text())
        assert record["chance"] == pytest.approx((8 * 11 / (8 * 11 + 1)) ** 2, abs=1e-4)
        assert neurosym("show", bare, "--problem", name) == 0
        assert neurosym("show", bare, "--operator", PUT_ON) == 0
        assert f"wrote {bare / f'pictures/operator-{PUT_ON}.png'}" in capsys.readouterr().out
    assert neurosym("execute", bare, name, plan_file) == 0
    assert neurosym("replay", bare, f"{name}.fast-downward") == 0
    assert "the same happened again" in capsys.readouterr().out


def test_encoding_can_be_asked_for_and_what_cannot_say_relations_is_refused(bare, capsys):
    made(bare, tower())
    assert neurosym("plan", bare, "tower", "--encoding", "strips") == 0
    said = refusal(capsys, "plan", bare, "tower", "--encoding", "sas")
    assert "is one of relations, which the encoding sas cannot say; valid: strips" in said
    said = refusal(capsys, "plan", bare, "tower", "--planner", "counting")
    assert "is one of relations, which counting does not take; valid: " in said
    assert "leave this option out" in refusal(capsys, "plan", bare, "tower", "--nearest")


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"relations": (("item-01", "item-02", LIE),)}, "no operator brings item-01 to lies-in-010 with"),
        ({"pairs": {"item-01 item-09": "00"}}, "pairs has an entry for 'item-01 item-09'; valid: the"),
        ({"foreseen": {"item-01": {"op": 1}}}, "foreseen has an entry for 'item-01'"),
        ({"touching": (("item-01", "item-01"),)}, "touching has an entry for 'item-01 item-01'"),
    ],
)
def test_scenes_that_cannot_be_are_refused_in_one_sentence(bare, tmp_path, capsys, change, said):
    file = tmp_path / "bad.json"
    msgspec.structs.replace(tower(), name="bad", **change).save(file)
    assert said in refusal(capsys, "new-problem", bare, "--scene", file)


def test_relations_that_cannot_be_read_are_refused(bare, capsys):
    for words, said in (
        (("item-01 on",), 'cannot be read; write it as "item-01 STATE item-02"'),
        (("item-01 rests-on item-02", "--scene", "x.json"), "Give --scene, or --objects"),
        (("item-01 rests-on item-02", "--task", "swap"), "Give only one of --actions, --task, and goals by"),
    ):
        assert said in refusal(capsys, "new-problem", bare, "--relation", *words)


def test_compiled_page_holds_relations_and_files_of_earlier_versions_are_removed(bare):
    (bare / "relations").mkdir()
    (bare / "relations/operators.json").write_bytes(msgspec.json.encode(PairFile.holding(relations())))
    (bare / "primitives.json").write_bytes(msgspec.json.encode(grounding().objects))
    (bare / "places").mkdir()
    (bare / "places/operators.json").write_bytes(msgspec.json.encode(PlaceFile.holding(grounding().places)))
    made(bare, tower())
    former = ("domain-operators.pddl", "domain-places.planviz.json", "problems/tower.relational.pddl")
    for file in former:
        (bare / file).write_text("of an earlier version")
    assert neurosym("compile-domain", bare, "--cell", "0.02") == 0
    assert not any((bare / file).exists() for file in former)
    assert sorted(file.name for file in bare.glob("*.pddl")) == ["domain-numeric.pddl", "domain.pddl"]
    assert REST.removesuffix("-001") + "-item-02" in (bare / "problems/tower.pddl").read_text()
    assert "(:action put ;" in (bare / "domain.pddl").read_text()
    assert neurosym("plan", bare, "tower") == 0


def test_explanation_says_what_states_kinds_and_actions_mean(bare, capsys):
    (bare / "grounding.json").unlink()
    (bare / "relations").mkdir()
    (bare / "relations/operators.json").write_bytes(msgspec.json.encode(PairFile.holding(relations())))
    (bare / "primitives.json").write_bytes(msgspec.json.encode(toy_domain.grounding().objects))
    assert neurosym("explain", bare, "--all") == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "one object bears another in rests-on-001, lies-in-010. Of 3 operators on pairs, 2 are in" in said
    assert "Relating symbol 01: brings pairs to rests-on-001, lies-in-010" in said
    assert "carries to at the other object" in said
    assert "Pair state symbol 001: rests-on-001 Typical of it: away 0.00, above 1.00" in said
    assert "Pair symbol 11: hollow-11 20% of the pairs; on average target: s_x 0.065" in said
    assert f"- {PUT_ON} (20 trials, 19 as promised, in the domain)" in said


@pytest.fixture
def record(folder, capsys) -> Path:
    """A record of a run, made here."""
    made = next(folder.glob("runs/*.fast-downward.run.json"))
    problem = made.name.split(".")[0]
    plan = folder / f"plans/{problem}.fast-downward.plan"
    assert neurosym("execute", folder, problem, plan) in (0, 3)
    capsys.readouterr()
    return made


def change(record: Path, by: float, **machine) -> None:
    """Make of a record what another machine might have written."""
    run = json.loads(record.read_text())
    for step in run["steps"]:
        step["positions"] = {name: [x + by, y, z] for name, (x, y, z) in step["positions"].items()}
    run["machine"] = {**run["machine"], **machine} if run["machine"] else None
    record.write_text(json.dumps(run))


def test_record_names_its_machine_and_is_the_same_each_time(folder, record):
    written = record.read_bytes()
    run = json.loads(written)
    assert run["machine"]["processor"] == this_machine().processor
    assert run["machine"]["versions"] == this_machine().versions
    problem = record.name.split(".")[0]
    neurosym("execute", folder, problem, folder / f"plans/{problem}.fast-downward.plan")
    assert record.read_bytes() == written


def test_record_of_another_processor_is_the_same_within_a_micrometre(folder, record, capsys):
    change(record, 3e-9, processor="Other 9000")
    assert neurosym("replay", folder, record) == 0
    said = capsys.readouterr().out
    assert "within a micrometre; goal" in said
    assert "lengths differ by 3e-06 mm at most, first in positions of step 1" in said
    assert f"another machine than this: processor: Other 9000 and {this_machine().processor}" in said
    assert "byte for byte; goal" not in said
    change(record, 0.0, processor=this_machine().processor)
    assert neurosym("replay", folder, record) == 0
    assert "machine and versions are those of the record" in capsys.readouterr().out


def test_record_of_an_earlier_version_can_be_run_again(folder, record, capsys):
    run = json.loads(record.read_text())
    del run["machine"], run["tolerance"]
    record.write_text(json.dumps(run))
    assert neurosym("replay", folder, record) == 0
    assert "byte for byte" in capsys.readouterr().out
    run["machine"] = None
    record.write_text(json.dumps(run))
    change(record, 1e-3)
    assert neurosym("replay", folder, record) == 3
    said = capsys.readouterr().out
    for words in ("something else", "in positions of step 1, ", ", by 1 mm", "does not name its machine"):
        assert words in said
