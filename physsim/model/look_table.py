"""What a scene looks like: every geom that is shown or collides, as the trajectory file keeps it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from physsim.model.arrays import floats, wholes
from physsim.model.body import Body
from physsim.model.geom import Geom, GeomKind, Surface
from physsim.model.hull import Hull
from physsim.model.polyhedron import IntArray
from physsim.model.rotation import FloatArray

SURFACES = (GeomKind.HULL, GeomKind.MESH)


@dataclass(frozen=True)
class LookTable:
    """L rows in the order of the bodies.

    body (L,): number of the body; kind: name of the `GeomKind`, `surface` for hulls and meshes; parameters
    (L, 4) [m] as `GeomKind` lists them; position (L, 3) [m] from the body's own ORIGIN and orientation
    (L, 4), body axes; material; color: "#rrggbb", "" where nobody declares one; shown and collides (L,), 0
    or 1; surface (L,): index into `surfaces`, -1 for the other kinds. Equal surfaces are stored once.
    """

    body: IntArray
    kind: tuple[str, ...]
    parameters: FloatArray
    position: FloatArray
    orientation: FloatArray
    material: tuple[str, ...]
    color: tuple[str, ...]
    shown: IntArray
    collides: IntArray
    surface: IntArray
    surfaces: tuple[Surface, ...]


def look_table(bodies: Sequence[Body], color_of: Callable[[str], str]) -> LookTable:
    """The table of all bodies. color_of: material -> its colour."""
    rows = [(number, look) for number, body in enumerate(bodies) for look in body.looks]
    geoms = [look.geom for _, look in rows]
    store = _Surfaces()
    numbers = [store.number(geom) for geom in geoms]
    return LookTable(
        body=wholes([number for number, _ in rows]),
        kind=tuple("surface" if geom.kind in SURFACES else geom.kind.name.lower() for geom in geoms),
        parameters=floats([[*geom.parameters, *[0.0] * (4 - len(geom.parameters))] for geom in geoms], 4),
        position=floats([geom.position for geom in geoms], 3),
        orientation=floats([geom.orientation for geom in geoms], 4),
        material=tuple(geom.material for geom in geoms),
        color=tuple(color_of(geom.material) for geom in geoms),
        shown=wholes([look.shown for _, look in rows]),
        collides=wholes([look.collides for _, look in rows]),
        surface=wholes(numbers),
        surfaces=tuple(store.surfaces),
    )


class _Surfaces:
    """Numbers surfaces, the same one once; hulls become triangles."""

    def __init__(self) -> None:
        self.surfaces: list[Surface] = []
        self._numbers: dict[int, int] = {}

    def number(self, geom: Geom) -> int:
        """Of the geom's surface or hull; -1 for geoms without."""
        source = geom.surface or geom.hull
        if source is None:
            return -1
        if id(source) not in self._numbers:
            self._numbers[id(source)] = len(self.surfaces)
            self.surfaces.append(source if isinstance(source, Surface) else _surface_of(source))
        return self._numbers[id(source)]


def _surface_of(hull: Hull) -> Surface:
    return Surface(hull.vertices, hull.triangles())
