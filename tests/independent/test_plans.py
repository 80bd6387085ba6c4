"""Plans of all planners for random tables, judged by what shares no line with them; see `campaign`.

The long campaign gives 200 tables of up to 16 objects, and 200 whose objects have steps of their own, to
every planner that is installed, in every encoding: `python -m pytest -m evaluation -s tests/independent`. It
prints its figures; about two hours (estimated).
"""

import os
from collections.abc import Callable, Iterator

import pytest
from independent.campaign import Figures, run
from independent.random_sizes import draw_sizes
from independent.random_tables import Drawn, draw

LONG = range(200)
OURS = ("bfs-operators", "counting")
LIMIT = 2.0
"""What a planner has for a table [s]."""


def drawn_of(numbers: range) -> Iterator[Drawn]:
    """Tables whose objects have steps of their own."""
    return filter(None, map(draw_sizes, numbers))


def _is_small(drawn: Drawn) -> bool:
    return len(drawn.problem.objects) <= 3 and drawn.grounding.cell >= 0.01


def _quick(planner: str, encoding: str | None, drawn: Drawn) -> bool:
    """Choose our own searches, and Fast Downward; on PDDL only where reading it takes no time."""
    if planner in OURS or (planner == "fast-downward" and encoding == "sas"):
        return len(drawn.problem.objects) <= 6
    return planner == "fast-downward" and _is_small(drawn) and drawn.number % 4 == 0


@pytest.mark.parametrize(
    ("tables", "least"),
    [
        (lambda: map(draw, range(18)), {"counting": 5, "brute force": 5}),
        (lambda: drawn_of(range(9)), {"counting": 3}),
    ],
    ids=["of the table", "of their own"],
)
def test_plans_and_denials_of_our_planners_and_fast_downward_hold(
    tables: Callable[[], Iterator[Drawn]], least: dict[str, int]
):
    figures = run(tables(), time_limit=LIMIT, chosen=_quick, most_states=30_000)
    assert not figures.findings, "\n".join(figures.findings)
    assert figures.counts["fast-downward sas"]["plans"] > 3
    for who, count in least.items():
        assert figures.counts[who]["plans"] >= count, who


@pytest.mark.evaluation
@pytest.mark.parametrize("tables", [lambda numbers: map(draw, numbers), drawn_of])
def test_plans_and_denials_of_every_planner_hold(tables: Callable[[range], Iterator[Drawn]]):
    """`TABLES=0:50` in the environment takes the first 50 of 200."""
    first, last = map(int, os.environ.get("TABLES", f"{LONG.start}:{LONG.stop}").split(":"))
    figures = Figures()
    for number, drawn in enumerate(tables(range(first, last)), start=first):
        run([drawn], time_limit=LIMIT, figures=figures)
        print(f"\nafter table {number}:", *figures.lines(), sep="\n", flush=True)
    assert not figures.findings
