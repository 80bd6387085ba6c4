"""`neurosym init` writes `world.toml` and names the step that comes after what is there."""

from pathlib import Path

from command_line import neurosym


def init(folder: Path, capsys) -> str:
    """Give a folder its world, and return what is to be typed next."""
    (folder / "world.toml").unlink(missing_ok=True)
    capsys.readouterr()
    assert neurosym("init", folder, "--world", "toy") == 0
    return capsys.readouterr().out.splitlines()[-1]


def test_next_step_is_what_follows_what_is_there(folder, capsys):
    assert init(folder, capsys) == f"next: neurosym distill {folder}"
    (folder / "effect_model.safetensors").unlink()
    assert init(folder, capsys) == f"next: neurosym train {folder}"
    (folder / "interactions.npz").unlink()
    assert init(folder, capsys) == f"next: neurosym explore {folder}"
