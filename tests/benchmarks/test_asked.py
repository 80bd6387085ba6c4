"""What people ask for: forms of goals are drawn and judged, and the page says what was found."""

import json

import pytest
from places import ROOT

from neurosym.stages.folder import DomainFolder
from neurosym.tasks.conditions import unmet_conditions
from tools.benchmarks.asked import evaluate
from tools.benchmarks.asked.tasks import DRAWN, FORMS, fallen, headed, said, turned
from tools.benchmarks.domains import bench_of

FOUND = {
    "turned-1-object-0": [{"status": "solved", "blind": {"reached": False}, "replanned": {"reached": True}}],
    "form-next-to-0": [
        {"status": "cannot be", "reason": "There is no room."},
        {"status": "solved", "blind": {"reached": True}, "replanned": {"reached": True}},
    ],
    "three-into-three-0": [
        {"status": "solved", "reached": True, "blind": False, "chance": 0.4},
        {"status": "solved", "reached": True, "blind": True, "chance": 0.7},
    ],
    "set-upright-0": [{"status": "solved", "blind": {"reached": False}, "replanned": {"reached": True}}],
}


def test_found_is_summed_up_and_told():
    told = evaluate.summarise(FOUND)
    assert told["turned"] == {"1": 1.0, "4": None}
    assert (told["goal_forms"], told["boxes"]) == (1, {"blind": 0.5, "replanned": 1.0})
    assert told["upright"] == {"blind": 0.0, "replanned": 1.0}
    assert told["chances"] == [{"plans": 2, "said": 0.55, "came": 0.5}]
    page = evaluate.page(told)
    assert "| 2 | 55 % | 50 % (9 to 91) |" in page
    assert "| form: next to | 1 | 1 |" in page
    assert "*form: next to*: There is no room. (1)" in page
    assert "| set upright | 1 | 1 |" in page


def test_the_page_is_that_of_the_figures():
    results = ROOT / "docs" / "results"
    told = json.loads((results / "asked.json").read_text())
    assert evaluate.page(told) == (results / "asked.md").read_text()
    assert {*told["kinds"]} == {*DRAWN, *evaluate.RELATED}


@pytest.fixture(scope="module")
def towers():
    folder = DomainFolder(ROOT / "domains" / "towers")
    return bench_of(folder.path), folder


@pytest.mark.parametrize("form", FORMS)
def test_every_form_is_asked_for_in_a_drawn_scene(form, towers):
    drawn = said(form, *towers, 960_001)
    assert drawn.goals or drawn.relations
    assert len(drawn.conditions) == 1
    assert [*unmet_conditions(drawn, towers[0].setting.grounding)] in ([], [*drawn.conditions])


def test_what_lies_on_a_side_shall_stand():
    folder = DomainFolder(ROOT / "domains" / "places")
    bench = bench_of(folder.path)
    for is_brought in (False, True):
        drawn = fallen(is_brought, bench, folder, 960_001)
        assert drawn.upright == ("item-01",)
        assert ("item-01" in drawn.goals) == is_brought


def test_things_lie_turned_and_are_to_be_turned(towers):
    drawn = [turned(4, *towers, seed) for seed in range(960_000, 960_004)]
    lie = [abs(item.orientation[2]) > 1e-3 for one in drawn for item in one.objects]
    assert len(lie) / 2 < sum(lie) < len(lie)  # the others have no room
    assert [*headed(*towers, 960_003).headings] == ["item-01"]
