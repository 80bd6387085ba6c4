"""`neurosym init` writes `world.toml` and names the step that comes after what is there."""

from pathlib import Path

from command_line import neurosym
from conftest import LEARN_TOY


def init(folder: Path, capsys) -> str:
    """Give a folder its world, and return what is to be typed next."""
    (folder / "world.toml").unlink(missing_ok=True)
    capsys.readouterr()
    assert neurosym("init", folder, "--world", "toy") == 0
    return capsys.readouterr().out.splitlines()[-1]


def test_next_step_is_what_follows_what_is_there(folder, capsys):
    assert init(folder, capsys) == f"next: neurosym new-problem {folder}"
    (folder / "grounding.json").unlink()
    assert init(folder, capsys) == f"next: neurosym compile-domain {folder}"
    (folder / "world.toml").unlink()
    assert neurosym("distill", folder) == 0  # from the data
    assert init(folder, capsys) == f"next: neurosym distill {folder}"
    (folder / "primitives.json").unlink()
    assert init(folder, capsys) == f"next: neurosym distill {folder}"
    for model in ("direct_model", "effect_model"):
        (folder / f"{model}.safetensors").unlink()
        assert init(folder, capsys) == f"next: neurosym train {folder}"
    (folder / "interactions.npz").unlink()
    assert init(folder, capsys) == f"next: neurosym explore {folder}"


def test_other_data_than_the_model_was_trained_on_are_trained_on_first(folder, capsys):
    again = ("--steps", 1280, "--seed", 3, *LEARN_TOY)
    assert neurosym("explore", folder, *again) == 0
    assert init(folder, capsys) == f"next: neurosym train {folder}"
