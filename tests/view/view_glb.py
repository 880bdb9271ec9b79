"""A reader of binary glTF that shares nothing with the writer: JSON, buffers, and poses at any time.

After the specification: LINEAR is a straight line for translations and scales and an arc for rotations.
"""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np

COMPONENTS = {5123: np.uint16, 5125: np.uint32, 5126: np.float32}
WIDTHS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}
STILL = {"translation": [0, 0, 0], "rotation": [0, 0, 0, 1], "scale": [1, 1, 1]}


class Glb:
    """A file, read. document: its JSON; nodes: number of each by name (the last one of a name)."""

    def __init__(self, path: Path) -> None:
        data = path.read_bytes()
        magic, version, length = struct.unpack_from("<4sII", data)
        assert (magic, version, length) == (b"glTF", 2, len(data))
        size, kind = struct.unpack_from("<I4s", data, 12)
        assert kind == b"JSON"
        assert size % 4 == 0
        self.document = json.loads(data[20 : 20 + size])
        body = data[20 + size :]
        self.binary = b""
        if body:
            size, kind = struct.unpack_from("<I4s", body)
            assert kind == b"BIN\0"
            assert size == len(body) - 8 == self.document["buffers"][0]["byteLength"]
            self.binary = body[8:]
        self.nodes = {node["name"]: number for number, node in enumerate(self.document["nodes"])}
        self.parents = {
            child: number
            for number, node in enumerate(self.document["nodes"])
            for child in node.get("children", ())
        }
        self.tracks: dict[tuple[int, str], tuple[np.ndarray, np.ndarray]] = {}
        for animation in self.document.get("animations", ()):
            for channel in animation["channels"]:
                sampler = animation["samplers"][channel["sampler"]]
                assert sampler.get("interpolation", "LINEAR") == "LINEAR"
                self.tracks[channel["target"]["node"], channel["target"]["path"]] = (
                    self.accessor(sampler["input"])[:, 0].astype(float),
                    self.accessor(sampler["output"]).astype(float),
                )

    def accessor(self, number: int) -> np.ndarray:
        """(count, width)."""
        accessor = self.document["accessors"][number]
        view = self.document["bufferViews"][accessor["bufferView"]]
        kind, width = np.dtype(COMPONENTS[accessor["componentType"]]), WIDTHS[accessor["type"]]
        assert view.get("byteStride", kind.itemsize * width) == kind.itemsize * width
        start = view["byteOffset"] + accessor["byteOffset"]
        found = np.frombuffer(self.binary, kind, accessor["count"] * width, start).reshape(-1, width)
        for name, bound in (("min", found.min(axis=0)), ("max", found.max(axis=0))):
            assert accessor.get(name, bound.tolist()) == bound.tolist()
        return found

    def value(self, node: int, path: str, time: float) -> np.ndarray:
        """A property of a node at a time [s], before the first key frame and after the last as there."""
        if (node, path) not in self.tracks:
            return np.array(self.document["nodes"][node].get(path, STILL[path]), float)
        times, values = self.tracks[node, path]
        after = int(np.clip(np.searchsorted(times, time, side="right"), 1, len(times) - 1))
        part = float(np.clip((time - times[after - 1]) / (times[after] - times[after - 1]), 0, 1))
        a, b = values[after - 1], values[after]
        if path != "rotation":
            return (1 - part) * a + part * b
        a, b = a / np.linalg.norm(a), b / np.linalg.norm(b)
        assert a @ b >= 0, "neighbours in different hemispheres"
        angle = np.arctan2(np.linalg.norm(b - (a @ b) * a), a @ b)
        if angle < 1e-9:
            return (1 - part) * a + part * b
        return (np.sin((1 - part) * angle) * a + np.sin(part * angle) * b) / np.sin(angle)

    def matrix(self, node: int, time: float) -> np.ndarray:
        """From the axes of a node to those of the world, (4, 4)."""
        local = np.eye(4)
        local[:3, :3] = rotation(self.value(node, "rotation", time)) * self.value(node, "scale", time)
        local[:3, 3] = self.value(node, "translation", time)
        parent = self.parents.get(node)
        return local if parent is None else self.matrix(parent, time) @ local

    def points(self, node: int, time: float) -> np.ndarray:
        """Where the vertices of a node and of its children are, z up, (V, 3)."""
        own = self.document["nodes"][node]
        found = [self.points(child, time) for child in own.get("children", ())]
        if "mesh" in own:
            local = np.concatenate([vertices for vertices, _, _ in self.primitives(own["mesh"])])
            world = self.matrix(node, time)
            found.append(z_up(local @ world[:3, :3].T + world[:3, 3]))
        return np.concatenate(found) if found else np.empty((0, 3))

    def primitives(self, mesh: int) -> list[tuple[np.ndarray, np.ndarray, np.ndarray]]:
        """Vertices, normals and triangles."""
        return [
            (
                self.accessor(part["attributes"]["POSITION"]).astype(float),
                self.accessor(part["attributes"]["NORMAL"]).astype(float),
                self.accessor(part["indices"]).reshape(-1, 3).astype(int),
            )
            for part in self.document["meshes"][mesh]["primitives"]
        ]

    def material(self, node: str) -> dict[str, Any]:
        """That of the first primitive of a node."""
        mesh = self.document["meshes"][self.document["nodes"][self.nodes[node]]["mesh"]]
        material: dict[str, Any] = self.document["materials"][mesh["primitives"][0]["material"]]
        return material


def z_up(points: np.ndarray) -> np.ndarray:
    """What a program with z up makes of the axes of glTF."""
    return np.stack([points[..., 0], -points[..., 2], points[..., 1]], axis=-1)


def rotation(q: np.ndarray) -> np.ndarray:
    """The matrix of a quaternion x, y, z, w."""
    x, y, z, w = q / np.linalg.norm(q)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
