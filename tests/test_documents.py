"""The documents: what they point to and name exists, and their films show runs that reached the goal."""

import re
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import neurosym as command
from documents import blocks, python_blocks
from places import DOCS, ROOT
from validators import quiet

import neurosym
from neurosym.execution.record import Run
from neurosym.files import read_json
from neurosym.report.run_film import step_named
from tools import draw_docs, prose
from tools.draw_films import FILMS
from tools.write_commands import page

DOCUMENTS = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
MEASURED = ROOT / "docs" / "results"
"""Written by the evaluations, each when it is run."""


@pytest.fixture(scope="module")
def sentences() -> dict[str, list[str]]:
    """What users read, sentence by sentence."""
    return prose.read_by_users(ROOT)


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.name)
def test_every_local_link_leads_somewhere_and_every_test_that_is_named_exists(path: Path):
    text = path.read_text()
    links = [link for link in re.findall(r"\]\(([^)#\s]+)", text) if "://" not in link]
    targets = [(path.parent / link).resolve() for link in links]
    assert not [target for target in targets if not target.exists() and target.parent != MEASURED]
    for name in re.findall(r"tests/(?:\w+/)*test_\w+\.py", text):
        assert (ROOT / name).is_file(), name
    sources = "".join(file.read_text() for file in (ROOT / "tests").rglob("test_*.py"))
    for name in re.findall(r"`(test_\w+)`", text):
        assert f"def {name}(" in sources, name


def test_every_file_that_the_map_names_exists():
    text = (DOCS / "architecture.md").read_text()
    rows = [line for line in text.splitlines() if line.startswith("| ") and line != "| what | look in |"]
    assert len(rows) >= 20
    for part in [*rows, *text.split("## I want to change")[0].splitlines()]:
        folder = ""
        for name in re.findall(r"`([\w/]+(?:/|\.py|\.urdf))`", part):
            known = [ROOT / "neurosym" / name, ROOT / name, ROOT / "neurosym" / folder / name]
            assert any(path.exists() for path in known), name
            folder = str(Path(name).parent) if "/" in name else folder


@pytest.mark.parametrize("draw", draw_docs.DRAWINGS, ids=lambda draw: draw.__name__)
def test_picture_is_what_the_shipped_domain_and_the_results_give(draw):
    """`make pictures` draws them anew."""
    drawn = [(DOCS / "images" / f"{draw.__name__}.svg").read_text(), draw()]
    if draw is draw_docs.symbols:  # where codes meet depends on the processor, by less than a pixel
        drawn = [re.sub(r' (d|c?[xy])="[^"]*"', "", one) for one in drawn]
    assert drawn[0] == drawn[1]


def test_scene_written_by_hand_is_taken_and_planned_for(tmp_path, monkeypatch):
    (text,) = blocks("manual.md", "json")
    (tmp_path / "mine.scene.json").write_text(text)
    monkeypatch.chdir(tmp_path)
    assert command("new-problem", "tabletop", "--scene", "mine.scene.json") == 0
    assert command("plan", "tabletop", "mine") == 0


def test_sentences_are_short(sentences):
    """`python -m tools.prose --longest 20` prints those that are not."""
    said_by_program = {"messages and help", "help of commands", "comments of domains", "page of a domain"}
    assert said_by_program < sentences.keys()
    every = [one for found in sentences.values() for one in found]
    for kind, found in {"all": every, **{kind: sentences[kind] for kind in said_by_program}}.items():
        middle, most = prose.measured(found)
        assert (middle <= prose.MEDIAN, most <= prose.MOST) == (True, True), (kind, middle, most)


def test_words_are_plain(sentences):
    wrong = [one for found in sentences.values() for one in found if prose.unplain(one)]
    assert wrong == []
    assert prose.unplain("We reckon with somebody's own data.") == ["estimate", "custom"]


def test_prose_has_none_of_the_faults_that_a_linter_knows(sentences, tmp_path):
    """Proselint, with `.proselintrc.json`; typography and dates of code and ranges are left out there."""
    for number, (name, found) in enumerate(sentences.items()):
        (tmp_path / f"{number:02d}.md").write_text(f"{name}\n\n" + "\n".join(found) + "\n")
    faulty = tmp_path / "faulty.md"
    faulty.write_text("It is very unique, and at this point in time in close proximity.\n")
    config = ["--config", str(ROOT / ".proselintrc.json")]
    command = [sys.executable, "-m", "proselint", *config, "--output-format", "compact", "check", tmp_path]
    said = subprocess.run(command, capture_output=True, text=True, check=False).stdout.splitlines()
    assert any("faulty.md" in line for line in said)
    assert [line for line in said if "faulty.md" not in line] == []


def test_commands_page_is_what_the_commands_say():
    """`python -m tools.write_commands` writes it anew."""
    assert (DOCS / "commands.md").read_text() == page()


def test_readme_is_short_and_its_python_reaches_the_goal(capsys):
    text = (ROOT / "README.md").read_text()
    assert len(text.split()) <= 500
    (block,) = re.findall(r"```python\n(.*?)```", text, flags=re.S)
    exec(compile(block, "README.md", "exec"), {})
    assert capsys.readouterr().out.strip().endswith("True")


def test_every_name_of_the_python_api_is_in_the_reference_and_documented():
    listed = set(re.findall(r"^\.\. auto\w+:: neurosym\.(\w+)$", (DOCS / "api.md").read_text(), flags=re.M))
    assert listed == {*neurosym.__all__} - {"__version__"}
    assert all((getattr(neurosym, name).__doc__ or "").strip() for name in listed)


def test_a_plan_of_unified_planning_comes_true(capsys):
    (block,) = python_blocks("other-plans.md")
    with quiet():
        exec(compile(block, "other-plans.md", "exec"), {})
    assert capsys.readouterr().out.strip().endswith("3 True")


SAID = {
    "tabletop": ["push right item-01", "lift item-02", "push forward right item-03"],
    "tabletop-paper": ["push forward right item-03", "lift item-05"],
    "camera": [
        *("carry item-01 to its goal", "carry item-03 to its goal", "carry item-02 to its goal"),
        *["push forward item-03"] * 4,
        "carry item-02 to its goal",
    ],
    "row": [f"carry item-0{number} to its goal" for number in (4, 3, 2, 1)],
    "boxes": ["item-03 rests on item-04", "item-05 rests on item-02", "item-06 rests on item-01"],
}


@pytest.mark.parametrize("name", FILMS)
def test_a_film_is_of_a_run_that_reached_its_goal_and_says_its_steps(name: str):
    domain, problem = FILMS[name]
    run = read_json(ROOT / "domains" / domain / "runs" / f"{problem}.fast-downward.run.json", Run)
    assert run.reached
    assert [step_named(record) for record in run.steps] == SAID[name]
    assert f"(images/{name}.gif)" in (ROOT / "docs" / "index.md").read_text()
