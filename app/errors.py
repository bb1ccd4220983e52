"""The errors a user can meet. Each has a stable `code` and a message that says what, where and what would be right.

They are raised where the mistake is found and caught only at the doors (`understudy.cli`, `understudy.api`).
"""

from dataclasses import dataclass
from pathlib import Path

LONGEST_SHOWN = 200


class UnderstudyError(Exception):
    """Root of the tree. `code` is stable and machine-readable; the message is one line for people."""

    def __init__(self, code: str, message: str) -> None:
        super().__init__(message)
        self.code = code
        self.message = message

    def __reduce__(self) -> tuple[object, ...]:
        """Errors cross processes, which exceptions with arguments of their own do not by themselves."""
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
    """The format is none of those we read."""


class NotAcceptableError(InputError):
    """The answer comes in none of the forms that the caller accepts."""


class SlowClientError(InputError):
    """The request arrives too slowly."""


class TooManyError(InputError):
    """One client asks too often; `retry_after_s` is when to ask again."""

    def __init__(self, code: str, message: str, *, retry_after_s: float = 1.0) -> None:
        super().__init__(code, message)
        self.retry_after_s = retry_after_s


class ForbiddenError(InputError):
    """The caller may not do this here."""


class TooLargeError(InputError):
    """The input passes a limit of `understudy.settings`."""


class ServiceError(UnderstudyError):
    """Our own trouble, not the caller's: the aligner died, the deadline passed. `retry_after_s` is when to try
    again."""

    def __init__(self, code: str, message: str, *, retry_after_s: float | None = None) -> None:
        super().__init__(code, message)
        self.retry_after_s = retry_after_s


def shown(value: object) -> str:
    """What a caller sent, as a message quotes it: as Python writes it, and no more than `LONGEST_SHOWN` characters of
    it, so that no message is as long as what was sent."""
    text = value if isinstance(value, str) else str(value)
    return repr(text) if len(text) <= LONGEST_SHOWN else f"{text[:LONGEST_SHOWN]!r}…"


@dataclass(frozen=True, slots=True)
class Mistake:
    """A mistake in a file that authors write. Line and column count from 1; `source_line` is the line itself."""

    path: Path
    line: int
    column: int
    message: str
    source_line: str = ""

    def __str__(self) -> str:
        where = f"{self.path}:{self.line}:{self.column}: {self.message}"
        if not self.source_line:
            return where
        return f"{where}\n    {self.source_line}\n    {' ' * (self.column - 1)}^"


class AuthoringError(UnderstudyError):
    """Files under `app/rules/` or `lexicon/` that do not load: every mistake at once."""

    def __init__(self, mistakes: tuple[Mistake, ...]) -> None:
        super().__init__("authoring", "\n".join(str(mistake) for mistake in mistakes))
        self.mistakes = mistakes


class WrongBmlError(InputError):
    """A BML file that realizers would refuse: `mistakes` has every one, the message the first few."""

    def __init__(self, code: str, message: str, *, mistakes: tuple[Mistake, ...] = ()) -> None:
        super().__init__(code, message, field="bml")
        self.mistakes = mistakes
