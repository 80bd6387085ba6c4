"""`neurosym report` writes one page that holds what a folder holds, and nothing that a browser would load."""

import re
import shutil
from collections import Counter
from html import escape
from html.parser import HTMLParser

import msgspec
import numpy as np
import pytest
import toy_relations
from command_line import contents, neurosym, refusal
from places import ROOT
from toy_relations import PUT_IN, PUT_ON

from neurosym.data.interactions import Interactions
from neurosym.evaluation.summary import Comparison, Tally
from neurosym.execution.record import Run
from neurosym.files import read_json, write_json
from neurosym.grounding import Grounding
from neurosym.learning.training_report import TrainingReport
from neurosym.pictures.motions import surest_carriers
from neurosym.problems import Problem
from neurosym.report.charts import Axis, chart, explored, round_values, what_became
from neurosym.report.html_page import gather, render, summaries
from neurosym.report.overview import promises_of, share_kept
from neurosym.report.run_film import film_of_run, step_named
from neurosym.stages.folder import DomainFolder
from neurosym.stages.plan_records import PlanRecord
from neurosym.stages.rounds import Budget, Spent
from neurosym.world import Palette

VOID = {"meta", "link", "img", "input"}
EVIL = "</pre><script>alert(1)</script><img src=x onerror=alert(1)>"


class Checked(HTMLParser):
    """Checks that tags are closed in order, and collects what a browser would act upon."""

    def __init__(self):
        super().__init__()
        self.open, self.images, self.references, self.tags = [], [], [], set()

    def handle_starttag(self, tag, attributes):  # noqa: D102
        named = dict(attributes)
        self.tags.add(tag)
        self.references += [named[name] for name in ("src", "href", "srcset", "data") if name in named]
        assert not [name for name in named if name.startswith("on")]
        if tag == "img":
            self.images.append(named)
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):  # noqa: D102
        assert self.open.pop() == tag


def checked(text: str) -> Checked:
    parser = Checked()
    parser.feed(text)
    parser.close()
    assert parser.open == []
    return parser


@pytest.fixture(scope="module")
def reported(toy_folder, tmp_path_factory):
    """The toy domain folder's page, made once."""
    folder = shutil.copytree(toy_folder, tmp_path_factory.mktemp("reported") / "toy")
    assert neurosym("report", folder) == 0
    return folder


def test_page_parses_and_loads_nothing(reported):
    text = (reported / "report.html").read_text()
    html_page = checked(text)
    assert html_page.references
    assert all(reference.startswith(("data:", "#")) for reference in html_page.references)
    assert not re.search(r"https?:|url\(|@import|<script", text)
    targets = set(re.findall(r'href="#([^"]+)"', text))
    assert targets <= set(re.findall(r'id="([^"]+)"', text))
    assert "script" not in html_page.tags
    assert all(image["alt"] and int(image["width"]) > 0 for image in html_page.images)


def test_page_shows_every_symbol_operator_and_plan(reported):
    text = (reported / "report.html").read_text()
    grounding = Grounding.load(reported / "grounding.json")
    for primitive in grounding.objects.primitives:
        assert f'id="action-{primitive.symbol}"' in text
    for category in grounding.objects.categories:
        assert f'id="object-{category.symbol}"' in text
    for operator in grounding.objects.operators:
        assert f'<th scope="row">{operator.name}</th><td class="number">{operator.trials}</td>' in text
    for reason in grounding.left_out.values():
        assert f"no: {escape(reason)}" in text
    for path in (reported / "plans").glob("*.json"):
        assert f'<th scope="row">{read_json(path, PlanRecord).problem}</th>' in text
    assert any("goal transparent" in image["alt"] for image in checked(text).images)
    for operator in surest_carriers(grounding):
        assert f"{operator.name}: carried" in text


def test_page_opens_with_map_kinds_matrix_and_promises(reported):
    """Each setting has its map and the rule that shows it; each arrow leads to its action."""
    text = (reported / "report.html").read_text()
    opening = text[: text.index('id="plans"')]
    radios = re.findall(r'<input type="radio" name="(tab-\d)" id="tab-\d-\d"( checked)?>', opening)
    groups = {name: sum(one == name for one, _ in radios) for name, _ in radios}
    assert groups
    assert sum(bool(checked) for _, checked in radios) == len(groups)
    maps = re.findall(r'<div class="drawn([^"]*)"><svg class="map"', opening)
    assert len(maps) == len({*maps}) == np.prod([*groups.values()])
    for one in maps:
        values = re.findall(r"v(\d)-(\d)", one)
        shown = "".join(f":has(#tab-{tab}-{value}:checked)" for tab, value in values)
        assert f".maps{shown} .drawn{one.replace(' ', '.')} {{ display: block; }}" in opening
    grounding = Grounding.load(reported / "grounding.json")
    for category in grounding.objects.categories:
        assert bool(category.share) == (f'">{category.symbol}</span><span class="word">' in opening)
    for symbol in grounding.objects.symbols:
        assert f'<a class="bits" href="#action-{symbol}">' in opening
    assert 'class="promises"' in opening


