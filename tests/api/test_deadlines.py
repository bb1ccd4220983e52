"""When a request must be answered."""

import asyncio
import time

import pytest

from understudy.api.deadlines import Deadline
from understudy.errors import ServiceError


def test_waiting_ends_with_the_deadline() -> None:
    async def scenario() -> None:
        began = time.monotonic()
        with pytest.raises(ServiceError) as caught:
            await Deadline.starting_now(0.05).within(asyncio.sleep(5))
        assert caught.value.code == "deadline_passed"
        assert time.monotonic() - began < 2

    asyncio.run(scenario())
