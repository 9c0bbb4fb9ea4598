"""`python -m tools.same record FILE` and `python -m tools.same compare FILE`."""

import sys

from tools.same.command import main

sys.exit(main())
