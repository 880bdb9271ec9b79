"""Geoms of all bodies -> one table."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from physsim.model.body import Body
from physsim.model.geom import Geom, Surface
from physsim.model.hull import Hull
from physsim.model.model import GeomTable


def geom_table(bodies: Sequence[Body], material_numbers: Mapping[str, int]) -> GeomTable:
    """The table of all geoms, in the order of the bodies; equal hulls and surfaces are stored once."""
    rows = [(number, body, geom) for number, body in enumerate(bodies) for geom in body.geoms]
    hulls: dict[int, tuple[int, Hull]] = {}
    surfaces: dict[int, tuple[int, Surface]] = {}
    parameters = np.zeros((len(rows), 4))
    for row, (_, _, geom) in enumerate(rows):
        own = _parameters(geom, hulls, surfaces)
        parameters[row, : len(own)] = own
    return GeomTable(
        body=np.array([number for number, _, _ in rows], dtype=np.int32),
        kind=np.array([int(geom.kind) for _, _, geom in rows], dtype=np.int32),
        parameters=parameters,
        position=np.array([geom.position - body.properties.center for _, body, geom in rows]).reshape(-1, 3),
        orientation=np.array([geom.orientation for _, _, geom in rows]).reshape(-1, 4),
        material=np.array([material_numbers[geom.material] for _, _, geom in rows], dtype=np.int32),
        hulls=tuple(hull for _, hull in hulls.values()),
        surfaces=tuple(surface for _, surface in surfaces.values()),
    )


def _parameters(
    geom: Geom, hulls: dict[int, tuple[int, Hull]], surfaces: dict[int, tuple[int, Surface]]
) -> tuple[float, ...]:
    if geom.hull is not None:
        return (float(hulls.setdefault(id(geom.hull), (len(hulls), geom.hull))[0]),)
    if geom.surface is not None:
        return (float(surfaces.setdefault(id(geom.surface), (len(surfaces), geom.surface))[0]),)
    return geom.parameters
