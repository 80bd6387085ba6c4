"""Data sets of interactions: what they hold, where they come from, and what can be wrong with them."""
