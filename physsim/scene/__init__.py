"""What the user wrote: YAML text -> typed spec, with every mistake told at its line and column."""

from physsim.scene.loader import Original, load_scene, load_scene_text, original
from physsim.scene.problems import format_problem, format_problems, problem_as_dict
from physsim.scene.scene import Scene
from physsim.scene.spec.scene import SceneSpec

__all__ = [
    "Original",
    "Scene",
    "SceneSpec",
    "format_problem",
    "format_problems",
    "load_scene",
    "load_scene_text",
    "original",
    "problem_as_dict",
]
