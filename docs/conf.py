# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx's settings: `make docs` builds these pages and the API reference into build/docs."""

import os
import subprocess
import sys
from pathlib import Path

from sphinx.application import Sphinx

import ltp

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))  # headers.py

project = "ltp"
author = "The ltp authors"
copyright = "2026, The ltp authors"
release = ltp.__version__
version = release

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx.ext.mathjax",
    "breathe",
    "headers",
]
html_theme = "furo"
html_title = f"ltp {release}"
html_static_path: list[str] = []

# Pages are Markdown as GitHub shows it: headings are link targets, and the tables that `ltp table`
# prints begin at a level of their own.
myst_heading_anchors = 4
suppress_warnings = ["myst.header"]
# Every header opens the namespace anew.
suppress_warnings += ["duplicate_declaration.cpp"]

# Docstrings are plain text with `code` in backticks; sections as in Google's style.
default_role = "code"
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_class_signature = "mixed"
python_display_short_literal_types = True
napoleon_numpy_docstring = False
napoleon_use_rtype = False

# The public headers: Doxygen reads their comments, Breathe shows them.
HEADERS = HERE.parent / "cpp/include"
DOXYGEN = Path(os.environ.get("LTP_DOCS_BUILD", HERE.parent / "build/docs")) / "doxygen"
breathe_projects = {"ltp": str(DOXYGEN / "xml")}
breathe_default_project = "ltp"
breathe_default_members = ("members",)
breathe_show_include = False
cpp_debug_lookup = False

DOXYGEN.mkdir(parents=True, exist_ok=True)
subprocess.run(
    ["doxygen", "-"],
    input=f"""
PROJECT_NAME           = ltp
INPUT                  = {HEADERS}
STRIP_FROM_PATH        = {HEADERS}
OUTPUT_DIRECTORY       = {DOXYGEN}
RECURSIVE              = YES
FILE_PATTERNS          = *.hpp
EXCLUDE_SYMBOLS        = *::detail::*
EXTRACT_ALL            = YES
GENERATE_XML           = YES
GENERATE_HTML          = NO
GENERATE_LATEX         = NO
XML_PROGRAMLISTING     = NO
JAVADOC_AUTOBRIEF      = YES
QUIET                  = YES
WARN_IF_INCOMPLETE_DOC = NO
WARN_AS_ERROR          = FAIL_ON_WARNINGS
""",
    text=True,
    check=True,
)


def keep_whole(
    _app: Sphinx, what: str, _name: str, _object: object, _options: object, lines: list[str]
) -> None:
    """Keep Napoleon from taking what stands before a colon for an attribute's type."""
    if what in ("attribute", "property") and lines:
        lines[:1] = lines[0].replace(": ", ":\n", 1).split("\n")


def setup(app: Sphinx) -> None:
    """Change docstrings before Napoleon reads them."""
    app.connect("autodoc-process-docstring", keep_whole, priority=400)
