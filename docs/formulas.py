"""Writes the pages about formulas from a run of every case of `physsim verify`.

    python docs/formulas.py             docs/formulas.md, and one page with its picture per formula in
    docs/formulas

Takes about a minute. The numbers are those of this machine; they are the same bits everywhere.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from reference.where import WHERE

from physsim.analysis.verify import FORMULAS, Verdict, scene_file
from physsim.analysis.verify.catalogue import SECTIONS
from physsim.analysis.verify.plot import draw_formula
from physsim.cli.verify_run import Tried, run_all

HERE = Path(__file__).resolve().parent
REPOSITORY = HERE.parent
HEAD = """# Formulas

Every row of the formula sheet that physsim covers, where it lives in the code, the scene that shows it at
work, and how far the engine is from the theory. `physsim verify` makes all of these comparisons on your
own installation; `physsim verify --list` names the scene files, which are ordinary scenes to copy and
change. Written by [formulas.py](formulas.py).

Errors are the greatest ones of a run, as a part of the greatest theoretical value (absolute where that is
0). Of formulas that are run with several integrators, the error at the smallest timestep of each and its
measured order stand on the formula's page. What the sheet itself has wrong is told [at the
end](#slips-of-the-sheet).
"""
SLIPS = """## Slips of the sheet

* Its collision code writes r × ω where its own formula has ω × r. The formula is right.
* The comment in that code says that the normal runs from A to B; its formulas need B to A, which is the
convention here. * Its code for a rigid body multiplies torque by the inverse inertia and forgets the
gyroscopic term. Its equations of motion are right: dL/dt = τ, and ω follows from L.
* "μ_s is 1.2 to 1.4 times μ_k" does not hold in its own table (greased steel 1.67, Teflon 1.0) and is not
enforced. * Its cone has the base at the origin; the moments here are about the centre of mass, H/4 above
the base. * Explicit Euler, the torsional spring and several moments of inertia have lost their text; the
standard ones are used.
"""


def main() -> int:
    """Run, write, and say what is off."""
    tried = list(run_all(FORMULAS, quiet=False))
    (HERE / "formulas").mkdir(exist_ok=True)
    for each in tried:
        name = each.formula.name
        draw_formula(each.formula, each.verdicts, HERE / "formulas" / f"{name}.svg")
        (HERE / "formulas" / f"{name}.md").write_text(page(each), encoding="utf-8")
    (HERE / "formulas.md").write_text(overview(tried), encoding="utf-8")
    off = [each.formula.name for each in tried if not each.passed]
    print(f"{len(tried)} formulas; off: {', '.join(off) or 'none'}")
    return 1 if off else 0


def overview(tried: Sequence[Tried]) -> str:
    """One table per section of the sheet."""
    parts = [HEAD]
    for number, title in SECTIONS.items():
        rows = [row(each) for each in tried if each.formula.section == number]
        head = "| formula | equation | code | scene | tests | measured error |\n|---|---|---|---|---|---|"
        parts.append("\n".join([f"## {number} {title}\n", head, *rows, ""]))
    return "\n".join([*parts, SLIPS])


def row(each: Tried) -> str:
    """One formula as a row of the table."""
    formula = each.formula
    code, tests = WHERE[formula.name]
    cells = [
        f"[{formula.title}](formulas/{formula.name}.md)",
        f"`{formula.equation}`".replace("|", "\\|"),
        ", ".join(link(path, "..") for path in code),
        ", ".join(link(str(scene_file(scene).relative_to(REPOSITORY)), "..") for scene in formula.scenes),
        ", ".join(link(path, "..") for path in tests),
        measured(each.verdicts),
    ]
    return f"| {' | '.join(cells)} |"


def measured(verdicts: Sequence[Verdict]) -> str:
    """The span of the errors, and of the measured orders."""
    errors = sorted(verdict.error for verdict in verdicts)
    span = f"{errors[0]:.1g}" if len(errors) == 1 else f"{errors[0]:.1g} to {errors[-1]:.1g}"
    orders = [verdict.order for verdict in verdicts if verdict.check.order and verdict.order]
    return span + (f"; orders {', '.join(f'{order:.2f}' for order in orders)}" if orders else "")


def link(path: str, up: str) -> str:
    """A link to a file of the repository, called by its own name."""
    return f"[{Path(path).name}]({up}/{path})"


def page(each: Tried) -> str:
    """The page of one formula: equation, numbers, picture, scene."""
    formula = each.formula
    code, tests = WHERE[formula.name]
    lines = [
        f"# {formula.title}",
        "",
        "```text",
        *formula.equation.split(";  "),
        "```",
        "",
        f"{formula.says} Source: {formula.source}.",
        "",
        f"In the code: {', '.join(link(path, '../..') for path in code)}. "
        f"Tests: {', '.join(link(path, '../..') for path in tests)}. "
        f"On your installation: `physsim verify --case {formula.name}`.",
        "",
        f"![What was measured against the theory]({formula.name}.svg)",
        "",
        "| case | compared | theory | measured | unit | error | allowed | order |",
        "|---|---|---|---|---|---|---|---|",
        *(comparison(verdict) for verdict in each.verdicts),
        "",
    ]
    for scene in formula.scenes:
        lines += [
            f"`{scene}.yaml`:",
            "",
            "```yaml",
            scene_file(scene).read_text(encoding="utf-8").rstrip(),
            "```",
            "",
        ]
    return "\n".join(lines)


def comparison(verdict: Verdict) -> str:
    """One line of the table of numbers."""
    check = verdict.check
    order = "" if check.order is None or verdict.order is None else f"{verdict.order:.3f} of {check.order:g}"
    cells = [
        verdict.case.name,
        check.name.replace("|", "\\|"),
        f"{verdict.theory:.9g}",
        f"{verdict.measured:.9g}",
        check.unit,
        f"{verdict.error:.2g}",
        f"{check.within:.2g}" + ("" if check.relative else f" {check.unit}"),
        order,
    ]
    return f"| {' | '.join(cells)} |"


if __name__ == "__main__":
    sys.exit(main())
