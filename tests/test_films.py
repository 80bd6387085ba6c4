"""The films of the documents: each shows a shipped run that reached its goal, and names its steps."""

import pytest
from places import ROOT

from neurosym.execution.record import Run
from neurosym.files import read_json
from tools.draw_films import FILMS, words

SAID = {
    "tabletop": ["lift item-04", "lift item-03", "lift item-05", "push right item-05"],
    "tabletop-paper": ["push forward right item-03", "pull right item-05", "push forward right item-05"],
    "row": [f"carry item-0{number} to its goal" for number in (4, 3, 2, 1)],
    "tower": ["item-02 rests on item-03", "item-04 rests on item-02", "item-01 rests on item-04"],
}


@pytest.mark.parametrize("name", FILMS)
def test_a_film_is_of_a_run_that_reached_its_goal_and_says_its_steps(name: str):
    domain, problem = FILMS[name]
    run = read_json(ROOT / "domains" / domain / "runs" / f"{problem}.fast-downward.run.json", Run)
    assert run.reached
    assert [words(record) for record in run.steps] == SAID[name]
    assert f"(images/{name}.gif)" in (ROOT / "docs" / "index.md").read_text()
