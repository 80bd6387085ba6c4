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
from neurosym.stages.pipeline import practise_stage
from neurosym.stages.practice import LESSONS, choose_lessons
from neurosym.stages.rounds import Lesson, Round

FILES = ("practice.json", "grounding.json", "domain.pddl")


def practised(folder, *options, interactions=150):
    return neurosym("practise", folder, "--interactions", interactions, "--seed", 1, *options)


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


def test_practice_in_parts_and_by_any_number_of_workers_comes_to_the_same_bytes(folder, tmp_path):
    parted = shutil.copytree(folder, tmp_path / "parted")
    assert practised(folder, "--workers", 2) == 0
    assert practised(parted, "--workers", 1, interactions=1) == 0
    first = practice_of(DomainFolder(parted))
    assert practised(parted, "--workers", 1) == 0
    assert (
        first.practised.rounds
        == practice_of(DomainFolder(parted)).practised.rounds[: len(first.practised.rounds)]
    )
    for name in FILES:
        assert (folder / name).read_bytes() == (parted / name).read_bytes(), name


def test_the_domain_is_compiled_from_what_was_practised_until_it_is_distilled_anew(folder, capsys):
    before = (folder / "grounding.json").read_bytes()
    assert practised(folder) == 0
    domain = DomainFolder(folder)
    assert (folder / "grounding.json").read_bytes() != before
    rows = [len(one.rehearsals) for one in operator_table(domain).operators]
    assert max(rows) > max(
        len(one.rehearsals) for one in OperatorTable.load(folder / "primitives.json").operators
    )
    assert neurosym("explain", folder) == 0
    assert "compiled from another" not in capsys.readouterr().out
    (folder / "primitives.json").write_bytes((folder / "primitives.json").read_bytes() + b"\n")
    assert practice_of(domain) is None
    assert operator_table(domain) == OperatorTable.load(folder / "primitives.json")


def test_even_practice_tries_no_tasks(folder):
    domain = DomainFolder(folder)
    domain.perform(practise_stage(domain, interactions=300, seed=1, workers=1, evenly=True), again=True)
    found = practice_of(domain)
    assert found.evenly
    assert all(one.planned == one.interactions == 0 and one.lessons for one in found.practised.rounds)


def test_another_seed_or_way_does_not_throw_practice_away(folder, capsys):
    assert practised(folder, interactions=1) == 0
    before = (folder / "practice.json").read_bytes()
    capsys.readouterr()  # what is said of how far it came
    said = refusal(capsys, "practise", folder, "--interactions", 300, "--seed", 2)
    assert "was practised with seed = 1; go on so, or remove it" in said
    domain = DomainFolder(folder)
    with pytest.raises(InvalidValue, match="was practised with seed = 1; go on so, or remove it"):
        domain.perform(practise_stage(domain, interactions=300, seed=1, workers=1, evenly=True), again=True)
    assert (folder / "practice.json").read_bytes() == before


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--interactions", 0], "interactions = 0 must be at least 1"),
        (["--workers", 0], "workers"),
        (["--seed", -1], "seed = -1 must be at least 0"),
    ],
)
def test_numbers_that_cannot_be_are_refused(folder, capsys, options, told):
    assert told in refusal(capsys, "practise", folder, *options)


def test_a_table_without_rehearsals_is_refused(folder, capsys):
    table = json.loads((folder / "primitives.json").read_text())
    for operator in table["operators"]:
        del operator["rehearsals"]
    (folder / "primitives.json").write_text(json.dumps(table))
    assert "its rehearsals are not kept" in refusal(capsys, "practise", folder)


def test_a_problem_that_cannot_be_used_is_refused_before_practice(folder, capsys):
    (folder / "problems/odd.scene.json").write_text("{}")
    assert "odd.scene.json cannot be used" in refusal(capsys, "practise", folder)
    assert not (folder / "practice.json").exists()


def test_a_journal_of_another_version_is_refused(folder, capsys):
    assert practised(folder, interactions=1) == 0
    capsys.readouterr()
    journal = folder / "practice.json"
    journal.write_text(journal.read_text().replace("neurosym-practice-1", "neurosym-practice-9"))
    assert "neurosym-practice-9" in refusal(capsys, "practise", folder)
