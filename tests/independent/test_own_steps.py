"""Plans for objects with steps of their own, judged by what the printed problem says of them."""

import math
from collections.abc import Iterator, Mapping

import pytest
from independent.campaign import Figures, run
from independent.own_facts import cell_of, moves_in_cells, moves_in_numbers
from independent.random_sizes import draw_sizes
from independent.random_tables import Drawn
from independent.replay import Step

from neurosym.pddl.compiler import domain_text, problem_text

SHORT, LONG = range(12), range(200)
LIMIT = 2.0
"""What a planner has for a table [s]."""
PUT_DOWN = "put-down-"


def drawn_of(numbers: range) -> Iterator[Drawn]:
    return (drawn for drawn in map(draw_sizes, numbers) if drawn is not None)


def _quick(planner: str, encoding: str | None, drawn: Drawn) -> bool:
    if planner in ("bfs-operators", "counting") or (planner == "fast-downward" and encoding == "sas"):
        return len(drawn.problem.objects) <= 4
    is_small = len(drawn.problem.objects) <= 2 and drawn.grounding.cell >= 0.01
    return planner == "fast-downward" and encoding == "strips" and is_small


def test_cells_and_numbers_say_the_same_of_every_object():
    differ = 0
    for drawn in drawn_of(range(60)):
        texts = (domain_text(drawn.grounding), problem_text(drawn.problem, drawn.grounding))
        cells, cell = moves_in_cells(*texts, drawn.domain_json), cell_of(texts[1])
        in_numbers = (
            domain_text(drawn.grounding, "numeric"),
            problem_text(drawn.problem, drawn.grounding, "numeric"),
        )
        numbers = moves_in_numbers(*in_numbers, drawn.domain_json)
        told = {(name, of): _both(cells, name, of) for name, of in cells}
        exact = {(name, of): _both(numbers, name, of) for name, of in numbers if of in drawn.problem.goals}
        assert told.keys() == exact.keys()
        for step, moved in told.items():
            assert _is_rounded(moved, exact[step], cell)
        for name, of in told:
            others = [moved for (n, o), moved in numbers.items() if n == name and o != of]
            differ += any(math.dist(other, numbers[name, of]) > 0.005 for other in others)
    assert differ > 20


def _both(moves: Mapping[Step, tuple], name: str, of: str) -> tuple:
    """What a step does along x and y; putting down with its lift, for the two are rounded as one."""
    moved = moves[name, of][:2]
    if not name.startswith(PUT_DOWN):
        return moved
    lift = moves[name.removeprefix(PUT_DOWN), of][:2]
    return tuple(map(sum, zip(moved, lift, strict=True)))


def _is_rounded(cells: tuple, exact: tuple, cell: float) -> bool:
    return all(
        abs(part * cell - float(value)) <= cell / 2 + 1e-4 for part, value in zip(cells, exact, strict=True)
    )


def test_plans_and_denials_hold_for_objects_with_steps_of_their_own():
    figures = run(drawn_of(SHORT), time_limit=LIMIT, chosen=_quick)
    assert not figures.findings, "\n".join(figures.findings)
    assert figures.counts["counting"]["plans"] > 3
    assert figures.counts["fast-downward sas"]["answers in PDDL"] > 3
    assert figures.counts["theorem"]["valid in PDDL"] > 3


@pytest.mark.evaluation
def test_plans_and_denials_of_every_planner_hold_for_objects_with_steps_of_their_own():
    figures = Figures()
    run(drawn_of(LONG), time_limit=LIMIT, figures=figures)
    print(*figures.lines(), sep="\n")
    assert not figures.findings
