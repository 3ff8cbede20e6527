# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""How this package came here, what brings its extras, and whether a stranger has its name.

The distribution is called `ltp-uav`. On PyPI, `ltp` is a language toolkit that is imported by the
same name: installed beside this package, one overwrites the other's files.
"""

import os
import re
import sys
import warnings
from collections.abc import Iterable, Iterator

#: What `pip install` calls this package.
DISTRIBUTION = "ltp-uav"

_METADATA = re.compile(r"(?P<name>ltp|ltp_uav)-\d[^-]*(-py\d[.\d]*)?\.(dist|egg)-info")


def pip_install(extra: str) -> str:
    """The command that installs an extra ("geo") from where this package lies.

    In a checkout that is not installed it names the folder; elsewhere the distribution.
    """
    from pathlib import Path  # not above: `import ltp` comes by here, and it takes milliseconds

    root = Path(__file__).resolve().parents[2]
    in_checkout = (root / "pyproject.toml").is_file() and (root / "CMakeLists.txt").is_file()
    if not in_checkout or any(name == "ltp_uav" for name, _ in _installed(sys.path)):
        return f'pip install "{DISTRIBUTION}[{extra}]"'
    return f'pip install "{"." if Path.cwd() == root else root}[{extra}]"'


def warn_of_strangers(folders: Iterable[str] | None = None) -> None:
    """Warn once if a distribution named `ltp` stands on the path: it has the same import name.

    Args:
        folders: where packages are looked for; default: `sys.path`.
    """
    for name, path in _installed(sys.path if folders is None else folders):
        if name == "ltp":
            warnings.warn(
                f"{path} belongs to a distribution named `ltp`, which is imported by the same name "
                f"as this package ({DISTRIBUTION}): a former version of it, or the language "
                "toolkit. They overwrite each other's files. Use two environments, or: "
                f"pip uninstall ltp, then pip install --force-reinstall {_ourselves()}",
                RuntimeWarning,
                stacklevel=3,
            )
            return


def warn_if_overwritten() -> None:
    """The same from the command line, where a stranger's `__init__` has replaced ours."""
    if "_load" not in vars(sys.modules["ltp"]):
        warn_of_strangers()


def _ourselves() -> str:
    return pip_install("").removeprefix("pip install ").replace("[]", "")


def _installed(folders: Iterable[str]) -> Iterator[tuple[str, str]]:
    """Name and path of what is installed under either name. Only names of files are looked at."""
    for folder in dict.fromkeys(folders):
        try:
            with os.scandir(folder or ".") as entries:
                named = [(entry.name, entry.path) for entry in entries if entry.name[:3] == "ltp"]
        except OSError:  # a zip file, or not there
            continue
        for name, path in named:
            if match := _METADATA.fullmatch(name):
                yield match["name"], path
