"""Figures of the studio: when it can be used, how smoothly it runs, and for how many at once."""
