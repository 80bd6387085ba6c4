"""Plan text: every dialect that planners write is read, and what cannot be read is refused by line."""

from pathlib import Path

import pytest
from tables import grounding, problem

from neurosym.errors import InvalidFile, InvalidPlan, InvalidValue
from neurosym.pddl.ground_plan import print_ground_plan
from neurosym.pddl.plan_text import PlanStep, parse_plan, print_plan, read_plan

PULL, PUSH = PlanStep("pull-010-tray", "item-02"), PlanStep("push-away-001-block", "item-01")
LIFT, DOWN = PlanStep("lift-010-block", "item-01"), PlanStep("put-down-lift-010-block", "item-01")


def read(text: str) -> tuple[PlanStep, ...]:
    return parse_plan(text, Path("some.plan"), grounding(), problem())


def test_printed_plan_is_read_back(tmp_path: Path):
    path = tmp_path / "errand.plan"
    path.write_text(print_plan([PULL, LIFT, DOWN, PUSH]))
    assert path.read_text().endswith("(push-away-001-block item-01)\n; 3 primitives\n")
    assert read_plan(path, grounding(), problem()) == (PULL, LIFT, DOWN, PUSH)


@pytest.mark.parametrize(
    "line",
    [
        "(pull-010-tray item-02)",
        "(PULL-010-TRAY ITEM-02 X060 X049)",
        "0: (pull-010-tray item-02 x060 x049) [1]",
        "  0.000: ( pull-010-tray  item-02 )  [1.000]",
        "(pull-010-tray item-02) ; cost 16",
    ],
)
def test_dialects_of_planners_are_read(line: str):
    assert read(f"; a plan\n\n{line}\n") == (PULL,)


def test_micro_steps_are_folded_into_their_step():
    text = print_ground_plan([PULL, LIFT, DOWN, PUSH], problem(), grounding())
    assert "(finish-put-down-lift-010-block-z item-01 z041 z000)" in text
    assert "(reach-goal item-02 x049 y031 z000)" in text
    assert read(text) == (PULL, LIFT, DOWN, PUSH)


def test_plan_with_all_axes_in_one_action_is_read():
    text = print_ground_plan([PULL, LIFT], problem(), grounding(), "operators")
    assert text.splitlines()[0] == "(pull-010-tray item-02 x060 x049 y040 y031)"
    assert read(text) == (PULL, LIFT)


def test_operator_left_out_of_the_domain_may_be_in_a_plan_but_has_no_cells():
    stay = PlanStep("stay-111-block", "item-01")
    assert read("(stay-111-block item-01)") == (stay,)
    with pytest.raises(InvalidValue, match="stay-111-block is not in the domain"):
        print_ground_plan([stay], problem(), grounding())


@pytest.mark.parametrize(
    ("line", "complaint"),
    [
        ("pull-010-tray item-02", "not of the form"),
        ("(pull-010-tray item-02", "not of the form"),
        ("(pull-010-tray)", "not of the form"),
        ("()", "not of the form"),
        ("(pull-010-tray item-02)(pull-010-tray item-02)", "not of the form"),
        ("(fly item-01)", "no operator 'fly'; valid: lift-010-block"),
        ("(finish-fly-y item-01)", "no operator 'fly'"),
        ("(pull-010-tray item-03)", "no object 'item-03'; valid: item-01, item-02"),
        ("(pull-010-tray item-01)", "for objects of category tray, and item-01 is of category block"),
        ("(put-down-pull-010-tray item-02)", "nothing can be put down"),
    ],
)
def test_line_that_cannot_be_is_refused_by_file_and_number(line: str, complaint: str):
    with pytest.raises(InvalidPlan, match=rf"some\.plan, line 3: .*{complaint}"):
        read(f"; a plan\n(pull-010-tray item-02)\n{line}\n")


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
        f"(a{' ' * 1_000_000}b)",
    ],
)
def test_little_is_quoted_of_a_long_line(line: str):
    with pytest.raises(InvalidPlan) as refused:
        read(line)
    assert "..." in str(refused.value)
    assert len(str(refused.value)) < 600


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
