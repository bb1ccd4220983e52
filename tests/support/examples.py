"""How many examples a property is tried with.

The suite tries the same ones in every run, so that what it says depends on the code alone; `make search` tries new
ones, `UNDERSTUDY_EXAMPLES` times as many. What that finds is a mistake, and gets a test of its own.
"""

import os

from hypothesis import HealthCheck, settings

TIMES = int(os.environ.get("UNDERSTUDY_EXAMPLES", "1"))
USUALLY = 100


def examples(count: int) -> settings:
    """So many in the suite; however long each takes, which says more of what else runs on the machine."""
    return settings(
        max_examples=count * TIMES,
        derandomize=TIMES == 1,
        deadline=None,
        suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
    )
