"""The command line: a command reads options, performs a stage, and says what came of it."""
