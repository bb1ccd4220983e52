"""`python -m app.cli`: the same as the installed command `understudy`."""

import sys

from app.cli.main import main

sys.exit(main())
