"""Verdicts: figures that deserve each, remedies that help, and shipped domains that are not useless."""

import json
import re
from pathlib import Path

import msgspec
import numpy as np
import pytest
from command_line import neurosym
from places import DOCS, ROOT

from neurosym.data.interactions import Interactions
from neurosym.data.origin import _OF_EXPLORATION
from neurosym.files import read_json
from neurosym.formats import PairFile, PlaceFile
from neurosym.grounding import Grounding
from neurosym.learning.training_report import TrainingReport
from neurosym.operators import Category, Mode, Operator, OperatorTable, Primitive
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

DOMAINS = ROOT / "domains"


def data(rows: int = 1000, **origin: object) -> Interactions:
    """A data set of so many rows, in which nothing happens."""
    still, never = np.zeros((rows, 2), dtype=np.float32), np.zeros(rows, dtype=bool)
    return Interactions(still, still, still, still, never, never, never, still[:, 0], origin)


def report(r2: float, direct: float, error: float, **changes: object) -> TrainingReport:
    """A model with such an R2 through its bits, without them, and such an error on each of two axes."""
    mae = {"model": [error, error], "always zero": [0.04, 0.04]}
    fitted = TrainingReport(100, r2, (r2, r2), r2, (r2, r2), direct, (direct, direct), None, mae, {}, {})
    return msgspec.structs.replace(fitted, **changes)


EMPTY = {"empty_action_codes": ("11",)}
LARGE = report(0.9, 0.9, 0.0, mae={"model": [0.2, 0.01], "always zero": [0.6, 0.6]})


@pytest.mark.parametrize(
    ("figures", "of", "level", "remedy"),
    [
        (report(0.3, 0.9, 0.03), data(), "good", ""),
        (report(0.29, 0.9, 0.03), data(), "weak", "bits lose most of a network without bits (R2 0.90); use"),
        (report(0.09, 0.9, 0.03), data(), "useless", "--action-bits, --object-bits"),
        (report(0.2, 0.9, 0.03, **EMPTY), data(), "weak", "take another --seed"),
        (report(0.2, 0.9, 0.03, **EMPTY), data(reference="place"), "weak", "bring more, or name mirrors"),
        (report(0.9, 0.9, 0.0381), data(), "weak", "little happens, or it scatters; bring more, or name"),
        (report(0.9, 0.9, 0.0379), data(), "good", ""),
        (report(0.2, 0.3, 0.03), data(499), "weak", "only 499 interactions; bring more, or name mirrors"),
        (report(0.2, 0.29, 0.03), data(500), "weak", "and action parameters that decide what happens"),
        (report(0.2, 0.2, 0.03), data(mirrors=[{}]), "weak", "or bring more"),
        (LARGE, data(), "good", ""),
        (LARGE, data(**dict.fromkeys(_OF_EXPLORATION, "")), "weak", "within a larger --tolerance"),
        (LARGE, data(reference="place"), "good", ""),
    ],
)
def test_bits_are_judged_by_what_they_tell(figures, of, level, remedy):
    verdict = judge_training(figures, of)
    assert verdict.level == level, verdict
    assert remedy in verdict.remedy
    assert ("mirrors" in verdict.remedy) <= ("mirrors" not in of.origin)
    said, *reason = verdict.lines
    assert said.startswith(f"verdict: {level}: R2 {figures.r2_through_codes:.2f} through the bits, errors ")
    assert [line.partition(": ")[0] for line in reason] == ["likeliest reason"] * (level != "good")


def table(
    *operators: tuple[str, int, int, float, float], measured: str = "rehearsal", share: float = 0.5
) -> OperatorTable:
    """Categories 0 and 1, and operators: category, trials, how many went well, effect and spread."""
    shares = {"0": share, "1": 1 - share}
    categories = tuple(Category(code, f"kind-{code}", shares[code], (0.1,), (0.0,)) for code in shares)
    made = []
    for number, (category, trials, near, effect, spread) in enumerate(operators):
        moved, off = (effect, 0.0, 0.0), (spread, 0.0, 0.0)
        mode = Mode("resting", trials, 1.0, moved, off, moved, off, 0.0, near)
        made.append(Operator(f"push-{number}", category, "0", trials, (mode,)))
    return OperatorTable(categories, (Primitive("0", (0.0,), 0.0),), tuple(made), measured=measured)


SURE, IDLE, UNSURE = ("0", 10, 5, 0.2, 0.0), ("1", 10, 10, 0.04, 0.0), ("1", 10, 4, 0.2, 0.1)
RARE, FAR = ("0", 4, 4, 0.2, 0.0), ("0", 10, 4, 0.51, 0.1)