def test_films_move_what_the_run_moved_and_nothing_else():
    domain, name = ROOT / "domains/towers", "tower-6-08"
    problem = Problem.load(domain / f"problems/{name}.scene.json")
    run = read_json(domain / f"runs/{name}.fast-downward.run.json", Run)
    table = Grounding.load(domain / "grounding.json").table
    film = film_of_run(problem, run, Palette(), table, "film")
    moved = {int(number) for number in re.findall(r"@keyframes film-(\d+)\{", film["styles"])}
    start = {item.name: item.position for item in problem.objects}
    apart = {
        item: np.linalg.norm(np.subtract(at, start[item])) for item, at in run.steps[-1].positions.items()
    }
    assert {problem.object_names[one] for one in moved} == {item for item, far in apart.items() if far > 0.01}
    for number, record in enumerate(run.steps, 1):
        assert f">{number}. {step_named(record)}</text>" in film["svg"]


def test_promises_are_ranked_with_those_on_pairs_and_without_what_is_left_out():
    grounding = toy_relations.grounding()
    found = promises_of(grounding.objects, grounding)
    told = {bar["name"]: (bar["kept"], bar["trials"]) for bar in found["bars"]}
    assert (told[PUT_ON], told[PUT_IN]) == ((19, 20), (20, 20))
    assert "miss-01-tray-10" not in told
    assert found["worst"]["name"] == [*told][-1] == PUT_ON
    assert promises_of(msgspec.structs.replace(grounding.objects, operators=()), None) is None


def test_share_of_what_can_be_foreseen_is_within_its_bar():
    def percent(through: float, direct: float) -> int:
        report = TrainingReport(9, through, (), through, (), direct, (), None, {}, {}, {})
        return share_kept(report)["percent"]

    assert [percent(0.3, 0.4), percent(-1.0, 0.4), percent(0.5, 0.4)] == [75, 0, 100]


def test_pictures_are_made_once_and_are_the_same_whatever_the_number_of_workers(reported, tmp_path):
    """The usual number, that of the machine's cores, made those of the fixture."""
    before, pictures = (reported / "report.html").read_bytes(), reported / "pictures/report"
    made = {path: path.stat().st_mtime_ns for path in pictures.iterdir()}
    assert neurosym("report", reported) == 0
    assert (reported / "report.html").read_bytes() == before
    assert {path: path.stat().st_mtime_ns for path in pictures.iterdir()} == made
    one = shutil.copytree(reported, tmp_path / "one")
    shutil.rmtree(one / "pictures")
    assert neurosym("report", one, "--workers", "1") == 0
    assert contents(one / "pictures/report") == contents(pictures)


def test_hostile_texts_are_shown_and_not_obeyed(reported, tmp_path):
    folder = shutil.copytree(reported, tmp_path / "<i>toy")
    (folder / "domain.pddl").write_text(f"; {EVIL}\n")
    data = Interactions.load(folder / "interactions.npz")
    data.origin["strategy"] = EVIL
    data.save(folder / "interactions.npz")
    path = next((folder / "plans").glob("*.json"))
    record = read_json(path, PlanRecord)
    write_json(path, PlanRecord(record.problem, EVIL, "failed", (), 0.0, EVIL))
    place = folder / "comparison/1-objects-50-mm"
    place.mkdir(parents=True)
    tally = Tally(7, 6, 5, 4, 1.5, 0.25, 3, 2, {}, {}, {}, {}, 9, 8)
    write_json(place / "comparison.json", Comparison(10, 1, 2, {EVIL: tally}))
    text = render(gather(DomainFolder(folder), lambda *_: None))
    html_page = checked(text)
    assert "script" not in html_page.tags
    assert "i" not in html_page.tags
    assert all(image["src"].startswith("data:image/webp;base64,") for image in html_page.images)
    assert text.count(escape(EVIL)) >= 5
    figures = (7, 6, 5, 4, "8 of 9", "1.50", "0.250")
    assert "".join(f'<td class="number">{figure}</td>' for figure in figures) in text


def test_what_is_missing_is_said_with_its_command(tmp_path, capsys):
    folder = tmp_path / "new"
    assert neurosym("init", folder, "--world", "toy") == 0
    assert neurosym("report", folder) == 0
    text = (folder / "report.html").read_text()
    checked(text)
    for command in ("explore", "train", "distill", "compile-domain", "new-problem"):
        assert f"<code>neurosym {command} {folder}" in text


