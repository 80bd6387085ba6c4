"""How far it goes: a million rows, a thousand symbols, a thousand objects."""
