"""The short round of fuzzing, the same cases in every run (`make fuzz` is the long one), and what it sees."""

import inspect
import shutil
from collections.abc import Iterator
from pathlib import Path
from random import Random

import pytest
import toy_relations
from command_line import neurosym
from fuzz.cases import MORE, Case, Edit, as_json, drawn_case, from_json, read_seeds
from fuzz.lines import ENDING, asks_for_much, command_line
from fuzz.mutations import KINDS, MUTATIONS, mutated
from fuzz.running import Ending, Runner, judge, runner
from places import ROOT

from neurosym.stages import layout

ROUND = (*range(14), *range(15, 24))
"""The cases of the short round, by the numbers that they are drawn from; 14 only distils, for seconds."""
RELATED = ("plan", "execute", "replay", "new-problem", "show", "explain", "report")
"""Commands that read what is known of relations."""
TRACEBACK = """Traceback (most recent call last):
  File "/somewhere/neurosym/commands/cli.py", line 68, in main
    code = read_arguments(words)()
  File "/somewhere/neurosym/files.py", line 52, in read_json
    return msgspec.json.decode(path.read_bytes(), type=kind)
  File "/usr/lib/python3.11/pathlib.py", line 1051, in read_bytes
    return f.read()
MemoryError
"""


@pytest.fixture(scope="module")
def seed(toy_folder, tmp_path_factory) -> Path:
    """A domain folder with a file of every format that is read."""
    folder = Path(shutil.copytree(toy_folder, tmp_path_factory.mktemp("fuzz") / "toy"))
    for line in MORE:
        assert neurosym(*(word.format(folder) for word in line.split())) == 0
    (folder / layout.UPRIGHT).mkdir()
    shutil.copy(ROOT / "domains" / "places" / layout.UPRIGHT_OPERATORS, folder / layout.UPRIGHT_OPERATORS)
    return folder


@pytest.fixture(scope="module")
def run(seed) -> Iterator[Runner]:
    """Who performs cases, in one process for all."""
    with runner(seed) as found:
        yield found


@pytest.fixture(scope="module")
def related(tmp_path_factory) -> Path:
    """A domain folder with relations that a person wrote, a problem, a plan, and its run."""
    folder = tmp_path_factory.mktemp("fuzz") / "related"
    folder.mkdir()
    (folder / "world.toml").write_text('world = "toy-relations"\n')
    toy_relations.grounding().save(folder / "grounding.json")
    toy_relations.sorting().save(folder.parent / "sorting.json")
    assert neurosym("new-problem", folder, "--scene", folder.parent / "sorting.json") == 0
    assert neurosym("plan", folder, "sorting") == 0
    assert neurosym("execute", folder, "sorting", folder / "plans/sorting.fast-downward.plan") == 0
    return folder


@pytest.mark.parametrize(
    ("folder", "names", "numbers"), [("seed", ENDING, ROUND), ("related", RELATED, ROUND[:10])]
)
def test_short_round_finds_nothing(folder, names, numbers, run, request):
    run.seed = request.getfixturevalue(folder)
    seeds, commands = read_seeds(run.seed), {name: ENDING[name] for name in names}
    for number in numbers:
        case = drawn_case(Random(number), commands, seeds)
        found = judge(case, run.run(case))
        assert not found, (number, as_json(case)[:500], found)


def test_what_is_left_behind_on_purpose_is_found(run, seed):
    run.seed, case = seed, Case(("plan", "toy", "task-01", "--planner", "own:littering"))
    kinds = {finding.key.partition(":")[0] for finding in judge(case, run.run(case))}
    assert kinds == {"a process left", "a file left"}


def test_every_file_that_a_command_reads_is_there_and_is_changed_the_same_again(seed):
    names = {value for name, value in vars(layout).items() if name.isupper() and isinstance(value, str)}
    read = {name for name in names if Path(name).suffix in MUTATIONS and not name.startswith(".")}
    seeds = read_seeds(seed)
    # No command reads the domains that are printed for other planners alone.
    # What is learned of relations is read as what is learned of places is; the folder holds none of it.
    # The folder was explored at once; tests/commands/test_rounds.py damages what rounds keep.
    # Its world has no camera; tests/perception/test_eye.py and tests/stages/test_seeing.py damage its files.
    without = {layout.EYE, layout.SEEN, layout.SEEN_LEDGER, layout.PLAIN_DOMAIN, layout.DURATIVE_DOMAIN} | {
        layout.STATES,
        layout.CHANCES,
        layout.BUDGET,
    }
    assert read - without - {name for name in read if "relation" in name} <= seeds.keys()
    for end in (
        layout.SCENE,
        layout.NUMERIC_PDDL,
        layout.RECORD,
        ".plan",
        "item-01.json",
        "interactions.partial.npz",
    ):
        assert any(path.endswith(end) for path in seeds), end
    for path, content in seeds.items():
        drawn = [mutated(Random(n), path, seeds) for n in range(9)]
        assert drawn == [mutated(Random(n), path, seeds) for n in range(9)]
        assert sum(other != content for other in drawn) > 2, path


@pytest.mark.parametrize("name", ENDING)
def test_every_option_of_a_command_is_drawn(name):
    drawn = {word for n in range(200) for word in command_line(Random(n), name, ENDING[name])}
    parameters = inspect.signature(ENDING[name]).parameters.values()
    options = {p.name for p in parameters if p.default is not p.empty}
    assert {f"--{option.replace('_', '-')}" for option in options} <= drawn


@pytest.mark.parametrize("kind", KINDS)
def test_something_else_can_stand_in_the_place_of_a_file(kind, tmp_path):
    (tmp_path / "world.toml").write_text("")
    Case(("check",), edits=(Edit("world.toml", kind),)).prepare(tmp_path)
    assert not (tmp_path / "world.toml").is_file() or kind == "sparse"


def test_case_can_be_written_down_and_what_asks_for_much_is_known():
    case = Case(("plan", "\udcff.plan", "\x1b"), "begun", (Edit("world.toml", "fifo"),))
    assert from_json(as_json(case)) == case
    assert asks_for_much(("explore", "toy", "--steps", "9223372036854775808"))
    assert not asks_for_much(("explore", "toy", "--steps", "64"))


@pytest.mark.parametrize(
    ("key", "changes"),
    [
        ("MemoryError in neurosym/files.py:read_json", {"code": 1, "errors": TRACEBACK}),
        ("exit code 139: ", {"code": 139}),
        ("exit code 2 without a word", {"code": 2}),
        ("a message with None: check", {"code": 2, "errors": "None: No space left on device\n"}),
        ("a control character: check", {"output": "\x1b[31mred"}),
        ("a warning of Python: a.py 9 RuntimeWarning", {"errors": "/neurosym/a.py:9: RuntimeWarning: x"}),
        ("a long line: check", {"errors": "x" * 4000}),
        ("much memory: check", {"memory": 3 * 1024**3}),
        ("a process left: sleep", {"left": ("sleep",)}),
        ("a file left: tmp/litter", {"files": ("tmp/litter",)}),
        ("no end: check", {"stage": 1}),
        ("deaf to Ctrl-C: check", {"stage": 2}),
    ],
)
def test_bad_ends_are_findings_and_good_ones_are_not(key, changes):
    assert [finding.key for finding in judge(Case(("check", "toy")), Ending(**changes))] == [key]
    for code in (0, 2, 3, 130):
        assert judge(Case(("plan", "toy")), Ending(code=code, errors="There is none.\n")) == []
