import assert from "node:assert/strict";
import { test } from "node:test";
import { csv } from "../src/ui/csv";
import { nearestFrame, range, trace } from "../src/ui/curve";
import { roundAbove, roundBelow, ticks, withAir } from "../src/ui/ticks";

test("ticks are round, lie within, and carry the digits that tell them apart", () => {
  assert.deepEqual(ticks(0, 1, 5).labels, ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
  assert.deepEqual(ticks(-3, 12, 3).values, [0, 5, 10]);
  const large = ticks(0, 25000, 5);
  assert.equal(large.exponent, 3);
  assert.deepEqual(large.labels, ["0", "5", "10", "15", "20", "25"]);
  assert.deepEqual(ticks(1000.0001, 1000.0003, 2).labels, ["1000.0001", "1000.0002", "1000.0003"]);
});

test("round numbers below and above", () => {
  assert.equal(roundBelow(7.3), 5);
  assert.equal(roundBelow(0.02), 0.02);
  assert.equal(roundAbove(7.3), 10);
  assert.equal(roundAbove(130), 200);
});

test("an interval with air is never empty", () => {
  assert.deepEqual(withAir(0, 0), [-1, 1]);
  const [low, high] = withAir(5, 5);
  assert.ok(low < 5 && high > 5);
  assert.deepEqual(withAir(NaN, NaN), [0, 1]);
});

test("the range leaves out what is not a number", () => {
  assert.deepEqual(range([Float64Array.of(NaN, 3, -2, Infinity)], 0, 4), [-2, 3]);
  assert.ok(Number.isNaN(range([], 0, 4)[0]));
});

test("the nearest frame of times that rise unevenly", () => {
  const times = Float64Array.of(0, 1, 1.5, 4);
  assert.equal(nearestFrame(times, 4, 1.2), 1);
  assert.equal(nearestFrame(times, 4, 1.3), 2);
  assert.equal(nearestFrame(times, 4, 99), 3);
  assert.equal(nearestFrame(times, 1, 99), 0);
});

test("a peak of one frame among thousands is drawn, and a gap breaks the line", () => {
  const frames = 10000;
  const times = Float64Array.from({ length: frames }, (_, i) => i);
  const values = new Float64Array(frames);
  values[5003] = 7;
  values[8000] = NaN;
  const drawn: number[] = [];
  let pieces = 0;
  const pen = { moveTo: () => (pieces += 1), lineTo: (_x: number, y: number) => drawn.push(y) };
  trace(pen as never, { times, frames, x: (t) => t / 100, y: (v) => v }, values);
  assert.equal(Math.max(...drawn), 7);
  assert.equal(pieces, 2);
  assert.ok(drawn.length < 600, `${drawn.length} points for 100 columns of pixels`);
});

test("CSV: a row for each frame, names with commas quoted, gaps empty", () => {
  const column = { name: "bodies.brick[0,1].position.z", unit: "m", values: Float64Array.of(1.5, NaN) };
  assert.equal(csv(Float64Array.of(0, 0.1), 2, [column]), 'time [s],"bodies.brick[0,1].position.z [m]"\r\n0,1.5\r\n0.1,\r\n');
});
