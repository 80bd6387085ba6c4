"""Relations, plans and domains that cannot be, each refused in one sentence."""

from pathlib import Path

import msgspec
import pytest
import toy_places
from toy_relations import LIE, PUT_IN, PUT_ON, REST, grounding, sorting, tower

from neurosym.errors import InvalidPlan, InvalidValue, NeurosymError
from neurosym.pddl.plan_reading import parse_plan
from neurosym.planners import PlanStatus, plan
from neurosym.tasks.pair_goals import check_relations, relations_meant
from neurosym.tasks.transition import PlanStep, validate


@pytest.mark.parametrize(
    ("steps", "said"),
    [
        (((PUT_IN, "item-02", "item-01"),), "it is not for item-02 with item-01, a pair of the kind 01"),
        (((PUT_ON, "item-01", "item-03"),), "item-03 bears item-02, which rehearsals forbid"),
        (((PUT_ON, "item-03", "item-01"),), "item-01 rests on item-03 itself"),
        ((("carry-to-01-cube", "item-03", "park-01"),), "it is not for item-03"),
        ((("carry-to-01-cube", "item-01", "spot-5000-0"),), "item-01 ends where item-02 is"),
        (
            (("carry-to-01-cube", "item-01", "park-01"),),
            "item-01 ends borne by nothing, not lies-in-010 item-04",
        ),
    ],
)
def test_replay_says_what_is_wrong(steps, said):
    checked = validate([PlanStep(*step) for step in steps], sorting(), grounding())
    assert not checked.valid
    assert said in checked.reason


@pytest.mark.parametrize(
    ("line", "said"),
    [
        (f"({PUT_ON} item-01 moon)", "no other object 'moon'; valid: item-02, item-03"),
        (f"({PUT_ON} item-01 item-01)", "no other object 'item-01'"),
        (f"({PUT_ON} item-01)", "it names no other object; valid: item-02, item-03"),
        ("(put-under item-01 item-02)", "no operator 'put-under'"),
    ],
)
def test_lines_of_plans_that_cannot_be_are_refused_in_one_sentence(line, said, tmp_path: Path):
    with pytest.raises(InvalidPlan, match=f"line 1: .*{said}"):
        parse_plan(line, tmp_path, grounding(), sorting())


@pytest.mark.parametrize(
    ("goals", "said"),
    [
        (
            [("item-01", "item-01", REST)],
            "item-01 cannot be rests-on-001 of itself; valid references: item-02",
        ),
        ([("item-01", "item-02", REST), ("item-02", "item-01", REST)], "lead round in a circle"),
        ([("item-01", "item-02", REST), ("item-01", "item-03", REST)], "give it one reference"),
        ([("item-01", "item-02", REST), ("item-01", "item-02", LIE)], "a pair is in one state at a time"),
        ([("item-01", "moon", REST)], "a relation of moon, which is not in the scene; objects: item-01"),
        ([("item-01", "item-02", "floats")], "no state of a pair 'floats'; valid: apart-000"),
        ([("item-01", "item-02", "apart-000")], "in which nothing is borne; valid states: rests-on-001"),
        ([("item-04", "item-03", REST)], "nothing puts item-04 on or into any other object"),
        (
            [("item-01", "item-04", REST)],
            "no operator brings item-01 to rests-on-001 with item-04; valid for item-01: rests-on-001 ",
        ),
        (
            [("item-01", "item-03", REST), ("item-02", "item-03", REST)],
            "item-03 shall bear item-01 and item-02, and rehearsals show that it bears one object at a time",
        ),
    ],
)
def test_relations_that_cannot_be_are_refused_in_one_sentence(goals, said):
    with pytest.raises(NeurosymError, match=said):
        check_relations(msgspec.structs.replace(sorting(), relations=tuple(goals)), grounding())


def test_goal_on_the_table_and_relation_of_one_object_are_refused():
    with pytest.raises(InvalidValue, match="item-01 has a goal and a relation to item-03"):
        msgspec.structs.replace(tower(), goals={"item-01": (0.8, 0.0, 0.025)})


def test_domains_of_one_kind_refuse_problems_of_the_other():
    with pytest.raises(
        InvalidValue, match="and the domain toy has learned none; valid: a problem with goals"
    ):
        plan(tower(), toy_places.grounding())


def test_planner_that_knows_no_relations_names_those_that_do():
    with pytest.raises(InvalidValue, match=r"which counting does not take; valid: .*bfs.*fast-downward"):
        plan(tower(), grounding(), "counting")


def test_encodings_of_numbers_and_cells_are_refused_for_relations():
    with pytest.raises(InvalidValue, match="does not take the encoding 'numeric'; valid: sas, strips"):
        plan(tower(), grounding(), "fast-downward", encoding="numeric")


def test_relation_that_nothing_leads_to_is_a_result_with_its_reason():
    problem = msgspec.structs.replace(sorting(), relations=(("item-04", "item-03", REST),))
    result = plan(problem, grounding())
    assert result.status is PlanStatus.UNSOLVABLE
    assert result.reason.startswith("no operator brings item-04 to rests-on-001 with item-03")


def test_states_are_meant_by_the_beginning_of_one_name_only():
    table = grounding().relations
    assert table.state_meant("rests").name == REST
    with pytest.raises(InvalidValue, match="'b' may be any of several states; valid: below-011, beside-100"):
        table.state_meant("b")


def test_a_relation_that_is_asked_for_twice_is_asked_for_once():
    goal = ("item-01", "item-02", "rests")
    assert relations_meant((goal, goal), grounding()) == (("item-01", "item-02", REST),)


def test_code_of_a_pair_with_other_bits_than_were_learned_is_refused():
    problem = msgspec.structs.replace(tower(), pairs={"item-01 item-02": "1"})
    with pytest.raises(InvalidValue, match=r"the code '1' for 'item-01 item-02'; valid: 2 bits"):
        check_relations(problem, grounding())
