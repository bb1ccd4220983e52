"""Where the files are that authors edit: the bundled ones, with the author's own folders laid over them.

An author's folder (`--lexicon DIR`, `UNDERSTUDY_LEXICON`) has the layout of the bundled files, by their names
(`lexicon/en/`, `app/rules/functions/`, as the studio saves them) or shorter (`en/`, `gestures/`, `characters/`,
`profiles/`, `acting/`, `rules/functions/`, `rules/behaviors/`). A file with the name of a bundled one, or of one in an
earlier folder, takes its place; others are added. The behaviour table and the families are added to, entry by entry
(`behaviors/`, `acting/families/`).

What is read is a folder of links to all these files, in the cache: its name is a hash of where each link points, so
that it never changes, and a new file makes another.
"""

import atexit
import os
import shutil
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from hashlib import blake2b
from pathlib import Path, PurePosixPath

from .cache import Cache
from .errors import AuthoringError, InputError, Mistake, ServiceError
from .files import RULES, resource_folder

VARIABLE = "UNDERSTUDY_LEXICON"
AUTHORED = frozenset({".rules", ".yaml", ".gesture"})
"""The suffixes of files that authors edit."""

_ADDED_TO = {"behaviors.yaml": "behaviors", "acting/families.yaml": "acting/families"}
"""Tables to which a folder's own file is added, and the folder beside the table where additions are read."""

_FOLDERS = ("en", "gestures", "characters", "profiles", "acting", "retarget", "batch", "behaviors")
_KINDS_OF_RULES = ("functions", "behaviors")
_LAYERS: ContextVar[tuple[Path, ...] | None] = ContextVar("layers", default=None)


@dataclass(frozen=True, slots=True)
class _Bundled:
    """The bundled files' folders, and how they are called from the folder above both."""

    lexicon: Path
    rules: Path

    @property
    def root(self) -> Path:
        return self.rules.parents[1]

    def named(self, path: PurePosixPath) -> PurePosixPath | None:
        """The name under the root of an author's file, None if nothing would read it."""
        for folder in (self.lexicon, self.rules):
            name = PurePosixPath(folder.relative_to(self.root).as_posix())
            if path.is_relative_to(name):
                return self.named_inside(path.relative_to(name), folder)
        if path.parts[0] in {"lexicon", "rules"} and len(path.parts) > 1:
            folder = self.lexicon if path.parts[0] == "lexicon" else self.rules
            return self.named_inside(PurePosixPath(*path.parts[1:]), folder)
        return self.named_inside(path, self.lexicon)

    def named_inside(self, inside: PurePosixPath, folder: Path) -> PurePosixPath | None:
        if not inside.parts:
            return None
        if folder == self.rules:
            is_read = inside.parts[0] in _KINDS_OF_RULES if len(inside.parts) == 2 else _is_file(folder / inside)
        else:
            is_read = inside.parts[0] in _FOLDERS if len(inside.parts) > 1 else _is_file(folder / inside)
            is_read = is_read and inside.suffix != ".rules"
        return PurePosixPath(folder.relative_to(self.root).as_posix()) / inside if is_read else None


def _is_file(path: Path) -> bool:
    """Whether there is such a file; none has a name that is too long."""
    try:
        return path.is_file()
    except OSError:
        return False


@contextmanager
def laid_over(layers: Sequence[Path]) -> Iterator[None]:
    """Within the block the bundled files are read with these folders over them, instead of those of the environment."""
    token = _LAYERS.set(tuple(layers))
    try:
        yield
    finally:
        _LAYERS.reset(token)


def layers_of(value: str | None) -> tuple[Path, ...]:
    """The folders in the value of `UNDERSTUDY_LEXICON`, which separates them as `PATH` does."""
    return tuple(Path(each) for each in (value or "").split(os.pathsep) if each)


def layers() -> tuple[Path, ...]:
    """The author's folders in use, the last one on top."""
    found = _LAYERS.get()
    return layers_of(os.environ.get(VARIABLE)) if found is None else found


def lexicon_folder() -> Path:
    """The words, gestures, characters, profiles and tables in use.

    Raises InputError `lexicon_wrong` for an author's folder that does not exist, AuthoringError for files in it that
    nothing reads.
    """
    bundled = resource_folder("lexicon")
    return _composed().joinpath(bundled.relative_to(RULES.parents[1])) if layers() else bundled


def rules_folder(bundled: Path = RULES) -> Path:
    """The rules in use; raises as `lexicon_folder` does."""
    return _composed().joinpath(RULES.relative_to(RULES.parents[1])) if layers() else bundled


