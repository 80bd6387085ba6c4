"""Rounds of practice spend interactions on what broke plans, and come to the same however they are cut."""

import json
import shutil
from collections import Counter

import pytest
from command_line import neurosym, refusal

from neurosym.errors import InvalidValue
from neurosym.operators import OperatorTable
from neurosym.stages.compilation import operator_table, practice_of
from neurosym.stages.folder import DomainFolder
from neurosym.stages.practice import LESSONS, choose_lessons, practise_stage
from neurosym.stages.rounds import Lesson, Round

FILES = ("practice.json", "grounding.json", "domain.pddl")


def practise(folder, *options, interactions=150):
    return neurosym("practise", folder, "--interactions", interactions, "--seed", 1, *options)


@pytest.fixture(scope="module")
def practised(toy_folder, tmp_path_factory):
    """A folder that was practised in by two workers; tests must not change it."""
    folder = shutil.copytree(toy_folder, tmp_path_factory.mktemp("practised") / "toy")
    assert practise(folder, "--workers", 2) == 0
    return folder


@pytest.fixture(scope="module")
def table(toy_folder):
    return OperatorTable.load(toy_folder / "primitives.json")


def test_what_broke_most_plans_is_practised_first_and_auditioned_the_second_time(table):
    names = [one.name for one in table.operators if one.name.startswith("push")]
    broke = Counter({names[0]: 1000, names[1]: 1})
    chosen = choose_lessons(table, (), Counter(), broke)
    assert [(one.name, how) for one, how in chosen] == [(names[0], "rehearsed"), (names[1], "rehearsed")]
    earlier = Round(8, 3, 20, dict(broke), (Lesson(names[0], "rehearsed", 30, 0.5, 0.6),))
    again = choose_lessons(table, (earlier,), Counter(), broke)
    assert (names[0], "auditioned") in [(one.name, how) for one, how in again]
    assert len(choose_lessons(table, (), Counter(names), Counter(names))) == LESSONS


def test_practice_in_parts_and_by_any_number_of_workers_comes_to_the_same_bytes(practised, folder):
    assert practise(folder, "--workers", 1, interactions=1) == 0
    first = practice_of(DomainFolder(folder)).practised.rounds
    assert practise(folder, "--workers", 1) == 0
    assert practice_of(DomainFolder(folder)).practised.rounds[: len(first)] == first
    for name in FILES:
        assert (folder / name).read_bytes() == (practised / name).read_bytes(), name


def test_the_domain_is_compiled_from_what_was_practised_until_it_is_distilled_anew(
    practised, toy_folder, tmp_path, capsys
):
    folder = shutil.copytree(practised, tmp_path / "toy")
    assert (folder / "grounding.json").read_bytes() != (toy_folder / "grounding.json").read_bytes()
    domain, distilled = DomainFolder(folder), OperatorTable.load(folder / "primitives.json")
    rehearsals = [
        max(len(one.rehearsals) for one in known.operators) for known in (distilled, operator_table(domain))
    ]
    assert rehearsals[0] < rehearsals[1]
    assert neurosym("explain", folder) == 0
    assert "compiled from another" not in capsys.readouterr().out
    (folder / "primitives.json").write_bytes((folder / "primitives.json").read_bytes() + b"\n")
    assert practice_of(domain) is None
    assert operator_table(domain) == distilled


def test_even_practice_tries_no_tasks(folder):
    domain = DomainFolder(folder)
    domain.perform(practise_stage(domain, interactions=300, seed=1, workers=1, evenly=True), again=True)
    found = practice_of(domain)
    assert found.evenly
    assert all(one.planned == one.interactions == 0 and one.lessons for one in found.practised.rounds)


def test_practice_of_another_seed_way_or_version_is_refused_and_kept(practised, tmp_path, capsys):
    folder = shutil.copytree(practised, tmp_path / "toy")
    journal = folder / "practice.json"
    before = journal.read_bytes()
    said = refusal(capsys, "practise", folder, "--interactions", 300, "--seed", 2)
    assert "was practised with seed = 1; go on so, or remove it" in said
    domain = DomainFolder(folder)
    with pytest.raises(InvalidValue, match="was practised with seed = 1; go on so, or remove it"):
        domain.perform(practise_stage(domain, interactions=300, seed=1, workers=1, evenly=True), again=True)
    assert journal.read_bytes() == before
    journal.write_text(journal.read_text().replace("neurosym-practice-1", "neurosym-practice-9"))
    assert "neurosym-practice-9" in refusal(capsys, "practise", folder)


def test_what_cannot_be_practised_is_refused_before_practice(folder, capsys):
    (folder / "problems/odd.scene.json").write_text("{}")
    assert "odd.scene.json cannot be used" in refusal(capsys, "practise", folder)
    (folder / "problems/odd.scene.json").unlink()
    table = json.loads((folder / "primitives.json").read_text())
    for operator in table["operators"]:
        del operator["rehearsals"]
    (folder / "primitives.json").write_text(json.dumps(table))
    assert "its rehearsals are not kept" in refusal(capsys, "practise", folder)
    assert not (folder / "practice.json").exists()
