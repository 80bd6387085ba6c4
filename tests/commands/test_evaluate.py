"""`neurosym evaluate` prints the paper's tables from what was measured in domain folders."""

import json
import re
import shutil

import numpy as np
import pytest
from command_line import neurosym, refusal

from neurosym.data.interactions import Interactions
from neurosym.data.origin import has_high_effect
from neurosym.evaluation.paper_tables import KINDS, KindsFound, Measured, errors_on, tables
from neurosym.evaluation.summary import Comparison, Tally
from neurosym.files import read_json, write_json
from neurosym.learning.training import TrainingReport
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import KINDS_FOUND


def tally(found: int, reached: int) -> Tally:
    return Tally(found, found, reached, reached, None, None, found, 0, {}, {}, {}, {})


def measured(folder, strategy, error, kinds, found) -> Measured:
    return Measured(
        folder=folder,
        strategy=strategy,
        errors={"model": [error] * 3, "always zero": [0.04] * 3},
        rows=100,
        kinds=KindsFound(10, {kind: (("000", "00"),) if kind in kinds else () for kind in KINDS}),
        r2={"model": 1 - 10 * error, "always zero": -0.1},
        comparisons={"1-objects-50-mm": Comparison(12, 2, 0, {"bfs": tally(found, found)})} if found else {},
    )


def test_folders_are_averaged_by_strategy():
    found = [
        measured("a", "random", 0.01, ["grasp"], 5),
        measured("b", "random", 0.03, [], 8),
        measured("c", "active", 0.02, ["grasp", "pull"], 0),
    ]
    first, second, third = tables(found, None)
    assert first.columns == ["strategy", "folders", "predictor", "x [mm]", "y [mm]", "z [mm]", "R2"]
    assert first.rows[0] == ["random", "2", "model", *["20.0 ± 10.0"] * 3, "0.80 ± 0.10"]
    assert ["active", "1", "always zero", *["40.0 ± 0.0"] * 3, "-0.10 ± 0.00"] in first.rows
    assert second.columns == ["", "random", "active"]
    assert ["grasp", "1 of 2", "1 of 1"] in second.rows
    assert second.rows[-1] == ["kinds, by folder", "1, 0", "2"]
    assert third.rows == [["random", "1-objects-50-mm", "bfs", "2", "20", *["65.0 ± 15.0"] * 4]]
    assert "`neurosym compare c`" in third.remark


def test_tables_hold_what_was_measured(folder, tmp_path, capsys):
    comparison = Comparison(4, 0, 1, {"fast-downward": tally(3, 2)})
    place = folder / "comparison/2-objects-50-mm"
    place.mkdir(parents=True)
    write_json(place / "comparison.json", comparison)
    assert neurosym("evaluate", folder, "--output", tmp_path / "tables.md", "--workers", 1) == 0
    page = (tmp_path / "tables.md").read_text()
    report = read_json(folder / "training.json", TrainingReport)
    x, y, z = (f"{1000 * error:.1f} ± 0.0" for error in report.mae["model"])
    r2 = f"{report.r2_through_codes:.2f} ± 0.00"
    assert f"| random | 1 | model | {x} | {y} | {z} | {r2} |" in page
    assert re.search(r"\| random \| 1 \| always zero \| [^|]+ \| [^|]+ \| [^|]+ \| - \|", page)
    kinds = read_json(folder / KINDS_FOUND, KindsFound).kinds
    for kind in KINDS:
        assert f"| {kind} | {int(bool(kinds[kind]))} of 1 |" in page
    assert "| random | 2-objects-50-mm | fast-downward | 1 | 4 | 75.0 ± 0.0 |" in page
    assert "Table III: planning" in capsys.readouterr().out
    before = (folder / KINDS_FOUND).stat().st_mtime_ns
    assert neurosym("evaluate", folder, "--output", tmp_path / "tables.json") == 0
    assert (folder / KINDS_FOUND).stat().st_mtime_ns == before
    assert json.loads((tmp_path / "tables.json").read_text())["folders"][0]["strategy"] == "random"


def test_errors_are_measured_on_a_test_set_on_request(folder, tmp_path, capsys):
    shutil.copy(folder / "interactions.npz", tmp_path / "test.npz")
    test = Interactions.load(tmp_path / "test.npz")
    errors, r2, rows = errors_on(DomainFolder(folder), test)
    high = has_high_effect(test.effects)
    assert rows == high.sum()
    np.testing.assert_allclose(errors["always zero"], np.abs(test.effects[high]).mean(0), rtol=1e-5)
    effects = test.effects[high].astype(float)
    squared = (effects**2).sum(0) / ((effects - effects.mean(0)) ** 2).sum(0)
    assert r2["always zero"] == pytest.approx(np.mean(1 - squared))
    assert r2["model"] > 0 > r2["always zero"]
    tested = ("evaluate", folder, "--test", tmp_path / "test.npz", "--workers", 1)
    assert neurosym(*tested, "--output", tmp_path / "tables.json") == 0
    said = capsys.readouterr().out
    assert f"{1000 * errors['model'][0]:.1f} ± 0.0" in said
    assert f"{r2['model']:.2f} ± 0.00" in said
    assert json.loads((tmp_path / "tables.json").read_text())["folders"][0]["r2"] == r2


def test_what_cannot_be_evaluated_is_refused(kept, tmp_path, capsys):
    seen = Interactions.load(kept / "interactions.npz")
    seen[np.flatnonzero(~has_high_effect(seen.effects))].save(tmp_path / "low.npz")
    rows = np.random.default_rng(0).normal(size=(9, 7)).astype(np.float32)
    np.savez(tmp_path / "odd.npz", features=rows, actions=rows[:, :5], effects=rows[:, :2])
    for arguments, said in (
        (["--output", "tables.csv"], "ends in .md or .json"),
        (["--test", "nowhere.npz"], "nowhere.npz cannot be used: there is no such file"),
        (["--test", tmp_path / "low.npz"], "No interaction of the test set has absolute displacements that"),
        (["--test", tmp_path / "odd.npz"], "it was trained on 4 object features, 12"),
    ):
        assert said in refusal(capsys, "evaluate", kept, *arguments)
    assert "no folder" in refusal(capsys, "evaluate", tmp_path / "nowhere")
    assert "neurosym explore" in refusal(capsys, "evaluate", tmp_path)
