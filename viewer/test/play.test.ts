import assert from "node:assert/strict";
import { test } from "node:test";
import { Clock } from "../src/clock";
import { Governor } from "../src/governor";
import { MomentFinder } from "../src/moment";
import type { Body, Recording, Track } from "../src/recording";
import { between, product, turned } from "../src/rotation";
import { round125 } from "../src/round125";

type Motion = (time: number) => number[];

/** One body of which only the motion is known. */
function recordingOf(times: number[], position: Motion, velocity: Motion, orientation: Motion, center = [0, 0, 0]): Recording {
  const track = (motion: Motion): Track => {
    const rows = times.map(motion);
    return {
      name: "", unit: "", rows: 1, components: rows[0].length, error: () => 0,
      at: (frame, _row, component) => rows[frame][component],
      read: (frame, _row, out, offset) => rows[frame].forEach((value, k) => (out[offset + k] = value)),
    };
  };
  const body = { index: 0, name: "body", fixed: false, center } as unknown as Body;
  return {
    bodies: [body], frames: times.length, times: Float64Array.from(times), growing: false, onGrowth: () => () => undefined,
    position: track(position), velocity: track(velocity), orientation: track(orientation),
  } as unknown as Recording;
}

const STILL: Motion = () => [1, 0, 0, 0];
const near = (found: ArrayLike<number>, known: readonly number[], within: number): void => {
  assert.equal(found.length, known.length);
  known.forEach((value, k) => assert.ok(Math.abs(found[k] - value) <= within, `${found[k]} instead of ${value}`));
};

test("a throw is a parabola between frames too", () => {
  const at: Motion = (t) => [3 * t, 0, 5 * t - 4.905 * t * t];
  const finder = new MomentFinder(recordingOf([0, 0.25, 0.5], at, (t) => [3, 0, 5 - 9.81 * t], STILL));
  for (const t of [0.1, 0.3, 0.45]) {
    finder.show(t);
    near(finder.moment.positions, at(t), 1e-12);
    near(finder.moment.velocities, [3, 0, 5 - 9.81 * t], 1e-12);
  }
});

test("a body that was hit between two frames goes straight", () => {
  // Down at 2 m/s, up at 2 m/s: the cubic would dip to a quarter of a step below the floor.
  const finder = new MomentFinder(recordingOf([0, 0.1], () => [0, 0, 0.1], (t) => [0, 0, t ? 2 : -2], STILL));
  finder.show(0.05);
  near(finder.moment.positions, [0, 0, 0.1], 1e-15);
});

test("on a frame stand the frame's own numbers", () => {
  const finder = new MomentFinder(recordingOf([0, 0.1, 0.3], (t) => [t / 3, 1 / 7, t], () => [1 / 3, 0, 1], STILL));
  finder.show(0.1);
  assert.deepEqual([finder.moment.frame, finder.moment.fraction], [1, 0]);
  assert.deepEqual(Array.from(finder.moment.positions), [0.1 / 3, 1 / 7, 0.1]);
});

test("a body turns about its centre of mass, which flies on", () => {
  // The centre of mass, 1 m beside the origin along the body's x, flies along z while the body turns about z at 2 rad/s.
  const turn: Motion = (t) => [Math.cos(t), 0, 0, Math.sin(t)];
  const origin: Motion = (t) => [-Math.cos(2 * t), -Math.sin(2 * t), 4 * t];
  const finder = new MomentFinder(recordingOf([0, 0.4], origin, () => [0, 0, 4], turn, [1, 0, 0]));
  finder.show(0.1);
  near(finder.moment.positions, origin(0.1), 1e-12);
  near(finder.moment.orientations, turn(0.1), 1e-12);
});

test("orientations take the shorter arc, whatever their signs", () => {
  const half = Math.PI / 8;
  const q = [1, 0, 0, 0, -Math.cos(half), 0, -Math.sin(half), 0];
  const out = new Float64Array(4);
  between(q, 0, 0.5, out, 0);
  near(out, [Math.cos(half / 2), 0, Math.sin(half / 2), 0], 1e-15);
  const twice = new Float64Array(4);
  product(out, 0, out, 0, twice, 0);
  near(twice, [Math.cos(half), 0, Math.sin(half), 0], 1e-15);
  const v = new Float64Array(3);
  turned([Math.SQRT1_2, 0, 0, Math.SQRT1_2], 0, 1, 0, 0, v, 0);
  near(v, [0, 1, 0], 1e-15);
});

test("the clock plays, stops at the end, loops and steps", () => {
  const clock = new Clock(recordingOf([0, 1, 2], (t) => [t, 0, 0], () => [1, 0, 0], STILL), () => undefined);
  clock.play();
  clock.advance(0.2);
  assert.ok(Math.abs(clock.moment.time - 0.2) < 1e-12);
  clock.setSpeed(10);
  clock.advance(0.2);
  assert.deepEqual([clock.moment.time, clock.playing], [2, false]);
  clock.step(-1);
  assert.deepEqual([clock.moment.time, clock.moment.frame], [1, 1]);
  clock.seek(1.5);
  clock.step(-1);
  assert.equal(clock.moment.time, 1);
  clock.step(100);
  assert.equal(clock.moment.time, 2);
  clock.setLoop(true);
  clock.play();
  assert.equal(clock.moment.time, 0);
  clock.advance(0.21);
  assert.ok(clock.playing && Math.abs(clock.moment.time - 0.1) < 1e-9);
  clock.seek(NaN);
  clock.setSpeed(-1);
  assert.equal(clock.speed, 10);
});

test("runs of microseconds and of years are played in seconds", () => {
  const speed = (end: number): number => new Clock(recordingOf([0, end], () => [0, 0, 0], () => [0, 0, 0], STILL), () => undefined).speed;
  assert.deepEqual([speed(0.0008), speed(5), speed(8e7)], [0.0001, 1, 1e7]);
  assert.deepEqual([round125(0.03), round125(7), round125(8)], [0.02, 5, 10]);
});

/** The quality after so many seconds of pictures that take `elapsed` seconds. */
function after(governor: Governor, elapsed: number, seconds: number): string {
  for (let t = 0; t < seconds; t += elapsed) governor.measure(elapsed);
  return `${governor.quality.pixels} ${governor.quality.shadows} ${governor.quality.fine}`;
}

test("quality falls while pictures are slow, and rises again when there is time", () => {
  const governor = new Governor(1, false, 10);
  assert.equal(after(governor, 1 / 60, 10), "1 2048 true");
  assert.equal(after(governor, 1 / 25, 1), "1 1024 true");
  assert.equal(after(governor, 1 / 10, 8), "0.5 0 false");
  assert.equal(after(governor, 1 / 60, 15), "0.5 0 false");
  assert.equal(after(governor, 1 / 60, 60), "1 2048 true");
});

test("a level that was too slow is left alone for a while", () => {
  const governor = new Governor(1, true, 1000);
  assert.equal(after(governor, 1 / 60, 1), "1 0 false");
  assert.equal(after(governor, 1 / 25, 1), "0.75 0 false");
  assert.equal(after(governor, 1 / 60, 12), "0.75 0 false");
});
