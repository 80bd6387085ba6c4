"""Plans and runs are counted by planner."""

from neurosym.report.plans import PlannerSummary, PlanRow, summaries


def row(planner: str, *, steps: int | None, reached: bool | None) -> PlanRow:
    return PlanRow(
        "p",
        1,
        planner,
        "solved" if steps else "unsolvable",
        steps,
        0.1,
        reached,
        None if reached is None else (1, 1),
        "",
    )


def test_found_plans_runs_and_reached_goals_are_counted_apart():
    rows = (
        row("bfs", steps=2, reached=True),
        row("bfs", steps=3, reached=False),
        row("bfs", steps=1, reached=None),
        row("bfs", steps=None, reached=None),
        row("kairos", steps=None, reached=None),
    )
    assert summaries(rows) == (
        PlannerSummary("bfs", problems=4, found=3, runs=2, reached=1),
        PlannerSummary("kairos", problems=1, found=0, runs=0, reached=0),
    )
