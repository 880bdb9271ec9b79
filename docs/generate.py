"""Writes the reference parts of these pages from the code that they describe.

    python docs/generate.py            renew every page
    python docs/generate.py --check    exit 1 when one is stale; what the tests do

A generated part stands between `<!-- begin generated NAME -->` and `<!-- end generated NAME -->`;
everything else on a page is written by hand.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]

from reference import commands, materials, performance, quantities, scene, trajectory  # noqa: E402

PARTS: dict[str, Callable[[], str]] = {
    "commands": commands.as_markdown,
    "comparison": performance.comparison,
    "comparison_details": performance.details,
    "instructions": performance.instructions,
    "materials": materials.as_markdown,
    "quantities": quantities.as_markdown,
    "scene": scene.as_markdown,
    "trajectory": trajectory.as_markdown,
}
PART = re.compile(r"(<!-- begin generated (\w+) -->\n).*?(<!-- end generated \2 -->)", re.DOTALL)


def renewed(page: str) -> str:
    """The page with every generated part written anew. Raises KeyError for a part that nobody makes."""
    return PART.sub(lambda found: found[1] + "\n" + PARTS[found[2]]().strip() + "\n\n" + found[3], page)


def stale_pages() -> dict[Path, str]:
    """What the pages should be, for those that are not."""
    pages = {path: path.read_text(encoding="utf-8") for path in sorted(HERE.glob("*.md"))}
    fresh = {path: renewed(text) for path, text in pages.items()}
    return {path: fresh[path] for path in pages if fresh[path] != pages[path]}


def main() -> int:
    """0 when nothing is stale, or after renewing; 1 when `--check` found something."""
    stale = stale_pages()
    checking = "--check" in sys.argv[1:]
    for path, text in stale.items():
        print(f"{path.name} is stale" if checking else f"{path.name} renewed")
        if not checking:
            path.write_text(text, encoding="utf-8")
    return 1 if checking and stale else 0


if __name__ == "__main__":
    sys.exit(main())
