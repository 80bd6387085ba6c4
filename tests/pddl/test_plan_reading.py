"""Plan reading: a plan is read by what it says, and what is not so is refused by line, step and argument."""

from pathlib import Path

import pytest
from tables import grounding, problem

from neurosym.errors import InvalidFile, InvalidPlan
from neurosym.pddl.ground_plan import print_ground_plan
from neurosym.pddl.plan_reading import parse_plan, read_plan
from neurosym.pddl.plan_text import PlanStep

PULL, PUSH = PlanStep("pull-010-tray", "item-02"), PlanStep("push-away-001-block", "item-01")
LIFT, DOWN = PlanStep("lift-010-block", "item-01"), PlanStep("put-down-lift-010-block", "item-01")
AWAY = "(push-away-001-block item-01 x030 x044)\n(finish-push-away-001-block-y item-01 y063 y061)\n"


def read(text: str) -> tuple[PlanStep, ...]:
    return parse_plan(text, Path("some.plan"), grounding(), problem())


def refusal(text: str) -> str:
    with pytest.raises(InvalidPlan) as refused:
        read(text)
    return str(refused.value)


@pytest.mark.parametrize(
    "line",
    [
        "(pull-010-tray item-02)",
        "(PULL-010-TRAY ITEM-02 X060 X049 Y040 Y031)",
        "0: (pull-010-tray item-02 x060 x049) (finish-pull-010-tray-y item-02 y040 y031) [1]",
        "  0.000: ( pull-010-tray  item-02 )  [1.000]",
        "(pull-010-tray item-02) ; cost 16",
        "pull_010_tray(item_02)",
        "pull-010-tray item-02",
        "pull-010-tray item-02 (16)",
    ],
)
def test_dialects_of_planners_are_read(line: str):
    assert read(f"; a plan\n\n{line}\n") == (PULL,)


@pytest.mark.parametrize(
    ("line", "complaint"),
    [
        ("(pull-010-tray item-02", "not of the form of a step; the nearest is"),
        ("()", "not of the form"),
        ("(pull-010-tray)", "names no object"),
        ("(fly item-01)", "no operator 'fly'; valid: lift-010-block"),
        ("FLY to item-01", "'FLY to item-01' is not of the form of a step; the nearest is words without"),
        ("(finish-fly-y item-01)", "no operator 'finish-fly-y'"),
        ("(pull-010-tray item-03)", "no object 'item-03'; valid: item-01, item-02"),
        ("(pull-010-tray item-01)", "for objects of category tray, and item-01 is of category block"),
        ("(put-down-pull-010-tray item-02)", "nothing can be put down"),
    ],
)
def test_line_that_cannot_be_is_refused_by_file_and_number(line: str, complaint: str):
    with pytest.raises(InvalidPlan, match=rf"some\.plan, line 3: .*{complaint}"):
        read(f"; a plan\n(pull-010-tray item-02)\n{line}\n")


def test_times_order_a_plan_and_equal_ones_leave_it_as_it_is_written():
    late = "5.0: (push-away-001-block item-01) [1]\n0.0: (pull-010-tray item-02) [1]\n"
    assert read(late) == (PULL, PUSH)
    assert read(late.replace("5.0", "0.00")) == (PUSH, PULL)
    assert read(late.replace("[1]", "[9]")) == (PULL, PUSH)  # durations that overlap change nothing
    assert "no time" in refusal("0: (pull-010-tray item-02)\n(push-away-001-block item-01)")
    assert "not of the form" in refusal("1e999: (pull-010-tray item-02)")


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        (AWAY.replace("x030", "x001"), "line 1: argument 2 is x001, where x030 would be right .step 1"),
        (AWAY.replace("x044", "x999"), "line 1: argument 3 is x999, where x044 would be right .step 1"),
        (AWAY.replace("y063", "y062"), "line 2: argument 2 is y062, where y063 would be right .step 1"),
        (
            AWAY.splitlines()[0],
            r"not complete; \(finish-push-away-001-block-y item-01 y063 y061\) comes after",
        ),
        (AWAY.splitlines()[1], r"nothing begins; \(push-away-001-block ...\) comes before it"),
        ("\n".join(AWAY.splitlines()[::-1]), "nothing begins"),
        (AWAY + AWAY, "line 3: argument 2 is x030, where x044 would be right .step 2"),
        ("(reach-goal item-01 x044 y061 z000)\n" + AWAY, "line 1: .*argument 2 is x044, where x030 would"),
        (AWAY + "(reach-goal item-01 x044 y061 z000)", r"line 3: .*\(reach-goal item-02 ...\) .*is missing"),
        (AWAY + "(reach-goal item-01 x044 y061 z001)", "argument 4 is z001, where z000 would be right"),
        (AWAY + "(push-away-001-block item-01)", "it has 1 argument, where .* x044 x058.* would be right"),
        (
            "(PULL-010-TRAY item_02 X060)",
            r"it has 2 arguments, .*step 1, `\(PULL-010-TRAY item_02 X060\)`",
        ),
        ("(reach-goal)\n(pull-010-tray item-02)", "names no object"),
        ("(stay-111-block item-01 x030 x030)", "it is not in the domain for item-01, so it leads to no cell"),
    ],
)
def test_plan_that_says_what_is_not_so_is_refused_by_step_and_argument(text: str, complaint: str):
    with pytest.raises(InvalidPlan, match=complaint):
        read(text)


