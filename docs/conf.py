"""How Sphinx builds the site: `make docs`, offline; a dead link or an undocumented name fails."""

import importlib.metadata

project = "neurosym"
author = "The neurosym authors"
copyright = "2026, the neurosym authors"  # noqa: A001  (Sphinx's own name)
release = importlib.metadata.version("neurosym-pddl")
extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
exclude_patterns = ["_build"]
html_theme = "furo"
html_title = "neurosym"
html_extra_path = ["studio-run.html"]  # a run whose view can be turned, in studio.md
myst_heading_anchors = 4
myst_enable_extensions = ["colon_fence"]
nb_execution_mode = "off"  # `make tutorial` runs the notebook, and a test does
autodoc_typehints = "none"  # docstrings give shapes and units
autodoc_member_order = "bysource"
napoleon_google_docstring = True
napoleon_numpy_docstring = False
napoleon_use_ivar = True
nitpicky = False
suppress_warnings = ["myst.header"]
