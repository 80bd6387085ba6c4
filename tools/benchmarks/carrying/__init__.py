"""How well objects are carried to places: far goals, swaps, rows and crowds (docs/results/places.md)."""
