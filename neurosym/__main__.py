"""`python -m neurosym` is the command line."""

from neurosym.commands.cli import main

if __name__ == "__main__":
    main()
