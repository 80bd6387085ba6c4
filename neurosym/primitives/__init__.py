"""Primitives: symbols to parameters, and what these really do, by rehearsal or from the data."""
