# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A directive for the API reference: `.. headers:: grid` documents every public header in grid/."""

from pathlib import Path

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

FOLDER = Path(__file__).parents[1] / "cpp/include/ltp"
SECTIONS = (
    "briefdescription detaileddescription innernamespace innerclass enum func var typedef "
    "user-defined public-type public-attrib public-func public-static-func public-static-attrib"
)


class Headers(SphinxDirective):
    """One section a header, ordered by name; the names must differ, for Breathe goes by them."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """The sections of the folder that the argument names."""
        folder = FOLDER / self.arguments[0]
        headers = sorted(folder.rglob("*.hpp"))
        if not headers:
            raise self.error(f"{folder}: no headers")
        sections: list[nodes.Node] = []
        for header in headers:
            title = f"ltp/{header.relative_to(FOLDER).as_posix()}"
            text = f"{title}\n{'^' * len(title)}\n\n"
            text += f".. doxygenfile:: {header.name}\n   :sections: {SECTIONS}\n\n"
            section = self.parse_text_to_nodes(text, allow_section_headings=True)
            if not any(next(node.findall(addnodes.desc), None) for node in section):
                raise self.error(f"{title}: nothing in it is documented")
            sections += section
        return sections


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the directive."""
    app.add_directive("headers", Headers)
    return {"parallel_read_safe": True}
