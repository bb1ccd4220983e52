"""What several test modules need: the whole understudy, loaded once."""

from collections.abc import Iterator

import pytest

from understudy.performance import Understudy
from understudy.settings import Settings


@pytest.fixture(scope="session")
def understudy() -> Iterator[Understudy]:
    with Understudy.load(Settings()) as whole:
        yield whole
