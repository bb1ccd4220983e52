"""The drill of the service: see `benchmarks.api.drill`, which this runs.

python -m benchmarks.drill
"""

import sys

from .api.drill import main

if __name__ == "__main__":
    sys.exit(main())