def checkout_name(name: str) -> str | None:
    """The name in a checkout of an author's file, by that or its shorter name; None if nothing would read it."""
    path = PurePosixPath(name)
    found = _Bundled(resource_folder("lexicon"), RULES).named(path) if path.parts else None
    return None if found is None else found.as_posix()


def name_in_checkout(path: Path) -> str:
    """The name in a checkout of a file or folder among those that are read."""
    return path.relative_to(rules_folder().parents[1]).as_posix()


def tables_of(table: Path) -> tuple[Path, ...]:
    """The files of a table that authors add to, itself first."""
    return (table, *sorted(table.with_suffix("").glob("*.yaml")))


def origin(path: Path) -> Path:
    """The author's own file, of a file that is read."""
    return path.readlink() if path.is_symlink() else path


def _composed() -> Path:
    """The folder of links to the bundled files and those of the layers."""
    bundled = _Bundled(resource_folder("lexicon"), RULES)
    links = dict(_bundled_links(bundled))
    mistakes: list[Mistake] = []
    for number, layer in enumerate(layers()):
        links |= _layer_links(bundled, layer.resolve(), number, mistakes)
    if mistakes:
        raise AuthoringError(tuple(mistakes))
    listing = "\0".join(f"{name}\0{target}" for name, target in sorted(links.items()))
    root = _home() / blake2b(listing.encode(), digest_size=12).hexdigest()
    if not root.is_dir():
        _link(root, links)
    return root


def _bundled_links(bundled: _Bundled) -> Iterator[tuple[str, Path]]:
    for folder in (bundled.lexicon, bundled.rules):
        for path in folder.rglob("*.*"):
            if path.suffix in AUTHORED and path.is_file():
                yield path.relative_to(bundled.root).as_posix(), path


def _layer_links(bundled: _Bundled, layer: Path, number: int, mistakes: list[Mistake]) -> Mapping[str, Path]:
    """The layer's files by the names under which they are read."""
    if not layer.is_dir():
        message = f"{layer}: no such folder; --lexicon and {VARIABLE} name folders of words, rules and gestures"
        raise InputError("lexicon_wrong", message, field="lexicon")
    links = {}
    for path in sorted(layer.rglob("*.*")):
        inside = PurePosixPath(path.relative_to(layer).as_posix())
        if path.suffix not in AUTHORED or path.is_dir() or any(part.startswith(".") for part in inside.parts):
            continue
        name = bundled.named(inside)
        if not path.is_file():
            mistakes.append(Mistake(path, 1, 1, "is neither a file nor a link to one"))
        elif name is None:
            known = ", ".join(f"{each}/" for each in (*_FOLDERS, *(f"rules/{kind}" for kind in _KINDS_OF_RULES)))
            mistakes.append(Mistake(path, 1, 1, f"a file here is never read; files are read from {known}"))
        else:
            links[_added(bundled, name, number)] = path
    return links


def _added(bundled: _Bundled, name: PurePosixPath, number: int) -> str:
    """The name, or that of an addition to the table of that name."""
    lexicon = bundled.lexicon.relative_to(bundled.root).as_posix()
    folder = _ADDED_TO.get(name.as_posix().removeprefix(f"{lexicon}/"))
    return name.as_posix() if folder is None else f"{lexicon}/{folder}/{number:03}.yaml"


def _home() -> Path:
    """The folder in the cache; one that lasts as long as the process where nothing is cached."""
    cache = Cache.of_environment().folder
    if cache is not None:
        return cache / "lexicon"
    home = Path(tempfile.mkdtemp(prefix="understudy-lexicon-"))
    atexit.register(shutil.rmtree, home, ignore_errors=True)
    return home


def _link(root: Path, links: Mapping[str, Path]) -> None:
    """Makes the folder under a temporary name, so that it is complete for whoever sees it."""
    try:
        root.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        beside = Path(tempfile.mkdtemp(prefix=f".{root.name}.", dir=root.parent))
        for name, target in links.items():
            link = beside / name
            link.parent.mkdir(parents=True, exist_ok=True)
            link.symlink_to(target)
        _moved(beside, root)
    except OSError as error:
        message = f"{root.parent}: the folders of --lexicon cannot be combined there: {error.strerror}"
        raise ServiceError("lexicon_unlinked", f"{message}; UNDERSTUDY_CACHE names another folder") from None


def _moved(beside: Path, root: Path) -> None:
    try:
        beside.rename(root)
    except OSError:
        shutil.rmtree(beside, ignore_errors=True)
        if not root.is_dir():
            raise
