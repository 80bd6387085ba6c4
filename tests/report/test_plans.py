"""Plans and runs are counted by planner."""

from neurosym.report.sections import PlannerSummary, PlanRow, summaries


def row(planner: str, *, steps: int | None, reached: bool | None, performed: int = 1) -> PlanRow:
    own = None if reached is None else (1, performed)
    return PlanRow("p", 1, planner, "solved" if steps else "unsolvable", steps, 0.1, reached, own, "")


def test_found_plans_runs_reached_goals_and_those_reached_without_a_new_plan_are_counted_apart():
    rows = (
        row("bfs", steps=2, reached=True),
        row("bfs", steps=3, reached=False),
        row("bfs", steps=1, reached=True, performed=4),
        row("bfs", steps=1, reached=None),
        row("bfs", steps=None, reached=None),
        row("kairos", steps=None, reached=None),
    )
    assert summaries(rows) == (
        PlannerSummary("bfs", problems=5, found=4, runs=3, reached=2, alone=1),
        PlannerSummary("kairos", problems=1, found=0, runs=0, reached=0, alone=0),
    )
