"""A run that a command shows, written as a page whose view can be turned."""

import rich

from neurosym.execution.record import Run
from neurosym.stages.folder import DomainFolder
from neurosym.stages.planning import load_problem


class Filmed:
    """Looks on at a run, and makes a page of what was seen.

    Args:
        domain: The domain folder.

    Attributes:
        onlooker: Who looks on.
    """

    def __init__(self, domain: DomainFolder):
        from neurosym.studio.library import Library
        from neurosym.studio.messages import Controls
        from neurosym.studio.onlooker import Onlooker
        from neurosym.studio.recording import Reel

        self._library, self._reel = Library(domain, domain.path.name), Reel()
        self.onlooker = Onlooker(self._reel, Controls(speed=0.0), pace=0.0)

    def page(self, run: Run) -> bytes:
        """Return the page as HTML; a run without a step has none."""
        from neurosym.studio.recording import film_of

        if not self._reel.seen:
            return b""
        rich.get_console().quiet = True  # on which the server of pages announces itself
        problem = load_problem(self._library.folder, run.problem).within(run.tolerance)
        return film_of(self._library, problem, self._reel.seen, run.steps)
