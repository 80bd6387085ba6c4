"""Puts the shipped domains into the wheel, without the plans, runs and pictures that users make anew."""

from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

MADE_AGAIN = {"plans", "runs", "pictures"}


class ShippedDomains(BuildHookInterface):
    """Adds `domains/NAME` as `neurosym/shipped_domains/NAME`."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Say which files are added; an editable installation finds them where they lie.

        Args:
            version: What kind of wheel is built.
            build_data: What hatchling is told.
        """
        if version == "editable":
            return
        domains = Path(self.root) / "domains"
        for path in sorted(domains.rglob("*")):
            part = path.relative_to(domains)
            if path.is_file() and part.parts[1] not in MADE_AGAIN:
                build_data["force_include"][str(path)] = f"neurosym/shipped_domains/{part.as_posix()}"
