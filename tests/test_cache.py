"""What is kept is what would be made, whatever happens to the files; and nobody else's word is taken for it."""

import errno
import logging
import os
import pickle
import stat
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

import pytest

from understudy.cache import GENERATIONS, Cache, _unpickled
from understudy.errors import AuthoringError
from understudy.model import Interval


@pytest.fixture(autouse=True)
def read_each_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """As outside the tests (tests/conftest.py)."""
    monkeypatch.setattr("understudy.cache._unpickled", _unpickled)


class Maker:
    """Makes what a file says, and counts how often."""

    def __init__(self, file: Path) -> None:
        self.file, self.times = file, 0

    def __call__(self) -> tuple[str, Interval]:
        self.times += 1
        return self.file.read_text(), Interval(0.0, 1.5)


@pytest.fixture
def cache(tmp_path: Path) -> Cache:
    return Cache(tmp_path / "cache")


@pytest.fixture
def make(tmp_path: Path) -> Maker:
    (tmp_path / "file").write_text("some")
    return Maker(tmp_path / "file")


def the_file(cache: Cache) -> Path:
    assert cache.folder is not None
    [file] = cache.folder.iterdir()
    return file


def test_a_thing_is_made_once_while_its_files_stay(cache: Cache, make: Maker) -> None:
    first, second = (cache.kept("thing", [make.file], make) for _ in range(2))
    assert first == second == ("some", Interval(0.0, 1.5))
    assert make.times == 1


@pytest.mark.parametrize("change", ["content", "name", "more", "made with"])
def test_it_is_made_again_when_what_it_follows_from_changes(cache: Cache, make: Maker, change: str) -> None:
    cache.kept("thing", [make.file], make)
    files, made_with = [make.file], ""
    if change == "content":
        make.file.write_text("more")
    elif change == "name":
        files = [make.file.rename(make.file.with_name("other"))]
        make.file = files[0]
    elif change == "more":
        files.append(make.file.with_name("nowhere"))
    else:
        made_with = "library 2.0"
    kept = cache.kept("thing", files, make, made_with=made_with)
    assert make.times == 2
    assert kept[0] == make.file.read_text()


def test_those_that_are_used_stay_and_others_go(cache: Cache, make: Maker) -> None:
    def use(made_with: str) -> int:
        cache.kept("thing", [make.file], make, made_with=made_with)
        return make.times

    assert cache.folder is not None
    for number in range(GENERATIONS + 2):
        use(f"library {number}")
        use("library of the user's own")
    assert len(list(cache.folder.iterdir())) == GENERATIONS
    made = make.times
    assert use("library of the user's own") == made
    assert use("library 0") == made + 1


@pytest.mark.parametrize("harm", [lambda content: content[:-1], lambda content: content[:-1] + b"?", lambda _: b""])
def test_a_damaged_file_is_replaced(cache: Cache, make: Maker, harm: Callable[[bytes], bytes]) -> None:
    cache.kept("thing", [make.file], make)
    file = the_file(cache)
    whole = file.read_bytes()
    file.write_bytes(harm(whole))
    assert cache.kept("thing", [make.file], make)[0] == "some"
    assert make.times == 2
    assert file.read_bytes() == whole