def test_goals_are_noted_after_the_last_step_with_their_object_or_of_none():
    goals = "(reach-goal item-01 x044 y061 z000)\n(reach-goal item-02 x060 y040 z000)\n"
    assert read(AWAY + goals) == (PUSH,)
    again = (
        AWAY.replace("x044", "x058").replace("x030", "x044").replace("y061", "y059").replace("y063", "y061")
    )
    assert read(AWAY + again) == (PUSH, PUSH)
    assert "(reach-goal item-01 ...)" in refusal(AWAY + goals + again)


def test_steps_in_short_may_be_followed_by_a_note_of_what_is_so():
    note = "(reach-goal item-02 x049 y031 z000) (reach-goal item-01 x030 y063 z000)"
    assert read(f"(pull-010-tray item-02) {note} (REACH-GOAL)") == (PULL,)
    assert "argument 2 is x060, where x049" in refusal(
        f"(pull-010-tray item-02) {note.replace('x049', 'x060')}"
    )


def test_off_the_grid_leads_no_step():
    row = [f"(push-away-001-block item-01 x{x:03} x{x + 14:03})" for x in range(30, 120, 14)]
    text = "\n".join(
        f"{line}\n(finish-push-away-001-block-y item-01 y{63 - 2 * k:03} y{61 - 2 * k:03})"
        for k, line in enumerate(row)
    )
    assert "leads item-01 off the grid along x" in refusal(text)


def test_printed_plans_are_read_on_the_grid_that_they_were_printed_on():
    fine, steps = grounding(0.002), (PULL, LIFT, DOWN, PUSH)
    text = print_ground_plan(steps, problem(), fine)
    assert parse_plan(text, Path("fine.plan"), fine, problem()) == steps
    assert "would be right" in refusal(text)


def test_plan_without_steps_is_one_if_nothing_is_said_or_that_there_are_none():
    for text in ("", "; nothing\n", "; cost = 0 (unit cost)\n", "[]", '{"plan": []}', "SequentialPlan:\n"):
        assert read(text) == ()
    for text in ("Plan cost: 3\n", "ff: found legal plan as follows\n\ntime spent: 0.00 seconds\n"):
        assert "has no steps" in refusal(text)


def test_no_line_is_passed_over_that_names_an_operator():
    log = "Solution found!\n{}\npull-010-tray item-02 (1)\nPlan length: 1 step(s).\n"
    assert read(log.format("Looking at pulls")) == (PULL,)
    assert "names push-away-001-block and is no step" in refusal(log.format("then push_away_001_block it"))


def test_of_plans_that_get_better_the_last_is_read_and_others_are_not_joined():
    one, other = "(push-away-001-block item-01)\n", "(pull-010-tray item-02)\n"
    assert read(f"; cost = 9\n{one}; better plan 2\n; cost = 3\n{other}") == (PULL,)
    assert read(f"Solution found!\n{one}Plan length: 1\nSolution found!\n{other}Plan length: 1\n") == (PULL,)
    assert "line 4: '; cost = 3' is said of a second plan" in refusal(f"{one}; cost = 9\n{other}; cost = 3\n")
    assert "is said, and 1 step can be read" in refusal(f"Solution found!\n{one}Plan length: 2 step(s).\n")
    assert "2 blocks between lines of ```" in refusal(f"```\n{one}```\n```\n{other}```\n")
    assert "stands before the line that a plan begins after" in refusal(f"{one}Solution found!\n{other}")
    assert "stands outside the block" in refusal(f"{one}```\n{other}```\n")


def test_plan_with_a_byte_order_mark_is_read(tmp_path: Path):
    (tmp_path / "windows.plan").write_text("(pull-010-tray item-02)\r\n", encoding="utf-8-sig")
    assert read_plan(tmp_path / "windows.plan", grounding(), problem()) == (PULL,)


@pytest.mark.parametrize(
    "line",
    [
        f"({'x' * 3_000_000} item-01)",
        f"(lift-010-block {'x' * 5000})",
        f"({'x' * 5000} item-01)",
        "\0" * 3_000_000,
        "1" * 3_000_000,
        f"(a{' ' * 1_000_000}b)",
        "(" * 90_000,
        "([" * 40_000,
        f"{'((a) ' * 10_000}",
        f"{'(a' * 10_000}",
        "a " * 40_000 + "(",
    ],
)
def test_little_is_quoted_of_a_long_line_and_it_is_refused_at_once(line: str):
    said = refusal(line)
    assert "..." in said
    assert len(said) < 700


def test_file_that_is_far_too_large_is_refused_unread(tmp_path: Path):
    with (tmp_path / "huge.plan").open("wb") as file:
        file.truncate(200 * 2**20)
    with pytest.raises(InvalidFile, match=r"huge\.plan cannot be used: it has 200 MB; valid: at most 16 MB"):
        read_plan(tmp_path / "huge.plan", grounding(), problem())


def test_file_that_is_missing_or_no_text_is_refused(tmp_path: Path):
    (tmp_path / "image.plan").write_bytes(b"\xff\xfe\x00")
    for name in ("missing.plan", "image.plan"):
        with pytest.raises(InvalidFile, match=name):
            read_plan(tmp_path / name, grounding(), problem())
