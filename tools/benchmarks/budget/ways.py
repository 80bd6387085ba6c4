"""Ways to spend a budget, after how many interactions each is tried, and on what."""

from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from typing import Any, NamedTuple
from unittest.mock import patch

from neurosym.primitives import audition, bandit
from neurosym.stages import rounds
from neurosym.stages.learning import Held


class Cell(NamedTuple):
    """What is tried: tasks of a size, within a tolerance [m], and in which engine if another one taught."""

    name: str
    objects: int
    count: int
    tolerance: float = 0.05
    engine: str = ""


@dataclass(frozen=True)
class Way:
    """A way to spend a budget.

    Attributes:
        about: What it is, in words.
        points: What is tried after how many interactions.
        options: Of `run`, where they are unusual.
        without: Which part of the loop is left out: `teaching`, `prior`, `weighing` or `stopping`.
    """

    about: str
    points: Mapping[int, tuple[Cell, ...]]
    options: Mapping[str, Any] = field(default_factory=dict)
    without: str = ""


STAGES, TOWERS, FAR = "stages", "tower of 3", (1, 2, 4)
_DRAWN = Cell("single", 1, 50), Cell("double", 2, 50)
_PRECISE = Cell("20mm-single", 1, 30, 0.02), Cell("20mm-double", 2, 30, 0.02)
_FAR = tuple(Cell(f"far-{n}", n, 20) for n in FAR)
_TOWERS = (Cell(TOWERS, 3, 20),)
_CURVE = {1000: _DRAWN, 2000: _DRAWN + _PRECISE, 4000: _DRAWN, 8000: _DRAWN + _PRECISE, 16_000: _DRAWN}
_MIDDLE = {2000: _DRAWN, 6000: _DRAWN}
_IN_MUJOCO, _IN_PYBULLET = (
    tuple(Cell(f"{engine}-{name}", n, count, near, engine) for name, n, count, near, _ in _DRAWN)
    for engine in ("mujoco", "pybullet")
)
WAYS: Mapping[str, Way] = {
    "one-budget": Way(
        "in rounds, what explores is curious by disagreement", _CURVE | {6000: _DRAWN + _PRECISE + _IN_MUJOCO}
    ),
    "random": Way("what explores is random", _CURVE, {"strategy": "random"}),
    "entropy": Way("what explores is curious by entropy (Algorithm 1)", _CURVE, {"strategy": "entropy"}),
    STAGES: Way(
        "one stage after another: all that rehearsing leaves is explored, and a network chooses",
        {total: _CURVE[total] for total in (2000, 4000, 8000)},
    ),
    "with-places": Way("places are learned, too", {5000: _FAR, 10_000: _FAR + _DRAWN}, {"places": None}),
    "with-relations": Way(
        "places and pairs are learned, too",
        {8000: _TOWERS},
        {"places": None, "relations": 1024},
    ),
    "mujoco": Way("as one budget, simulated by MuJoCo", {6000: _DRAWN + _IN_PYBULLET}, {"engine": "mujoco"}),
    "no-teaching": Way(
        "the network learns from nothing that was performed to choose", _MIDDLE, {}, "teaching"
    ),
    "no-prior": Way("what is predicted of candidates counts for nothing", _MIDDLE, {}, "prior"),
    "evenly": Way("every candidate performs as often as any other", _MIDDLE, {}, "weighing"),
    "no-stopping": Way("candidates perform whatever little they gain", _MIDDLE, {}, "stopping"),
}


def domain_name(way: str, seed: int, total: int) -> str:
    """Name what was learned in a way from so many interactions."""
    return f"{way}-{seed}-{total}"


@contextmanager
def left_out(part: str) -> Iterator[None]:
    """Leave out a part of the loop, in this process alone."""
    train = rounds.train_stage

    def untaught(*given: Any, held: Held, **options: Any) -> Any:
        return train(*given, held=Held(0, held.bits), **options)

    def evenly(arm: Any) -> float:
        return 1 / (1 + arm.count) if arm.count + bandit.AT_ONCE <= len(arm.contest.scenes) else 0.0

    parts: dict[str, list[Any]] = {
        "": [],
        "teaching": [patch.object(rounds, "train_stage", untaught)],
        "prior": [patch.object(bandit.Contest, "counts", property(lambda _: 1e-3, lambda *_: None))],
        "weighing": [patch.object(bandit._Arm, "gain", property(evenly))],
        "stopping": [patch.object(audition, "LEAST_GAIN", 0.0)],
    }
    with ExitStack() as stack:
        for each in parts[part]:
            stack.enter_context(each)
        yield
