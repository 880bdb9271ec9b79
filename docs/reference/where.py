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
    "force": (("engine/src/force/applied.rs",), (VERIFY,)),
    "torque": (("engine/src/force/applied.rs", "engine/src/body.rs"), (VERIFY,)),
    "energy_and_momentum": (("engine/src/ledger.rs", "physsim/simulation/measure.py"), (VERIFY,)),
    "impact_head_on": (("engine/src/impact.rs",), ("tests/physics/test_physics_collisions.py", VERIFY)),
    "impact_off_centre": (
        ("engine/src/impact.rs", "engine/src/contact.rs"),
        ("tests/physics/test_physics_collisions.py", VERIFY),
    ),
    "bounce": (("engine/src/impact.rs",), ("tests/physics/test_physics_bounce.py", VERIFY)),
    "static_friction": (("engine/src/solver.rs",), ("tests/physics/test_physics_friction.py", VERIFY)),
    "kinetic_friction": (("engine/src/solver.rs",), ("tests/physics/test_physics_friction.py", VERIFY)),
    "friction_impulse": (("engine/src/impact.rs",), ("tests/physics/test_physics_friction.py", VERIFY)),
    "spring_damper": (SPRINGS, (VERIFY,)),
    "damping_ratio": (("physsim/model/springs.py",), (VERIFY,)),
    "natural_frequency": (SPRINGS, (VERIFY,)),
    "torsional_spring": (("engine/src/force/torsional.rs",), (VERIFY,)),
    "quaternion": (("engine/src/math.rs", *INTEGRATORS), ("tests/physics/test_physics_flight.py", VERIFY)),
    "free_rotation": (("engine/src/body.rs", *INTEGRATORS), ("tests/physics/test_physics_flight.py", VERIFY)),
    "wobbling_plate": (("engine/src/body.rs", *INTEGRATORS), (VERIFY,)),
    "heavy_top": (JOINTS, (VERIFY,)),
    "rotating_frame": (("physsim/analysis/verify/sections/rigid_body.py",), (VERIFY,)),
    **{
        f"inertia_{shape}": (MOMENTS, (*MOMENTS_TESTS, VERIFY))
        for shape in ("sphere", "hollow_sphere", "cylinder", "box", "cone", "rod", "capsule", "ellipsoid")
    },
    "rolling": (("engine/src/solver.rs",), ("tests/physics/test_physics_friction.py", VERIFY)),
    "parallel_axis": (("physsim/model/inertia.py",), ("tests/model/test_model_inertia.py", VERIFY)),
    "integrator": (INTEGRATORS, (VERIFY,)),
    "integrator_energy": (INTEGRATORS, (VERIFY,)),
    "kepler": (("engine/src/force/gravitation.rs",), (VERIFY,)),
    "pendulum": (JOINTS, (VERIFY,)),
    "double_pendulum": (JOINTS, (VERIFY,)),
    "stabilization": (("engine/src/position.rs", *JOINTS), (VERIFY,)),
    "ball_joint": (JOINTS, (VERIFY,)),
    "hinge": (JOINTS, (VERIFY,)),
    "slider": (JOINTS, (VERIFY,)),
    "fixed_joint": (JOINTS, (VERIFY,)),
    "cone_joint": (JOINTS, (VERIFY,)),
}
"""Formula: (files of the code, files of tests)."""
