"""Verdicts: data sets that deserve each, remedies that help, and shipped domains that are not useless."""

import json
import re
from functools import cache

import msgspec
import numpy as np
import pytest
from command_line import neurosym
from places import DOCS, ROOT

from neurosym.data.interactions import Interactions
from neurosym.data.origin import box_of
from neurosym.files import read_json
from neurosym.grounding import Grounding
from neurosym.learning.training import TrainingReport, train
from neurosym.learning.training_config import (
    CodingConfig,
    DecoderConfig,
    DirectConfig,
    ModelConfig,
    NamingConfig,
    TeacherConfig,
    TrainingConfig,
)
from neurosym.operators import TOLERANCE, OperatorTable
from neurosym.pair_operators import PlaceOperators, RelationOperators
from neurosym.primitives.operator_search import average_operators
from neurosym.stages import verdicts as rules
from neurosym.stages.verdicts import (
    Tries,
    Verdict,
    judge_domain,
    judge_operators,
    judge_relations,
    judge_training,
    judge_tries,
    wilson,
    worst,
)
from neurosym.world import ActionBox

SHORT = TrainingConfig(
    teacher=TeacherConfig(DirectConfig(hidden=64), epochs=40),
    naming=NamingConfig(
        table_actions=600,
        table_objects=48,
        table_restarts=4,
        actions=8000,
        objects=1000,
        starts=2,
        steps=200,
        batch=512,
    ),
    coding=CodingConfig(actions=128, steps=300),
    decoder=DecoderConfig(imagined=10_000),
)
"""A training that learns what is easy, in some seconds."""
DOMAINS = ROOT / "domains"
THRESHOLDS = (
    *("USELESS_R2", "GOOD_R2", "LEAST_GAIN", "MOST", "FEW", "FEW_ROWS", "LEAST_TOLD", "FAR", "WIDEST"),
    *("ENOUGH_TASKS", "TOLERANCE", "MIN_TRIALS"),
)


def interactions(effects_of, rows: int = 1500, **origin: object) -> Interactions:
    """Draw objects of three features and actions of three parameters; two axes of effects follow."""
    rng = np.random.default_rng(0)
    features = rng.uniform(size=(rows, 3)).astype(np.float32)
    actions = rng.uniform(-1, 1, size=(rows, 3)).astype(np.float32)
    effects = effects_of(features, actions, rng).astype(np.float32)
    never, flat = np.zeros(rows, dtype=bool), np.zeros(rows, dtype=np.float32)
    return Interactions(features, actions, effects, effects, never, never, never, flat, origin)


def pushed(size: float, noise: float = 0.05):
    """Push by `size` in one of four directions, heavy objects by half of that."""

    def effects(features, actions, rng):
        far = np.where(features[:, :1] < 0.5, size, size / 2)
        return far * np.sign(actions[:, :2]) + rng.normal(0, noise * size, (len(actions), 2))

    return effects


def scattered(features, actions, rng):
    """Nothing tells what happens."""
    return rng.normal(0, 0.1, (len(actions), 2))


def steep(features, actions, rng):
    """Move by up to 1.0, and mostly by little: the case that every stage once let pass."""
    return np.sign(actions[:, :2]) * np.abs(actions[:, :2]) ** 4 * features[:, :1]


SETS = {
    "pushes": (interactions(pushed(0.2)), (2, 3)),
    "pushes in mm": (interactions(pushed(200.0)), (2, 3)),
    "few pushes": (interactions(pushed(0.2, noise=0.4), rows=60), (2, 3)),
    "noise": (interactions(scattered), (2, 3)),
    "effects up to 1.0": (interactions(steep), (2, 3)),
}
"""Data, and the bits of objects and actions that they are learned with."""


@cache
def learned(name: str) -> tuple[TrainingReport, OperatorTable]:
    """What training measures and distilling finds without a world."""
    data, (object_bits, action_bits) = SETS[name]
    trained = train(data, config=SHORT, model_config=ModelConfig(object_bits, action_bits, hidden=64), seed=0)
    box = ActionBox(*box_of(data.actions, data.origin))
    return trained.report, average_operators(
        trained.model, trained.direct.predict_outcomes, data, box, "own", seed=0
    )


