"""Shared fixtures: the whole understudy, loaded once by each process that runs tests, and the service's nursery, which
loads it in a process of its own."""

import os
from collections.abc import Iterator

import hypothesis
import pytest

from tests.support.examples import USUALLY, examples
from understudy.api.workers.processes import Nursery
from understudy.models import Understudy
from understudy.settings import Settings

BEGUN_FIRST = (
    "_in_chromium",
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

hypothesis.settings.register_profile("understudy", examples(USUALLY))
hypothesis.settings.load_profile("understudy")


def pytest_configure(config: pytest.Config) -> None:
    """Compiled rules are kept between runs, and shared by the processes of one, but not in the user's own cache."""
    os.environ["UNDERSTUDY_CACHE"] = str(config.rootpath / ".pytest_cache" / "understudy")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Brings the files that take long to the front; `make test` hands files out in this order."""
    items.sort(key=lambda item: next((rank for rank, part in enumerate(BEGUN_FIRST) if part in item.nodeid), 99))


@pytest.fixture(scope="session")
def understudy() -> Iterator[Understudy]:
    with Understudy.load(Settings()) as whole:
        yield whole


@pytest.fixture(scope="session")
def nursery() -> Iterator[Nursery]:
    with Nursery.start(Settings()) as nursery:
        yield nursery
