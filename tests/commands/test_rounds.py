"""One budget, spent in rounds: there is a domain after each, and interruptions change nothing."""

import os
import shutil
import signal
from dataclasses import replace

import msgspec
import numpy as np
import pytest
from command_line import neurosym, refusal
from toy_learning import BRIEF, SMALL

from neurosym import files
from neurosym.files import read_json
from neurosym.learning.training_config import REGIMES
from neurosym.primitives.ledger import Ledger
from neurosym.stages import layout, rounds
from neurosym.stages.folder import DomainFolder
from neurosym.stages.learning import TO_PLACES
from neurosym.worlds.processes import parent

RUN = [
    "--world",
    "toy",
    "--regime",
    "quick",
    "--seed",
    "3",
    "--workers",
    "1",
    "--problems",
    "0",
    "--strategy",
    "random",
]
RUN += ["--object-bits", "1", "--action-bits", "2"]  # eight operators
FOR_OBJECTS = ["--places", 0]
OF_OBJECTS = layout.INTERACTIONS, layout.PRIMITIVES, layout.LEDGER
FILES = (*OF_OBJECTS, layout.DOMAIN, layout.BUDGET)
OF_PLACES = [TO_PLACES.file(name) for name in (layout.DIRECT_MODEL, layout.MODEL, layout.TRAINING)]
trained = rounds._trained


