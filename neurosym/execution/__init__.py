"""Execution: a plan runs in the world, step by step beside its promises."""
