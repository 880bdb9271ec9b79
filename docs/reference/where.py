"""Where each formula of the sheet lives in the code, and the tests that hold it."""

from __future__ import annotations

INTEGRATORS = ("engine/src/integrator",)
SPRINGS = ("engine/src/force/linear.rs", "engine/src/force/law.rs")
JOINTS = ("engine/src/joint/placement.rs", "engine/src/articulation")
MOMENTS = ("physsim/model/primitives.py",)
MOMENTS_TESTS = ("tests/model/test_model_primitives.py", "tests/model/test_model_inertia.py")
VERIFY = "tests/analysis/test_analysis_verify.py"

WHERE: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "free_fall": (INTEGRATORS, ("tests/physics/test_physics_flight.py", VERIFY)),
    "force": (("engine/src/force/applied.rs",), ("tests/physics/test_physics_forces.py", VERIFY)),
    "torque": (
        ("engine/src/force/applied.rs", "engine/src/body.rs"),
        ("tests/physics/test_physics_forces.py", VERIFY),
    ),
    "energy_and_momentum": (
        ("engine/src/ledger.rs", "physsim/simulation/measure.py"),
        ("tests/physics/test_physics_invariance.py", VERIFY),
    ),
    "impact_head_on": (("engine/src/impact.rs",), ("tests/physics/test_physics_collisions.py", VERIFY)),
    "impact_off_centre": (
        ("engine/src/impact.rs", "engine/src/contact.rs"),
        ("tests/physics/test_physics_collisions.py", VERIFY),
    ),
    "bounce": (("engine/src/impact.rs",), ("tests/physics/test_physics_bounce.py", VERIFY)),
    "static_friction": (("engine/src/solver.rs",), ("tests/physics/test_physics_friction.py", VERIFY)),
    "kinetic_friction": (("engine/src/solver.rs",), ("tests/physics/test_physics_friction.py", VERIFY)),
    "friction_impulse": (("engine/src/impact.rs",), ("tests/physics/test_physics_friction.py", VERIFY)),
    "spring_damper": (SPRINGS, ("tests/physics/test_physics_springs.py", VERIFY)),
    "damping_ratio": (("physsim/model/springs.py",), ("tests/physics/test_physics_springs.py", VERIFY)),
    "natural_frequency": (SPRINGS, ("tests/physics/test_physics_springs.py", VERIFY)),
    "torsional_spring": (
        ("engine/src/force/torsional.rs",),
        ("tests/physics/test_physics_springs.py", VERIFY),
    ),
    "quaternion": (("engine/src/math.rs", *INTEGRATORS), ("tests/physics/test_physics_rotation.py", VERIFY)),
    "free_rotation": (
        ("engine/src/body.rs", *INTEGRATORS),
        ("tests/physics/test_physics_rotation.py", VERIFY),
    ),
    "wobbling_plate": (
        ("engine/src/body.rs", *INTEGRATORS),
        ("tests/physics/test_physics_rotation.py", VERIFY),
    ),
    "heavy_top": (JOINTS, ("tests/physics/test_physics_rotation.py", VERIFY)),
    "rotating_frame": (("physsim/analysis/verify/sections/rigid_body.py",), (VERIFY,)),
    **{
        f"inertia_{shape}": (MOMENTS, (*MOMENTS_TESTS, VERIFY))
        for shape in ("sphere", "hollow_sphere", "cylinder", "box", "cone", "rod", "capsule", "ellipsoid")
    },
    "rolling": (("engine/src/solver.rs",), ("tests/physics/test_physics_friction.py", VERIFY)),
    "parallel_axis": (("physsim/model/inertia.py",), ("tests/model/test_model_inertia.py", VERIFY)),
    "integrator": (INTEGRATORS, ("tests/physics/test_physics_integrators.py", VERIFY)),
    "integrator_energy": (INTEGRATORS, ("tests/physics/test_physics_integrators.py", VERIFY)),
    "kepler": (("engine/src/force/gravitation.rs",), ("tests/physics/test_physics_orbits.py", VERIFY)),
    "pendulum": (JOINTS, ("tests/physics/test_physics_joints.py", VERIFY)),
    "double_pendulum": (JOINTS, ("tests/physics/test_physics_joints.py", VERIFY)),
    "stabilization": (("engine/src/position.rs", *JOINTS), ("tests/physics/test_physics_joints.py", VERIFY)),
    "ball_joint": (JOINTS, ("tests/physics/test_physics_joints.py", VERIFY)),
    "hinge": (JOINTS, ("tests/physics/test_physics_joints.py", VERIFY)),
    "slider": (JOINTS, ("tests/physics/test_physics_joints.py", VERIFY)),
    "fixed_joint": (JOINTS, ("tests/physics/test_physics_joints.py", VERIFY)),
    "cone_joint": (JOINTS, ("tests/physics/test_physics_joints.py", VERIFY)),
    "drag": (("engine/src/force/drag.rs",), ("tests/physics/test_physics_forces.py", VERIFY)),
    "time_profile": (
        ("engine/src/profile.rs", "physsim/scene/program.py"),
        ("tests/physics/test_physics_forces.py", VERIFY),
    ),
    "shaken_spring": (("engine/src/motion.rs", *SPRINGS), ("tests/physics/test_physics_forces.py", VERIFY)),
    "force_curve": (("engine/src/curve.rs",), ("tests/physics/test_physics_springs.py", VERIFY)),
    "rolling_friction": (("engine/src/roll.rs",), ("tests/physics/test_physics_rolling.py", VERIFY)),
    "conveyor": (("engine/src/contact.rs",), ("tests/physics/test_physics_friction.py", VERIFY)),
    "screw": (JOINTS, ("tests/physics/test_physics_joints.py", VERIFY)),
    "gear": (JOINTS, ("tests/physics/test_physics_joints.py", VERIFY)),
    "universal": (JOINTS, ("tests/physics/test_physics_joints.py", VERIFY)),
    "drives": (
        ("engine/src/joint/drive.rs", "engine/src/joint/pull.rs"),
        ("tests/physics/test_physics_joints.py", VERIFY),
    ),
    "breaking": (("engine/src/joint/joints.rs",), ("tests/physics/test_physics_joints.py", VERIFY)),
}
"""Formula: (files of the code, files of tests)."""
