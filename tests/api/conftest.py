"""The nursery of the service's tests."""

from collections.abc import Iterator

import pytest

from understudy.api.workers.processes import Nursery


@pytest.fixture(scope="package")
def nursery(nursery: Nursery) -> Iterator[Nursery]:
    """One that has no children but those of these tests, which count them: the other may serve pages elsewhere."""
    with nursery.divided() as own:
        own.require_next()
        yield own
