"""Whatever is typed, a command does it or refuses it in one sentence, and in time."""

import inspect
import shutil
from collections.abc import Iterator
from typing import get_args, get_type_hints

import pytest
from command_line import neurosym, refusal
from conftest import LEARN_TOY, RUN_TOY

from neurosym.commands.catalogue import SUMMARIES, command_named
from neurosym.commands.learn import distill, explore, train
from neurosym.commands.pipeline import run
from neurosym.commands.tasks import plan
from neurosym.data.origin import STRATEGIES
from neurosym.learning.training_config import REGIMES
from neurosym.pddl.syntax import ENCODINGS, SAS
from neurosym.primitives.audition import CHOICES

TWICE = ("--goal", "item-01=0.6,0.1", "--goal", "item-01=0.7,0.1")
PLAN = "{folder}/plans/task-01.fast-downward.plan"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["new-problem", "--goal", "item-01=5,0"], "out of reach; valid: x 0.4 to 1"),
        (["new-problem", "--goal", "item-01=left"], "cannot be read; write it as item-01=0.60,0.10"),
        (["new-problem", "--goal", "item-07=0.6,0"], "item-07, which is not in the scene"),
        (["new-problem", "--name", "Bad Name"], "'Bad Name' is not a legal name"),
        (["new-problem", "--objects", "0"], "objects = 0 must be at least 1"),
        (["new-problem", "--objects", "500"], "500 objects do not fit"),
        (["plan", "task-01", "--planner", "magic"], "no planner 'magic'; valid: bfs, bfs-operators"),
        (["plan", "task-01", "--encoding", "runes"], "no encoding 'runes'; valid: numeric, sas, strips"),
        (["plan", "task-99"], "no problem 'task-99'; valid: task-01, task-02"),
        (["explore", "--strategy", "luck"], "no strategy 'luck'; valid: active, curiosity, disagreement"),
        (["explore", "--regime", "big"], "no regime 'big'; valid: default, paper, quick"),
        (["train", "--object-bits", "7"], "object_bits = 7 must be between 1 and 6"),
        (["train", "--action-bits", "0"], "action_bits = 0 must be between 1 and 8"),
        (["run", "--world", "tabletop"], "of the world 'toy', not 'tabletop'"),
        (["explore", *LEARN_TOY, "--seed", "3", "--steps", "600"], "holds 1024 interactions already"),
        (["new-problem", *TWICE], "item-01=0.7,0.1; give each object one"),
        (["execute", "task-01", PLAN, "--replanner", "magic"], "no planner 'magic'"),
        (["execute", "task-01", PLAN, "--gif", "nowhere/x.gif"], "No picture can be written to nowhere"),
        (["execute", "task-01", PLAN, "--strip", "/proc/x.png"], "/proc/x.png cannot be written"),
        (["report", "--output", "/proc/x.html"], "/proc/x.html cannot be written"),
        (["replay", "task-01.full"], "no record of a run 'task-01.full'; valid: task-01."),
        (["explore", *LEARN_TOY, "--steps", "2048", "--seed", "4"], "seed = 3, not 4"),
        (["distill", "--choice", "luck"], "no choice 'luck'; valid: lowest-error, own, predictable"),
    ],
)
def test_impossible_request_is_refused_in_one_sentence(kept, arguments, message, capsys):
    command, *rest = (word.format(folder=kept) for word in arguments)
    assert message in refusal(capsys, command, kept, *rest)


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        (["plan", "d", "p", "--time-limit", "abc"], "plan: error parsing --time-limit: 'abc' is no number"),
        (["execute", "d", "p", "f", "--disturb", "x"], "error parsing --disturb: 'x' is no whole number"),
        (["plan", "d"], "neurosym plan: missing: PROBLEM; `neurosym plan --help` says what there is"),
        (["plan", "d", "p", "--bogus", "3"], "neurosym plan: unrecognized options: --bogus, 3;"),
        (["compile"], "There is no command 'compile'; the nearest is compile-domain, and"),
        (["plam", "d"], "There is no command 'plam'; the nearest is plan, and `neurosym --help` lists all."),
        (["plan", "d", "p", "--time-limi", "3"], "--time-limi, 3; the nearest is --time-limit; `neurosym"),
        (["--bogus"], "neurosym: unrecognized options: --bogus; `neurosym --help` says"),
        ([], "neurosym: expected one of {demo, run, plan, execute,"),
        (["new-problem", "d", "--goal", "item-01=0.6,0", "item-02=0,0"], "unrecognized options: item-02"),
    ],
)
def test_what_cannot_be_read_is_refused_in_one_sentence(typed, said, capsys):
    assert said in refusal(capsys, *typed)


