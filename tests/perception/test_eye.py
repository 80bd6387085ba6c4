"""The eye tells crops by what actions showed to matter."""

from pathlib import Path

import numpy as np
import pytest
from command_line import refusal

from neurosym.data.archives import write_tensors
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.learning.eye_lesson import LessonConfig, _Eye, teach
from neurosym.learning.network import inference, tensor
from neurosym.perception.eye import FORMAT, NUMBERS, Eye
from neurosym.perception.regions import CELLS
from neurosym.stages.seeing import seen_in

BRIEF = LessonConfig(epochs=30, batch=32)
FEW = 160


def lesson(seed: int = 0, config: LessonConfig = BRIEF) -> tuple[Eye, np.ndarray, np.ndarray]:
    """Teach an eye that squares move as far as they are wide; return it with crops and widths."""
    rng = np.random.default_rng(1)
    widths = rng.integers(2, 15, 2 * FEW)
    crops = np.zeros((2 * FEW, CELLS, CELLS))
    for crop, half in zip(crops, widths, strict=True):
        crop[CELLS // 2 - half : CELLS // 2 + half, CELLS // 2 - half : CELLS // 2 + half] = 0.05
    actions = rng.uniform(0, 1, (FEW, 2)).astype(np.float32)
    effects = np.stack([0.01 * widths[:FEW] * actions[:, 0], 0 * actions[:, 0]], axis=1).astype(np.float32)
    columns = {"features": np.zeros((FEW, 1), dtype=np.float32), "actions": actions, "effects": effects}
    data = Interactions.filled(columns, {})
    return teach(crops[:FEW], data, crops[FEW:], seed=seed, config=config), crops, widths


def test_what_matters_for_effects_can_be_read_from_the_numbers():
    eye, crops, widths = lesson()
    told = np.array([eye.tell(crop) for crop in crops[FEW:]])  # it never acted on these
    known = np.column_stack([told, told**2, np.ones(len(told))])
    half = len(told) // 2
    weights = np.linalg.lstsq(known[:half], widths[FEW:][:half], rcond=None)[0]
    missed = known[half:] @ weights - widths[FEW:][half:]
    assert 1 - missed.var() / widths[FEW:][half:].var() > 0.8


def test_same_seed_same_bytes_and_a_file_tells_the_same(tmp_path: Path):
    eye, crops, _ = lesson(config=LessonConfig(epochs=2, batch=32))
    again, *_ = lesson(config=LessonConfig(epochs=2, batch=32))
    for one, path in ((eye, tmp_path / "a"), (again, tmp_path / "b")):
        one.save(path)
    assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes()
    read = Eye.load(tmp_path / "a")
    assert [*read.tell(crops[3])] == [*eye.tell(crops[3])]
    assert read.taught_by["interactions"] == FEW
    assert read.tell(crops[3]).shape == (NUMBERS,)


def test_it_tells_what_the_network_that_learned_tells():
    import torch

    torch.manual_seed(3)
    network, crops = _Eye().train(), np.random.default_rng(0).uniform(0, 0.1, (64, CELLS, CELLS))
    network(tensor(crops))  # so that mean and variance are some
    with inference(network):
        wanted = network(tensor(crops)).numpy()
    eye = Eye(network.weights())
    assert np.array([eye.tell(crop) for crop in crops]) == pytest.approx(wanted, abs=2e-3)


def test_other_crops_and_files_are_refused(tmp_path: Path):
    eye, *_ = lesson(config=LessonConfig(epochs=1, batch=32))
    with pytest.raises(InvalidValue, match=r"The crop has shape \(3, 3\)"):
        eye.tell(np.zeros((3, 3)))
    weights = {name: array.astype(np.float32) for name, array in eye.weights.items()}
    for change, said in (
        ({"mean": weights["mean"][:2]}, "those of no eye"),
        ({"variance": -weights["variance"]}, "a variance below zero"),
    ):
        write_tensors(tmp_path / "eye", FORMAT, weights | change, {"taught_by": {}})
        with pytest.raises(InvalidFile, match=said):
            Eye.load(tmp_path / "eye")
    write_tensors(tmp_path / "eye", FORMAT, weights, {})
    with pytest.raises(InvalidFile, match="what taught it"):
        Eye.load(tmp_path / "eye")


def pictures(count: int, side: int = 42) -> tuple[np.ndarray, np.ndarray]:
    """Draw squares, and say how wide each is."""
    halves = np.random.default_rng(5).integers(3, 20, count)
    images = np.zeros((count, side, side), dtype=np.float32)
    for image, half in zip(images, halves, strict=True):
        image[side // 2 - half : side // 2 + half, side // 2 - half : side // 2 + half] = 200
    return images, halves


@pytest.mark.parametrize("beside", [False, True])
def test_a_table_of_images_becomes_one_of_numbers(tmp_path: Path, beside: bool):
    images, halves = pictures(120)
    actions = np.random.default_rng(1).uniform(-1, 1, (120, 2))
    columns = {"images": images, "actions": actions, "effects": actions * (halves > 10)[:, None]}
    columns |= {"features": halves[:, None] % 2} if beside else {}
    np.savez(tmp_path / "own.npz", **columns)
    data, eye = seen_in(tmp_path / "own.npz", None, lambda _: None)
    assert eye is not None
    names = ["v1", "v2", "v3", "v4", "v5"]
    assert data.origin["feature_names"] == (["features", *names] if beside else names)
    assert data.features[:, -5:].std(0) == pytest.approx(np.ones(5), abs=0.6)
    plain = {name: column for name, column in columns.items() if name != "images"}
    np.savez(tmp_path / "plain.npz", **{"features": halves[:, None], **plain})
    assert seen_in(tmp_path / "plain.npz", None, lambda _: None)[1] is None


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda images: images[:, :20], r"its images are float32 \(4, 20, 42\)"),
        (lambda images: images * np.nan, r"images\[0, 0, 0\] is not finite"),
        (lambda images: images * 0, "every pixel is 0"),
        (lambda images: images[0], r"its images are float32 \(42, 42\)"),
    ],
)
def test_what_is_no_image_in_a_table_is_refused(tmp_path: Path, change, said: str):
    images, _ = pictures(4)
    np.savez(tmp_path / "own.npz", images=change(images), actions=np.eye(4), effects=np.eye(4))
    with pytest.raises(InvalidFile, match=said):
        seen_in(tmp_path / "own.npz", None, lambda _: None)


