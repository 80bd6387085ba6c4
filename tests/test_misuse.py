"""Plausible mistakes with the Python API are refused with our own errors, which say what would be valid."""

import json
import subprocess
import sys
from pathlib import Path

import misuse
import pytest

import neurosym


@pytest.fixture(scope="module")
def outcomes():
    """What came of each mistake, without the checks of types that tests have."""
    ended = subprocess.run([sys.executable, misuse.__file__], capture_output=True, text=True)
    assert ended.returncode == 0, ended.stderr
    return json.loads(ended.stdout)


def test_there_are_mistakes_with_every_name_that_can_be_used_wrongly(outcomes):
    assert len(misuse.CALLS) == len(outcomes) >= 150
    source = Path(misuse.__file__).read_text()
    values = {
        *("__version__", "NeurosymError", "Run", "Trained", "Rehearsals", "PlannerAnswer", "PlanResult"),
        *("PlanStatus", "Outcome", "World", "Scene"),
    }
    assert [name for name in neurosym.__all__ if f"ns.{name}" not in source and name not in values] == []


@pytest.mark.parametrize(
    "number", range(len(misuse.CALLS)), ids=lambda number: f"{number}-{misuse.CALLS[number][2]}"
)
def test_mistake_is_refused_in_one_sentence(outcomes, number):
    label, _, error, words = misuse.CALLS[number]
    kinds, said = outcomes[number]
    assert error in kinds, (label, kinds, said)
    assert "NeurosymError" in kinds
    assert words in said
    assert "\n" not in said
    assert said.endswith(".")
