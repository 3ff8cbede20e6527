# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What all tests rely on: Ctrl-C works, and they pass every time or never."""

import signal

from hypothesis import settings

# The same examples in every run, however slow the machine is.
settings.register_profile("ltp", derandomize=True, deadline=None)
settings.load_profile("ltp")

# A shell without job control starts commands in the background with SIGINT ignored, and children
# inherit that; the tests that press Ctrl-C in a child would wait for ever.
signal.signal(signal.SIGINT, signal.default_int_handler)
