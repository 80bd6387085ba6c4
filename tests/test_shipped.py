"""Shipped domains are copied whole or not at all."""

import errno
import shutil

import pytest

from neurosym.choices import DOMAINS, copy_shipped, shipped_domain
from neurosym.errors import CannotWrite


@pytest.mark.parametrize("name", DOMAINS)
def test_copy_has_what_a_user_needs_and_nothing_that_is_made_again(name, tmp_path):
    assert copy_shipped(name, tmp_path / "mine")
    assert (tmp_path / "mine/grounding.json").read_bytes() == (
        shipped_domain(name) / "grounding.json"
    ).read_bytes()
    assert not {"plans", "runs", "pictures"} & {path.name for path in (tmp_path / "mine").iterdir()}


def test_other_names_are_no_shipped_domains_and_a_folder_that_is_there_stays_as_it_is(tmp_path):
    assert not copy_shipped("kitchen", tmp_path / "mine")
    assert list(tmp_path.iterdir()) == []
    (tmp_path / "mine").mkdir()
    assert copy_shipped("tabletop", tmp_path / "mine")
    assert list((tmp_path / "mine").iterdir()) == []


def test_disk_that_is_full_half_way_leaves_nothing(tmp_path, monkeypatch):
    copied, real = [], shutil.copyfile

    def copyfile(source, target, **options):
        copied.append(target)
        if len(copied) == 3:
            raise OSError(errno.ENOSPC, "No space left on device")
        return real(source, target, **options)

    monkeypatch.setattr(shutil, "copyfile", copyfile)
    with pytest.raises(CannotWrite, match="mine cannot be written: No space left on device"):
        copy_shipped("tabletop", tmp_path / "mine")
    assert list(tmp_path.iterdir()) == []
