"""Plans and runs are counted by planner."""

from neurosym.report.html_page import summaries


def row(planner: str, *, steps: int | None, reached: bool | None, performed: int = 1) -> dict:
    own = None if reached is None else (1, performed)
    return {"planner": planner, "steps": steps, "reached": reached, "own": own}


def test_found_plans_runs_reached_goals_and_those_reached_without_a_new_plan_are_counted_apart():
    rows = (
        row("bfs", steps=2, reached=True),
        row("bfs", steps=3, reached=False),
        row("bfs", steps=1, reached=True, performed=4),
        row("bfs", steps=1, reached=None),
        row("bfs", steps=None, reached=None),
        row("kairos", steps=None, reached=None),
    )
    assert summaries(rows) == [
        {"planner": "bfs", "problems": 5, "found": 4, "runs": 3, "reached": 2, "alone": 1},
        {"planner": "kairos", "problems": 1, "found": 0, "runs": 0, "reached": 0, "alone": 0},
    ]
