"""Planners, interchangeable: each takes a problem and returns a result."""
