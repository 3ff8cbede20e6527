# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What all tests rely on: Ctrl-C works, and they pass every time or never."""

import signal

from hypothesis import settings
from hypothesis.internal.conjecture import providers

# The same examples in every run, however slow the machine is, and none from an earlier run.
settings.register_profile("ltp", derandomize=True, deadline=None, database=None)
# Fresh ones: `make test-random`. What it finds is kept in .hypothesis, and tried first.
settings.register_profile("random", derandomize=False, deadline=None, print_blob=True)
settings.load_profile("ltp")

# Of late, hypothesis also draws numbers that stand in the sources of whatever modules are loaded:
# then a test's examples would depend on which tests ran before, and on how the package is
# installed. The version is fixed in pyproject.toml, so its inner names may be used.
providers._get_local_constants = lambda: providers.Constants()

# A shell without job control starts commands in the background with SIGINT ignored, and children
# inherit that; the tests that press Ctrl-C in a child would wait for ever.
signal.signal(signal.SIGINT, signal.default_int_handler)
