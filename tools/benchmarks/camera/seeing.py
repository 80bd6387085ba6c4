"""How well objects are seen, and what is lost where networks are shown crops in place of true features."""

import time
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from neurosym.data.interactions import Interactions
from neurosym.learning.eye_lesson import teach
from neurosym.learning.training import split, train
from neurosym.learning.training_config import DEFAULT_BITS, ModelConfig, regime_named
from neurosym.perception.eye import NUMBERS
from neurosym.sim.camera_world import CameraTableConfig, CameraWorld
from neurosym.sim.depth_camera import DepthCamera
from neurosym.sim.shapes import FEATURE_NAMES
from neurosym.world import Scene, heading
from tools.benchmarks.domains import bench_of
from tools.benchmarks.options import ROOT

NOISE = DepthCamera(depth_step=0.001, dropout=0.3, offset=0.001)
"""As of a depth sensor a metre above a table: steps of 1 mm, 30 % of the pixels at edges lost, and all
depths of a picture 1 mm off in the standard deviation."""
CAMERAS = {"still": DepthCamera(), "noisy": NOISE}
_SCENES, _OBJECTS, _SEED = 200, (1, 4), 830_000
_TAUGHT, _LOOKED = 2000, 4000  # as `neurosym see` by default
_COMPARED = 500  # objects
_APART = 0.05  # an object that is seen no nearer than this is not seen [m]


def errors(camera: str) -> dict[str, Any]:
    """Look at scenes of objects that lie turned by any angle: how far from the truth they are seen [mm]."""
    world = CameraWorld(CameraTableConfig(camera=CAMERAS[camera]))
    rng, rows, wrong, spent, acted = np.random.default_rng(_SEED), list[Any](), 0, 0.0, 0.0
    for number in range(_SCENES):
        drawn = world.table_world.sample_scene(rng, _OBJECTS[number % len(_OBJECTS)])
        turns = Rotation.from_euler("z", rng.uniform(-np.pi, np.pi, (len(drawn), 1))).as_quat()
        scene = replace(drawn, orientations=turns)
        begin = time.process_time()
        found = world.look(scene)
        spent += time.process_time() - begin
        wrong += len(found) != len(scene)
        for index in range(len(scene)):
            rows += _error(found, scene, index)
        if number % 4 == 0:
            begin = time.process_time()
            world.table_world.interact(scene, world.action_box.sample(rng, 1)[0], 0)
            acted += time.process_time() - begin
    position, size, turn = zip(*rows, strict=True)
    cpu = {"look_ms": 1000 * spent / _SCENES, "interaction_ms": 4000 * acted / _SCENES}
    middles = {"position": position, "size": size, "heading": turn}
    told = {name: [float(np.percentile(of, share)) for share in (50, 90)] for name, of in middles.items()}
    return {**told, "scenes": _SCENES, "miscounted": wrong, "objects": len(rows), **cpu}


def _error(found: list[Any], scene: Scene, index: int) -> list[tuple[float, float, float]]:
    """Say how far off an object is seen: its middle, its sizes in the mean [mm], its heading [degrees]."""
    at, sizes = scene.positions[index], scene.features[index, :3]
    nearest = min(found, key=lambda one: float(np.linalg.norm(one.position - at)), default=None)
    if nearest is None or np.linalg.norm(nearest.position - at) > _APART:
        return []
    if abs(Rotation.from_quat(scene.orientations[index]).as_matrix()[0, 0]) < np.sqrt(0.5):
        sizes = sizes[[1, 0, 2]]  # it lies turned by more than an eighth, so its sides change places
    turn = (nearest.heading - heading(scene.orientations[index]) + np.pi / 4) % (np.pi / 2) - np.pi / 4
    missed = float(np.abs(nearest.size - sizes).mean())
    return [
        (1000 * float(np.linalg.norm(nearest.position - at)), 1000 * missed, float(np.degrees(abs(turn))))
    ]


def agree(features: Path, images: Path) -> list[list[str]]:
    """Name the category of objects by two domains, one that knows features and one that sees images."""
    world: Any = bench_of(images).setting.world
    rng, known, seen = np.random.default_rng(_SEED), list[np.ndarray](), list[np.ndarray]()
    for _ in range(_COMPARED):
        scene = world.sample_scene(rng, 1)
        seen.append(scene.features[0])
        known.append(scene.unseen[0, : len(FEATURE_NAMES)])
    pairs = zip((features, images), (known, seen), strict=True)
    return [[*bench_of(folder).categorise(np.array(rows))] for folder, rows in pairs]


@cache
def _explored() -> Interactions:
    return Interactions.load(ROOT / "domains" / "tabletop" / "interactions.npz")


def draw_crops(work: Path) -> int:
    """Look at the objects of the interactions that `domains/tabletop` was learned from, somewhere each."""
    world, crops = CameraWorld(), list[np.ndarray]()
    for number, features in enumerate(_explored().features.astype(float)):
        rng = np.random.default_rng([_SEED, number])
        middle = np.mean([world.table.x, world.table.y], axis=1) + rng.uniform(-0.18, 0.18, 2)
        scene = Scene(
            features[None], np.array([[*middle, features[2] / 2]]), np.array([[0.0, 0.0, 0.0, 1.0]])
        )
        (seen,) = world.look(scene)
        crops.append(np.round(seen.crop, 4).astype(np.float32))
    np.savez_compressed(work / "crops.npz", crops=np.array(crops))
    return len(crops)


def compare(work: Path, seed: int) -> dict[str, Any]:
    """Train on the same interactions, shown true features and what an eye tells of crops."""
    data, crops = _explored(), np.load(work / "crops.npz")["crops"]
    chosen, bits = regime_named("quick"), ModelConfig(*DEFAULT_BITS)
    share = chosen.training.validation_share
    numbers = replace(data, features=np.arange(len(data), dtype=np.float32)[:, None])
    kept = split(numbers, share, seed)[0].features[:, 0].astype(int)  # nothing held out teaches the eye
    acted, looked = kept[:_TAUGHT], kept[_TAUGHT : _TAUGHT + _LOOKED]
    eye = teach(crops[acted], data[acted], crops[looked], seed=seed)
    told = np.array([eye.tell(crop.astype(float)) for crop in crops]).astype(np.float32)
    names = [f"v{number}" for number in range(1, NUMBERS + 1)]
    shown = {
        "features": data,
        "images": replace(data, features=told, origin={**data.origin, "feature_names": names}),
    }
    found = {}
    for name, one in shown.items():
        report = train(one, config=chosen.training, model_config=bits, seed=seed).report
        found[name] = {"direct_r2": report.r2_direct, "r2": report.r2_through_codes, "share": report.share}
    return found