@pytest.mark.parametrize(
    ("found", "level", "remedy"),
    [
        (table(SURE, UNSURE), "good", ""),  # half of them, for half of the objects
        (table(SURE, UNSURE, UNSURE), "weak", "what has one symbol ends differently; use more bits"),
        (table(*[UNSURE] * 5, SURE), "useless", "what has one symbol ends differently"),
        (table(), "useless", "what happens scatters"),
        (table(("0", 10, 10, 0.02, 0.2)), "useless", "decide what happens and tell objects apart"),
        (table(RARE, RARE), "useless", "most have fewer than 5 rehearsals; bring more interactions"),
        (table(RARE, measured="data"), "useless", "rows of the data; bring more interactions"),
        (table(FAR, measured="data"), "useless", "and within 0.05 counts as promised; give them in a larger"),
        (table(FAR), "useless", "what has one symbol ends differently"),
        (table(IDLE), "useless", "no effect is large, and all within 0.05"),
        (table(IDLE, ("0", 10, 10, 0.051, 0.0)), "good", ""),
    ],
)
def test_operators_are_judged_by_the_promises_that_they_keep(found, level, remedy):
    verdict = judge_operators(found)
    assert verdict.level == level, verdict
    assert remedy in verdict.remedy
    assert bool(verdict.remedy) == (level != "good")


def test_what_no_operator_moves_is_named_and_counts_if_it_is_most():
    verdict = judge_operators(table(SURE, IDLE))
    assert verdict.level == "good"
    assert verdict.sentence.endswith("none of these moves kind-1 (50% of objects)")
    verdict = judge_operators(table(SURE, IDLE, share=0.4))
    assert verdict.level == "weak"
    assert "what moves these objects was not found" in verdict.remedy
    assert judge_operators(table(SURE), usable=()).level == "useless"


def bits_of(folder: Path) -> Verdict:
    """Judge the bits of a shipped domain, of what carries, or of relations."""
    figures = read_json(folder / "training.json", TrainingReport)
    return judge_training(figures, Interactions.load(folder / "interactions.npz"))


@pytest.mark.parametrize("name", ["tabletop", "tabletop-paper", "places", "towers", "camera"])
def test_shipped_domains_are_judged_good(name):
    folder = DOMAINS / name
    assert bits_of(folder).level == "good"
    assert judge_operators(OperatorTable.load(folder / "primitives.json")).level == "good"
    assert judge_domain(Grounding.load(folder / "grounding.json")).level == "good"


def test_shipped_carrying_and_relations_are_good_and_say_what_they_lack():
    places, relations = DOMAINS / "places" / "places", DOMAINS / "towers" / "relations"
    assert bits_of(places).level == "good"
    assert bits_of(relations).level == "weak"
    assert "bits lose most" in bits_of(relations).remedy
    verdict = judge_operators(PlaceFile.load(places / "operators.json").table())
    assert verdict.level == "good"
    assert "none of these moves solid-low-10 (30% of objects)" in verdict.sentence
    pairs = PairFile.load(relations / "operators.json").table()
    assert judge_relations(pairs).level == "good"
    assert judge_relations(msgspec.structs.replace(pairs, operators=())).level == "useless"


@pytest.mark.parametrize(
    ("reached", "of", "level"),
    [
        *((3, 3, "unproven"), (0, 0, "unproven"), (10, 20, "unproven"), (85, 100, "good")),
        *((40, 100, "weak"), (0, 6, "weak"), (0, 30, "useless")),
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


def test_wilson_interval_is_that_of_the_book():
    assert wilson(8, 10) == pytest.approx((0.4902, 0.9433), abs=1e-4)
    assert wilson(0, 20) == pytest.approx((0.0, 0.1611), abs=1e-4)
    assert wilson(20, 20)[1] == pytest.approx(1.0)


def test_the_document_has_each_rule_with_its_threshold():
    rows = re.findall(r"^\| `([A-Z_0-9]+)` \| ([\d.]+) \|", (DOCS / "learning.md").read_text(), re.MULTILINE)
    named = {name: value for name, value in vars(rules).items() if re.fullmatch("[A-Z][A-Z_0-9]+", name)}
    thresholds = {name: value for name, value in named.items() if isinstance(value, int | float)}
    assert dict(rows) == {name: f"{value:g}" for name, value in thresholds.items()}


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
    options = ("--tasks", 1, "--planners", "bfs-operators", "--workers", 1)
    assert neurosym("compare", folder, *options) == 0
    assert last_lines()[0].startswith("verdict: unproven: nothing is proved by")
    assert neurosym("compare", folder, *options, "--json") == 0
    verdict = json.loads(capsys.readouterr().out)["verdict"]
    assert (verdict["level"], set(verdict)) == ("unproven", {"level", "sentence", "remedy"})
