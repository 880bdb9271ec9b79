"""What `physsim verify` says: the table, the list, the JSON document."""

# ruff: noqa: PLC0415  a verb imports the rooms that it needs when it is called

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import click

from physsim.cli import output
from physsim.cli.table import number, table

if TYPE_CHECKING:
    from physsim.analysis.verify import Formula, Verdict
    from physsim.cli.verify_run import Tried

HEAD = ("case", "compared", "theory", "measured", "unit", "error", "order", "passed")
RIGHT = (2, 3, 5, 6)


def show_list(formulas: Sequence[Formula], as_json: bool) -> None:
    """Names, equations and scene files."""
    from physsim.analysis.verify import scene_file
    from physsim.analysis.verify.catalogue import SECTIONS

    if as_json:
        output.document("verify", 0, formulas=[formula_data(formula) for formula in formulas])
        return
    for section, title in SECTIONS.items():
        of_section = [formula for formula in formulas if formula.section == section]
        if of_section:
            output.result(click.style(f"{section} {title}", bold=True))
        for formula in of_section:
            output.result(f"  {formula.name}: {formula.equation}")
            for scene in formula.scenes:
                output.result(f"    {scene_file(scene)}")


def show(tried: Sequence[Tried]) -> None:
    """The table, each formula above its comparisons; then whatever else was off, then the count."""
    rows = [row(verdict) for each in tried for verdict in each.verdicts]
    head, *lines = table(HEAD, rows, right=RIGHT).splitlines()
    output.result(head)
    for each in tried:
        output.result(click.style(f"{each.formula.title}: {each.formula.equation}", bold=True))
        for _ in each.verdicts:
            output.result(lines.pop(0))
        for trouble in each.troubles:
            output.result(click.style(f"NO: {trouble}", fg="red"))
    failed = sum(not verdict.passed for each in tried for verdict in each.verdicts)
    troubles = sum(len(each.troubles) for each in tried)
    expected = sum(each.expectations for each in tried)
    output.result(
        f"\n{len(rows) - failed} of {len(rows)} comparisons passed, {expected} expectations of the scenes "
        f"checked, {output.counted(troubles, 'trouble', 'troubles')}"
    )


def row(verdict: Verdict) -> list[str]:
    """One line of the table."""
    check, passed = verdict.check, verdict.passed
    return [
        verdict.case.name,
        check.name,
        number(verdict.theory, 8),
        number(verdict.measured, 8),
        check.unit,
        number(verdict.error, 2),
        "" if check.order is None else number(verdict.order, 3),
        click.style("yes" if passed else "NO", fg="green" if passed else "red"),
    ]


def as_data(tried: Sequence[Tried]) -> dict[str, Any]:
    """The JSON document: formulas with their comparisons."""
    return {
        "passed": all(each.passed for each in tried),
        "formulas": [
            formula_data(each.formula)
            | {
                "passed": each.passed,
                "expectations": each.expectations,
                "troubles": each.troubles,
                "comparisons": [verdict_data(verdict) for verdict in each.verdicts],
            }
            for each in tried
        ],
    }


def formula_data(formula: Formula) -> dict[str, Any]:
    """What a formula is, in words."""
    from physsim.analysis.verify import scene_file

    return {
        "name": formula.name,
        "section": formula.section,
        "title": formula.title,
        "equation": formula.equation,
        "source": formula.source,
        "scenes": [str(scene_file(scene)) for scene in formula.scenes],
        "cases": [case.name for case in formula.cases],
    }


def verdict_data(verdict: Verdict) -> dict[str, Any]:
    """One comparison, in numbers."""
    return {
        "case": verdict.case.name,
        "compared": verdict.check.name,
        "unit": verdict.check.unit,
        "theory": verdict.theory,
        "measured": verdict.measured,
        "error": verdict.error,
        "within": verdict.check.within,
        "relative": verdict.check.relative,
        "timesteps": list(verdict.timesteps),
        "errors": list(verdict.errors),
        "order": verdict.order,
        "order_expected": verdict.check.order,
        "passed": verdict.passed,
    }
