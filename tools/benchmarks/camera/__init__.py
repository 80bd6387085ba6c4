"""Objects that are seen by a camera, beside objects whose features are known."""
