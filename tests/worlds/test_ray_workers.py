"""A Ray cluster gives the bytes of one worker, whatever dies; a missing one is refused in a sentence."""

import pickle
import socket
import sys
import time
from functools import partial
from types import ModuleType

import pytest
from worker_tasks import Deadly, some_tasks

from neurosym.commands.cli import main
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.exploration.loop import explore
from neurosym.worlds import ray_workers
from neurosym.worlds.pool import WorkerDied
from neurosym.worlds.ray_workers import NoCluster, OtherVersion, RayMissing, ray_crew
from neurosym.worlds.toy import make_world
from neurosym.worlds.workers import Task, in_order
from neurosym.worlds.world_file import make_world as make_any_world

TABLETOP = partial(make_any_world, "tabletop", {})


def enter(address):
    with ray_crew(make_world, address):
        pass


def free_port():
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        return listener.getsockname()[1]


def test_outcomes_come_in_the_order_of_the_tasks_with_a_bounded_number_handed_out():
    submitted, awaited = [], []

    def submit(task):
        submitted.append(task)
        assert len(submitted) - len(awaited) <= 4
        return task

    def result(task):
        awaited.append(task)
        return -task

    assert list(in_order(range(10), submit=submit, result=result, ahead=4)) == [-n for n in range(10)]
    assert submitted == awaited == list(range(10))


def test_errors_survive_the_way_between_processes_as_themselves():
    error = pickle.loads(pickle.dumps(UnknownChoice("world", "moon", ["toy"])))
    assert type(error) is UnknownChoice
    assert str(error) == "There is no world 'moon'; valid: toy."


def test_without_ray_a_sentence_says_how_to_install_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "ray", None)
    with pytest.raises(RayMissing, match=r"pip install 'neurosym-pddl\[ray\]'"):
        enter("auto")


def test_a_node_with_another_version_is_refused_and_named():
    origin = pickle.dumps(([], {"numpy": "0.1"}, pickle.dumps(make_world)))
    with pytest.raises(OtherVersion, match=r"install numpy 0\.1 there"):
        ray_workers._world_from(origin)


@pytest.mark.parametrize("address", ["cluster", "ray://host:10001", "host:", ":6379", ""])
def test_what_is_no_address_is_refused(address):
    with pytest.raises(InvalidValue, match="give auto, or HOST:PORT"):
        enter(address)


def test_an_address_where_nothing_listens_is_refused_and_says_how_to_start_a_cluster(monkeypatch):
    module = ModuleType("ray")
    module.is_initialized = lambda: False
    monkeypatch.setitem(sys.modules, "ray", module)
    with pytest.raises(NoCluster, match=r"nothing answers\); start one with `ray start --head`"):
        enter(f"127.0.0.1:{free_port()}")


def test_workers_and_ray_together_are_refused(tmp_path, capsys):
    assert command("explore", tmp_path, "--workers", "2", "--ray", "auto") == 2
    assert "--workers or --ray, not both" in capsys.readouterr().err


def command(*words):
    with pytest.raises(SystemExit) as ended:
        main([str(word) for word in words])
    return ended.value.code


@pytest.fixture
def cluster():
    """A head without CPUs and two nodes of one CPU each, all on this machine."""
    pytest.importorskip("ray", reason="needs Ray: pip install 'neurosym-pddl[ray]'")
    from ray.cluster_utils import Cluster

    small = {"object_store_memory": 80_000_000, "include_dashboard": False}
    cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 0, **small})
    try:
        for _ in range(2):
            cluster.add_node(num_cpus=1, **small)
        yield cluster
    finally:
        cluster.shutdown()


on_a_cluster = [
    pytest.mark.evaluation,
    pytest.mark.filterwarnings("ignore::ResourceWarning"),  # Ray leaves pipes to its processes open
]


def marked(test):
    for mark in on_a_cluster:
        test = mark(test)
    return test


def bytes_of(interactions, path):
    interactions.save(path)
    return path.read_bytes()


@marked
@pytest.mark.parametrize("world", ["toy", "tabletop"])
def test_a_cluster_gives_the_bytes_of_one_worker(cluster, tmp_path, capfd, world):
    explored = []
    for name, choice in (("here", ["--workers", "1"]), ("there", ["--ray", cluster.address])):
        assert command("init", tmp_path / name, "--world", world) == 0
        capfd.readouterr()
        start = time.perf_counter()
        options = ["--strategy", "random", "--steps", "64", "--places", "32", "--seed", "3", *choice]
        assert command("explore", tmp_path / name, *options) == 0
        print(f"{world} {name}: {time.perf_counter() - start:.1f} s\n{capfd.readouterr()}")
        data = ("interactions.npz", "places/interactions.npz")
        explored.append([(tmp_path / name / file).read_bytes() for file in data])
    assert explored[0] == explored[1]


def cpus_left(wanted):
    """How many CPUs the cluster has, once it has seen who died."""
    import ray

    end = time.monotonic() + 60
    while (found := ray.cluster_resources()["CPU"]) != wanted and time.monotonic() < end:
        time.sleep(0.2)
    return found


@marked
def test_a_node_killed_in_mid_run_costs_only_time(cluster, tmp_path):
    cpus = []

    def kill_one(done, steps):
        import ray

        if done == 20:
            cpus.append(ray.cluster_resources()["CPU"])
            cluster.remove_node(next(iter(cluster.worker_nodes)), allow_graceful=False)
        if done == steps:
            cpus.append(cpus_left(1))

    start = time.perf_counter()
    options = {"steps": 160, "strategy": "random", "seed": 3}
    there = explore(TABLETOP, ray=cluster.address, progress=kill_one, **options)
    print(f"with one node killed: {time.perf_counter() - start:.1f} s")
    here = explore(TABLETOP, **options)
    assert cpus == [2, 1]
    assert bytes_of(there, tmp_path / "there.npz") == bytes_of(here, tmp_path / "here.npz")


@marked
def test_an_interaction_that_kills_every_worker_ends_the_run_with_a_sentence(cluster, monkeypatch):
    monkeypatch.setattr(ray_workers, "_RETRIES", 2)
    with pytest.raises(WorkerDied), ray_crew(Deadly, cluster.address) as perform:
        list(perform(some_tasks(1)))


@marked
def test_an_error_in_the_world_comes_through_as_itself_and_everything_is_released(cluster):
    import ray

    task = next(some_tasks(1))
    tasks = [Task(task.scene, task.action, target=9), *some_tasks(30)]
    with (
        pytest.raises(InvalidValue, match="no object 9") as raised,
        ray_crew(make_world, cluster.address) as perform,
    ):
        list(perform(tasks))
    assert raised.type is InvalidValue
    assert not ray.is_initialized()


@marked
def test_what_listens_but_is_no_cluster_is_given_up(cluster, monkeypatch):
    monkeypatch.setattr(ray_workers, "_PATIENCE", 3.0)
    with socket.create_server(("127.0.0.1", 0)) as listener, pytest.raises(NoCluster, match="within 3 s"):
        enter(f"127.0.0.1:{listener.getsockname()[1]}")
