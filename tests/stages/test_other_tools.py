"""What a domain folder holds for other planners: of durative actions, and without costs."""

from pathlib import Path

import pytest
import toy_places
from command_line import neurosym, refusal

from neurosym.files import write_json
from neurosym.formats import PlaceFile
from neurosym.grounding import Grounding
from neurosym.pddl import problem_text
from neurosym.pddl.durative import durative_domain_text, durative_problem_text
from neurosym.planners import PlanStatus
from neurosym.planners.external import plan_fast_downward
from neurosym.problems import Problem
from neurosym.stages.compilation import compile_stage
from neurosym.stages.folder import DomainFolder

CELL = ("--cell", "0.02")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """What distilling would have left of the toy world with places, and two problems by hand."""
    place = tmp_path / "domain"
    (place / "places").mkdir(parents=True)
    (place / "problems").mkdir()
    (place / "world.toml").write_text('world = "toy"\n')
    learned = toy_places.grounding()
    write_json(place / "primitives.json", learned.objects)
    write_json(place / "places/operators.json", PlaceFile.holding(learned.places))
    for problem in (toy_places.swap(), toy_places.mixed()):
        problem.save(place / f"problems/{problem.name}.scene.json")
    return place


def names(folder: Path, pattern: str) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob(pattern)}


def test_durative_domain_is_written_if_asked_for_and_kept_up_to_date(folder, capsys, tmp_path):
    assert neurosym("compile-domain", folder, *CELL) == 0
    assert names(folder, "*durative*") == set()
    assert neurosym("compile-domain", folder, *CELL, "--durative") == 0
    said = capsys.readouterr().out
    assert f"{folder}/domain-durative.pddl takes 1 of 2 problems" in said
    assert "does so at first: mixed" in said
    learned = Grounding.load(folder / "grounding.json")
    texts = {
        "domain-durative.pddl": durative_domain_text(learned),
        "problems/swap.durative.pddl": durative_problem_text(toy_places.swap(), learned),
    }
    for _ in range(2):
        assert {name: (folder / name).read_text() for name in names(folder, "*durative*")} == texts
        for file in texts:
            (folder / file).write_text("stale")
        assert neurosym("compile-domain", folder, *CELL) == 0
    scene, file = tmp_path / "mine.json", folder / "problems/mine.durative.pddl"
    for problem, is_written in ((toy_places.swap(), True), (toy_places.mixed(), False)):
        problem.save(scene)
        assert neurosym("new-problem", folder, "--scene", scene, "--name", "mine") == 0
        assert file.exists() == is_written
    domain = DomainFolder(folder)
    assert domain.problem_names() == ("mine", "mixed", "swap")
    (folder / "domain-durative.pddl").unlink()  # what other tools read makes no stage out of date
    assert not domain.perform(compile_stage(domain, cell=0.02), again=False)


def test_durative_domain_of_what_is_only_pushed_is_refused_and_nothing_is_written(folder, capsys):
    (folder / "places/operators.json").unlink()
    said = refusal(capsys, "compile-domain", folder, *CELL, "--durative")
    assert "Nothing in the domain toy carries objects to places" in said
    assert names(folder, "*.pddl") == set()


def test_page_without_costs_is_written_if_asked_for_kept_up_to_date_and_planned_on(folder, tmp_path):
    assert neurosym("compile-domain", folder, *CELL) == 0
    assert names(folder, "*plain*") == set()
    assert neurosym("compile-domain", folder, *CELL, "--plain") == 0
    domain, mixed, swap = "domain-plain.pddl", "problems/mixed.plain.pddl", "problems/swap.plain.pddl"
    assert names(folder, "*plain*") == {domain, mixed, swap}
    assert DomainFolder(folder).problem_names() == ("mixed", "swap")
    texts = {file: (folder / file).read_text() for file in (domain, mixed, swap)}
    for word in (":action-costs", ":functions", "increase", "total-cost", ":metric"):
        assert not any(word in text for text in texts.values())
        assert any(word in (folder / file).read_text() for file in ("domain.pddl", "problems/swap.pddl"))
    for name in ("mixed", "swap"):
        found = plan_fast_downward(folder / domain, folder / f"problems/{name}.plain.pddl", time_limit=60.0)
        assert found.status is PlanStatus.SOLVED, found.reason
        (tmp_path / f"{name}.plan").write_text(found.text)
        assert neurosym("validate", folder, name, tmp_path / f"{name}.plan") == 0
    for file in texts:
        (folder / file).write_text("stale")
    assert neurosym("compile-domain", folder, *CELL) == 0
    assert {file: (folder / file).read_text() for file in texts} == texts
    scene = tmp_path / "mine.json"
    toy_places.swap().save(scene)
    assert neurosym("new-problem", folder, "--scene", scene) == 0
    mine = Problem.load(folder / "problems/mine.scene.json")
    learned = Grounding.load(folder / "grounding.json")
    assert (folder / "problems/mine.plain.pddl").read_text() == problem_text(mine, learned, costs=False)
