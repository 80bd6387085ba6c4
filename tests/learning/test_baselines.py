"""Trivial predictors say the same of everything, axis by axis."""

import numpy as np
import pytest

from neurosym.learning.training import trivial_predictions


def test_each_axis_has_a_mean_and_a_median_of_its_own():
    seen = np.array([[0.0, 10.0], [1.0, 10.0], [8.0, 40.0]])
    found = trivial_predictions(seen, 2)
    assert list(found) == ["always zero", "always mean", "per-axis median"]
    assert found["always zero"].tolist() == [[0.0, 0.0]] * 2
    assert found["always mean"].tolist() == [pytest.approx([3.0, 20.0])] * 2
    assert found["per-axis median"].tolist() == [[1.0, 10.0]] * 2
