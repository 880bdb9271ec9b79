"""What a page keeps of a trajectory, opened again by other means, and what it says of its errors."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from view_unpacked import NOT_A_NUMBER, Opened, decoded, opened_page

from physsim import open_trajectory
from physsim.cli.app import answer
from physsim.errors import FileTrouble
from physsim.view.page import plan
from physsim.view.page.coding import encoded
from physsim.view.page.contacts import relative_error, shortened
from physsim.view.page.motion import kept_frames
from physsim.view.page.pack import packed
from physsim.view.page.quantise import quantised

PLANES = st.sampled_from([1, 2, 3, 4])
CROWD = """
physsim: 1
title: A crowd
simulation: {duration: 600 ms, timestep: 2 ms}
bodies:
  floor: {fixed: true, shape: {type: halfspace, normal: [0, 0, 1]}, material: concrete}
  crate:
    repeat: {count: [3, 3, 3], spacing: [15 cm, 15 cm, 15.2 cm]}
    shape: {type: box, size: [14 cm, 14 cm, 15 cm]}
    material: oak
    position: [0, 0, 8 cm]
    velocity: [0.3, 0.2, -0.1]
record: {every: 2 ms}
"""


@pytest.fixture(scope="module")
def crowd(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The trajectory of 27 crates that fall on each other: 301 frames, 30 000 contact points."""
    folder = tmp_path_factory.mktemp("crowd")
    (folder / "crowd.yaml").write_text(CROWD)
    assert answer(["run", str(folder / "crowd.yaml"), "-o", str(folder / "crowd.h5"), "--quiet"]) == 0
    return folder / "crowd.h5"


def in_room(path: Path, room: int) -> tuple[Opened, Any]:
    """The data packed into so many bytes, and the report."""
    with open_trajectory(path) as trajectory:
        made = packed(trajectory, room)
    assert made.size <= room
    return Opened(made.head, made.data), made.report


def size_of_all(path: Path, bits: int = 32) -> int:
    """Bytes of everything with numbers of 32 or 16 bits."""
    page, report = in_room(path, 10_000_000)
    while report.bits > bits:
        page, report = in_room(path, sum(map(len, page.data)) - 1)
    assert report.most_contacts is None
    return sum(map(len, page.data))


@st.composite
def tables(draw: st.DrawFn) -> tuple[Any, int]:
    planes = draw(PLANES)
    shape = draw(st.tuples(st.integers(0, 4), st.integers(0, 40)))
    return draw(arrays(np.uint32, shape, elements=st.integers(0, 256**planes - 1))), planes


@given(tables())
@example((np.array([[0, 2**32 - 1, 0, 2**32 - 1, 5]], np.uint32), 4))
def test_whole_numbers_come_back(table: tuple[Any, int]) -> None:
    codes, planes = table
    assert (decoded(encoded(codes, planes), *codes.shape, planes) == codes).all()


@pytest.mark.parametrize("power", [0, 1, 2])
def test_what_moves_evenly_costs_next_to_nothing(power: int) -> None:
    """10 numbers of 1000 frames that stay, rise, or rise ever faster: 30 kB become 60 to 130 bytes."""
    codes = (np.arange(10)[:, None] + np.arange(1000) ** power).astype(np.uint32)
    assert len(encoded(codes, 3)) < 200


NUMBERS = st.floats(-1e300, 1e300) | st.sampled_from(
    [0.0, -0.0, np.nan, np.inf, -np.inf, 5e-324, 1e-310, 1e11]
)


@given(arrays(np.float64, st.tuples(st.integers(1, 4), st.integers(1, 30)), elements=NUMBERS), PLANES)
def test_no_number_is_off_by_more_than_is_said(values: Any, planes: int) -> None:
    """Nor is more said than half a step: range / (2 (256**planes - 2)), and a few roundings."""
    found = quantised(values, planes)
    again = found.base[:, None] + found.codes * found.step[:, None]
    finite = np.isfinite(values)
    assert ((found.codes == NOT_A_NUMBER[planes]) == ~finite).all()
    off = np.where(finite, np.abs(again - np.where(finite, values, 0.0)), 0.0)
    assert (off <= found.error[:, None]).all()
    low = np.min(values, axis=1, initial=np.inf, where=finite)
    high = np.max(values, axis=1, initial=-np.inf, where=finite)
    known = low <= high
    half = (high[known] / 2 - low[known] / 2) / (256**planes - 2)
    rounding = 1e-15 * np.maximum(np.abs(low), np.abs(high))[known]
    assert (found.error[known] <= half * (1 + 1e-12) + rounding + 1e-297).all()


