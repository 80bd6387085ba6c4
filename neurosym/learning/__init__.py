"""Learning: the networks, and how they are fitted to a data set."""
