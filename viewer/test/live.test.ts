import assert from "node:assert/strict";
import { test } from "node:test";
import type { Body } from "../src/recording";
import { Frames } from "../src/live/frames";
import { messagesOf, type Message } from "../src/live/messages";

const BALL = { index: 0, name: "ball", fixed: false } as Body;
const KINDS = [
  { name: "time", unit: "s", components: 1 },
  { name: "velocity", unit: "m s-1", components: 3 },
  { name: "joints/force", unit: "N", components: 3 },
  { name: "energy/spring", unit: "J", components: 1 },
];

/** A message as physsim/view/live/wire.py writes it. */
function encoded(kind: string, facts: object, arrays: [string, string, number[], Uint8Array][]): Uint8Array {
  const text = JSON.stringify({ kind, facts, arrays: arrays.map(([name, type, shape]) => [name, type, shape]) });
  const head = new TextEncoder().encode(text.padEnd(8 * Math.ceil(text.length / 8)));
  const parts = arrays.map(([, , , bytes]) => {
    const filled = new Uint8Array(8 * Math.ceil(bytes.length / 8));
    filled.set(bytes);
    return filled;
  });
  const body = parts.reduce((sum, part) => sum + part.length, 0);
  const lengths = new Uint8Array(new Uint32Array([head.length, body]).buffer);
  return Uint8Array.from([lengths, head, ...parts].flatMap((part) => [...part]));
}

/** A stream that gives so many bytes at a time. */
function stream(bytes: Uint8Array, size: number): ReadableStream<Uint8Array> {
  let at = 0;
  return new ReadableStream({
    pull(controller) {
      if (at >= bytes.length) controller.close();
      else controller.enqueue(bytes.slice(at, (at += size)));
    },
  });
}

async function all(bytes: Uint8Array, size: number): Promise<Message[]> {
  const found: Message[] = [];
  for await (const message of messagesOf(stream(bytes, size))) found.push(message);
  return found;
}

function frame(number: number, bodies = 1): Message {
  const velocity = new Float64Array(3 * bodies);
  velocity[0] = number;
  return { kind: "frame", facts: { frame: number, time: number / 8 }, arrays: [{ name: "velocity", values: velocity }] };
}

test("messages are the same however the stream is cut", async () => {
  const bytes = encoded("frame", { frame: 3 }, [
    ["position", "<f8", [1, 3], new Uint8Array(new Float64Array([1, 2.5, -3]).buffer)],
    ["solver/iterations", "<i8", [], new Uint8Array(new BigInt64Array([-7n]).buffer)],
    ["contacts/sliding", "|i1", [3], new Uint8Array([1, 0, 1])],
    ["contacts/body_a", "<i4", [1], new Uint8Array(new Int32Array([-1]).buffer)],
  ]);
  for (const size of [1, 7, 8, 1000]) {
    const found = await all(Uint8Array.from([...bytes, ...bytes, ...bytes.slice(0, -1)]), size);
    assert.equal(found.length, 2);
    for (const message of found) {
      assert.deepEqual(message.facts, { frame: 3 });
      assert.deepEqual(message.arrays.map(({ name, values }) => [name, [...values]]), [
        ["position", [1, 2.5, -3]],
        ["solver/iterations", [-7]],
        ["contacts/sliding", [1, 0, 1]],
        ["contacts/body_a", [-1]],
      ]);
    }
  }
});

test("numbers of a type that is not known are refused", async () => {
  await assert.rejects(all(encoded("frame", {}, [["x", "<f2", [1], new Uint8Array(2)]]), 100), /unknown type <f2/);
});

test("frames have the tracks of the first of them", () => {
  const frames = new Frames(KINDS, [BALL]);
  assert.equal(frames.track("velocity"), null);
  frames.add(frame(3));
  assert.deepEqual(frames.names, ["time", "velocity"]);
  const track = frames.track("velocity");
  assert.equal(track?.rows, 1);
  assert.equal(track?.at(0, 0, 0), 3);
  frames.add({ ...frame(4), arrays: [] });
  assert.ok(Number.isNaN(track?.at(1, 0, 0)));
  assert.deepEqual([...frames.times.slice(0, 2)], [0.375, 0.5]);
  assert.equal(frames.topSpeed, 3);
  assert.equal(frames.contacts(0), null);
});

test("too many frames are thinned out evenly; the first and the newest stay", () => {
  const frames = new Frames(KINDS, [BALL]);
  for (let number = 0; number < 90_000; number++) {
    frames.add(frame(number));
    if (number % 100 === 0) frames.thinOut();
  }
  assert.ok(frames.frames > 10_000 && frames.frames <= 20_100);
  const velocity = frames.track("velocity");
  const numbers = Array.from({ length: frames.frames }, (_, k) => velocity?.at(k, 0, 0) ?? NaN);
  assert.equal(numbers[0], 0);
  assert.equal(numbers[numbers.length - 1], 89_999);
  const gaps = numbers.slice(1).map((number, k) => number - numbers[k]);
  assert.ok(gaps.every((gap) => gap > 0 && gap <= 16));
  assert.ok(gaps.slice(-4000).every((gap) => gap === 1));
  assert.ok(numbers.every((number, k) => frames.times[k] === number / 8));
});

test("large frames are bounded by their bytes", () => {
  const frames = new Frames(KINDS, [BALL]);
  for (let number = 0; number < 60; number++) {
    frames.add(frame(number, 200_000));
    frames.thinOut();
  }
  assert.ok(frames.frames * 200_000 * 24 < 136 * 1024 * 1024);
  assert.equal(frames.track("velocity")?.at(0, 0, 0), 0);
  assert.equal(frames.track("velocity")?.at(frames.frames - 1, 0, 0), 59);
});
