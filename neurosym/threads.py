"""In how many threads small matrices are computed: in one.

Several would wait for one another much longer than they compute: 356 decompositions of matrices of a hundred
rows took 5.2 s of CPU on two threads, and 0.08 s on one.
"""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from threadpoolctl import ThreadpoolController

_VARIABLE = "OPENBLAS_NUM_THREADS"  # of what numpy computes with; networks compute with something else


def compute_in_one_thread() -> None:
    """Have numpy compute in one thread, in this process and those it starts, unless the user says how many.

    It is said before numpy is imported, which takes half the time then.
    """
    os.environ.setdefault(_VARIABLE, "1")


@contextmanager
def one_thread() -> Iterator[None]:
    """Have numpy compute in one thread meanwhile, however it was imported."""
    if os.environ.get(_VARIABLE) == "1":
        yield
        return
    with _controller().limit(limits=1, user_api="blas"):
        yield


@cache
def _controller() -> "ThreadpoolController":
    from threadpoolctl import ThreadpoolController

    return ThreadpoolController()
