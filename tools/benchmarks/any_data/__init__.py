"""Six data sets of others and of other kinds, taken from rows to plans that are performed."""
