import assert from "node:assert/strict";
import { test } from "node:test";
import type { Body, Contacts } from "../src/recording";
import { nextSpeed } from "../src/ui/bar";
import { partnersOf } from "../src/ui/body_card";
import { shortNames } from "../src/ui/catalogue";
import { emptyNumbers, kineticEnergy, turnInWords } from "../src/ui/numbers";
import { viridis } from "../src/ui/palette";

const body: Body = {
  index: 0, name: "b", material: "", mass: 2, fixed: false, colour: "#000000", center: [0, 0, 0],
  inertia: [1, 0, 0, 0, 2, 0, 0, 0, 3],
};

test("kinetic energy takes the inertia in body axes", () => {
  const half = Math.SQRT1_2;
  const numbers = { ...emptyNumbers(), speed: 3, angularVelocity: [0, 0, 4] as [number, number, number] };
  assert.equal(kineticEnergy(body, numbers), (2 * 9) / 2 + (3 * 16) / 2);
  // Turned by 90 degrees about x, the body's y lies along the world's z.
  numbers.orientation = [half, half, 0, 0];
  assert.ok(Math.abs(kineticEnergy(body, numbers) - (9 + (2 * 16) / 2)) < 1e-12);
});

test("a turn in words, the same for q and -q", () => {
  const half = Math.SQRT1_2;
  assert.equal(turnInWords([half, 0, 0, half]), "90.00° about (0.000, 0.000, 1.000)");
  assert.equal(turnInWords([-half, 0, 0, -half]), "90.00° about (0.000, 0.000, 1.000)");
  assert.equal(turnInWords([1, 0, 0, 0]), "as declared: not turned");
});

test("forces of a pair are summed as they act on the body that is asked for", () => {
  const contacts: Contacts = {
    count: 3, omitted: 0, bodyA: Int32Array.of(0, 1, 0), bodyB: Int32Array.of(1, 0, 2), position: new Float64Array(9),
    force: Float64Array.of(0, 0, 5, 0, 0, -2, 9, 0, 0), sliding: new Uint8Array(3),
  };
  assert.deepEqual(partnersOf(contacts, 0), [[2, { points: 1, force: [9, 0, 0] }], [1, { points: 2, force: [0, 0, 7] }]]);
});

test("legends leave out what all names share", () => {
  assert.deepEqual(shortNames(["bodies.a.b.position.x", "bodies.a.b.position.y"]), ["x", "y"]);
  assert.deepEqual(shortNames(["energy.total"]), ["total"]);
});

test("speeds go up and down the list, and end there", () => {
  assert.equal(nextSpeed(1, 1), 2);
  assert.equal(nextSpeed(0.3, -1), 0.2);
  assert.equal(nextSpeed(100, 1), 100);
});

test("viridis rises in lightness, so that its order needs no colour vision", () => {
  const light = (share: number): number => {
    const [r, g, b] = viridis(share, [0, 0, 0]);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  for (let i = 0; i < 20; i++) assert.ok(light((i + 1) / 20) > light(i / 20));
});
