"""The parts of what a run that is watched takes: messages, and the frames that are kept for late pages."""

from __future__ import annotations

import io

import numpy as np
import pytest

from physsim.view.live.store import MOST_BEHIND, Kept, Store, caught_up
from physsim.view.live.wire import Message, encoded, read

MESSAGE = Message(
    "frame",
    {"frame": 3, "name": "Körper </script>\u2028", "list": ["a", None]},
    {
        "table": np.arange(6.0).reshape(2, 3),
        "turned": np.asfortranarray(np.arange(6.0).reshape(2, 3)),
        "big-endian": np.array([1.5, np.nan], ">f8"),
        "bytes": np.array([1, 2, 3], np.int8),
        "number": np.float64(7.25),
        "none": np.zeros((0, 3)),
    },
)


class TestMessages:
    def test_what_is_sent_arrives(self) -> None:
        got = read(io.BytesIO(encoded(MESSAGE)))
        assert got is not None
        message, data = got
        assert (message.kind, message.facts) == (MESSAGE.kind, MESSAGE.facts)
        assert data == encoded(MESSAGE)
        assert [*message.arrays] == [*MESSAGE.arrays]
        for name, array in MESSAGE.arrays.items():
            np.testing.assert_array_equal(message.arrays[name], array)
            assert message.arrays[name].shape == np.shape(array)

    def test_every_array_begins_where_a_typed_array_of_a_browser_may(self) -> None:
        data = encoded(MESSAGE)
        head, body = np.frombuffer(data, "<u4", 2)
        assert (head % 8, body % 8, 8 + head + body) == (0, 0, len(data))

    def test_messages_follow_each_other_and_one_that_is_cut_is_the_end(self) -> None:
        data = encoded(MESSAGE)
        stream = io.BytesIO(data + encoded(Message("end")) + data[:-1])
        kinds = []
        while (got := read(stream)) is not None:
            kinds.append(got[0].kind)
        assert kinds == ["frame", "end"]

    @pytest.mark.parametrize("size", [0, 3, 8, 40])
    def test_no_beginning_of_a_message_is_one(self, size: int) -> None:
        assert read(io.BytesIO(encoded(MESSAGE)[:size])) is None

    def test_facts_are_those_of_json(self) -> None:
        with pytest.raises(ValueError, match="JSON"):
            encoded(Message("frame", {"time": float("nan")}))


def filled(frames: int, most: int) -> Store:
    """A store with room for so many frames of 100 bytes, which got every second one of a recording."""
    store = Store(100 * most)
    for number in range(frames):
        store.add(2 * number, bytes(100))
    return store


class TestWhatIsKept:
    def test_everything_while_there_is_room(self) -> None:
        found, end = filled(50, 50).after(-1, 0)
        assert [kept.number for kept in found] == [2 * number for number in range(50)]
        assert end is None

    @pytest.mark.parametrize("frames", [51, 100, 500, 12345])
    def test_older_ones_are_thinned_evenly_and_first_and_newest_stay(self, frames: int) -> None:
        found, _ = filled(frames, 50).after(-1, 0)
        numbers = [kept.number // 2 for kept in found]
        assert 25 <= len(numbers) <= 50
        assert (numbers[0], numbers[-1]) == (0, frames - 1)
        gaps = np.diff(numbers)
        assert (gaps >= 0).all()
        # Strides are powers of two, and older ones have a third to two thirds of the room.
        assert max(gaps) <= 4 * frames / 50
        assert gaps[-1] == 1

    def test_frames_that_do_not_fit_at_all_leave_the_newest(self) -> None:
        store = Store(10)
        for number in range(5):
            store.add(number, bytes(100))
        found, _ = store.after(-1, 0)
        assert [kept.number for kept in found][-1] == 4
        assert len(found) <= 2

    def test_only_what_is_later_than_asked_for(self) -> None:
        store = filled(10, 50)
        assert [kept.number for kept in store.after(13, 0)[0]] == [14, 16, 18]
        assert store.after(18, 0) == ([], None)

    def test_the_end_comes_with_the_last_frames(self) -> None:
        store = filled(3, 50)
        store.finish(b"the end")
        assert [kept.number for kept in store.after(1, 0)[0]] == [2, 4]
        assert store.after(4, 1e6) == ([], b"the end")


@pytest.mark.parametrize("behind", [0, 1, 60, 61, 1000])
def test_who_is_behind_gets_few_and_the_newest(behind: int) -> None:
    frames = [Kept(number, number, b"") for number in range(behind)]
    some = caught_up(frames)
    assert len(some) == min(behind, len(some)) <= MOST_BEHIND
    assert some[-1:] == frames[-1:]
    if behind <= MOST_BEHIND:
        assert some == frames
