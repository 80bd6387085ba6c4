"""What bears what: the encoder tells it by typical states, and plain physics where it cannot be so."""

from places import ROOT

from neurosym.grounding import Grounding
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.supports import bearers_of

TOWERS = Grounding.load(ROOT / "domains" / "towers" / "grounding.json")
DEEP_BOX = SceneObject("item-01", "11", (0.156, 0.094, 0.076, 1.0), (0.6, 0.1, 0.038))
LOW_BOX = SceneObject("item-02", "01", (0.065, 0.062, 0.024, 1.0), (0.6, 0.1, 0.018))  # on the floor of that


def test_a_low_thing_in_a_deep_box_is_borne_by_the_box_and_not_the_other_way_round():
    """Its middle is lower than that of the box, so that it looks as if the box rested on it."""
    for objects in ((DEEP_BOX, LOW_BOX), (LOW_BOX, DEEP_BOX)):
        found = bearers_of(Problem("deep", objects, {}), TOWERS.relations)
        assert {name: one.by for name, one in found.items()} == {"item-02": "item-01"}
        assert found["item-02"].state.bears