def test_what_was_written_by_code_that_is_no_more_is_made_again(
    cache: Cache, make: Maker, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A service that runs while its code is replaced writes its old classes under the new code's key."""
    cache.kept("thing", [make.file], make)
    with monkeypatch.context() as patch:
        patch.delattr(f"{Interval.__module__}.Interval")
        assert cache.kept("thing", [make.file], lambda: ("new", None)) == ("new", None)
    kept: object = cache.kept("thing", [make.file], make)
    assert kept == ("new", None)


def test_files_may_be_deleted_at_any_time(cache: Cache, make: Maker) -> None:
    cache.kept("thing", [make.file], make)
    the_file(cache).unlink()
    assert cache.kept("thing", [make.file], make)[0] == "some"
    assert make.times == 2


def test_what_is_kept_is_read_where_nothing_can_be_written(
    cache: Cache, make: Maker, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As in a container whose file system is read-only, with a cache that was filled before."""
    first = cache.kept("thing", [make.file], make)
    monkeypatch.setattr(os, "utime", _refused)
    assert cache.kept("thing", [make.file], make) == first
    assert make.times == 1


def _refused(*_given: object, **_named: object) -> None:
    raise OSError(errno.EROFS, os.strerror(errno.EROFS))


def test_mistakes_are_never_kept(cache: Cache) -> None:
    def make() -> None:
        raise AuthoringError(())

    for _ in range(2):
        with pytest.raises(AuthoringError):
            cache.kept("thing", [], make)
    assert cache.folder is not None
    assert not cache.folder.exists()


def test_only_the_user_can_read_and_write_there(cache: Cache, make: Maker) -> None:
    cache.kept("thing", [make.file], make)
    assert stat.S_IMODE(the_file(cache).parent.stat().st_mode) == 0o700
    assert stat.S_IMODE(the_file(cache).stat().st_mode) == 0o600


@pytest.mark.parametrize("mode", [0o620, 0o602])
def test_a_file_that_others_may_write_to_is_not_read(cache: Cache, make: Maker, mode: int) -> None:
    cache.kept("thing", [make.file], make)
    the_file(cache).chmod(mode)
    cache.kept("thing", [make.file], make)
    assert make.times == 2
    assert stat.S_IMODE(the_file(cache).stat().st_mode) == 0o600


@pytest.mark.parametrize("mode", [0o770, 0o707, 0o1777])
def test_in_a_folder_that_others_may_write_to_nothing_is_kept(
    cache: Cache, make: Maker, mode: int, caplog: pytest.LogCaptureFixture
) -> None:
    assert cache.folder is not None
    cache.kept("thing", [make.file], make)
    kept = the_file(cache).read_bytes()
    cache.folder.chmod(mode)
    with caplog.at_level(logging.DEBUG, "understudy.cache"):
        cache.kept("thing", [make.file], make)
    assert make.times == 2
    assert the_file(cache).read_bytes() == kept
    assert "others may write to it" in caplog.text


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can give a file away")
@pytest.mark.parametrize("whose", ["file", "folder"])
def test_what_is_another_users_is_not_read(cache: Cache, make: Maker, whose: str) -> None:
    cache.kept("thing", [make.file], make)
    os.chown(the_file(cache) if whose == "file" else the_file(cache).parent, 12_345, 12_345)
    cache.kept("thing", [make.file], make)
    assert make.times == 2


def test_a_link_is_not_followed(cache: Cache, make: Maker) -> None:
    cache.kept("thing", [make.file], make)
    file = the_file(cache)
    elsewhere = make.file.with_name("elsewhere")
    file.rename(elsewhere)
    file.symlink_to(elsewhere)
    cache.kept("thing", [make.file], make)
    assert make.times == 2
    assert not file.is_symlink()


def test_where_no_folder_can_be_nothing_is_kept(make: Maker, caplog: pytest.LogCaptureFixture) -> None:
    cache = Cache(make.file / "below a file")
    with caplog.at_level(logging.DEBUG, "understudy.cache"):
        assert [cache.kept("thing", [make.file], make)[0] for _ in range(2)] == ["some", "some"]
    assert "thing is not kept in the cache" in caplog.text
    assert all(record.levelno == logging.DEBUG for record in caplog.records)


class Boast:
    """Not one of the package's classes; its pickle would call `os.system`."""

    def __reduce__(self) -> tuple[Callable[[str], int], tuple[str]]:
        return os.system, ("touch boasted",)


@dataclass(frozen=True)
class Stranger:
    """A dataclass that is not the package's."""

    name: str


@pytest.mark.parametrize("thing", [Boast(), Stranger("a"), Path.cwd])
def test_no_class_but_our_own_is_read(cache: Cache, thing: object, tmp_path: Path) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path)
        cache.kept("thing", [], lambda: thing)
        with pytest.raises(pickle.UnpicklingError, match="may not be in a cached value"):
            cache.kept("thing", [], lambda: thing)
    assert not (tmp_path / "boasted").exists()


def test_read_only_mappings_stay_so(cache: Cache) -> None:
    for _ in range(2):
        kept = cache.kept("thing", [], lambda: MappingProxyType({"a": (1, frozenset({2}))}))
        assert isinstance(kept, MappingProxyType)
        assert kept == {"a": (1, frozenset({2}))}


def test_processes_at_the_same_time_do_not_disturb_each_other(cache: Cache, make: Maker) -> None:
    def use(number: int) -> str:
        return cache.kept("thing", [make.file], make, made_with=str(number % 2))[0]

    with ThreadPoolExecutor(8) as pool:
        assert set(pool.map(use, range(64))) == {"some"}
    assert cache.folder is not None
    assert len(list(cache.folder.iterdir())) == 2  # no temporary file is left


@pytest.mark.parametrize("told", ["off", "OFF"])
def test_it_can_be_switched_off(told: str, make: Maker, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("UNDERSTUDY_CACHE", told)
    cache = Cache.of_environment()
    for _ in range(2):
        cache.kept("thing", [make.file], make)
    assert (cache.folder, make.times) == (None, 2)


def test_the_environment_says_where(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("UNDERSTUDY_CACHE", str(tmp_path / "here"))
    assert Cache.of_environment().folder == tmp_path / "here"
    monkeypatch.setenv("UNDERSTUDY_CACHE", "")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "home"))
    folder = Cache.of_environment().folder
    assert folder is not None
    assert folder.name == "understudy"
