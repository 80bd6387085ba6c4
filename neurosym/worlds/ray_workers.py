"""Performing interactions on a Ray cluster, in order, whatever its size and whichever of its nodes die.

A world is a function without memory, so an interaction whose node died is performed again elsewhere, with the
same result. Ray is an extra (`pip install 'neurosym-pddl[ray]'`), imported only when a cluster is asked for.
"""

import logging
import os
import pickle
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

from neurosym.distribution import version_of
from neurosym.errors import InvalidValue, NeurosymError
from neurosym.guarded import made
from neurosym.world import Outcome, World, WorldFactory
from neurosym.worlds.aimed import AimedFactory
from neurosym.worlds.hosted import OwnFactory
from neurosym.worlds.pool import WorkerDied
from neurosym.worlds.workers import AHEAD, Perform, in_order, perform_task

AUTO = "auto"
_PATIENCE = 20.0  # for a cluster to answer [s]; left alone, Ray tries for minutes
_RETRIES = 12  # of one interaction; so many deaths are its own doing
_SAME_EVERYWHERE = ("neurosym", "numpy", "pybullet")


class RayMissing(NeurosymError):
    """A cluster was asked for where Ray is not installed."""

    def __init__(self) -> None:
        super().__init__("Ray is not installed; install it with: pip install 'neurosym-pddl[ray]'")


class NoCluster(NeurosymError):
    """No Ray cluster could be reached."""

    def __init__(self, address: str, problem: str):
        super().__init__(
            f"No Ray cluster for --ray {address} ({problem}); start one with "
            "`ray start --head`, and let other machines join with `ray start --address=HOST:6379`."
        )


class OtherVersion(NeurosymError):
    """A node of the cluster has another version of what decides the result."""

    def __init__(self, node: str, package: str, found: str, wanted: str):
        super().__init__(
            f"The Ray node {node} has {package} {found}; install {package} {wanted} there, as it is here."
        )


@contextmanager
def ray_crew(world_factory: WorldFactory, address: str) -> Iterator[Perform]:
    """Connect to a Ray cluster; yields the function that has tasks performed and gives outcomes in order.

    Args:
        world_factory: Builds a world, once in each worker process; must survive pickling.
        address: `auto` for the cluster that this machine belongs to, or its HOST:PORT.

    Raises:
        RayMissing: If Ray is not installed.
        InvalidValue: If the address is neither, or this process has a cluster already.
        NoCluster: If none answers, or none of its nodes has a CPU.
        WorkerDied: From the outcomes, if an interaction ends every process that tries it.
        OtherVersion: From the outcomes, if a node would give other results.
    """
    _check_address(address)
    ray = _connect(address)
    try:
        if _cpus(ray) == 0:
            raise NoCluster(address, "none of its nodes has a CPU")
        perform_there = ray.remote(num_cpus=1, max_retries=_RETRIES)(_perform_there)
        origin = _origin(ray, world_factory)
        yield lambda tasks: in_order(
            tasks,
            submit=lambda task: perform_there.remote(origin, pickle.dumps(task)),
            result=lambda pending: _outcome(ray, pending),
            ahead=AHEAD * max(_cpus(ray), 1),  # counted for each block: nodes come and go
        )
    finally:
        ray.shutdown()  # also ends whatever of ours the nodes still do


def _check_address(address: str) -> None:
    """Refuse what cannot be an address."""
    if address == AUTO:
        return
    host, _, port = address.rpartition(":")
    if not host or "/" in host or not port.isdecimal():
        raise InvalidValue(
            f"--ray {address} is no address; give auto, or HOST:PORT as `ray start` printed it."
        )


def _connect(address: str) -> Any:
    """Connect to a cluster, and return the module `ray`."""
    os.environ.setdefault("RAY_DEDUP_LOGS_SKIP_REGEX", ".")  # else it prints the logs of nodes that die
    try:
        import ray
    except ModuleNotFoundError as error:
        raise RayMissing from error

    if ray.is_initialized():
        raise InvalidValue("This process is connected to a Ray cluster already; call ray.shutdown() first.")
    _await_answer(address)
    try:
        ray.init(address, logging_level=logging.ERROR, log_to_driver=False)
    except (ConnectionError, RuntimeError, ValueError) as error:
        raise NoCluster(address, str(error).strip().partition("\n")[0].rstrip(".")) from error
    return ray


def _await_answer(address: str) -> None:
    """Let another process try, which can be ended; whatever else goes wrong, it will go wrong here, too."""
    if address != AUTO:
        host, _, port = address.rpartition(":")
        try:
            socket.create_connection((host, int(port)), timeout=_PATIENCE).close()
        except (OSError, OverflowError) as error:
            raise NoCluster(address, "nothing answers") from error
    attempt = "import ray, sys; ray.init(sys.argv[1], log_to_driver=False)"
    command = [sys.executable, "-c", attempt, address]
    try:
        subprocess.run(command, timeout=_PATIENCE, capture_output=True, check=False)
    except subprocess.TimeoutExpired as error:
        raise NoCluster(address, f"it did not answer within {_PATIENCE:.0f} s") from error


def _cpus(ray: Any) -> int:
    return int(ray.cluster_resources().get("CPU", 0))


def _origin(ray: Any, world_factory: WorldFactory) -> bytes:
    """Pack what a node needs in order to build the world, and to be sure that it is the same world."""
    path = [str(Path(entry).absolute()) for entry in sys.path]  # "" is the folder that we are in
    versions = {package: version_of(package) for package in _SAME_EVERYWHERE}
    return pickle.dumps((path, versions, ray.cloudpickle.dumps(world_factory)))


@cache
def _world_from(origin: bytes) -> World:
    path, versions, factory = pickle.loads(origin)
    sys.path.extend(entry for entry in path if entry not in sys.path)
    for package, wanted in versions.items():
        if (found := version_of(package)) != wanted:
            raise OtherVersion(socket.gethostname(), package, found, wanted)
    world_factory = pickle.loads(factory)
    is_own = isinstance(world_factory, OwnFactory | AimedFactory)
    return made(world_factory.here if is_own else world_factory)


def _perform_there(origin: bytes, task: bytes) -> bytes:
    """Perform a task in a worker process; bytes, since arrays that Ray unpacks itself are read-only."""
    return pickle.dumps(perform_task(_world_from(origin), pickle.loads(task)))


def _outcome(ray: Any, pending: Any) -> Outcome:
    try:
        answer = ray.get(pending)
    except ray.exceptions.RayTaskError as error:
        raise error.cause from error
    except ray.exceptions.RayError as error:
        raise WorkerDied from error
    outcome: Outcome = pickle.loads(answer)
    return outcome
