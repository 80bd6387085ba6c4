"""The problems that planners are timed with are what they are said to be."""

from collections import Counter

from places import ROOT

from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.problem_making import sight_of_pairs
from tools.benchmarks.relations.bench import HEIGHT, SMALL, TOWERS, TWENTY, towers


def test_twenty_small_objects_shall_stand_in_towers_that_share_none():
    folder = DomainFolder(ROOT / "domains" / "towers")
    paths = sorted((folder / "problems").glob("*.scene.json"))
    kinds = [item for path in paths for item in Problem.load(path).objects if max(item.features[:2]) <= SMALL]
    sight = sight_of_pairs(folder)
    assert sight is not None
    problem = towers(kinds, Grounding.load(folder / "grounding.json"), sight, "rests-on-011", 1)
    assert len(problem.objects) == TWENTY
    assert problem.tolerance == TOLERANCE
    uppers, lowers = ([goal[side] for goal in problem.related] for side in (0, 1))
    assert len(problem.related) == TOWERS * (HEIGHT - 1)
    assert max(Counter(uppers).values()) == max(Counter(lowers).values()) == 1
    assert len({*uppers} - {*lowers}) == TOWERS
