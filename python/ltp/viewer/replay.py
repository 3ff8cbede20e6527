# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`replay`: opens a recording in the rerun viewer, private: no analytics, loopback only."""

import contextlib
import os
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

from .rerun_module import require_rerun

# `python -m rerun_cli` forgets the viewer's exit status.
_VIEWER = "import sys; from rerun_cli.__main__ import main; sys.exit(main())"
_MAGIC = (b"RRF2", b"RRIO")  # how a recording begins


def replay(path: str | os.PathLike[str]) -> int:
    """Open a recording and wait until the viewer is closed.

    The viewer gets a settings folder of its own, in which its usage statistics are switched off;
    the user's is not touched. It listens on 127.0.0.1 only, on any free port.

    Returns:
        The viewer's exit status.

    Raises:
        ImportError: with the pip command, if rerun is not installed.
        OSError: if the file cannot be read.
        ValueError: if it is no recording.
    """
    file = Path(path).resolve()
    with file.open("rb") as stream:
        if stream.read(4) not in _MAGIC:
            raise ValueError(f"{path} is not a recording (.rrd)")
    require_rerun("rerun_cli")
    viewer = [sys.executable, "-c", _VIEWER]
    with tempfile.TemporaryDirectory(prefix="ltp-viewer-") as settings:
        environment = os.environ | {"XDG_CONFIG_HOME": settings}
        subprocess.run(
            [*viewer, "analytics", "disable"],
            env=environment,
            check=True,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        command = [*viewer, str(file), "--bind", "127.0.0.1", "--port", "auto"]
        # `rerun_cli` starts the viewer proper: the two must end together.
        process = subprocess.Popen(command, env=environment, start_new_session=True)
        try:
            return process.wait()
        except BaseException:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGTERM)
            process.wait()
            raise
