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


MENDED = {
    'role="heading">': 'role="heading" aria-level="2">',  # captions of lists of pages
    "<pre>": '<pre tabindex="0">',  # what may be wider than a page is scrolled by keyboard, too
    '<div class="table-wrapper': '<div tabindex="0" class="table-wrapper',
    ' aria-label="Toggle hidden content"': "",  # folds are called what they say
}
"""What themes and writers leave out for those who do not see the site, or who have no mouse."""


def setup(app):
    """Mend what is written of each page."""

    def mend(app, page, template, context, doctree):  # noqa: ARG001  (what Sphinx calls it with)
        for part in ("body", "furo_navigation_tree"):
            for written, meant in MENDED.items():
                context[part] = (context.get(part) or "").replace(written, meant)

    app.connect("html-page-context", mend, priority=900)  # after the theme has written its own