def test_tables_whose_images_do_not_fit_are_refused(tmp_path: Path):
    images, _ = pictures(40)
    actions = np.random.default_rng(1).uniform(-1, 1, (40, 2))
    table = {"images": images, "actions": actions, "effects": actions}
    for change, said in (
        ({"images": images[:30]}, "it has 30 images and 40 rows"),
        ({"feature.v1": actions[:, 0]}, "a column is called feature.v1"),
        ({name: one[:1] for name, one in table.items()}, "needed"),
    ):
        np.savez(tmp_path / "own.npz", **(table | change))
        with pytest.raises(InvalidFile, match=said):
            seen_in(tmp_path / "own.npz", None, lambda _: None)
    np.savez(tmp_path / "own.npz", **(table | {"images": np.repeat(images[:1], 40, axis=0)}))
    with pytest.raises(InvalidValue, match="All crops look the same"):
        seen_in(tmp_path / "own.npz", None, lambda _: None)


def test_check_says_what_reads_images_without_features(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    path, rng = tmp_path / "t.npz", np.random.default_rng(0)
    np.savez(path, images=rng.random((30, 8, 8)), actions=rng.random((30, 2)), effects=rng.random((30, 3)))
    said = refusal(capsys, "check", path)
    assert f"it has images in place of features, which `neurosym init DIR --data {path}` reads" in said
