"""Worlds: ours and custom ones, made from `world.toml`, checked, and performing in many processes."""
