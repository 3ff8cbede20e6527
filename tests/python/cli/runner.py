# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Running `ltp` in a test: what a command says when it succeeds, and when it fails."""

from typer.testing import CliRunner, Result

from ltp.cli import app

#: Global paths that fit into `scenes.town`.
SHORT = ["--length", "120", "--spacing", "40", "--altitude", "30", "--margin", "10"]


def run(*arguments: object) -> Result:
    return CliRunner().invoke(app, [str(argument) for argument in arguments])


def succeed(*arguments: object) -> str:
    result = run(*arguments)
    assert result.exit_code == 0, result.output
    return result.output


def fail(*arguments: object) -> str:
    """The one line that a mistake earns."""
    result = run(*arguments)
    assert result.exit_code == 2, result.output
    assert "Traceback" not in result.output
    assert result.stderr.startswith("ltp: error: ") and result.stderr.count("\n") == 1
    return result.stderr
