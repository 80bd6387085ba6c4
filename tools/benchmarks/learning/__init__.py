"""How well and how fast it learns (docs/learning.md)."""
