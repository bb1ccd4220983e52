"""`python -m understudy.cli`: the same as the installed command `understudy`."""

import sys

from .main import main

sys.exit(main())
