"""Code that stands in a document, to be run as it stands there."""

import re

from places import DOCS


def python_blocks(document: str) -> list[str]:
    """The blocks of Python in a document, as a reader would copy them."""
    return blocks(document, "python")


def blocks(document: str, language: str) -> list[str]:
    """The blocks of one language in a document, as a reader would copy them."""
    return re.findall(rf"```{language}\n(.*?)```", (DOCS / document).read_text(), flags=re.S)
