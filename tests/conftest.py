"""What several test modules need: the whole understudy, loaded once by each process that runs tests."""

from collections.abc import Iterator

import hypothesis
import pytest

from understudy.performance import Understudy
from understudy.settings import Settings

# How long an example takes says more of what else runs on the machine than of what is tested.
hypothesis.settings.register_profile("understudy", deadline=None)
hypothesis.settings.load_profile("understudy")


@pytest.fixture(scope="session")
def understudy() -> Iterator[Understudy]:
    with Understudy.load(Settings()) as whole:
        yield whole