def test_what_stands_still_is_exact() -> None:
    found = quantised(np.full((1, 5), 0.1), 2)
    assert found.error[0] == 0
    assert found.base[0] == 0.1


def test_counts_are_exact_where_their_range_allows() -> None:
    values = np.array([[3.0, 70000.0, 12.0, np.nan]])
    wide, narrow = quantised(values, 4, whole=True), quantised(values, 2, whole=True)
    assert wide.error[0] == 0
    assert (wide.base[0] + wide.codes[0, :3] * wide.step[0] == values[0, :3]).all()
    assert 0.5 <= narrow.error[0] < 0.6  # a step of 69997 / 65534


@given(arrays(np.float64, 20, elements=st.floats(-1e30, 1e30).filter(lambda x: abs(x) > 1e-30)), PLANES)
def test_shortened_forces_are_as_near_as_is_said(values: Any, planes: int) -> None:
    bits = shortened(values, planes) << np.uint32(32 - 8 * planes)
    if planes > 1:  # one byte keeps no more than sign and size
        assert (np.abs(bits.view(np.float32) - values) <= relative_error(planes) * np.abs(values)).all()


@pytest.mark.parametrize("scene", ["balls", "machine", "offset"])
def test_every_number_of_the_file_is_in_the_page(show: Callable[[str], Any], scene: str) -> None:
    page = opened_page(show(scene).page)
    with h5py.File(show(scene).recording) as file:
        assert (page.plain(page.head["times"]) == file["time"][:]).all()
        names = {track["name"] for track in page.head["tracks"]}
        assert {"position", "orientation", "velocity", "angular_velocity", "energy/residual"} <= names
        for name in names:
            values, error = page.track(name)
            known = file[name][:].reshape(values.shape)
            assert (np.isnan(values) == np.isnan(known)).all()
            off = np.nan_to_num(np.abs(values - known))
            assert (off <= error).all(), name
        recorded = {name for name in file if isinstance(file[name], h5py.Dataset) and file[name].ndim > 1}
        assert {name for name in recorded if len(file[name]) == len(file["time"])} <= names | {"inertia"}


def test_bodies_shapes_and_links_are_those_of_the_file(show: Callable[[str], Any]) -> None:
    page = opened_page(show("machine").page)
    head = page.head
    with h5py.File(show("machine").recording) as file:
        bodies = page.plain(head["bodies"]["numbers"]).reshape(-1, 13)
        assert head["bodies"]["name"] == list(file["body"].asstr())
        assert (bodies[:, 0] == file["mass"][:]).all()
        assert (bodies[:, 1:4] == file["center_of_mass"][:]).all()
        assert (bodies[:, 4:].reshape(-1, 3, 3) == file["inertia"][:]).all()
        joints = page.plain(head["joints"]["numbers"]).reshape(-1, 9)
        assert head["joints"]["name"] == list(file["joints/joint"].asstr())
        assert (joints[:, :3] == file["joints/anchor_a"][:]).all()
        assert np.array_equal(joints[:, 6:], file["joints/axis_a"][:], equal_nan=True)
        assert [tuple(pair) for pair in head["joints"]["bodies"]] == list(
            zip(file["joints/body_a"][:], file["joints/body_b"][:], strict=True)
        )
        assert head["units"]["springs/length"] == ["m", "rad"]
        solids = page.plain(head["placed"]["numbers"]).reshape(-1, 10)
        assert head["placed"]["body"] == list(file["geometry/body"][:])
        assert (solids[:, 3:6] == file["geometry/position"][:]).all()
    for mesh in head["meshes"]:
        vertices = page.plain(mesh["vertices"]).reshape(-1, 3)
        triangles = page.plain(mesh["triangles"]).reshape(-1, 3)
        assert triangles.max() < len(vertices)


def test_all_contacts_are_in_a_small_page(crowd: Path) -> None:
    page, report = in_room(crowd, 10_000_000)
    assert report.bits == 32
    assert report.most_contacts is None
    found = page.contacts()
    with h5py.File(crowd) as file:
        group = file["contacts"]
        assert len(found["frame"]) == len(group["frame"]) > 1000
        order = np.lexsort((group["body_b"][:], group["body_a"][:], group["frame"][:]))
        for name in ("frame", "body_a", "body_b", "sliding"):
            assert (found[name] == group[name][:][order]).all()
        assert (np.abs(found["position"] - group["position"][:][order]) <= found["error"]).all()
        force = group["force"][:][order]
        assert (np.abs(found["force"] - force) <= report.force_error * np.abs(force) + 1e-37).all()
        assert (found["in_file"] == np.diff(group["offset"][:])).all()


