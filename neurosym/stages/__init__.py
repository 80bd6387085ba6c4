"""Stages: each loads values from a domain folder, calls a function, and saves what it returns."""
