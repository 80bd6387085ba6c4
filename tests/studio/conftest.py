"""Processes that plan and that run for all pages of the tests."""

import pytest
from studio_pages import workers


@pytest.fixture(scope="session")
def both():
    with workers() as started:
        yield started
