"""Plans of all planners for random tables, judged by what shares no line with them; see `campaign`.

The long campaign gives 200 tables of up to 16 objects to every planner that is installed, in every encoding:
`python -m pytest -m evaluation -s tests/independent`. It prints its figures; about an hour (estimated).
"""

import os

import pytest
from independent.campaign import Figures, run
from independent.random_tables import Drawn, draw

from neurosym.planners import bfs

OURS = ("bfs-operators", "counting")
LIMIT = 2.0
"""What a planner has for a table [s]."""


def _is_small(drawn: Drawn) -> bool:
    return len(drawn.problem.objects) <= 3 and drawn.grounding.cell >= 0.01


def _quick(planner: str, encoding: str | None, drawn: Drawn) -> bool:
    """Choose our own searches, and Fast Downward; on PDDL only where reading it takes no time."""
    if planner in OURS or (planner == "fast-downward" and encoding == "sas"):
        return len(drawn.problem.objects) <= 6
    return planner == "fast-downward" and _is_small(drawn) and drawn.number % 4 == 0


@pytest.mark.parametrize(("numbers", "chunk"), [(range(12), bfs.CHUNK), (range(12, 18), 5)])
def test_plans_and_denials_of_our_planners_and_fast_downward_hold(numbers: range, chunk: int, monkeypatch):
    monkeypatch.setattr(bfs, "CHUNK", chunk)
    figures = run(map(draw, numbers), time_limit=LIMIT, chosen=_quick, most_states=30_000)
    assert not figures.findings, "\n".join(figures.findings)
    for who in ("fast-downward sas", "counting", "brute force"):
        assert figures.counts[who]["plans"] >= len(numbers) // 4, who


@pytest.mark.evaluation
def test_plans_and_denials_of_every_planner_hold():
    """`TABLES=0:50` in the environment takes the first 50 of 200."""
    first, last = map(int, os.environ.get("TABLES", "0:200").split(":"))
    figures = Figures()
    for number in range(first, last):
        run([draw(number)], time_limit=LIMIT, figures=figures)
        print(f"\nafter table {number}:", *figures.lines(), sep="\n", flush=True)
    assert not figures.findings
