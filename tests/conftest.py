"""What several test modules need: the whole understudy, loaded once, and the lines recorded outside the repository."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from understudy.performance import Understudy
from understudy.settings import Settings

SHARED_LINES = Path(__file__).resolve().parents[2] / "shared" / "data" / "speech" / "lines"


@pytest.fixture(scope="session")
def understudy() -> Iterator[Understudy]:
    with Understudy.load(Settings()) as whole:
        yield whole
