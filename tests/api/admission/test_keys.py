"""API keys come from the settings and from a file, and nothing of them is kept but digests."""

import os
from base64 import urlsafe_b64encode
from hashlib import sha256
from pathlib import Path

import pytest
from pydantic import SecretStr
from starlette.datastructures import Headers

from understudy import api, live
from understudy.api.admission.keys import (
    FEWEST_CHARACTERS,
    LOOK_EVERY_S,
    ApiKeys,
    KeyRing,
    authorization,
    offers_protocol,
)
from understudy.errors import InputError
from understudy.settings import Settings

ONE, OTHER = "one-key-of-twenty-chars", "another-key-of-the-file"


def _keys(keys: str | None = None, file: Path | None = None) -> ApiKeys:
    return ApiKeys.of(Settings(api_keys=None if keys is None else SecretStr(keys), api_keys_file=file))


def test_keys_of_settings_and_file_all_let_in(tmp_path: Path) -> None:
    (tmp_path / "keys").write_text(f"# those of the games\n\n{OTHER}\n")
    keys = _keys(f"{ONE}, {ONE}x", tmp_path / "keys")
    for key in (ONE, f"{ONE}x", OTHER):
        assert keys.name(f"Bearer {key}") == keys.name(f"bearer  {key} ") == sha256(key.encode()).hexdigest()[:8]


@pytest.mark.parametrize(
    "authorization",
    [None, "", ONE, f"Basic {ONE}", "Bearer", "Bearer ", f"Bearer {ONE[:-1]}", f"Bearer {ONE}é", "Bearer \udcff"],
)
def test_nothing_else_does(authorization: str | None) -> None:
    assert _keys(ONE).name(authorization) is None


def test_no_key_is_kept_or_shown() -> None:
    settings = Settings(api_keys=SecretStr(ONE))
    assert ONE not in repr(settings)
    assert ONE not in repr(ApiKeys.of(settings))


def test_a_key_is_long_enough() -> None:
    assert _keys("k" * FEWEST_CHARACTERS).are_asked
    with pytest.raises(InputError) as caught:
        _keys(f"{ONE}," + "k" * (FEWEST_CHARACTERS - 1))
    assert caught.value.code == "setting_wrong"
    assert "API key 2" in caught.value.message
    assert "kkk" not in caught.value.message


@pytest.mark.parametrize("content", [None, b"", b"# none\n", b"\xff\xfe"])
def test_a_file_without_keys_lets_nobody_in_by_mistake(tmp_path: Path, content: bytes | None) -> None:
    if content is not None:
        (tmp_path / "keys").write_bytes(content)
    with pytest.raises(InputError) as caught:
        _keys(file=tmp_path / "keys")
    assert caught.value.code == "setting_wrong"
    assert str(tmp_path / "keys") in caught.value.message


def _offered(protocols: str) -> Headers:
    return Headers({"Sec-WebSocket-Protocol": protocols})


@pytest.mark.parametrize("key", [ONE, "key-with-ünicode-?>~~", "k" * 17])
def test_a_websocket_may_offer_its_key_as_a_protocol(key: str) -> None:
    coded = urlsafe_b64encode(key.encode()).decode().rstrip("=")
    headers = _offered(f"understudy, understudy.key.{coded}")
    assert _keys(key).name(authorization(headers))
    assert not _keys(OTHER).name(authorization(headers))
    assert offers_protocol(headers)


@pytest.mark.parametrize(
    "protocols", ["", "understudy", "understudy.key.", "understudy.key.a", "understudy.key.é", ONE]
)
def test_other_protocols_let_nobody_in(protocols: str) -> None:
    assert _keys(ONE).name(authorization(_offered(protocols))) is None


def test_the_header_goes_before_a_protocol() -> None:
    coded = urlsafe_b64encode(ONE.encode()).decode().rstrip("=")
    headers = Headers({"Authorization": "Bearer wrong", "Sec-WebSocket-Protocol": f"understudy.key.{coded}"})
    assert _keys(ONE).name(authorization(headers)) is None


@pytest.mark.parametrize(
    ("when", "lets_in"),
    [("2999-01-31", True), ("2020-01-31", False), ("2999-01-31T12:00+02:00", True), ("2020-01-31T12:00:00Z", False)],
)
def test_a_key_may_expire(tmp_path: Path, when: str, lets_in: bool) -> None:
    (tmp_path / "keys").write_text(f"{ONE} expires={when}\n{OTHER}\n")
    keys = _keys(file=tmp_path / "keys")
    assert (keys.name(f"Bearer {ONE}") is not None) is lets_in
    assert keys.name(f"Bearer {OTHER}")


@pytest.mark.parametrize(
    "further", ["expires=soon", "until 2030-01-01", "expires=", "expires=2030-01-01 expires=2031-01-01"]
)
def test_what_else_stands_after_a_key_is_told_without_it(tmp_path: Path, further: str) -> None:
    (tmp_path / "keys").write_text(f"{ONE} {further}\n")
    with pytest.raises(InputError) as caught:
        _keys(file=tmp_path / "keys")
    assert f"API_KEYS_FILE: {tmp_path / 'keys'}: API key 1" in caught.value.message
    assert ONE not in caught.value.message


def test_a_clock_that_jumps_changes_nothing_but_when_keys_expire() -> None:
    """All else is measured by the monotonic clock."""
    folders = [Path(api.__file__).parent, Path(live.__file__).parent]
    reading = [path.name for folder in folders for path in folder.rglob("*.py") if "time.time(" in path.read_text()]
    assert reading == ["keys.py"]


def test_a_file_that_changes_is_read_again_and_a_broken_one_changes_nothing(tmp_path: Path) -> None:
    file, now_s = tmp_path / "keys", [0.0]
    file.write_text(ONE)
    ring = KeyRing(Settings(api_keys_file=file), lambda: now_s[0])

    def lets_in(key: str) -> bool:
        now_s[0] += LOOK_EVERY_S
        return ring.current.name(f"Bearer {key}") is not None

    assert (lets_in(ONE), lets_in(OTHER)) == (True, False)
    file.write_text(f"{ONE}\n{OTHER}\n")
    assert (lets_in(ONE), lets_in(OTHER)) == (True, True)
    file.write_text("# none\n")
    assert (lets_in(ONE), lets_in(OTHER)) == (True, True)
    file.unlink()
    assert (lets_in(ONE), lets_in(OTHER)) == (True, True)
    os.mkfifo(file)
    assert (lets_in(ONE), lets_in(OTHER)) == (True, True), "a pipe is not waited for"
    file.unlink()
    file.write_text(f"{OTHER}  # the second\n".replace("  # the second", ""))
    assert (lets_in(ONE), lets_in(OTHER)) == (False, True)