@pytest.mark.parametrize(
    ("name", "bits", "bits_remedy", "operators", "operators_remedy"),
    [
        ("pushes", "good", "", "good", ""),
        ("pushes in mm", "weak", "give them in a larger unit", "useless", "give them in a larger unit"),
        (
            *("few pushes", "weak", "only 60 interactions; bring more, or name mirrors"),
            *("weak useless", "fewer than 5 rows of the data; bring more interactions"),
        ),
        (
            *("noise", "useless", "features and action parameters that decide what happens"),
            *("useless", "bring features that tell objects apart"),
        ),
        (
            *("effects up to 1.0", "weak", "0.05 is too strict for effects so large"),
            *("weak useless", "give them in a larger unit"),
        ),
    ],
)
def test_bits_are_judged_by_what_they_tell_and_operators_by_the_promises_that_they_keep(
    name, bits, bits_remedy, operators, operators_remedy
):
    report, table = learned(name)
    for verdict, levels, remedy in (
        (judge_training(report, SETS[name][0]), bits, bits_remedy),
        (judge_operators(table), operators, operators_remedy),
    ):
        assert verdict.level in levels.split(), verdict
        assert remedy in verdict.remedy, verdict
        assert bool(verdict.remedy) == (levels != "good")
        said, *reason = verdict.lines
        assert said.startswith(f"verdict: {verdict.level}: ")
        assert [line.partition(": ")[0] for line in reason] == ["likeliest reason"] * (levels != "good")


def test_table_without_operators_is_useless_and_a_category_that_none_moves_is_named():
    table = learned("pushes")[1]
    assert judge_operators(msgspec.structs.replace(table, operators=())).level == "useless"
    first = table.categories[0]
    left = tuple(one for one in table.operators if one.category != first.symbol)
    verdict = judge_operators(msgspec.structs.replace(table, operators=left))
    assert f"none of these moves {first.name} ({first.share:.0%} of objects)" in verdict.sentence


@pytest.mark.parametrize("name", ["tabletop", "tabletop-paper", "places", "towers"])
def test_shipped_domains_are_judged_good(name):
    folder = DOMAINS / name
    report = read_json(folder / "training.json", TrainingReport)
    data = Interactions.load(folder / "interactions.npz")
    assert judge_training(report, data).level == "good"
    assert judge_operators(OperatorTable.load(folder / "primitives.json")).level == "good"
    assert judge_domain(Grounding.load(folder / "grounding.json")).level == "good"


def test_shipped_carrying_and_relations_are_good_and_say_what_they_lack():
    places, relations = DOMAINS / "places" / "places", DOMAINS / "towers" / "relations"
    bits = [
        judge_training(
            read_json(one / "training.json", TrainingReport), Interactions.load(one / "interactions.npz")
        )
        for one in (places, relations)
    ]
    assert [one.level for one in bits] == ["good", "weak"]
    assert "bits lose most" in bits[1].remedy
    verdict = judge_operators(PlaceOperators.load(places / "operators.json").operators)
    assert verdict.level == "good"
    assert "none of these moves solid-low-10 (30% of objects)" in verdict.sentence
    table = RelationOperators.load(relations / "operators.json")
    assert judge_relations(table).level == "good"
    assert judge_relations(msgspec.structs.replace(table, operators=())).level == "useless"


def test_domain_without_operators_is_useless():
    grounding = Grounding.load(DOMAINS / "tabletop" / "grounding.json")
    seldom = tuple(msgspec.structs.replace(one, trials=1000) for one in grounding.operators.operators)
    table = msgspec.structs.replace(grounding.operators, operators=seldom)
    verdict = judge_domain(msgspec.structs.replace(grounding, operators=table))
    assert verdict.level == "useless"
    assert "the domain has 0 operators" in verdict.sentence


