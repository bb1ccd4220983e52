"""Reads and saves the files of rules and words that an author edits: those saved in the author's folder, else those in
use. Files are written to a temporary name, then renamed."""

import os
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from ..errors import ForbiddenError, InputError
from .rule_edits import FIELD, editable_files, is_new_file, require_file


@dataclass(frozen=True, slots=True)
class RuleText:
    """A file's text, and whether it is the author's own, saved in the author's folder."""

    name: str
    text: str
    saved: bool


def read_rule_text(name: str, folder: Path | None = None) -> RuleText:
    """The text of the file of that name, from `folder` if it is there; none of a new file. Raises InputError
    `unknown_file`, `rules_unreadable`."""
    require_file(name)
    path = editable_files().get(name)
    own = folder / name if folder is not None else None
    if own is not None and own.is_file():
        return RuleText(name, _text(own, name), saved=path is None or own.resolve() != path.resolve())
    return RuleText(name, "" if path is None else path.read_text(encoding="utf-8"), saved=False)


def saved_names(folder: Path | None) -> tuple[str, ...]:
    """The names of the files that are saved in `folder`."""
    if folder is None:
        return ()
    files = editable_files()
    inside = sorted(path for path in folder.rglob("*.*") if path.is_file())
    own = {path.relative_to(folder).as_posix(): path for path in inside}
    return tuple(
        name
        for name, path in own.items()
        if is_new_file(name) or (name in files and path.resolve() != files[name].resolve())
    )


def write_rule_text(name: str, text: str, folder: Path | None) -> None:
    """Saves the text as the file of that name in `folder`.

    Raises ForbiddenError `rules_read_only` if there is no folder or it cannot be written to, InputError `unknown_file`.
    """
    if folder is None:
        message = "nothing is written here; start `understudy studio --rules DIR`, and rules are saved in DIR"
        raise ForbiddenError("rules_read_only", message, field=FIELD)
    require_file(name)
    target = folder / name
    temporary = target.with_name(f".{target.name}.{os.getpid()}")
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        temporary.write_text(text, encoding="utf-8")
        temporary.replace(target)
    except OSError as error:
        with suppress(OSError):
            temporary.unlink(missing_ok=True)
        raise ForbiddenError("rules_read_only", f"{name}: cannot be saved: {error.strerror}", field=FIELD) from None


def _text(file: Path, name: str) -> str:
    try:
        return file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else f"it is not UTF-8 at byte {error.start}"
        message = f"{name}, as it was saved, cannot be read: {reason}"
        raise InputError("rules_unreadable", message, field=FIELD) from None
