"""Objects of each category are the first of the world's draws that fall into it."""

import numpy as np

from neurosym.primitives.sampling import MOST_DRAWS, draw_scene, sample_by_category
from neurosym.worlds.toy import make_world


def by_width(share):
    """Say of objects whether they are among the narrowest share of all."""
    limit = 0.03 + 0.15 * share
    return lambda features: tuple(str(int(narrow)) for narrow in features[:, 0] < limit)


def drawn(count):
    return np.concatenate([draw_scene(make_world(), 3, 7, number).features for number in range(count)])


def sample(categorise, **options):
    return sample_by_category(make_world(), categorise, seed=3, stream=7, **options)


def test_rare_categories_have_as_many_objects_as_asked_for_and_common_ones_what_is_typical():
    found = sample(by_width(0.1), least=12, typical=40)
    everything, symbols = drawn(600), by_width(0.1)(drawn(600))
    counts = {symbol: max(12, symbols[:40].count(symbol)) for symbol in "01"}
    assert {symbol: len(scenes) for symbol, scenes in found.scenes.items()} == counts
    for symbol, scenes in found.scenes.items():
        first = [row for row, its in zip(everything, symbols, strict=True) if its == symbol]
        assert np.array_equal([scene.features[0] for scene in scenes], first[: counts[symbol]])


def test_a_category_too_rare_has_what_was_found():
    found = sample(by_width(0.008), least=9)
    symbols = by_width(0.008)(drawn(MOST_DRAWS * 9))
    assert 0 < symbols.count("1") < 9
    assert len(found.scenes["1"]) == symbols.count("1")
    assert found.shares["1"] == symbols.count("1") / len(symbols)


def test_shares_are_those_of_the_world():
    assert abs(sample(by_width(0.3), least=60).shares["1"] - 0.3) < 0.1
    assert sum(sample(by_width(0.3), least=60).shares.values()) == 1.0


def test_more_of_the_common_does_not_change_the_first():
    few, many = (sample(by_width(0.3), least=least).scenes["0"] for least in (4, 9))
    assert all(np.array_equal(a.features, b.features) for a, b in zip(few, many, strict=False))
