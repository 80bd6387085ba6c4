"""A folder that nobody had to learn."""

from pathlib import Path

import pytest
import toy_domain


@pytest.fixture
def bare(tmp_path: Path) -> Path:
    """A folder with the toy world and a hand-written domain; no network, no problem."""
    place = tmp_path / "domain"
    place.mkdir()
    (place / "world.toml").write_text('world = "toy"\n')
    toy_domain.grounding().save(place / "grounding.json")
    return place
