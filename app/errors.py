"""The errors a user can meet. Each has a stable `code` and a message that says what is wrong, where, and what would be
right. They are raised where the mistake is found and caught only at the doors (`understudy.cli`, `understudy.api`).

A message on a name that is not known suggests the nearest known ones.
"""

import json
from collections.abc import Callable, Collection, Iterable
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import ClassVar, TypeVar

Loaded = TypeVar("Loaded")

LONGEST_SHOWN = 200


class UnderstudyError(Exception):
    """Base class. `code` is stable and machine-readable; the message is one line for people, or if it `names_places`,
    one line a mistake, each beginning with its place in a file."""

    names_places: ClassVar[bool] = False

    def __init__(self, code: str, message: str) -> None:
        super().__init__(message)
        self.code = code
        self.message = message

    def __reduce__(self) -> tuple[object, ...]:
        """Makes errors picklable, for other processes: by default, exceptions with arguments of their own are not."""
        return _restored, (type(self), self.args, self.__dict__)


def _restored(
    kind: type[UnderstudyError], arguments: tuple[object, ...], attributes: dict[str, object]
) -> UnderstudyError:
    error = kind.__new__(kind, *arguments)
    error.__dict__.update(attributes)
    return error


class InputError(UnderstudyError):
    """What the caller sent is wrong: text, options or a file's content. `field` names the part at fault."""

    def __init__(self, code: str, message: str, *, field: str | None = None) -> None:
        super().__init__(code, message)
        self.field = field


class UndecodableError(InputError):
    """The bytes are not what they claim to be: broken audio, broken JSON."""


class UnsupportedFormatError(InputError):
    """A format that we do not read."""


class NotAcceptableError(InputError):
    """The response is available in no media type that the caller accepts."""


class SlowClientError(InputError):
    """The request arrives too slowly."""


class TooManyError(InputError):
    """Too many requests from one client; `retry_after_s` is when to try again."""

    def __init__(self, code: str, message: str, *, retry_after_s: float = 1.0) -> None:
        super().__init__(code, message)
        self.retry_after_s = retry_after_s


class ForbiddenError(InputError):
    """The caller is not allowed to do this."""


class ChangedError(InputError):
    """What is to be replaced is no longer what the caller read."""


class TooLargeError(InputError):
    """The input exceeds a limit of `understudy.settings`."""


class ServiceError(UnderstudyError):
    """A failure of the service, not a mistake of the caller's: the aligner died, the deadline passed. `retry_after_s`
    is when to try again."""

    def __init__(self, code: str, message: str, *, retry_after_s: float | None = None) -> None:
        super().__init__(code, message)
        self.retry_after_s = retry_after_s


def shown(value: object) -> str:
    """The repr of what a caller sent, for quoting in a message: cut after `LONGEST_SHOWN` characters, so that messages
    stay short."""
    text = value if isinstance(value, str) else str(value)
    return repr(text) if len(text) <= LONGEST_SHOWN else f"{text[:LONGEST_SHOWN]!r}…"


def why_not_json(error: ValueError | RecursionError) -> str:
    """Why Python refused a text as JSON, without its advice to raise limits."""
    if isinstance(error, RecursionError):
        return "it is nested too deeply"
    is_told = isinstance(error, (json.JSONDecodeError, UnicodeDecodeError))
    return str(error) if is_told else "a number has too many digits"


@dataclass(frozen=True, slots=True)
class Mistake:
    """A mistake in a file that authors write. Line and column count from 1; `source_line` is the line itself. A link
    is shown as the file that it points to (`understudy.authored_folders`)."""

    path: Path
    line: int
    column: int
    message: str
    source_line: str = ""

    def __str__(self) -> str:
        path = self.path.readlink() if self.path.is_symlink() else self.path
        where = f"{path}:{self.line}:{self.column}: {self.message}"
        if not self.source_line:
            return where
        return f"{where}\n    {self.source_line}\n    {' ' * (self.column - 1)}^"


class AuthoringError(UnderstudyError):
    """Files under `app/rules/` or `lexicon/` that do not load, with every mistake in them."""

    names_places = True

    def __init__(self, mistakes: tuple[Mistake, ...]) -> None:
        super().__init__("authoring", "\n".join(str(mistake) for mistake in mistakes))
        self.mistakes = mistakes


def collected(load: Callable[[], Loaded], mistakes: list[Mistake]) -> Loaded | None:
    """What `load` returns; None if it has mistakes, which are appended to `mistakes`."""
    try:
        return load()
    except AuthoringError as error:
        mistakes += error.mistakes
        return None


def all_loaded(loads: Iterable[Callable[[], Loaded]]) -> tuple[Loaded, ...]:
    """What each load returns; raises AuthoringError with the mistakes of all of them if any has some."""
    mistakes: list[Mistake] = []
    loaded = [collected(load, mistakes) for load in loads]
    if mistakes:
        raise AuthoringError(tuple(mistakes))
    return tuple(each for each in loaded if each is not None)


class WrongBmlError(InputError):
    """A BML file that realizers would refuse: `mistakes` has all of them, the message the first few."""

    def __init__(self, code: str, message: str, *, mistakes: tuple[Mistake, ...] = ()) -> None:
        super().__init__(code, message, field="bml")
        self.mistakes = mistakes


MOST_COMPARED = 5000
"""Known names beyond these are not compared: a file may define any number."""


def nearest_names(name: str, known: Iterable[str], *, most: int = 1) -> tuple[str, ...]:
    """The known names that are like `name`, the nearest first, `most` at most."""
    from difflib import get_close_matches  # imported late: only mistakes need it

    return tuple(get_close_matches(name[:LONGEST_SHOWN], sorted(islice(known, MOST_COMPARED)), n=most))


def did_you_mean(name: str, known: Collection[str], *, most: int = 1, otherwise: str = "") -> str:
    """The end of a message on an unknown name: a question for the nearest known names, else `otherwise`."""
    near = nearest_names(name, known, most=most)
    return f"; did you mean {' or '.join(map(repr, near))}?" if near else otherwise
