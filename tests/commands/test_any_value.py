"""Whatever is given to an option, a command ends in an answer or in one sentence, and in time."""

import inspect
import shutil
from collections.abc import Iterator
from typing import get_args, get_type_hints

import pytest
from command_line import neurosym, refusal
from conftest import LEARN_TOY, RUN_TOY

from neurosym.commands.catalogue import SUMMARIES, command_named

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
