"""How well objects are put on and into one another."""
