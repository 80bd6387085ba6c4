"""What fitting came to is kept beside a grounding, changes nothing, and is believed of no other grounding."""

import json
import os
from pathlib import Path

import pytest
from rehearsed import grounding, item

from neurosym import grounding as module
from neurosym import regression
from neurosym.choices import DOMAINS, shipped_domain
from neurosym.grounding import Grounding
from neurosym.regression import NAME, save_fits
from neurosym.tasks import promises
from neurosym.tasks.promises import fits_of, promised

BLOCK = item("item-01", 0.45, 0.0, 0.05)


@pytest.fixture
def sought(monkeypatch) -> list[int]:
    """One entry for each fit for which it was sought what decides."""
    times: list[int] = []
    deciding = regression._deciding

    def counted(*given):
        times.append(1)
        return deciding(*given)

    monkeypatch.setattr(regression, "_deciding", counted)
    return times


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """A grounding with what fitting it came to beside it."""
    path = tmp_path / "grounding.json"
    grounding().save(path)
    save_fits(path, fits_of(grounding()))
    return path


def told(path: Path) -> str:
    """What operators of a grounding promise for an object, read and fitted anew."""
    promises._regression.cache_clear()
    promises.refined.cache_clear()
    promises._promised.cache_clear()
    module._decoded.cache_clear()
    return repr(dict(promised(Grounding.load(path), BLOCK)))


def test_what_is_kept_is_not_sought_again_and_promises_the_same(path, sought):
    with_fits = told(path)
    assert not sought
    path.with_name(NAME).unlink()
    assert told(path) == with_fits
    assert sought


@pytest.mark.parametrize(
    "damage",
    [
        lambda _: "",
        lambda _: "[" * 100_000,
        lambda fits: json.dumps({**fits, "format": "neurosym-fits-9"}),
        lambda fits: json.dumps({**fits, "grounding": "0" * 64}),
        lambda fits: json.dumps({**fits, "choices": {name: [1.5] for name in fits["choices"]}}),
        lambda fits: json.dumps(
            {**fits, "choices": {name: [1e300, -1.0, [7.0], 10**9] for name in fits["choices"]}}
        ),
        None,
    ],
)
def test_what_is_damaged_foreign_impossible_or_no_file_is_passed_over(path, sought, damage):
    whole = told(path)
    file = path.with_name(NAME)
    if damage:
        file.write_text(damage(json.loads(file.read_text())))
    else:
        file.unlink()
        os.mkfifo(file)
    assert told(path) == whole
    assert sought


@pytest.mark.parametrize("name", DOMAINS)
def test_shipped_domains_keep_what_fitting_came_to(name, sought, tmp_path):
    path = shipped_domain(name) / "grounding.json"
    learned = Grounding.load(path)
    promises._regression.cache_clear()
    found = fits_of(learned)
    assert found
    assert not sought
    save_fits(_copied(path, tmp_path), found)
    assert (tmp_path / NAME).read_bytes() == path.with_name(NAME).read_bytes()


def _copied(path: Path, folder: Path) -> Path:
    (folder / path.name).write_bytes(path.read_bytes())
    return folder / path.name