def test_less_room_costs_precision_first_then_contacts_then_frames(crowd: Path) -> None:
    """24-bit numbers take about half of the room of 32-bit numbers, 16-bit ones a quarter."""
    size, least = size_of_all(crowd), size_of_all(crowd, bits=16)
    rooms = [*(size * percent // 100 for percent in (200, 160, 80, 40)), least * 9 // 10, least // 2]
    reports = [in_room(crowd, room)[1] for room in rooms]
    assert [report.bits for report in reports] == [32, 24, 24, 16, 16, 16]
    assert [report.most_contacts is not None for report in reports[:5]] == [False] * 4 + [True]
    assert [report.stride for report in reports[:5]] == [1] * 5
    assert reports[5].stride > 1


def test_the_strongest_contacts_stay(crowd: Path) -> None:
    whole = in_room(crowd, 10_000_000)[0].contacts()
    page, report = in_room(crowd, size_of_all(crowd, bits=16) * 9 // 10)
    kept = page.contacts()
    strength = np.linalg.norm(whole["force"], axis=1)
    for frame in range(0, 301, 20):
        there = np.sort(strength[whole["frame"] == frame])[::-1][: report.most_contacts]
        left = np.sort(np.linalg.norm(kept["force"][kept["frame"] == frame], axis=1))[::-1]
        assert len(left) == len(there)
        assert left == pytest.approx(there, rel=2 * report.force_error)
    assert (kept["in_file"] == np.bincount(whole["frame"], minlength=301)).all()
    assert f"the strongest {report.most_contacts} of each frame" in " ".join(page.head["about"]["notes"])


def test_kept_frames_are_those_of_the_file_and_the_last_is_among_them(crowd: Path) -> None:
    page, report = in_room(crowd, size_of_all(crowd, bits=16) // 2)
    assert report.stride > 1
    with h5py.File(crowd) as file:
        times = file["time"][:]
        kept = [*range(0, len(times), report.stride)]
        kept += [] if kept[-1] == len(times) - 1 else [len(times) - 1]
        assert (page.plain(page.head["times"]) == times[kept]).all()
        values, error = page.track("position")
        assert (np.abs(values - file["position"][:][kept]) <= error).all()
        assert page.head["about"]["frames_in_file"] == len(times)
        points = page.contacts()
        bodies = set(zip(points["frame"], points["body_a"], points["body_b"], strict=True))
        group = {name: file["contacts"][name][:] for name in ("frame", "body_a", "body_b")}
        known = set(zip(group["frame"], group["body_a"], group["body_b"], strict=True))
        assert bodies
        assert all((kept[frame], a, b) in known for frame, a, b in bodies)


def test_more_numbers_than_a_browser_keeps(crowd: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Bodies at rest pack into nothing, but a browser has all of them in memory."""
    monkeypatch.setattr(plan, "MOST_NUMBERS", 40_000)
    page, report = in_room(crowd, 10_000_000)
    assert report.stride > 1
    assert sum(t["rows"] * t["components"] for t in page.head["tracks"]) * page.head["frames"] <= 42_000


@pytest.mark.parametrize(
    ("frames", "stride", "kept"), [(0, 1, []), (1, 7, [0]), (7, 3, [0, 3, 6]), (6, 4, [0, 4, 5])]
)
def test_kept_frames(frames: int, stride: int, kept: list[int]) -> None:
    assert list(kept_frames(frames, stride)) == kept


def test_what_does_not_fit_is_refused(crowd: Path) -> None:
    with open_trajectory(crowd) as trajectory, pytest.raises(FileTrouble, match="--max-size"):
        packed(trajectory, 3_000)


def test_contacts_of_bodies_that_are_not_there(crowd: Path, tmp_path: Path) -> None:
    damaged = tmp_path / "damaged.h5"
    damaged.write_bytes(crowd.read_bytes())
    with h5py.File(damaged, "r+") as file:
        file["contacts/body_b"][100] = 28
    with open_trajectory(damaged) as trajectory, pytest.raises(FileTrouble, match="damaged"):
        packed(trajectory, 10_000_000)
