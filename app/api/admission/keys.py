"""API keys: of the settings or of a file, kept as SHA-256, compared in constant time.

The file is read again when it changes, so that a key is replaced without a restart. A file that cannot be used changes
nothing: the keys that were read before stay in use, and the log says why.
"""

import hmac
import logging
import time
from base64 import urlsafe_b64decode
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path
from typing import Self

from starlette.datastructures import Headers
from starlette.requests import HTTPConnection

from ...errors import InputError
from ...files import require_regular
from ...settings import PREFIX, Settings

FEWEST_CHARACTERS = 16
SHOWN_DIGITS = 8
LARGEST_FILE_BYTES = 1 << 20
LOOK_EVERY_S = 1.0

PROTOCOL = "understudy"
"""The protocol that answers a browser's WebSocket which offers its key as another protocol."""

_LOGGER = logging.getLogger(__name__)
_SCHEME, _KEY_PROTOCOL, _EXPIRES = "bearer ", "understudy.key.", "expires="


@dataclass(frozen=True, slots=True)
class ApiKey:
    """The SHA-256 of a key, and when it expires, in seconds since 1970 (None: never)."""

    digest: bytes
    expires_s: float | None = None


@dataclass(frozen=True, slots=True)
class ApiKeys:
    """The valid keys; if there are none, no key is required."""

    keys: tuple[ApiKey, ...] = ()

    @classmethod
    def of(cls, settings: Settings) -> Self:
        """Raises InputError `setting_wrong` for a short key, a file that cannot be read or has none, a date that is
        none."""
        given = settings.api_keys.get_secret_value() if settings.api_keys else ""
        parts = {f"{PREFIX}API_KEYS": given.replace(",", " ").split()}
        if settings.api_keys_file:
            parts[f"{PREFIX}API_KEYS_FILE: {settings.api_keys_file}"] = _lines_in(settings.api_keys_file)
        keys = (
            _key(f"{place}: API key {number}", line)
            for place, lines in parts.items()
            for number, line in enumerate(lines, 1)
        )
        return cls(tuple(dict.fromkeys(keys)))

    @property
    def are_asked(self) -> bool:
        """Whether callers need a key."""
        return bool(self.keys)

    def name(self, authorization: str | None) -> str | None:
        """The key's name in logs, the beginning of its SHA-256; None if the Authorization header has no valid key.
        Takes constant time."""
        if authorization is None or not authorization.lower().startswith(_SCHEME):
            return None
        sent = sha256(authorization[len(_SCHEME) :].strip().encode("utf-8", "surrogateescape")).digest()
        found = [hmac.compare_digest(known.digest, sent) and not _is_past(known.expires_s) for known in self.keys]
        return sent.hex()[:SHOWN_DIGITS] if any(found) else None


class KeyRing:
    """The keys of the settings and of their file, reloaded when it changes."""

    def __init__(self, settings: Settings, clock: Callable[[], float] = time.monotonic) -> None:
        """Raises InputError `setting_wrong`."""
        self._settings, self._clock = settings, clock
        self._changed = self._stamp()
        self._keys = ApiKeys.of(settings)
        self._looked_s = clock()

    @property
    def current(self) -> ApiKeys:
        """The keys in use, expired ones among them, which `name` refuses."""
        if self._clock() - self._looked_s >= LOOK_EVERY_S:
            self._looked_s = self._clock()
            self._look()
        return self._keys

    def _look(self) -> None:
        changed = self._stamp()
        if changed == self._changed:
            return
        self._changed = changed
        try:
            self._keys = ApiKeys.of(self._settings)
        except InputError as error:
            _LOGGER.error("%s; the previous keys stay in use", error.message)
        else:
            _LOGGER.info("API keys read again; there are %d", len(self._keys.keys))

    def _stamp(self) -> tuple[int, ...]:
        """Changes with the file; symbolic links, as in Kubernetes' secrets, are followed."""
        try:
            found = self._settings.api_keys_file.stat() if self._settings.api_keys_file else None
        except OSError:  # reported when it is read
            return ()
        return () if found is None else (found.st_mtime_ns, found.st_size, found.st_ino)


def caller_of(connection: HTTPConnection) -> str:
    """The caller of a request or WebSocket: the name of its key, else its address."""
    address = connection.client.host if connection.client else ""
    return str(getattr(connection.state, "key", None) or address)


def authorization(headers: Headers) -> str | None:
    """The Authorization header, or its equivalent for a browser's WebSocket, which cannot set headers: the key as
    base64url in one of the offered protocols."""
    sent = [each for each in _protocols(headers) if each.startswith(_KEY_PROTOCOL)]
    if "authorization" in headers or not sent:
        return headers.get("authorization")
    coded = sent[0].removeprefix(_KEY_PROTOCOL)
    try:
        key = urlsafe_b64decode(coded + "=" * (-len(coded) % 4))
    except ValueError:
        return _SCHEME
    return _SCHEME + key.decode("utf-8", "surrogateescape")


def offers_protocol(headers: Headers) -> bool:
    """Whether a WebSocket offers `PROTOCOL`."""
    return PROTOCOL in _protocols(headers)


def _protocols(headers: Headers) -> list[str]:
    return [each.strip() for each in ",".join(headers.getlist("sec-websocket-protocol")).split(",")]


def _key(place: str, line: str) -> ApiKey:
    """A key, after which `expires=` and a date or time may stand, in UTC if it does not say otherwise."""
    key, *further = line.split()
    if len(key) < FEWEST_CHARACTERS:
        message = f"{place} has {len(key)} characters; give each {FEWEST_CHARACTERS} or more"
        raise InputError("setting_wrong", message)
    digest = sha256(key.encode()).digest()
    if not further:
        return ApiKey(digest)
    try:
        [when] = [each.removeprefix(_EXPIRES) for each in further if each.startswith(_EXPIRES)]
        found = datetime.fromisoformat(when)
    except ValueError:
        message = f"{place}: a key may only be followed by {_EXPIRES} and a date, such as 2030-01-31"
        raise InputError("setting_wrong", message) from None
    return ApiKey(digest, (found if found.tzinfo else found.replace(tzinfo=UTC)).timestamp())


def _is_past(expires_s: float | None) -> bool:
    return expires_s is not None and time.time() >= expires_s


def _lines_in(path: Path) -> list[str]:
    """The keys in a file, one a line; lines that begin with # are comments."""
    try:
        require_regular(path)
        with path.open(encoding="utf-8") as file:
            lines = [line.strip() for line in file.read(LARGEST_FILE_BYTES).splitlines()]
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is not UTF-8"
        raise InputError("setting_wrong", f"{PREFIX}API_KEYS_FILE: {path}: cannot be read: {reason}") from None
    keys = [line for line in lines if line and not line.startswith("#")]
    if not keys:
        raise InputError("setting_wrong", f"{PREFIX}API_KEYS_FILE: {path}: has no key; write one a line")
    return keys
