"""Bits out and in: traces that learners of action models read, and a domain that is compiled from others'."""

import csv
import random

import numpy as np
import pytest
from command_line import neurosym, refusal

from neurosym.data.axes import Axis
from neurosym.data.interactions import Interactions
from neurosym.values.traces import GivenSymbols, traces_text

LAMPS = 3


@pytest.fixture
def traces(tmp_path):
    """Traces of three lamps that are switched one by one; the last only while the first is lit."""
    rng, rows = random.Random(0), [["lamp1", "lamp2", "lamp3", "action", "plan_id"]]
    for plan in range(30):
        lit = [0] * LAMPS
        for _ in range(15):
            lamp = rng.randrange(LAMPS)
            rows.append([*lit, f"switch{lamp + 1}", plan])
            lit[lamp] ^= lamp < 2 or lit[0]
        rows.append([*lit, "", plan])
    file = tmp_path / "traces.csv"
    with file.open("w", newline="") as text:
        csv.writer(text).writerows(rows)
    return file


def test_traces_of_others_are_compiled_as_they_are(traces, tmp_path, capsys):
    folder = tmp_path / "lamps"
    assert neurosym("init", folder, "--data", traces) == 0
    assert neurosym("compile-domain", folder) == 0
    goals = (word for n in range(1, 4) for word in ("--goal", f"thing-01.lamp{n}={int(n == 3)}"))
    assert neurosym("new-problem", folder, *goals) == 0
    assert neurosym("plan", folder, "task-01") == 0
    capsys.readouterr()
    assert neurosym("validate", folder, "task-01", folder / "plans/task-01.fast-downward.plan") == 0
    assert "validator says: valid" in capsys.readouterr().out
    assert "switch3-10-state-100" in (folder / "domain.pddl").read_text()
    assert "switch3-10-state-000" not in (folder / "domain.pddl").read_text()  # which changes nothing


def test_bits_go_out_as_they_came_in(traces, tmp_path):
    folder, again = tmp_path / "lamps", tmp_path / "again"
    assert neurosym("init", folder, "--data", traces) == 0
    assert neurosym("traces", folder) == 0
    assert neurosym("init", again, "--data", folder / "traces.csv") == 0
    first, second = (Interactions.load(one / "interactions.npz") for one in (folder, again))
    np.testing.assert_array_equal(first.features, second.features)
    np.testing.assert_array_equal(first.effects, second.effects)
    told = GivenSymbols(first).action_symbols(first.actions)
    assert told == GivenSymbols(second).action_symbols(second.actions)
    assert [first.origin[one] for one in ("feature_names", "action_names")] == [
        second.origin[one] for one in ("feature_names", "action_names")
    ]


def test_actions_in_traces_are_named_after_their_choices():
    moves = np.eye(3, dtype=np.float32)[np.arange(12) % 3]
    lit, none = np.arange(12)[:, None].astype(np.float32) % 2, np.zeros(12, dtype=bool)
    data = Interactions(
        lit, moves, 1 - 2 * lit, 1 - 2 * lit, none, none, none, lit[:, 0],
        {"feature_names": ["lit"], "choices": [0, 1, 2], "action_names": ["do=flip", "do=turn", "do=3"]},
    )  # fmt: skip

    def named(*symbols: str) -> list[str]:
        told = traces_text(
            data, [Axis("lit", "flag")],
            object_symbols=lambda rows: tuple("01"[int(one)] for one in rows[:, 0]),
            action_symbols=lambda rows: tuple(symbols[n] for n in rows.argmax(1)),
        )  # fmt: skip
        return [row.split(",")[1] for row in told.splitlines()[1:6:2]]

    assert named("00", "01", "10") == ["flip", "turn", "do-3"]
    assert named("00", "01", "01") == ["act-00", "act-01", "act-01"]


def test_angles_in_traces_stay_where_the_data_are():
    angle = np.linspace(-3, 3, 41, dtype=np.float32)[:, None]
    none, flat = np.zeros(41, dtype=bool), np.full((41, 1), 0.5, dtype=np.float32)
    turning = Interactions(
        angle, np.ones_like(angle), flat, flat, none, none, none, flat[:, 0], {"feature_names": ["angle"]}
    )
    seen = list[np.ndarray]()

    def symbols(rows: np.ndarray) -> tuple[str, ...]:
        seen.append(rows)
        return ("0",) * len(rows)

    axis = Axis("angle", "angle", period=6.5)
    traces_text(turning, [axis], object_symbols=symbols, action_symbols=lambda rows: ("1",) * len(rows))
    assert seen[1].min() >= -3
    assert seen[1].max() <= 3.5
    assert seen[1][0, 0] == pytest.approx(-2.5)


def test_bits_that_never_change_are_left_out(tmp_path):
    rows = "\n".join(f"1,{n % 2},flip,0" for n in range(40))
    (tmp_path / "t.csv").write_text(f"wall,lit,action,plan_id\n{rows}")
    assert neurosym("init", tmp_path / "t", "--data", tmp_path / "t.csv") == 0
    assert Interactions.load(tmp_path / "t/interactions.npz").origin["feature_names"] == ["lit"]


def test_what_no_feature_shows_has_no_traces(tmp_path, capsys):
    rows = "\n".join(f"{n % 2},{n % 3},{n}" for n in range(30))
    (tmp_path / "push.csv").write_text(f"feature.red,choice.push,effect.x\n{rows}")
    assert neurosym("init", tmp_path / "push", "--data", tmp_path / "push.csv") == 0
    capsys.readouterr()
    assert "No feature shows what actions change" in refusal(capsys, "traces", tmp_path / "push")
