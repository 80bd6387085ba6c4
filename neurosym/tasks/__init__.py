"""Tasks: what a problem and a learned domain mean together, and what steps do there."""
