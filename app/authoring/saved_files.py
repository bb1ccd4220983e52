"""Reads and saves the files that an author edits: those saved in the author's folder, else those in use. Files are
written to a temporary name, then renamed, and only if they are still what the author read."""

from dataclasses import dataclass
from hashlib import blake2b
from pathlib import Path

from ..authored_folders import origin
from ..errors import ChangedError, ForbiddenError, InputError
from ..whole_files import replace_file
from .editable_files import EditableFiles


@dataclass(frozen=True, slots=True)
class SavedText:
    """A file's text, and whether it is the author's own, saved in the author's folder."""

    name: str
    text: str
    saved: bool

    @property
    def version(self) -> str:
        """Another for each text."""
        return blake2b(self.text.encode(), digest_size=12).hexdigest()


def read_text(kind: EditableFiles, name: str, folder: Path | None = None) -> SavedText:
    """The text of the file of that name, from `folder` if it is there; none of a new file. Raises InputError
    `unknown_file`, `rules_unreadable`."""
    name = kind.required(name)
    path = kind.files().get(name)
    own = _own(folder, name, path) if folder is not None else None
    if own is not None and own.is_file():
        return SavedText(name, _text(kind, own, name), saved=path is None or own.resolve() != path.resolve())
    return SavedText(name, "" if path is None else path.read_text(encoding="utf-8"), saved=False)


def saved_names(kind: EditableFiles, folder: Path | None) -> tuple[str, ...]:
    """The names of the files of a kind that are saved in `folder`."""
    if folder is None:
        return ()
    files = kind.files()
    inside = sorted(path for path in folder.rglob("*.*") if path.is_file())
    own = {path.relative_to(folder).as_posix(): path for path in inside}
    return tuple(
        name
        for name, path in own.items()
        if kind.is_new(name) or (name in files and path.resolve() != files[name].resolve())
    )


def write_text(
    kind: EditableFiles, name: str, text: str, folder: Path | None, *, version: str | None = None
) -> SavedText:
    """Saves the text as the file of that name in `folder`; `version` is that of the text which the author read, if that
    is to be replaced alone.

    Raises ForbiddenError `rules_read_only` if there is no folder or it cannot be written to,
    ChangedError `file_changed` if it holds another text meanwhile, InputError `unknown_file`.
    """
    require_folder(kind, folder)
    name = kind.required(name)
    if version is not None and read_text(kind, name, folder).version != version:
        message = f"{name} has changed since it was read; read it again, then save"
        raise ChangedError("file_changed", message, field=kind.field)
    assert folder is not None
    _replace(kind, _own(folder, name, kind.files().get(name)), name, text)
    return read_text(kind, name, folder)


def require_folder(kind: EditableFiles, folder: Path | None) -> None:
    """Raises ForbiddenError `rules_read_only` if there is none."""
    if folder is None:
        message = "nothing is written here; start `understudy studio --lexicon DIR`, and files are saved in DIR"
        raise ForbiddenError("rules_read_only", message, field=kind.field)


def _own(folder: Path, name: str, in_use: Path | None) -> Path:
    """Where the author's file is: the one in use if it is in the author's folder, which may call it shorter."""
    used = origin(in_use) if in_use is not None else None
    return used if used is not None and used.resolve().is_relative_to(folder.resolve()) else folder / name


def _replace(kind: EditableFiles, target: Path, name: str, text: str) -> None:
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        replace_file(target, text.encode())
    except OSError as error:
        message = f"{name}: cannot be saved: {error.strerror}"
        raise ForbiddenError("rules_read_only", message, field=kind.field) from None


def _text(kind: EditableFiles, file: Path, name: str) -> str:
    try:
        return file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else f"it is not UTF-8 at byte {error.start}"
        message = f"{name}, as it was saved, cannot be read: {reason}"
        raise InputError("rules_unreadable", message, field=kind.field) from None
