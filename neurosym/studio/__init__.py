"""The studio: a page in the browser in which one sees, drags, plans, watches and teaches."""
