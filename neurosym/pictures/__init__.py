"""Pictures: what happens in a world, as strips, films and stills."""
