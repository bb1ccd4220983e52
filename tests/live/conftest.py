"""The models of live speech, loaded once."""

import pytest

from understudy.live.models import LiveModels
from understudy.models import Understudy


@pytest.fixture(scope="session")
def models(understudy: Understudy) -> LiveModels:
    return LiveModels.load(understudy)
