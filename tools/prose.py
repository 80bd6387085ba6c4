"""How long are the sentences that users read? `python -m tools.prose` prints it; a test holds the limits.

These are the documents, and what the program itself says: messages, help, comments of domains, the page of
`report`. Code, tables, headings and links' addresses do not count. A sentence ends at a full stop, a question
mark, an exclamation mark, a colon at the end of a line, or with its paragraph or point of a list.
"""

import re
from pathlib import Path
from statistics import median, quantiles
from typing import Annotated

import tyro

from neurosym.stages.console import say, show_table
from tools.program_texts import program_texts

PAGES = ("README.md", "CONTRIBUTING.md", "SECURITY.md", "CODE_OF_CONDUCT.md", "docs/*.md")
MEDIAN, MOST = 18, 35  # words that the median sentence has at most, and 95 of a hundred
PLAIN = {
    r"reckon\w*": "estimate",
    r"somebody's own|one's own": "custom",
    r"utili[sz]e\w*": "use",
    r"in order to": "to",
    r"prior to": "before",
    r"whilst": "while",
    r"aforementioned": "this",
    r"leverag\w+": "use",
}  # words that users do not read here, and what stands for them
_END = re.compile(r"(?<=[.!?])[\"')*_`]*\s+(?=[\"'(*_\[]*(?:[A-Z0-9]|`))|:\n")


def main(
    longest: Annotated[int, tyro.conf.arg(help="How many of the longest sentences are printed.")] = 0,
) -> None:
    """Print for each page how many sentences it has, and how long they are in words."""
    rows, every = [], list[str]()
    for name, found in read_by_users(Path()).items():
        every += found
        rows.append([name, str(len(found)), *map(str, measured(found))])
    show_table("Words in a sentence", ["page", "sentences", "median", "95 %"], rows)
    say(f"all: median and 95 % are {measured(every)}; at most {MEDIAN} and {MOST}")
    for sentence in sorted(every, key=lambda one: -len(one.split()))[:longest]:
        say(f"{len(sentence.split())}: {sentence}")


def read_by_users(root: Path) -> dict[str, list[str]]:
    """Return the sentences of each document, and of what the program says."""
    pages = [path for pattern in PAGES for path in sorted(root.glob(pattern))]
    found = {str(path.relative_to(root)): sentences(path.read_text()) for path in pages}
    for kind, texts in program_texts(root).items():
        found[kind] = list(dict.fromkeys(one for text in texts for one in sentences(text)))
    return found


def unplain(sentence: str) -> list[str]:
    """Say which plainer words a sentence ought to have; see `PLAIN`."""
    return [better for word, better in PLAIN.items() if re.search(rf"\b(?:{word})\b", sentence, flags=re.I)]


def sentences(text: str) -> list[str]:
    """List the sentences of a page."""
    text = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    lines = [line for line in text.splitlines() if not re.match(r"\s*[|#]|    ", line)]
    text = re.sub(r"^\s*([-*]|\d+\.)\s+", "\n", "\n".join(lines), flags=re.M)
    found = [part for paragraph in re.split(r"\n\s*\n", text) for part in _END.split(paragraph)]
    return [" ".join(part.split()) for part in found if len(re.findall(r"[A-Za-z]{2,}", part)) > 2]


def measured(found: list[str]) -> tuple[float, float]:
    """Return the median and the 95th percentile of the words of sentences."""
    counts = [len(one.split()) for one in found]
    return median(counts), round(quantiles(counts, n=20)[-1], 1) if len(counts) > 1 else counts[0]


if __name__ == "__main__":
    tyro.cli(main)
