"""A hook of the documentation's site (mkdocs.yml): links to files of the repository outside `docs/` become their names.

A link whose file is not there stays as it is, so that the build reports it.
"""

import re
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
_OUTSIDE = re.compile(r"\[([^\]]+)\]\((?:\.\./)+([^)#\s]+)\)")


def on_page_markdown(markdown: str, **_page: Any) -> str:  # noqa: ANN401
    """The page's text, with links out of the site as the names of their files."""
    return _OUTSIDE.sub(_named, markdown)


def _named(link: re.Match[str]) -> str:
    text, path = link[1], link[2]
    if not (ROOT / path).exists() or path.startswith("docs/"):
        return link[0]
    return f"{text} (`{path}`)"
