# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`python -m ltp` is the same as `ltp`."""

from ltp.cli import main

if __name__ == "__main__":
    main()
