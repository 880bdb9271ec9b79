"""What acts between and on bodies besides contact, of a whole scene."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from physsim.model import motion
from physsim.model.findings import Findings
from physsim.model.forces import ForceTable, force_table
from physsim.model.joints import JointTable, joint_table
from physsim.model.motion import Motion, motions
from physsim.model.placement import Placement
from physsim.model.profiles import Profiles
from physsim.model.springs import SpringTable, spring_table

if TYPE_CHECKING:
    from physsim.scene import Scene


@dataclass(frozen=True)
class Mechanics:
    """Springs, joints, forces and motions, with the profiles in time that they share."""

    springs: SpringTable
    joints: JointTable
    forces: ForceTable
    motions: tuple[Motion, ...]
    profiles: Profiles

    def engine_input(self) -> dict[str, object]:
        """All of it as plain arrays; those that nothing feeds have no rows."""
        return {
            **self.profiles.engine_input(),
            **self.springs.engine_input(),
            **self.joints.engine_input(),
            **self.forces.engine_input(),
            **motion.engine_input(self.motions),
        }


def mechanics(scene: Scene, placement: Placement, findings: Findings) -> Mechanics:
    """Of a scene whose bodies stand as `placement` says; what cannot be is an error in `findings`."""
    spec, profiles = scene.spec, Profiles()
    return Mechanics(
        springs=spring_table(spec.springs, placement),
        joints=joint_table(spec.joints, spec.springs, placement, profiles, findings),
        forces=force_table(spec.forces, placement, profiles),
        motions=motions(scene.bodies, placement, profiles),
        profiles=profiles,
    )
