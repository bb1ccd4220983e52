"""When a request must be answered."""

import asyncio

import pytest

from understudy.api.workers.limits import Deadline
from understudy.errors import ServiceError


def test_waiting_ends_with_the_deadline() -> None:
    async def scenario() -> None:
        with pytest.raises(ServiceError) as caught:
            await Deadline.starting_now(0.05).within(asyncio.Event().wait())
        assert caught.value.code == "deadline_passed"

    asyncio.run(scenario())
