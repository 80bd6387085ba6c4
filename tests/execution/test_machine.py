"""A record of a run names the machine that it was made on."""

import os
import subprocess
import sys
from importlib.metadata import Distribution, version

import msgspec

from neurosym.errors import BUILDS
from neurosym.execution import record
from neurosym.execution.record import Machine, this_machine

HERE = this_machine()


def installed(*distributions: str) -> list[str]:
    """Versions of those that are installed."""
    return [one.version for name in distributions for one in Distribution.discover(name=name)]


def test_machine_names_processor_system_and_versions():
    assert HERE.processor
    assert HERE.architecture
    assert HERE.system
    assert HERE.versions["numpy"] == version("numpy")
    assert HERE.versions["pybullet"] in installed(*BUILDS["pybullet"])
    assert HERE.differences(HERE) == ()


def test_machine_is_told_alike_by_every_process():
    code = (
        "import msgspec\nfrom neurosym.execution.record import this_machine\n"
        "print(msgspec.json.encode(this_machine()).decode())"
    )
    for seed in ("0", "7"):
        ran = subprocess.run(
            [sys.executable, "-c", code],
            capture_output=True,
            text=True,
            check=True,
            env={**os.environ, "PYTHONHASHSEED": seed},
        )
        assert msgspec.json.decode(ran.stdout, type=Machine) == HERE


def test_differences_name_both_sides():
    there = msgspec.structs.replace(
        HERE, processor="Other 9000", versions={**HERE.versions, "numpy": "0.1", "blas": "3"}
    )
    assert HERE.differences(there) == (
        f"processor: {HERE.processor} and Other 9000",
        "blas: unknown and 3",
        f"numpy: {version('numpy')} and 0.1",
    )


def test_processor_of_a_cloud_is_told_by_its_numbers(tmp_path, monkeypatch):
    told = tmp_path / "cpuinfo"
    told.write_text(
        "processor\t: 0\ncpu family\t: 26\nmodel\t\t: 2\nmodel name\t: AMD EPYC\nstepping\t: 1\n"
        "cpu MHz\t\t: 2596.124\n\nprocessor\t: 1\nmodel name\t: other\n"
    )
    monkeypatch.setattr(record, "_CPUINFO", told)
    this_machine.cache_clear()
    assert this_machine().processor == "AMD EPYC (family 26, model 2, stepping 1)"
    for text in ("", "CPU part\t: 0xd0c\n"):
        told.write_text(text)
        this_machine.cache_clear()
        assert this_machine().processor
    monkeypatch.setattr(record, "_CPUINFO", tmp_path / "none")
    this_machine.cache_clear()
    assert this_machine().processor
    this_machine.cache_clear()
