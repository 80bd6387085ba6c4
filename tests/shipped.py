"""`domains/tabletop` as it is shipped; tests must not change it."""

from places import SHIPPED

from neurosym.grounding import Grounding
from neurosym.stages.folder import DomainFolder

FOLDER = DomainFolder(SHIPPED)
GROUNDING = Grounding.load(FOLDER / "grounding.json")
