"""The part of a page's head that does not change with time: bodies, meshes, joints, springs."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from physsim.view.page.sections import Sections
from physsim.view.shapes.tessellate import Mesh, Placed, tessellated
from physsim.view.stage import Actor, Link, Solid, Stage

# Half width of a half-space in the head; the page stretches it to the size of what it shows.
GROUND = 1.0
# Segments around a circle: fine up to so many solids, what looks round close by; and coarse, for machines
# without a graphics card, which draw a thousand moving bodies with it and no more.
FINENESS = ((100, 48), (400, 32))
FINE_OF_MANY = 24
COARSE = 8


def still_part(stage: Stage, sections: Sections) -> dict[str, Any]:
    """Bodies, meshes (fine and coarse ones, in the same order), placed, joints and springs, as
    `viewer/src/head.ts` describes them.
    """
    fineness = next((fine for most, fine in FINENESS if len(stage.solids) <= most), FINE_OF_MANY)
    meshes, placed = tessellated(stage, fineness, GROUND)
    coarse, _ = tessellated(stage, COARSE, GROUND)
    return {
        "bodies": _bodies(stage.actors, stage.solids, sections),
        "meshes": [_mesh(*both, sections) for both in zip(meshes, coarse, strict=True)],
        "placed": _placed(placed, stage.solids, sections),
        "joints": _links(stage.joints, sections),
        "springs": _links(stage.springs, sections),
    }


def _bodies(actors: Sequence[Actor], solids: Iterable[Solid], sections: Sections) -> dict[str, Any]:
    """`numbers`: mass, centre (3) and inertia (9) of each. A body has the colour of its first solid."""
    colours: dict[int, str] = {}
    for solid in solids:
        colours.setdefault(solid.body, solid.colour)
    numbers = [[actor.mass, *actor.center, *np.ravel(actor.inertia)] for actor in actors]
    return {
        "name": [actor.name for actor in actors],
        "material": _indexed([actor.material for actor in actors]),
        "colour": _indexed([colours.get(number, "#808080") for number in range(len(actors))]),
        "fixed": [int(actor.fixed) for actor in actors],
        "numbers": sections.add("f8", np.reshape(numbers, (len(actors), 13))),
    }


def _mesh(mesh: Mesh, coarse: Mesh, sections: Sections) -> dict[str, Any]:
    """`coarse`: None where it is the same."""
    same = len(coarse.triangles) == len(mesh.triangles)
    return {
        "vertices": sections.add("f4", mesh.vertices),
        "normals": sections.add("f4", mesh.normals),
        "triangles": sections.add("u4", mesh.triangles),
        "coarse": None if same else _mesh(coarse, coarse, sections),
    }


def _placed(placed: Sequence[Placed], solids: Sequence[Solid], sections: Sections) -> dict[str, Any]:
    """`numbers`: scale (3), position (3) and orientation (4) of each."""
    own = [solids[part.solid] for part in placed]
    numbers = [[*p.scale, *s.position, *s.orientation] for p, s in zip(placed, own, strict=True)]
    return {
        "mesh": [part.mesh for part in placed],
        "body": [solid.body for solid in own],
        "kind": _indexed([solid.kind for solid in own]),
        "material": _indexed([solid.material for solid in own]),
        "colour": _indexed([solid.colour for solid in own]),
        "shown": [int(solid.shown) for solid in own],
        "collides": [int(solid.collides) for solid in own],
        "numbers": sections.add("f8", np.reshape(numbers, (len(placed), 10))),
    }


def _links(links: Sequence[Link], sections: Sections) -> dict[str, Any]:
    """`numbers`: anchors (6) and axis (3) of each, NaN where there is none."""
    numbers = [[*np.ravel(link.anchors), *link.axis] for link in links]
    return {
        "name": [link.name for link in links],
        "kind": _indexed([link.kind for link in links]),
        "bodies": [list(link.bodies) for link in links],
        "numbers": sections.add("f8", np.reshape(numbers, (len(links), 9))),
    }


def _indexed(words: Sequence[str]) -> dict[str, list[Any]]:
    """Each different word once, and for each place which one."""
    known = {word: number for number, word in enumerate(dict.fromkeys(words))}
    return {"words": list(known), "of": [known[word] for word in words]}
