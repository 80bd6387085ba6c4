"""PyBullet, imported without the build time that its C code prints to standard error on every import.

The rest of this folder takes it from here, so that sizes and shapes can be asked for without it.
"""

import os

_saved, _nowhere = os.dup(2), os.open(os.devnull, os.O_WRONLY)
try:
    os.dup2(_nowhere, 2)
    import pybullet
finally:
    os.dup2(_saved, 2)
    os.close(_saved)
    os.close(_nowhere)

__all__ = ["pybullet"]
