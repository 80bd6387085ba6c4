"""The folder that a page works in: it looks like the domain's, whose own files stay as they are."""

import shutil
import tempfile
from pathlib import Path

from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import INTERACTIONS, PLANS, PROBLEMS, RUNS

_LEFT_OUT = (INTERACTIONS, "pictures", "comparison", "report.html")
_OWN = (PROBLEMS, PLANS, RUNS)


class Room:
    """A folder of one's own with links to the files of a domain.

    Stages replace whole files, so that a link gives way to a file and what it led to stays as it is.

    Args:
        folder: The domain folder.

    Attributes:
        path: Where it is.
    """

    def __init__(self, folder: DomainFolder):
        self.path = Path(tempfile.mkdtemp(prefix="neurosym-studio-"))
        for source in sorted(folder.path.iterdir()):
            if source.name in _OWN:
                (self.path / source.name).mkdir()
                for file in sorted(source.iterdir()):
                    if file.is_file():
                        (self.path / source.name / file.name).symlink_to(file.resolve())
            elif source.name not in _LEFT_OUT and not source.name.startswith("."):
                (self.path / source.name).symlink_to(source.resolve())

    def close(self) -> None:
        """Remove the folder."""
        shutil.rmtree(self.path, ignore_errors=True)
