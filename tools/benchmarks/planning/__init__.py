"""How well and how fast it plans and executes (docs/planning.md)."""
