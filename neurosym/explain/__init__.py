"""Symbols in words: what each action symbol does, and which objects each object symbol holds."""
