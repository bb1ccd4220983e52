"""Shared fixtures: the whole understudy, loaded once by each process that runs tests, and the service's nursery, which
loads it in a process of its own."""

import gc
import os
import sys
from collections.abc import Iterator
from functools import cache, lru_cache

import hypothesis
import pytest

from tests.support.chromium import CHROMIUM
from tests.support.examples import USUALLY, examples
from tests.support.kept_models import models_kept
from understudy.api.workers.processes import Nursery
from understudy.cache import _unpickled
from understudy.models import Understudy
from understudy.settings import Settings
from understudy.syntax.parser import load_pipeline

_IN_CHROMIUM = "_in_chromium"

BEGUN_FIRST = (
    _IN_CHROMIUM,
    "tests/batch/running/",
    "tests/docs/",
    "tests/api/test_",
    "tests/test_",
    "tests/examples/",
    "tests/batch/",
    "tests/clients/",
    "tests/cli/",
    "tests/rules/chaining/",
    "tests/authoring/",
    "tests/api/",
)
"""Where files take long, the longest first: begun last, one of them would keep one process busy when all others are
done."""

COMPILED_FILES_KEPT = 16
"""Twice what a load reads."""

hypothesis.settings.register_profile("understudy", examples(USUALLY))
hypothesis.settings.load_profile("understudy")


def pytest_configure(config: pytest.Config) -> None:
    """Compiled rules are kept between runs, and shared by the processes of one, but not in the user's own cache. So is
    compiled Python, which each of some hundred processes would compile anew otherwise."""
    os.environ["UNDERSTUDY_CACHE"] = str(config.rootpath / ".pytest_cache" / "understudy")
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    sys.dont_write_bytecode = False
    gc.disable()


def pytest_collection_finish() -> None:
    """What is collected stays to the end: garbage is looked for neither meanwhile nor in it, which takes half a second
    each time."""
    gc.freeze()
    gc.enable()


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Brings the files that take long to the front; `make test` hands files out in this order. Where there is no
    Chromium, what is tested in it is skipped before anything is loaded for it."""
    for item in items:
        if CHROMIUM is None and _IN_CHROMIUM in item.nodeid:
            item.add_marker(pytest.mark.skip("chromium is not installed"))
    items.sort(key=lambda item: next((rank for rank, part in enumerate(BEGUN_FIRST) if part in item.nodeid), 99))


@pytest.fixture(scope="session", autouse=True)
def read_once() -> Iterator[None]:
    """Whatever loads models in a process of tests gets the usual ones, else the same spaCy pipeline of a folder, and
    the same object of a compiled file: reading them takes longer than all else."""
    with pytest.MonkeyPatch.context() as patch, models_kept():
        patch.setattr("understudy.syntax.parser.load_pipeline", cache(load_pipeline))
        patch.setattr("understudy.cache._unpickled", lru_cache(COMPILED_FILES_KEPT)(_unpickled))
        yield


@pytest.fixture(scope="session")
def understudy() -> Iterator[Understudy]:
    with Understudy.load(Settings()) as whole:
        yield whole


@pytest.fixture(scope="session")
def nursery() -> Iterator[Nursery]:
    with Nursery.start(Settings()) as nursery:
        nursery.require_next()
        yield nursery
