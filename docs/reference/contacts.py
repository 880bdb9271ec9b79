"""Who answers which pair of shapes: the engine is asked, so the table cannot be out of date."""

from __future__ import annotations

from physsim._engine import World

from physsim.model import compile_scene
from physsim.scene import load_scene_text

SHAPES = {
    "sphere": "{type: sphere, radius: 1}",
    "capsule": "{type: capsule, radius: 1, height: 1}",
    "box": "{type: box, size: [1, 1, 1]}",
    "cylinder": "{type: cylinder, radius: 1, height: 1}",
    "cone": "{type: cone, radius: 1, height: 1}",
    "ellipsoid": "{type: ellipsoid, radii: [1, 2, 3]}",
    "rod": "{type: rod, length: 1}",
    "convex": "{type: convex, points: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]}",
}
HALFSPACE = "{type: halfspace}"


def as_markdown() -> str:
    """Shapes of moving bodies against one another and against a half-space."""
    against = {**SHAPES, "halfspace": HALFSPACE}
    lines = [f"| | {' | '.join(against)} |", f"|---|{'---|' * len(against)}"]
    for name, shape in SHAPES.items():
        cells = ["engine" if engine_answers(shape, other) else "FCL" for other in against.values()]
        lines.append(f"| **{name}** | {' | '.join(cells)} |")
    return "\n".join(lines)


def engine_answers(shape: str, other: str) -> bool:
    """Whether the engine has a kernel for the two shapes."""
    matter = "mass: 1 kg, inertia: {xx: 1, yy: 1, zz: 1}"
    scene = load_scene_text(f"""
physsim: 1
simulation: {{duration: 1 s, timestep: 1 ms}}
bodies:
  a: {{shape: {shape}, material: steel, {matter}}}
  b: {{shape: {other}, material: steel, {"fixed: true" if other == HALFSPACE else matter}}}
""")
    return not World(compile_scene(scene).engine_input()).needs_answer()
