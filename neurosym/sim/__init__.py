"""The PyBullet world; nothing outside this folder imports PyBullet."""

import os


def _import_pybullet_quietly() -> None:
    """Import PyBullet without the build time that its C code prints to standard error on every import."""
    saved, nowhere = os.dup(2), os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nowhere, 2)
        import pybullet  # noqa: F401
    finally:
        os.dup2(saved, 2)
        os.close(saved)
        os.close(nowhere)


_import_pybullet_quietly()
