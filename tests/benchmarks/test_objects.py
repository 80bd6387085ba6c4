"""Objects that nothing was learned of: how they are drawn, and what is said of them."""

import json

import msgspec
import numpy as np
import pytest
from places import ROOT

from neurosym.problems import Trial
from neurosym.sim.shapes import UNSEEN
from neurosym.tasks.options import puts_for
from neurosym.tasks.pasts import LEAST_CHANCE
from tools.benchmarks.domains import bench_of
from tools.benchmarks.objects import evaluate
from tools.benchmarks.objects.summary import page, summarise
from tools.benchmarks.objects.tasks import LOOKALIKE, SHAPES, at_an_edge, object_of, to_a_point

GOAL = {"reached": True, "steps": 1, "ended": "goal", "away": 0.004}
LOST = {"reached": False, "steps": 3, "ended": "lost", "away": 0.12}
FOUND = {
    "carry-ball-0": [[LOST, GOAL, GOAL, GOAL], [LOST, LOST, GOAL, GOAL]],
    "stack-wedge-0": [[GOAL] * 4],
    "look-pushes-0": [[None, 0.03, 0.01, 0.01], [0.04, 0.2, 0.01, 0.001]],
    "pushed-0": [GOAL, LOST],
    "edge-2-low-0": [[0.9, True, False], [0.6, False, True]],
}


def test_found_is_summed_up_and_told():
    told = summarise(FOUND)
    assert told["lookalikes"] == {"features": 0.5, "effects": 1.0}
    assert told["unseen"]["0"] == {"carry": 0.0, "push": None, "stack": 1.0}
    assert told["unseen"]["1"]["carry"] == 0.5
    assert (told["pushed_20mm"], told["pushed"]["motions"], told["pushed"]["of_reached"]) == (0.5, 2.0, 1.0)
    assert told["away_mm"] == {"carry": [120, 62, 4, 4], "push": [None] * 4}
    assert told["edge_brier"] == pytest.approx((0.01 + 0.36) / 2)
    assert told["edge_base"] == 0.25
    said = page(told)
    assert "| ball | 0, 50, 100, 100 % | -, -, -, - % | -, -, -, - % |" in said
    assert "| d low | 2 | 0.75 | 0.5 | 0.185 | 0.25 |" in said
    assert "50% (9 to 91) of 2; 2.0 motions a task, 1.0 where it was reached." in said
    assert "| 1 | 62 mm | - |" in said
    assert "With 0 more pushes that stop on their way" in said


def test_the_page_is_that_of_the_figures():
    results = ROOT / "docs" / "results"
    assert page(json.loads((results / "objects.json").read_text())) == (results / "objects.md").read_text()


@pytest.mark.parametrize("kind", [*SHAPES, LOOKALIKE])
def test_what_is_hidden_is_drawn_and_the_features_say_nothing_of_it(kind):
    drawn = object_of(kind, np.random.default_rng(5))
    hidden = dict(zip(UNSEEN, drawn.unseen[0].tolist(), strict=True))
    if kind == LOOKALIKE:
        assert hidden["shape"] == 0
        assert hidden["mass"] > 0
        assert hidden["friction"] > 0
        assert (hidden["false_bottom"] > 0) != (hidden["heavy_end"] != 0)
    else:
        assert hidden == {**dict.fromkeys(UNSEEN, 0.0), "shape": SHAPES.index(kind) + 1}


def test_objects_at_an_edge_have_a_size_there():
    assert at_an_edge(2, False, 3).features[0, 2] <= 0.028
    assert at_an_edge(0, True, 3).features[0, 0] >= 0.165


def test_a_task_of_a_look_alike_knows_what_is_hidden_and_goes_far_enough():
    task = to_a_point(bench_of(ROOT / "domains" / "places"), LOOKALIKE, 4)
    (item,) = task.objects
    assert len(item.unseen) == len(UNSEEN)
    assert np.linalg.norm(np.subtract(task.goals[item.name], item.position)) >= 0.15
    assert task.scene().unseen.tolist() == [list(item.unseen)]


def test_what_was_carried_as_another_category_is_put_on_others_so(tmp_path):
    _, task, grounding = evaluate.drawn(tmp_path, "stack", "u-block", 905_002)
    plain, zeros = task.objects[0], (0.0, 0.0, 0.0)
    tried = Trial("to-001a", "carried", zeros, zeros, plain.orientation, crowded=False)

    def puts(item):
        asked = msgspec.structs.replace(task, objects=(item, *task.objects[1:]))
        return [
            put for put in puts_for(asked, grounding, *asked.object_names) if put.state.name == "rests-on-011"
        ]

    (usual,), (better,) = puts(plain), puts(msgspec.structs.replace(plain, past=(tried,)))
    assert not usual.shown
    assert better.shown
    assert usual.share < LEAST_CHANCE < better.share
    assert grounding.primitive_of(better.operator).label != grounding.primitive_of(usual.operator).label
