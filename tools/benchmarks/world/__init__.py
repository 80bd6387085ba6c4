"""How the simulated world behaves, and how fast it is (docs/world.md)."""
