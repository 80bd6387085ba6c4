"""Whether what the page is drawn with is installed; this module is imported without it."""

from neurosym.errors import NeurosymError

LEAST, BELOW = (1, 1), (2, 0)
"""The versions of viser that do: drags were dead in some before, and the next great one may differ."""
_REMEDY = "install it with: pip install 'neurosym-pddl[studio]'"


class StudioMissing(NeurosymError):
    """What draws the page is not installed, or in a version that will not do."""

    def __init__(self, found: str = ""):
        wrong = f"viser {found} will not do (valid: from 1.1, below 2)" if found else "viser is not installed"
        super().__init__(f"{wrong}; {_REMEDY}")


def check_extra() -> None:
    """Raise `StudioMissing` unless the page can be drawn."""
    from importlib.metadata import PackageNotFoundError, version  # takes longer than the rest of this

    try:
        found = version("viser")
    except PackageNotFoundError:
        raise StudioMissing from None
    numbers = tuple(int(part) for part in found.split(".")[:2] if part.isdigit())
    if not LEAST <= numbers < BELOW:
        raise StudioMissing(found)
