"""Who watches a run: asked before every step whether to move an object, or to end the run there."""

from dataclasses import dataclass
from typing import Literal, Protocol

from neurosym.execution.record import Nudge, Replanning
from neurosym.tasks.steps import PlanStep
from neurosym.world import Scene

Answer = Nudge | Literal["stop"] | None
"""What a watcher wants before a step: an object moved, the run ended, or nothing."""
STOP: Literal["stop"] = "stop"
"""Ends a run before its next step."""


@dataclass(frozen=True, slots=True, eq=False)
class Moment:
    """A run between two steps.

    Attributes:
        number: Number of the step that is to be next, counted from 1.
        scene: Where everything is, at rest.
        left: What is left of the plan, the next step first.
    """

    number: int
    scene: Scene
    left: tuple[PlanStep, ...]


class Watcher(Protocol):
    """Watches a run while it goes on. Who only watches changes nothing, down to the bytes of the record."""

    def before_step(self, moment: Moment) -> Answer:
        """Say what shall happen before a step; asked again after each nudge, until nothing is wanted.

        A plan that is at its end is asked for once more, since a nudge may call for a new one.
        """
        ...

    def replanned(self, replanning: Replanning) -> None:
        """Hear of a new plan, or that there is none, and why the old one would not do."""
        ...
