"""Every file that a command reads, damaged in every way: one sentence that names it, and no waiting."""

import io
import json
import os
import shutil
import struct
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest
from command_line import neurosym, refusal

from neurosym.errors import InvalidFile
from neurosym.files import DEEPEST, MOST_SETTINGS, digest, read_bytes, read_json, read_text, read_toml

READERS = {
    "world.toml": ["explain", "{}"],
    "manifest.json": ["explain", "{}"],
    "primitives.json": ["explain", "{}"],
    "grounding.json": ["explain", "{}"],
    "interactions.npz": ["check", "{}"],
    "effect_model.safetensors": ["new-problem", "{}", "--name", "another"],
    "training.json": ["report", "{}", "--workers", "1"],
    "problems/task-01.scene.json": ["plan", "{}", "task-01", "--planner", "bfs-operators"],
    "plans/task-01.fast-downward.plan": ["execute", "{}", "task-01", "{}/plans/task-01.fast-downward.plan"],
    "runs/task-01.fast-downward.run.json": ["replay", "{}", "{}/runs/task-01.fast-downward.run.json"],
}
"""What reads each kind of file; other networks and the state of an exploration are read as the model is."""


def text(content: str | bytes) -> Callable[[Path], None]:
    return lambda path: path.write_bytes(content if isinstance(content, bytes) else content.encode())


def huge(path: Path) -> None:
    with path.open("wb") as file:
        file.truncate(2**40)


DAMAGES: dict[str, Callable[[Path], object]] = {
    "a named pipe": os.mkfifo,
    "an endless device": lambda path: path.symlink_to("/dev/zero"),
    "a folder": Path.mkdir,
    "a link to nowhere": lambda path: path.symlink_to("nowhere"),
    "a file of the system": lambda path: path.symlink_to("/proc/self/mem"),
    "a terabyte": huge,
    "nothing": text(""),
    "no text": text(b"\xff\xfe\x00\xd8"),
    "brackets": text("[" * 20_000),
    "braces": text('{"a":' * 20_000),
    "parentheses": text("(" * 20_000),
    "a value of brackets": text("a = " + "[" * 20_000),
    "tables in tables": text("[" + "a." * 20_000 + "b]"),
    "a long number": text('world = "toy"\n[options]\ngap = ' + "9" * 5000),
    "a long number in JSON": text('{"stages": {"a": {"seconds": ' + "9" * 5000 + "}}}"),
    "escapes": text('\x1b[31m{"a\x1b[31m": "\\u001b[31m"}'),
    "a header without end": text(struct.pack("<Q", 2**63) + b"{" * 100),
    "a header of brackets": text(struct.pack("<Q", 20_000) + b"[" * 20_000),
    "an empty archive": lambda path: zipfile.ZipFile(path, "w").close(),
    "an array": lambda path: path.write_bytes(array_file(header("(3,)"), bytes(12))),
    "a pickle": text(b"\x80\x04K\x01."),
}


def put(path: Path, damage: str) -> None:
    """Put something in the place of a file."""
    if path.is_dir() and not path.is_symlink():
        path.rmdir()
    path.unlink(missing_ok=True)
    DAMAGES[damage](path)


@pytest.mark.parametrize("name", READERS)
def test_whatever_stands_in_the_place_of_a_file_is_refused_in_a_sentence(folder: Path, name: str, capsys):
    if name == "training.json":
        (folder / "primitives.json").unlink()  # so that nothing is rehearsed
    for damage in DAMAGES:
        put(folder / name, damage)
        code = neurosym(*(word.format(folder) for word in READERS[name]))
        captured = capsys.readouterr()
        assert "\x1b" not in captured.err + captured.out, damage
        if code == 2:
            assert Path(name).name in captured.err or "There is no record of a run" in captured.err, damage
            assert len(captured.err) < 1500, damage
        else:
            assert code in (0, 3)
            assert name in OPTIONAL or (name, damage) == EMPTY_PLAN, (damage, captured)


OPTIONAL = {"training.json", "manifest.json", "grounding.json", "world.toml"}
"""What the command of `READERS` does without, if there is no such file."""
EMPTY_PLAN = ("plans/task-01.fast-downward.plan", "nothing")


def array_file(header: bytes, body: bytes = b"") -> bytes:
    """An array of a file of numpy's, with any header."""
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + body


def header(shape: str, kind: str = "'<f4'") -> bytes:
    return f"{{'descr': {kind}, 'fortran_order': False, 'shape': {shape}, }}\n".encode()


@pytest.mark.parametrize(
    "content",
    [
        array_file(b"{'descr': ('<f4', 'shape': (3,"),
        array_file(b"(" * 9000),
        array_file(header("(1000000000000, 4)")),
        array_file(header("(-1, -4)")),
        array_file(header("(1000000000000,)", "'<U0'")),
        array_file(header("(4,)", "'|O'"), b"cos\nsystem\n(S'echo'\ntR."),
        array_file(header("(4, 4)", "'<f4'"), bytes(63)),
        b"\x93NUMPY\x02\x00" + struct.pack("<I", 2**31) + header("(1,)"),
        b"\x93NUMPY\x09\x00",
        b"",
    ],
)
def test_array_that_is_not_what_it_says_is_refused(tmp_path: Path, content: bytes, capsys):
    with zipfile.ZipFile(tmp_path / "interactions.npz", "w") as archive:
        archive.writestr("features.npy", content)
    assert neurosym("check", tmp_path) == 2
    assert "'features' is damaged, or holds Python objects" in capsys.readouterr().err


