"""glTF has y up, scenes have z up: (x, y, z) -> (x, z, -y), a quarter turn about x.

Bodies, solids and vertices are all turned, and no node above them: a program with z up, such as Blender,
turns everything back as it reads the file, and then shows each body at the coordinates that it has in the
scene.
"""

from __future__ import annotations

import numpy as np

from physsim.view.stage import FloatArray


def turned(vectors: FloatArray) -> FloatArray:
    """Positions or directions (..., 3) in the axes of glTF."""
    return np.stack([vectors[..., 0], vectors[..., 2], -vectors[..., 1]], axis=-1)


def quaternions(orientations: FloatArray) -> FloatArray:
    """Orientations (..., 4) as w, x, y, z -> in the axes of glTF, as x, y, z, w."""
    return np.concatenate([turned(orientations[..., 1:]), orientations[..., :1]], axis=-1)


def scales(factors: FloatArray) -> FloatArray:
    """Factors (..., 3) along the axes."""
    return factors[..., [0, 2, 1]]


def numbers(values: FloatArray) -> list[float]:
    """For JSON, with the nine digits that tell 32-bit floats apart."""
    return [float(f"{value:.9g}") for value in values.tolist()]
