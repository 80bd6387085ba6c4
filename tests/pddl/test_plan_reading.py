"""Plan reading: whatever its form, a plan is read by what it says; what is not so is refused."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest
import toy_places
import toy_relations
from places import DOCS, ROOT
from plan_forms import FORMS, edited
from tables import grounding, problem
from toy_relations import PUT_ON

from neurosym.errors import InvalidFile, InvalidPlan
from neurosym.grounding import Grounding
from neurosym.pddl.plan_reading import parse_plan, read_plan
from neurosym.problems import Problem
from neurosym.tasks.transition import PlanStep

AS_FILES = FORMS["the IPC form, as plan files have it"]
PULL, PUSH = PlanStep("pull-010-tray", "item-02"), PlanStep("push-away-001-block", "item-01")
LIFT, DOWN = PlanStep("lift-010-block", "item-01"), PlanStep("put-down-lift-010-block", "item-01")
FORMER = """(push-away-001-block item-01 x030 x044)
(finish-push-away-001-block-y item-01 y063 y061)
(lift-010-block item-01 x044 x046)
(finish-lift-010-block-y item-01 y061 y057)
(finish-lift-010-block-z item-01 z000 z041)
(put-down-lift-010-block item-01 z041 z000)
(pull-010-tray item-02 x060 x049 y040 y031)
(move-y item-02 y-minus-9 y040 y031)
(reach-goal item-02 x049 y031 z000)
"""
"""What earlier versions printed, in several encodings."""


def read(text: str) -> tuple[PlanStep, ...]:
    return parse_plan(text, Path("some.plan"), grounding(), problem())


def refusal(text: str) -> str:
    with pytest.raises(InvalidPlan) as refused:
        read(text)
    return str(refused.value)


@pytest.mark.parametrize(
    "line",
    [
        "(PUSH ITEM_02 M_010 DX-5 DY-5 COST16)(MOVE_X ITEM_02 DX-5 X30 X25)(MOVE-Y ITEM-02 DY-5 Y20 Y15)",
        "0: (push item-02 m-010 dx-5 dy-5 cost16)(move-x item-02 dx-5 x30 x25) (move-y item-02 dy-5 y20 y15)",
        "(pull-010-tray item-02) ; cost 16",
        "pull-010-tray item-02 (16)",
        "(pull-010-tray item-02) (reach-goal item-02 x049 y031 z000) (REACH-GOAL)",
    ],
)
def test_dialects_of_planners_are_read(line: str):
    assert read(f"; a plan\n\n{line}\n") == (PULL,)


@pytest.mark.parametrize(
    ("line", "complaint"),
    [
        ("(pull-010-tray item-02", "not of the form of a step; valid: a step a line"),
        ("(pull-010-tray)", "names no object"),
        ("(fly item-01)", "no operator 'fly'; valid: lift-010-block"),
        ("FLY to item-01", "'FLY to item-01' is not of the form of a step; valid"),
        ("(finish-fly-y item-01)", "no operator 'finish-fly-y'"),
        ("(leave-nothing item-01)", "no operator 'leave-nothing'"),
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


def test_plans_of_earlier_versions_are_read_for_their_steps_alone(tmp_path: Path):
    assert read(FORMER) == (PUSH, LIFT, DOWN, PULL)
    assert read(FORMER.replace("x030", "x999")) == (PUSH, LIFT, DOWN, PULL), "their cells are no longer known"
    for line in (FORMER.splitlines()[1], "(move-z item-01 z-plus-14 z030 z044)"):
        assert f"nothing begins what {line.split()[0][1:]} leads on" in refusal(line)
    carried = "(carry-to-01-cube item-01 start-item-01 park-01)"
    timed = "0.0: (carry-to-01-cube item-01 start-item-01 park-01 nowhere nowhere nowhere) [6.1]"
    for text in (f"(look-on item-01 park-01 start-item-02 nowhere)\n{carried}\n(leave-start item-01)", timed):
        steps = parse_plan(text, tmp_path, toy_places.grounding(), toy_places.swap())
        assert steps == (PlanStep(toy_places.NAME, "item-01", "park-01"),)
    built = f"(leave-place item-03 start-item-03)\n({PUT_ON} item-03 item-02 none one from-place surely)\n"
    built += f"(leave-rests-on-001 item-03 item-02 none one)\n({PUT_ON}-laden item-03 item-04 from-object)\n"
    built += "(carry-to-01-cube item-03 park-01 from-object)"
    steps = parse_plan(built, tmp_path, toy_relations.grounding(), toy_relations.tower())
    put = [(PUT_ON, "item-02"), (PUT_ON, "item-04")]
    assert [(one.operator, one.place) for one in steps] == [*put, ("carry-to-01-cube", "park-01")]


def test_plan_without_steps_is_one_if_nothing_is_said_or_that_there_are_none():
    for text in ("", "; nothing\n", "; cost = 0 (unit cost)\n", "[]", '{"plan": []}', "SequentialPlan:\n"):
        assert read(text) == ()
    for text in ("Plan cost: 3\n", "ff: found legal plan as follows\n\ntime spent: 0.00 seconds\n"):
        assert "has no steps" in refusal(text)


def test_no_line_is_passed_over_that_names_an_operator_or_an_object():
    log = "Solution found!\n{}\npull-010-tray item-02 (1)\nPlan length: 1 step(s).\n"
    assert read(log.format("Looking at pulls")) == (PULL,)
    for line in ("then push_away_001_block it", "and item_02"):
        assert f"{line!r} is not of the form of a step" in refusal(log.format(line))


def test_of_plans_that_get_better_the_last_is_read_and_others_are_not_joined():
    one, other = "(push-away-001-block item-01)\n", "(pull-010-tray item-02)\n"
    assert read(f"; cost = 9\n{one}; better plan 2\n; cost = 3\n{other}") == (PULL,)
    assert read(f"Solution found!\n{one}Plan length: 1\nSolution found!\n{other}Plan length: 1\n") == (PULL,)
    assert read(f"{one}Solution found!\nPlan length: 1\n") == (PUSH,), "nothing better came after it"
    assert read(f"Here it is:\n```\n{one}```\nand then\n```\n{other}```\n") == (PUSH, PULL)


@pytest.mark.parametrize(
    "line",
    [
        f"({'x' * 3_000_000} item-01)",
        f"(lift-010-block {'x' * 5000})",
        f"({'x' * 5000} item-01)",
        "\0" * 3_000_000,
        f"(a{' ' * 1_000_000}b)",
        "(" * 90_000,
        f"{'((a) ' * 10_000}",
        "a " * 40_000 + "(",
    ],
)
def test_little_is_quoted_of_a_long_line_and_it_is_refused_at_once(line: str):
    said = refusal(line)
    assert "..." in said or "has no steps" in said
    assert len(said) < 700


def test_file_with_a_byte_order_mark_is_read_and_one_that_is_no_text_or_far_too_large_is_not(tmp_path: Path):
    (tmp_path / "windows.plan").write_text("(pull-010-tray item-02)\r\n", encoding="utf-8-sig")
    assert read_plan(tmp_path / "windows.plan", grounding(), problem()) == (PULL,)
    (tmp_path / "image.plan").write_bytes(b"\xff\xfe\x00")
    with (tmp_path / "huge.plan").open("wb") as file:
        file.truncate(200 * 2**20)
    large = r"huge\.plan cannot be used: it has 200 MB; valid: at most 16 MB"
    for name, said in (("missing", "missing.plan"), ("image", "image.plan"), ("huge", large)):
        with pytest.raises(InvalidFile, match=said):
            read_plan(tmp_path / f"{name}.plan", grounding(), problem())


SHIPPED = (
    ("places", "row-4-12.fast-downward"),
    ("tabletop", "task-01.fast-downward"),
    ("towers", "tower-6-05.fast-downward"),
)
"""A plan of each kind of domain: by places, over cells, and by relations."""
Words = list[list[str]]


@cache
def shipped(domain: str, plan: str) -> tuple[str, Grounding, Problem]:
    folder = ROOT / "domains" / domain
    scene = folder / "problems" / f"{plan.partition('.')[0]}.scene.json"
    text = (folder / "plans" / f"{plan}.plan").read_text()
    return text, Grounding.load(folder / "grounding.json"), Problem.load(scene)


def actions_of(text: str) -> Words:
    """Return the words of the ground actions in a plan file, an action a line."""
    lines = (line.partition(";")[0].strip() for line in text.splitlines())
    return [line.strip("()").split() for line in lines if line]


def read_shipped(text: str, domain: str, plan: str) -> tuple[PlanStep, ...]:
    return parse_plan(text, Path("some.plan"), *shipped(domain, plan)[1:])


@pytest.mark.parametrize(("domain", "plan"), SHIPPED)
def test_misspelt_action_of_the_page_is_named_with_its_line_and_the_nearest(domain: str, plan: str):
    lines = shipped(domain, plan)[0].splitlines()
    number = max(number for number, line in enumerate(lines) if line.startswith("("))
    name = lines[number][1:].split()[0]
    lines[number] = lines[number].replace(name, f"{name}e", 1)
    with pytest.raises(
        InvalidPlan, match=rf", line {number + 1}: .* '{name}e'; the nearest is {name}; valid"
    ):
        read_shipped("\n".join(lines), domain, plan)


def by_hand(actions: Words) -> list[tuple[str, str]]:
    """Fold ground actions into steps by their names alone: the object of each, and where it goes."""
    at = {"push": None, "lift": None, "put-down": None, "put-at": 2, "put": 3, "put-loaded": 3}
    return [
        (words[1], words[place] if (place := at[words[0]]) else "") for words in actions if words[0] in at
    ]


@pytest.mark.parametrize("form", FORMS)
def test_a_plan_gives_the_same_steps_in_every_form(form: str):
    assert f"| {form} |" in (DOCS / "other-plans.md").read_text()
    for domain, plan in SHIPPED:
        text = shipped(domain, plan)[0]
        written = FORMS[form].write(actions_of(text))
        assert read_shipped(written, domain, plan) == read_shipped(text, domain, plan) != ()


@pytest.mark.parametrize(("domain", "plan"), SHIPPED)
def test_an_edited_plan_is_refused_or_gives_the_steps_that_it_says(domain: str, plan: str):
    actions, rng, refused = actions_of(shipped(domain, plan)[0]), np.random.default_rng(41), 0
    words = [*sorted({word for action in actions for word in action}), "x999", "item-77", "goal-item-01"]
    for _ in range(40):
        some = edited(actions, rng, words)
        try:
            steps = read_shipped(AS_FILES.write(some), domain, plan)
        except InvalidPlan:
            refused += 1
        else:
            assert [(step.object, step.place) for step in steps] == by_hand(some)
    assert refused > 20
