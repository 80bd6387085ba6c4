"""What is measured about neurosym, each figure of its documents by a command."""
