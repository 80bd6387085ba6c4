"""Exploration (Algorithm 1): a robot tries what it knows least about, and learns from it."""
