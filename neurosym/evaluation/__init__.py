"""Evaluation: planners compared on the same tasks, and the paper's tables."""
