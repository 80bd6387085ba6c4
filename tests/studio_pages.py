"""Pages on the toy worlds and on the shipped domain, and waiting for what they hand to processes."""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
import toy_relations
import viser
from places import SHIPPED
from toy_domain import grounding, problem

from neurosym.grounding import Grounding
from neurosym.pddl import domain_text
from neurosym.problems import Problem
from neurosym.stages.compilation import print_problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import DOMAIN
from neurosym.studio.library import Library
from neurosym.studio.page import Page
from neurosym.studio.server import PANELS
from neurosym.studio.session import Session
from neurosym.studio.studio_workers import Workers
from tools.benchmarks.studio.browser import BROWSERS, browser_here, wait_for

__all__ = ["wait_for"]
AWAY = {"item-01": (0.6, 0.16, 0.025)}


def _library(path: Path, world: str, learned: Grounding, problems: Iterable[Problem]) -> Library:
    path.mkdir(exist_ok=True)
    (path / "world.toml").write_text(f'world = "{world}"\n')
    (path / "problems").mkdir(exist_ok=True)
    learned.save(path / "grounding.json")
    (path / DOMAIN).write_text(domain_text(learned))
    for made in problems:
        made.save(path / "problems" / f"{made.name}.scene.json")
        print_problem(DomainFolder(path), made, learned)
    return Library(DomainFolder(path), path.name)


def toy_library(path: Path, goals: dict[str, tuple[float, float, float]] = AWAY) -> Library:
    """The toy world with three operators that keep their promises, and a problem for it."""
    return _library(path, "toy", grounding(), [problem(goals)])


def relations_library(path: Path, *problems: Problem) -> Library:
    """The toy world whose objects stand on and in one another, and problems for it."""
    return _library(path, "toy-relations", toy_relations.grounding(), problems)


def shipped_library(path: Path = SHIPPED) -> Library:
    """A shipped domain, as it is looked at without a folder of one's own."""
    return Library(DomainFolder(path), path.name, is_shipped=True)


@contextmanager
def workers() -> Iterator[tuple[Workers, Workers]]:
    """Processes that plan and that run, one each."""
    both = Workers(1), Workers(1)
    try:
        yield both
    finally:
        for one in both:
            one.close()


@contextmanager
def session_on(library: Library, both: tuple[Workers, Workers]) -> Iterator[Session]:
    """A page without a browser."""
    session = Session(library, *both)
    try:
        yield session
    finally:
        session.close()


@contextmanager
def page_on(session: Session) -> Iterator[Page]:
    """A page that nobody looks at."""
    server = viser.ViserServer("127.0.0.1", 0, verbose=False)
    page = Page(server, session, PANELS)
    try:
        yield page
    finally:
        page.close()
        server.stop()


def planned(session: Session, planner: str) -> None:
    """Have a page plan, and wait for it."""
    session.plan(planner)
    wait_for(lambda: not session.planning and session.plans)


def ran(session: Session, **options: object) -> None:
    """Have a page run its plan at once, and wait for the end."""
    session.running.steer(speed=0.0)
    session.running.begin(**options)
    wait_for(lambda: not session.running.is_active)


@contextmanager
def chromium(*flags: str) -> Iterator[Any]:
    """A browser of this machine without a window; the test is skipped where there is none."""
    playwright = pytest.importorskip("playwright.sync_api", reason="pip install 'neurosym-pddl[browser]'")
    found = browser_here()
    if found is None:
        pytest.skip(f"none of {', '.join(BROWSERS)} is installed")
    with playwright.sync_playwright() as running:
        opened = running.chromium.launch(executable_path=found, args=["--no-sandbox", *flags])
        yield opened
        opened.close()