def test_page_of_another_ending_or_in_no_folder_is_refused(folder, capsys):
    for name in ("page.md", "nowhere/page.html"):
        said = refusal(capsys, "report", folder, "--output", folder / name)
        assert "name a file that ends in .html" in said
    assert not (folder / "report.html").exists()


def test_damaged_records_and_scenes_are_named_once_and_left_out(folder, capsys):
    (folder / "plans/task-02.fast-downward.json").write_text("{}")
    run = folder / "runs/task-02.mine.run.json"
    run.write_text('{"problem": null}')
    scene = folder / "problems/task-01.scene.json"
    scene.write_text(scene.read_text().replace('"tolerance": 0.05', '"tolerance": -1'))
    assert neurosym("report", folder) == 0
    notes = [line for line in capsys.readouterr().out.splitlines() if line.startswith("note: ")]
    assert len(notes) == 3
    for path in (folder / "plans/task-02.fast-downward.json", run, scene):
        assert sum(f"note: {path} cannot be used" in note for note in notes) == 1
    html_page = (folder / "report.html").read_text()
    assert '<th scope="row">task-01</th>' not in html_page


def test_every_interaction_is_counted_once(toy_folder):
    data = Interactions.load(toy_folder / "interactions.npz")
    kinds = what_became(data)
    np.testing.assert_array_equal(sum(rows.astype(int) for rows in kinds.values()), 1)
    np.testing.assert_array_equal(kinds["ended in the hand"], data.held)
    shares = dict(explored(data)["shares"])
    assert shares["ended in the hand"] == pytest.approx(float(data.held.mean()))
    assert sum(shares.values()) == pytest.approx(1.0)
    for rows in (1, 2, 300):
        assert len(explored(data[:rows])["charts"]) == 4


def test_all_interactions_of_a_budget_are_told(reported, tmp_path):
    folder = shutil.copytree(reported, tmp_path / "told")
    write_json(folder / "budget.json", Budget(({"": Spent(800, 200, 200), "places": Spent(500, 34, 100)},)))
    assert neurosym("report", folder) == 0
    assert "In all, 1,534 interactions were performed" in (folder / "report.html").read_text()
    assert "interactions were performed" not in (reported / "report.html").read_text()


def test_effects_are_drawn_by_outcome_without_colours_and_by_symbol_in_its_colour(toy_folder):
    data = Interactions.load(toy_folder / "interactions.npz")
    palette = Palette(["11", "10"])
    codes = ["11" if wide else "10" for wide in data.features[:, 1] > np.median(data.features[:, 1])]
    *by_outcome, above, beside = explored(data, codes, palette)["charts"]
    assert len(by_outcome) == 4
    assert {series["paint"] for chart in by_outcome for series in chart["series"]} == {""}
    signs = [series["sign"] for series in by_outcome[1]["series"]]
    assert len({*signs[:-1]}) == len(signs) - 1
    for drawn in (above, beside):
        assert {one["name"]: one["paint"] for one in drawn["series"]} == {c: palette.hex(c) for c in codes}
    acts = ["0" if held else "1" for held in data.held]
    panels = explored(data, codes, palette, acts)["by_action"]["panels"]
    assert {one["code"]: one["count"] for one in panels} == Counter(acts)
    dots = [sum(one["path"].count("M") for one in chart["series"]) for chart in (by_outcome[1], above)]
    assert dots[0] == dots[1]


def test_dots_stand_where_their_points_are():
    groups = {"none": np.zeros((0, 2)), "c": np.array([[0.0, 0.0], [10.0, 1.0], [11.0, 0.5]])}
    drawn = chart("dots", "t", "a", (Axis("x", 0.0, 10.0), Axis("y", 0.0, 1.0)), groups)
    (series,) = drawn["series"]
    assert (series["name"], series["colour"]) == ("c", 1)
    left, right, top, bottom = (drawn[side] for side in ("left", "right", "top", "bottom"))
    assert series["path"] == f"M{left:.1f} {bottom:.1f}h0M{right:.1f} {top:.1f}h0"
    assert [tick["label"] for tick in drawn["x_ticks"]] == ["0", "2", "4", "6", "8", "10"]
    assert round_values(-0.07, 0.31) == (0.0, 0.1, 0.2, 0.3)


def test_plans_and_reached_goals_are_counted_by_planner():
    rows = [
        {"planner": planner, "steps": steps, "reached": reached, "own": own}
        for planner, steps, reached, own in (
            ("bfs", 2, True, (1, 1)),
            ("bfs", 3, False, (1, 1)),
            ("bfs", 1, True, (1, 4)),  # with a new plan
            ("bfs", None, None, None),
            ("kairos", None, None, None),
        )
    ]
    assert summaries(rows) == [
        {"planner": "bfs", "problems": 4, "found": 3, "runs": 3, "reached": 2, "alone": 1},
        {"planner": "kairos", "problems": 1, "found": 0, "runs": 0, "reached": 0, "alone": 0},
    ]