@pytest.mark.parametrize(
    ("reached", "of", "level"),
    [
        (3, 3, "unproven"),
        (0, 0, "unproven"),
        (10, 20, "unproven"),
        (85, 100, "good"),
        (40, 100, "weak"),
        (0, 6, "weak"),
        (0, 30, "useless"),
    ],
)
def test_tasks_are_judged_by_their_interval(reached, of, level):
    verdict = judge_tries({"bfs": Tries(reached, found=of, of=of)})
    assert verdict.level == level
    assert bool(verdict.remedy) == (level != "good")
    assert of in (0, 100) or ("nothing is proved by" in verdict.sentence) == (level == "unproven")


def test_planner_is_better_only_if_the_intervals_say_so():
    tries = {"bfs": Tries(30, 90, 100), "counting": Tries(80, 90, 100), "kairos": Tries(78, 90, 100)}
    sentence = judge_tries(tries, how="with replanning").sentence
    assert sentence.startswith("counting reached 80 of 100 tasks with replanning, 71% to 87% with 95%")
    assert sentence.endswith("; more than bfs; not proved to be more than kairos")


@pytest.mark.parametrize(
    ("found", "tolerance", "reason"),
    [
        (10, TOLERANCE, "most tasks have no plan"),
        (90, 0.02, "goals within 0.02 ask for more than operators promise"),
        (90, TOLERANCE, "plans are found and miss"),
    ],
)
def test_what_missed_tasks_lack_follows_from_what_became_of_them(found, tolerance, reason):
    assert reason in judge_tries({"bfs": Tries(5, found, 100)}, tolerance=tolerance).remedy


def test_wilson_interval_is_that_of_the_book():
    assert wilson(8, 10) == pytest.approx((0.4902, 0.9433), abs=1e-4)
    low, high = wilson(0, 20)
    assert (low, high) == (pytest.approx(0.0, abs=1e-12), pytest.approx(0.1611, abs=1e-4))
    assert wilson(20, 20)[1] == pytest.approx(1.0)


def test_the_document_has_each_rule_with_its_threshold():
    rows = re.findall(r"^\| `([A-Z_0-9]+)` \| ([\d.]+) \|", (DOCS / "learning.md").read_text(), re.MULTILINE)
    assert dict(rows) == {name: f"{getattr(rules, name):g}" for name in THRESHOLDS}
    named = {name for name, value in vars(rules).items() if name.isupper() and isinstance(value, int | float)}
    assert {*THRESHOLDS} == {name for name in named if not name.startswith("_")}


def test_the_whole_is_judged_by_what_is_worst_and_what_proves_nothing_does_not_count():
    good, weak, open_ = Verdict("good", "a"), Verdict("weak", "b", "c"), Verdict("unproven", "d", "e")
    assert worst([good, weak, open_]) == weak
    assert worst([weak, Verdict("weak", "later")]) == weak
    assert worst([good, open_]) == good


def test_commands_end_with_a_verdict(folder, capsys):
    def last_lines() -> list[str]:
        said = capsys.readouterr().out
        return said[said.rindex("verdict: ") :].splitlines()

    assert neurosym("compile-domain", folder) == 0
    lines = last_lines()
    assert lines[0].startswith(("verdict: good: ", "verdict: weak: "))
    assert lines[-1].startswith("next: ")
    assert len(lines) <= 5
    options = ("--tasks", 3, "--planners", "bfs-operators", "--workers", 1)
    assert neurosym("compare", folder, *options) == 0
    assert last_lines()[0].startswith("verdict: unproven: nothing is proved by")
    assert neurosym("compare", folder, *options, "--json") == 0
    verdict = json.loads(capsys.readouterr().out)["verdict"]
    assert verdict["level"] == "unproven"
    assert set(verdict) == {"level", "sentence", "remedy"}
    (folder / "world.toml").unlink()
    assert neurosym("distill", folder) == 0
    lines = last_lines()
    assert (lines[0][:9], lines[-1][:6]) == ("verdict: ", "next: ")