@pytest.fixture(autouse=True, scope="module")
def small():
    """Let rounds begin small, and training take a moment."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(rounds, "_FIRST", 30)
        patch.setattr(rounds, "_HELD", 72)
        patch.setitem(REGIMES, "quick", brief())
        patch.setattr(rounds, "_trained", trained_briefly)
        yield


def brief():
    """The quick regime with a training that takes a moment."""
    naming = replace(BRIEF.naming, steps=100)  # so that there are actions with most codes
    return replace(REGIMES["quick"], model=SMALL, training=replace(BRIEF, naming=naming))


def trained_briefly(*given):
    """Train in another process, in which nothing is patched, in a moment, too."""
    parent().send("halfway")
    REGIMES["quick"] = brief()
    return trained(*given)


def killed(*_):
    """Be killed in the midst of training."""
    os.kill(os.getpid(), signal.SIGKILL)


@pytest.fixture(scope="module")
def alone(small, tmp_path_factory):
    """What is learned of objects alone, in two rounds."""
    folder = tmp_path_factory.mktemp("alone") / "whole"
    assert spend(folder, 350, *FOR_OBJECTS) == 0
    return folder


def spend(folder, count, *options):
    return neurosym("run", folder, "--interactions", count, *RUN, *options)


def interrupted_in_call(number):
    """Perform as a ledger does, but be interrupted once."""
    inner, calls = Ledger.perform, []

    def perform(*given, **options):
        calls.append(1)
        if len(calls) == number:
            raise KeyboardInterrupt
        return inner(*given, **options)

    return perform


def contents(folder):
    return {name: (folder / name).read_bytes() for name in FILES}


def test_rounds_end_with_a_domain_each_and_never_exceed_the_budget(alone, tmp_path, capsys):
    assert spend(tmp_path / "whole", 584) == 0
    said = capsys.readouterr().out
    budget = read_json(tmp_path / "whole" / layout.BUDGET, rounds.Budget)
    assert len(budget.rounds) == 2  # 300, 584
    assert 500 <= budget.total <= 584
    for number, (count, most) in enumerate(((1, 300), (2, 584)), 1):
        done = rounds.Budget(budget.rounds[:count])
        assert done.total <= most
        assert f"round {number} of 2: {done.total} interactions so far" in said
    assert said.count("compile-domain: done") == 2
    assert f"{budget.total} interactions: " in said
    for name in OF_OBJECTS:  # with places or without, since their share is the same
        assert (tmp_path / "whole" / name).read_bytes() == (alone / name).read_bytes()


def test_interrupted_and_continued_runs_end_with_the_same_bytes(alone, tmp_path, monkeypatch):
    folder = tmp_path / "broken"
    monkeypatch.setattr(Ledger, "perform", interrupted_in_call(5))
    assert spend(folder, 180, *FOR_OBJECTS) != 0
    assert read_json(folder / layout.BUDGET, rounds.Budget) == rounds.Budget()
    assert spend(folder, 180, *FOR_OBJECTS) == 0
    assert len(read_json(folder / layout.BUDGET, rounds.Budget).rounds) == 1
    assert spend(folder, 350, *FOR_OBJECTS) == 0  # more later
    assert contents(folder) == contents(alone)
    before = {path: path.stat().st_mtime_ns for path in folder.rglob("*")}
    assert spend(folder, 350, *FOR_OBJECTS) == 0
    assert {path: path.stat().st_mtime_ns for path in folder.rglob("*")} == before


def test_networks_that_are_trained_at_a_time_are_the_same_whatever_happens_meanwhile(
    tmp_path, monkeypatch, capsys
):
    assert spend(tmp_path / "one", 500) == 0
    folder = tmp_path / "two"
    monkeypatch.setattr(rounds, "_SOON", -1.0)
    with monkeypatch.context() as patch:
        patch.setattr(rounds, "_trained", killed)
        assert spend(folder, 500, "--workers", 2) != 0
    assert "A worker process died" in capsys.readouterr().err
    with monkeypatch.context() as patch:
        patch.setattr(Ledger, "perform", interrupted_in_call(2))
        assert spend(folder, 500, "--workers", 2) != 0
    assert spend(folder, 500, "--workers", 2) == 0
    assert "halfway" in capsys.readouterr().err.splitlines()
    for name in (*FILES, *OF_PLACES):
        assert (folder / name).read_bytes() == (tmp_path / "one" / name).read_bytes()


@pytest.mark.parametrize("aims", [[("",)] * 3, [("", "places")] * 3, [("",), ("", "places"), ("", "places")]])
def test_going_on_never_exceeds_the_larger_budget_nor_takes_back_what_was_spent(aims, monkeypatch):
    monkeypatch.setattr(rounds, "_FIRST", 400)
    rng = np.random.default_rng(7)
    for _ in range(300):
        last, ceilings = {}, np.sort(rng.integers(1000, 30_000, size=3)).tolist()
        for ceiling, names in zip(ceilings, aims, strict=True):
            for more in rounds._left_of(rounds.rounds(ceiling, names, {"": 4}, {}), last):
                assert all(share.explored for share in more.values())
                for name, share in last.items():
                    assert share.explored <= more[name].explored
                    assert share.budget <= more[name].budget
                last = {**last, **more}
                assert sum(map(sum, last.values())) <= ceiling


def test_relations_that_are_asked_for_later_get_what_is_left_and_nothing_less():
    spent = {"": rounds.Share(1024, 4976), "places": rounds.Share(1024, 2976)}
    aims = (*spent, "relations")
    (left,) = rounds._left_of(rounds.rounds(15_000, aims, {"": 4}, {}), spent)
    assert sum(left["relations"]) == 5000
    assert {name: left[name] for name in spent} == spent
    (left,) = rounds._left_of(rounds.rounds(16_000, aims, {"": 4}, {}), spent)  # 400 more are no reason
    assert {name: left[name] for name in spent} == spent
    assert rounds._left_of(rounds.rounds(10_000, aims, {"": 4}, {}), spent) == []


def test_symbols_are_learned_anew_only_if_enough_is_left_to_measure_them(tmp_path, monkeypatch):
    asked = []
    recipe = rounds.Recipe("random", "quick", "own", 100, 3, 1, {})
    monkeypatch.setattr(rounds, "perform", lambda *_: None)
    monkeypatch.setattr(rounds, "ledger_of", lambda *_: range(100))
    monkeypatch.setattr(rounds, "train_stage", lambda *_, held, **__: asked.append(held))
    for explored, budget, symbols in ((60, 150, 50), (60, 250, 50), (200, 250, 72)):
        before = rounds.Spent(50, 100, 100, symbols)
        recipe.learn(DomainFolder(tmp_path), {"": rounds.Share(explored, budget)}, {"": before})
    assert [held.bits for held in asked] == [True, False, True]


def test_others_plan_while_a_round_works_and_nobody_else_learns(tmp_path, monkeypatch, capsys):
    folder, inner, calls = tmp_path / "grown", rounds.train_stage, []

    def interrupting(*given, **options):
        if (folder / layout.GROUNDING).exists():  # in the second round
            assert neurosym("new-problem", folder, "--name", f"meanwhile-{len(calls)}") == 0
            assert neurosym("plan", folder, f"meanwhile-{len(calls)}") in (0, 1)
            capsys.readouterr()  # what takes long says how far it has come
            assert f"works in {folder}" in refusal(capsys, "train", folder)
            assert f"works in {folder / layout.GROWING}" in refusal(capsys, *spending)
            calls.append(read_json(folder / layout.BUDGET, rounds.Budget))
        return inner(*given, **options)

    spending = "run", folder, "--interactions", 350, *RUN, *FOR_OBJECTS
    monkeypatch.setattr(rounds, "train_stage", interrupting)
    monkeypatch.setattr(files, "_TRIES", 1)
    assert neurosym(*spending) == 0
    assert [len(budget.rounds) for budget in calls] == [1]
    assert not (folder / layout.GROWING).exists()
    stages = DomainFolder(folder).manifest().stages
    assert {"plan meanwhile-0 fast-downward", "train", "compile-domain"} <= stages.keys()


def test_files_that_were_changed_meanwhile_are_not_overwritten(tmp_path, monkeypatch, capsys):
    def changing(*given, **options):
        (tmp_path / "grown" / layout.INTERACTIONS).write_text("mine")
        return {"": rounds.Spent(0, 0, 0)}

    monkeypatch.setattr(rounds.Recipe, "learn", changing)
    said = refusal(capsys, "run", tmp_path / "grown", "--interactions", 350, *RUN, *FOR_OBJECTS)
    assert "were changed while it grew" in said
    assert (tmp_path / "grown" / layout.INTERACTIONS).read_text() == "mine"


def test_it_stops_where_nothing_more_is_worth_performing(tmp_path, monkeypatch, capsys):
    spent = rounds.Spent(explored=60, performed=10, budget=90)
    assert rounds.Budget(({"": spent},)).is_idle
    assert not rounds.Budget(({"": msgspec.structs.replace(spent, performed=85)},)).is_idle
    monkeypatch.setattr(rounds, "_IDLE", 1.1)
    assert spend(tmp_path / "done", 400, "--places", 0) == 0
    assert "found too little that was worth performing" in capsys.readouterr().out
    assert len(read_json(tmp_path / "done" / layout.BUDGET, rounds.Budget).rounds) == 1


def test_what_cannot_be_spent_is_refused_and_so_is_a_damaged_record(tmp_path, capsys):
    said = refusal(capsys, "run", tmp_path / "new", "--interactions", 50, *RUN, *FOR_OBJECTS)
    assert "--interactions 50 are too few for 8 operators, which are to be seen 5 times each" in said
    said = refusal(capsys, "run", tmp_path / "new", "--interactions", 100, *RUN)
    assert "--interactions 100 are too few for 16 operators of places" in said  # and not first for objects
    said = refusal(capsys, "run", tmp_path / "new", "--interactions", 500, "--steps", 200, *RUN)
    assert "give one" in said
    said = refusal(capsys, "run", tmp_path / "new", "--interactions", 150, "--relations", 60, *RUN)
    assert "too few" in said
    said = refusal(capsys, "run", tmp_path / "new", "--relations", 60, *RUN, *FOR_OBJECTS)
    assert "give --places a number" in said
    assert not (tmp_path / "new").exists()
    assert neurosym("init", tmp_path / "new", "--world", "toy") == 0
    (tmp_path / "new" / layout.BUDGET).write_text('{"rounds": [{"": {"explored": -1}}]}')
    said = refusal(capsys, "run", tmp_path / "new", "--interactions", 500, *RUN)
    assert f"{layout.BUDGET} cannot be used" in said


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--object-bits", 2], "was trained with object_bits = 1, not 2; use that again, or another folder"),
        (["--regime", "default"], "was trained with regime = 'quick', not 'default'"),
        (["--seed", 4], "was explored with seed = 3, not 4; use that again, or another folder"),
    ],
)
def test_what_was_learned_otherwise_is_not_gone_on_with(alone, capsys, options, told):
    before = contents(alone)
    assert told in refusal(capsys, "run", alone, "--interactions", 5000, *RUN, *FOR_OBJECTS, *options)
    assert contents(alone) == before
    assert "give --interactions in place of --steps" in refusal(capsys, "run", alone, "--steps", 500, *RUN)


@pytest.mark.parametrize(
    ("rounds_told", "told"),
    [
        ([{}], "Expected `object` of length >= 1 - at `$.rounds[0]`; remove it to begin with a first round"),
        ([{"foo": rounds.Spent(60, 90, 90)}], "Expected `str` matching regex"),
        ([{"": rounds.Spent(61_000, 90, 90)}], "it tells of 61000 interactions, and "),
        ([{"": rounds.Spent(60, 91_000, 90)}], "it tells of 91000 interactions, and "),
    ],
)
def test_an_account_that_is_not_true_is_refused(alone, tmp_path, capsys, rounds_told, told):
    folder = tmp_path / "damaged"
    shutil.copytree(alone, folder)
    (folder / layout.BUDGET).write_bytes(msgspec.json.encode({"rounds": rounds_told}))
    said = refusal(capsys, "run", folder, "--interactions", 5000, *RUN, *FOR_OBJECTS)
    assert f"{folder / layout.BUDGET} cannot be used: {told}" in said


def test_a_round_that_is_not_done_is_gone_on_with_for_its_own_budget(alone, tmp_path, capsys, monkeypatch):
    folder = tmp_path / "broken"
    monkeypatch.setattr(Ledger, "perform", interrupted_in_call(2))
    assert spend(folder, 350, *FOR_OBJECTS) != 0
    capsys.readouterr()
    said = refusal(capsys, "run", folder, "--interactions", 100, *RUN, *FOR_OBJECTS)
    assert f"ask for that budget again, or remove {folder / layout.GROWING}" in said
    assert spend(folder, 350, *FOR_OBJECTS) == 0
    assert contents(folder) == contents(alone)


def test_exploring_at_once_needs_no_budget_for_its_bits(tmp_path, capsys):
    many = ["--object-bits", 6, "--action-bits", 8]
    said = refusal(capsys, "run", tmp_path / "many", "--world", "nowhere", "--steps", 200, *many)
    assert "too few" not in said


def test_a_folder_that_was_explored_at_once_goes_on_as_it_was(tmp_path, capsys):
    assert neurosym("run", tmp_path / "old", "--steps", 128, *RUN) == 0
    capsys.readouterr()
    assert neurosym("run", tmp_path / "old", *RUN) == 0
    assert ": done" not in capsys.readouterr().out
    assert not (tmp_path / "old" / layout.BUDGET).exists()
