"""What users choose among by name, and what is taken where they do not say.

It imports next to nothing, so that a command line is read without what it is about.
"""

from typing import Literal

TOLERANCE = 0.05
"""How near an object must come to its goal, and an outcome to its promise [m] (section III-E)."""
CELL = 0.005
"""Edge of a grid cell unless the user says otherwise [m]."""
StrategyName = Literal["disagreement", "entropy", "curiosity", "random", "active"]
"""A way to explore; see `strategies`."""
DEFAULT_STRATEGY: StrategyName = "disagreement"
TaskKind = Literal["anywhere", "swap", "row", "crowded"]
"""What a task asks for; see `draw_task`."""
RelationTask = Literal["tower", "boxes", "unstack", "exchange", "like"]
"""What a task of relations asks for; see `draw_relation_task`."""
AnyTask = TaskKind | RelationTask
"""What a task may ask for."""
DrawnTask = Literal["anywhere", "swap", "row", "crowded", "tower", "boxes", "unstack", "exchange"]
"""What a task may ask for that needs no other scene."""