@pytest.mark.parametrize(
    "wrong", [["--strategy", "luck"], ["--rehearsals", "0"], ["--workers", "257"], ["--problems", "-1"]]
)
def test_run_checks_what_was_typed_before_it_makes_a_folder(tmp_path, wrong, capsys):
    assert wrong[1] in refusal(capsys, "run", tmp_path / "new", *wrong)
    asked = ("init", tmp_path / "new", "--world", "moon")
    assert "no world 'moon'; valid: camera, tabletop, toy" in refusal(capsys, *asked)
    assert not (tmp_path / "new").exists()


@pytest.mark.parametrize(
    ("command", "option", "choices"),
    [
        (run, "strategy", {*STRATEGIES, "curiosity"}),
        (explore, "strategy", {*STRATEGIES, "curiosity"}),
        (train, "regime", {*REGIMES}),
        (distill, "choice", {*CHOICES}),
        (plan, "encoding", {*ENCODINGS, SAS}),
    ],
)
def test_help_lists_the_choices_that_there_are(command, option, choices, capsys):
    hint = get_type_hints(command)[option]
    kinds = (hint, *get_args(hint))
    assert {one for kind in kinds for one in get_args(kind) if isinstance(one, str)} == choices
    assert neurosym(command.__name__, "--help") == 0
    said = capsys.readouterr().out
    assert all(choice in said for choice in choices)


def test_problems_are_listed_where_none_is_named(capsys):
    said = refusal(capsys, "plan", "tabletop")
    assert "missing: PROBLEM; problems of tabletop: task-01, task-02, " in said
    assert "problems of" not in refusal(capsys, "plan", "no-such-folder")


FLOATS = ["nan", "-1", "1e308"]
WHOLE = ["1.5", "-1", f"{2**63 - 1}"]
WORDS = ["", "\x1b[31m", "/dev/full"]
PLACES = {
    "run": ["{folder}", *RUN_TOY],
    "explore": ["{folder}", *LEARN_TOY, "--seed", "3", "--steps", "1024"],
    "new-problem": ["{folder}", "--name", "drawn"],
    "plan": ["{folder}", "task-01"],
    "execute": ["{folder}", "task-01", "{folder}/empty.plan", "--replans", "0"],
    "replay": ["{folder}", "task-01.fast-downward"],
    "compare": ["{folder}", "--tasks", "1", "--workers", "1", "--planners", "bfs-operators"],
    "check": ["{folder}"],
    "planners": [],
}
"""What each command is given besides, if it is more than a domain folder."""
COSTLY = {
    *((command, "--seed", WHOLE[2]) for command in ("train", "distill")),
    *((command, "--places", WHOLE[2]) for command in ("explore", "run")),
    ("distill", "--interactions", WHOLE[2]),
}
"""Values as good as any: the command does its work, for as long as it is let."""


def options() -> Iterator[tuple[str, str, str]]:
    """Give each command, each of its options, and each value to try."""
    for name in SUMMARIES:
        command = command_named(name)
        hints = get_type_hints(command)
        for parameter in inspect.signature(command).parameters.values():
            kinds = {hints[parameter.name], *get_args(hints[parameter.name])}
            if parameter.default is inspect.Parameter.empty or bool in kinds:
                continue
            values = FLOATS if float in kinds else WHOLE if int in kinds else WORDS
            option = f"--{parameter.name.replace('_', '-')}"
            yield from ((name, option, value) for value in values if (name, option, value) not in COSTLY)


@pytest.mark.parametrize(("name", "option", "value"), list(options()), ids=lambda word: repr(word[:20]))
def test_any_value_of_any_option_ends_in_an_answer_or_a_sentence(
    used, name, option, value, capsys, monkeypatch, tmp_path
):
    monkeypatch.chdir(tmp_path)
    words = [word.format(folder=used) for word in PLACES.get(name, ["{folder}"])]
    if option in words:
        words[words.index(option) + 1] = value
    else:
        words += [option, value]
    code = neurosym(name, *words)
    captured = capsys.readouterr()
    assert code in (0, 2, 3)
    assert "Traceback" not in captured.err + captured.out
    if code == 2:
        assert 0 < len(captured.err) < 2500
        assert len(captured.err.strip().splitlines()) == 1
    assert "\x1b[31m" not in captured.err + captured.out
    assert value or code == 2


@pytest.mark.parametrize("value", ["x" * 5000, "\udcff", "a\0b", "9" * 4000])
def test_what_no_option_takes_is_refused_in_a_sentence(capsys, value):
    for option in ("--seed", "--time-limit", "--planner"):
        assert len(refusal(capsys, "plan", "folder", "task-01", option, value)) < 2500


@pytest.fixture(scope="module")
def used(toy_folder, tmp_path_factory):
    """A domain folder that all values are tried on."""
    folder = shutil.copytree(toy_folder, tmp_path_factory.mktemp("used") / "toy")
    (folder / "empty.plan").write_text("; nothing\n")
    return folder
