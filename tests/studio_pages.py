"""Pages on the toy worlds and on the shipped domain, and waiting for what they hand to processes."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import toy_relations
from places import SHIPPED
from toy_domain import grounding, problem

from neurosym.pddl import domain_text
from neurosym.problems import Problem
from neurosym.stages.compilation import print_problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import DOMAIN
from neurosym.studio.desk import Library
from neurosym.studio.session import Session
from neurosym.studio.studio_workers import Workers
from tools.benchmarks.studio.browser import wait_for

__all__ = ["wait_for"]
AWAY = {"item-01": (0.6, 0.16, 0.025)}


def toy_library(path: Path, goals: dict[str, tuple[float, float, float]] = AWAY) -> Library:
    """The toy world with three operators that keep their promises, and a problem for it."""
    path.mkdir(exist_ok=True)
    (path / "world.toml").write_text('world = "toy"\n')
    (path / "problems").mkdir(exist_ok=True)
    grounding().save(path / "grounding.json")
    (path / DOMAIN).write_text(domain_text(grounding()))
    folder = DomainFolder(path)
    made = problem(goals)
    made.save(path / "problems" / f"{made.name}.scene.json")
    print_problem(folder, made, grounding())
    return Library(folder, path.name)


def relations_library(path: Path, *problems: Problem) -> Library:
    """The toy world whose objects stand on and in one another, and problems for it."""
    path.mkdir(exist_ok=True)
    (path / "world.toml").write_text('world = "toy-relations"\n')
    (path / "problems").mkdir(exist_ok=True)
    learned = toy_relations.grounding()
    learned.save(path / "grounding.json")
    (path / DOMAIN).write_text(domain_text(learned))
    for made in problems:
        made.save(path / "problems" / f"{made.name}.scene.json")
        print_problem(DomainFolder(path), made, learned)
    return Library(DomainFolder(path), path.name)


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


def planned(session: Session, planner: str) -> None:
    """Have a page plan, and wait for it."""
    session.plan(planner)
    wait_for(lambda: not session.is_planning and session.plans)


def ran(session: Session, **options: object) -> None:
    """Have a page run its plan at once, and wait for the end."""
    session.running.set_speed(0.0)
    session.running.begin(**options)
    wait_for(lambda: not session.running.is_active)