@pytest.mark.filterwarnings("ignore:Duplicate name")
def test_archives_of_strange_lists_or_of_more_than_can_be_are_refused_unread(tmp_path: Path, capsys):
    file = tmp_path / "interactions.npz"
    for names in (
        ["features.npy"] * 2,
        [f"{n}.npy" for n in range(1500)],
        ["/etc/passwd", "../x"],
        ["features.npy"],
    ):
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
            for name in names:
                archive.writestr(name, array_file(header("(10, 4)"), bytes(160)))
        if len(names) > 1:
            assert neurosym("check", tmp_path) == 2
            assert "interactions.npz cannot be used: it h" in capsys.readouterr().err
    raw = file.read_bytes()
    size = struct.pack("<I", zipfile.ZipFile(io.BytesIO(raw)).infolist()[0].file_size)
    file.write_bytes(raw.replace(size, struct.pack("<I", 2**32 - 2)))
    assert neurosym("check", tmp_path) == 2
    assert "unpacked, it takes 4095 MB; valid: at most 1024 MB" in capsys.readouterr().err


def test_network_of_any_size_takes_no_memory_before_it_is_refused(folder: Path, capsys):
    path = folder / "effect_model.safetensors"
    raw = path.read_bytes()
    length = int.from_bytes(raw[:8], "little")
    document = json.loads(raw[8 : 8 + length])
    given = json.loads(document["__metadata__"]["neurosym"])
    size = {"actions": 12, "effects": 3, "gripper_columns": []}
    for change in (
        {"dimensions": {"features": 10**9, **size}},
        {"dimensions": {"features": 10**30, **size}},
        {"config": {"hidden": 4096}},
        {"config": []},
        {"format": "another"},
    ):
        document["__metadata__"]["neurosym"] = json.dumps(given | change)
        changed = json.dumps(document).encode()
        path.write_bytes(struct.pack("<Q", len(changed)) + changed + raw[8 + length :])
        said = refusal(capsys, "new-problem", folder, "--name", "another")
        assert "effect_model.safetensors cannot be used" in said


def test_byte_order_mark_is_read_over(folder: Path, capsys):
    for name in ("world.toml", "grounding.json", "problems/task-01.scene.json"):
        (folder / name).write_bytes(b"\xef\xbb\xbf" + (folder / name).read_bytes())
    assert neurosym("plan", folder, "task-01", "--planner", "bfs-operators") in (0, 3)
    assert neurosym("explain", folder) == 0


def test_pipes_and_endless_files_are_neither_waited_for_nor_read(tmp_path: Path):
    """In a process of its own, whose memory and time can be limited."""
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "zero").symlink_to("/dev/zero")
    code = "import resource; resource.setrlimit(resource.RLIMIT_AS, (2**30, 2**30))\n"
    code += "from pathlib import Path; from neurosym import files as reading\nfor name in ('pipe', 'zero'):\n"
    code += "  for read in (reading.read_text, reading.read_toml, reading.digest):\n"
    code += "    try: read(Path(name))\n    except reading.InvalidFile as error: print(error)\n"
    ran = subprocess.run(
        [sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, timeout=60
    )
    assert (ran.stderr, len(ran.stdout.splitlines())) == ("", 6)


def test_bounds_lie_where_they_are_said_to(tmp_path: Path):
    path = tmp_path / "a"
    for depth, fits in ((DEEPEST, True), (DEEPEST + 1, False)):
        path.write_text("[" * depth + "]" * depth)
        if fits:
            read_json(path, list)
        else:
            with pytest.raises(InvalidFile, match="nested too deep; valid: at most 50"):
                read_json(path, list)
    path.write_text('["' + "[" * 1000 + '\\"["]')
    assert read_json(path, list) == ["[" * 1000 + '"[']
    path.write_bytes(b"#" * MOST_SETTINGS)
    assert read_toml(path) == {}
    path.write_bytes(b"#" * (MOST_SETTINGS + 1))
    with pytest.raises(InvalidFile, match="it has 1 MB; valid: at most 1 MB"):
        read_toml(path)
    path.write_bytes(b"12345")
    assert (read_bytes(path, 5), read_text(path, 5)) == (b"12345", "12345")
    with pytest.raises(InvalidFile, match="valid: at most"):
        read_bytes(path, 4)
    assert digest(path).startswith("5994471abb01112a")


def test_files_with_names_of_terminal_escapes_are_named_without_them(folder: Path, capsys):
    shutil.copy(folder / "world.toml", folder / "\x1b[31m.plan")
    assert neurosym("execute", folder, "task-01", folder / "\x1b[31m.plan") == 2
    said = capsys.readouterr().err
    assert "\x1b" not in said
    assert "\\x1b[31m.plan" in said


def test_numbers_that_are_none_are_named(tmp_path: Path):
    file = tmp_path / "a.json"
    for written, said in (('"NaN"', None), ("NaN", "NaN"), ("[1.0, -Infinity]", "Infinity")):
        file.write_text(f'{{"NaN": {written}}}')
        if said is None:
            assert read_json(file, dict) == {"NaN": "NaN"}
            continue
        with pytest.raises(InvalidFile, match=rf"it is not JSON: .*; {said} is no number there"):
            read_json(file, dict)


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="no file says that it holds nothing")
def test_a_file_that_says_it_holds_nothing_is_read_no_further_than_any_other():
    assert Path("/proc/self/status").stat().st_size == 0
    with pytest.raises(InvalidFile, match="valid: at most"):
        read_bytes(Path("/proc/self/status"), 4)
