"""Inlines ES modules into one page, because browsers do not load modules from files (`file://`).

Every module that the first one needs becomes a `data:` address in the page's import map, and what it imports is named
by the module's path, so that modules stay modules. Names of packages are those of the studio's own import map.
"""

import base64
import json
import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from ...errors import ServiceError

_IMPORTED = re.compile(r"""((?:\bfrom|\bimport)\s*)(["'])([^"'\n]+)\2""")
_IMPORT_MAP = re.compile(r'<script type="importmap">(.*?)</script>', re.DOTALL)
_BLOCK_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)


class Modules:
    """The modules in a folder, and the locations of the packages that they import."""

    def __init__(self, root: Path, packages: Mapping[str, Path]) -> None:
        self._root, self._packages = root, packages

    def import_map(self, first: Path) -> str:
        """The import map, JSON, of the module and all that it imports.

        Raises ServiceError `installation_incomplete`.
        """
        found: dict[str, str] = {}
        waiting = [first]
        while waiting:
            path = waiting.pop()
            name = self.name(path)
            if name not in found:
                found[name] = _address(self._named(path))
                waiting += self._imported(path)
        return json.dumps({"imports": found}, separators=(",", ":"))

    def name(self, path: Path) -> str:
        """The name of a module in the import map."""
        return path.relative_to(self._root).as_posix()

    def _named(self, path: Path) -> str:
        """The module's text, its imports by their names in the map."""

        def renamed(match: re.Match[str]) -> str:
            target = self._target(path, match[3])
            return match[0] if target is None else f"{match[1]}{match[2]}{self.name(target)}{match[2]}"

        return _IMPORTED.sub(renamed, _text(path))

    def _imported(self, path: Path) -> Iterator[Path]:
        targets = (self._target(path, match[3]) for match in _IMPORTED.finditer(_text(path)))
        yield from (target for target in targets if target is not None)

    def _target(self, path: Path, named: str) -> Path | None:
        """The file that an import names; None for a text that only looks like one."""
        if named.startswith("."):
            return (path.parent / named).resolve()
        longest = max((name for name in self._packages if _is_in(named, name)), key=len, default=None)
        return None if longest is None else self._packages[longest] / named.removeprefix(longest)


def packages_of(page: Path, at: str) -> dict[str, Path]:
    """The packages of a page's import map, whose addresses `at` stand for the page's folder."""
    match = _IMPORT_MAP.search(page.read_text(encoding="utf-8"))
    named = json.loads(match[1])["imports"] if match else {}
    return {name: (page.parent / address.removeprefix(at)).resolve() for name, address in named.items()}


def _is_in(named: str, package: str) -> bool:
    return named == package or (package.endswith("/") and named.startswith(package))


def _text(path: Path) -> str:
    """A module's text without its comments, which may speak of other modules."""
    try:
        text = path.read_text(encoding="utf-8")
    except OSError:
        message = f"the studio's {path.name} is missing at {path}; reinstall understudy"
        raise ServiceError("installation_incomplete", message) from None
    return text if "/vendor/" in path.as_posix() else _BLOCK_COMMENT.sub("", text)


def _address(module: str) -> str:
    return f"data:text/javascript;base64,{base64.b64encode(module.encode()).decode()}"
