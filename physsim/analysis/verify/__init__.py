"""The formula sheet as cases: scenes whose motion is known in closed form, and how they are judged.

`catalogue` declares what is compared, section by section of the sheet; `judge` compares trajectories with it;
`plot` draws the comparison. Whoever wants the trajectories runs the scenes, see `physsim/cli/verify.py`.
"""

from physsim.analysis.verify.case import Case, Check, Formula, scene_file
from physsim.analysis.verify.catalogue import FORMULAS, pick
from physsim.analysis.verify.judge import Verdict, judge

__all__ = ["FORMULAS", "Case", "Check", "Formula", "Verdict", "judge", "pick", "scene_file"]
