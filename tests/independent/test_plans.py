"""Plans of all planners for random tables, judged by what shares no line with them; see `campaign`.

The long campaign gives 200 tables of up to 16 objects to every planner that is installed, in every encoding:
`python -m pytest -m evaluation -s tests/independent`. It prints its figures; about two hours (estimated).
"""

import os

import pytest
from independent.campaign import Figures, run
from independent.random_tables import Drawn, draw

SHORT, LONG = range(24), range(200)
OURS = ("bfs-operators", "counting")
LIMIT = 2.0
"""What a planner has for a table [s]."""
SLOW = ("up-fast-downward", "up-fast-downward-opt", "pyperplan", "aries")
"""They read PDDL in Python, or need long for it: they are given a few small tables, and more time."""
SLOW_LIMIT, FEW = 20.0, 8
"""What they have for a table [s], and of how many tables they are given one."""


def _is_small(drawn: Drawn) -> bool:
    return len(drawn.problem.objects) <= 3 and drawn.grounding.cell >= 0.01


def _quick(planner: str, encoding: str | None, drawn: Drawn) -> bool:
    """Choose our own searches, and Fast Downward; on PDDL only where reading it takes no time."""
    if planner in OURS or (planner == "fast-downward" and encoding == "sas"):
        return len(drawn.problem.objects) <= 8
    return planner == "fast-downward" and _is_small(drawn) and drawn.number % 3 == 0


def _all(planner: str, encoding: str | None, drawn: Drawn) -> bool:
    return planner not in SLOW


def _slow(planner: str, encoding: str | None, drawn: Drawn) -> bool:
    return planner in (*SLOW, "counting") and _is_small(drawn)


def test_plans_and_denials_of_our_planners_and_fast_downward_hold():
    figures = run(map(draw, SHORT), time_limit=LIMIT, chosen=_quick, most_states=50_000)
    assert not figures.findings, "\n".join(figures.findings)
    assert figures.counts["counting"]["plans"] > 5
    assert figures.counts["brute force"]["plans"] > 5
    assert figures.counts["fast-downward sas"]["answers in PDDL"] > 5


@pytest.mark.evaluation
def test_plans_and_denials_of_every_planner_hold():
    """`TABLES=0:50` in the environment takes the first 50 of 200."""
    first, last = map(int, os.environ.get("TABLES", f"{LONG.start}:{LONG.stop}").split(":"))
    figures = Figures()
    for number in range(first, last):
        run([draw(number)], time_limit=LIMIT, chosen=_all, figures=figures)
        if number % FEW == 0:
            run([draw(number)], time_limit=SLOW_LIMIT, chosen=_slow, figures=figures)
        print(f"\nafter table {number}:", *figures.lines(), sep="\n", flush=True)
    assert not figures.findings
