import assert from "node:assert/strict";
import { test } from "node:test";
import { count, decimalsFor, exact, number, quantity, signed, timeDecimals, times, unitInPrint } from "../src/ui/format";

test("as many decimals as the error allows: one unit of the last is not below it", () => {
  assert.equal(decimalsFor(3e-9), 8);
  assert.equal(decimalsFor(1e-3), 2);
  assert.equal(decimalsFor(0.9e-3), 3);
  assert.equal(decimalsFor(5), 0);
  assert.equal(number(1.23456789, 10, 2e-4), "1.235");
  assert.equal(number(-0.5, 4), "−0.5000");
});

test("what is below its error is 0 without a sign", () => {
  assert.equal(number(-1e-9, 6, 1e-3), "0.00");
  assert.equal(signed(-0.0004, 2), "0.00");
});

test("large and small numbers get a power of ten", () => {
  assert.equal(number(5.972e24, 4), "5.972\u2009×\u200910²⁴");
  assert.equal(number(-1.5e-7, 3), "−1.50\u2009×\u200910⁻⁷");
  assert.equal(number(12345, 4), "12345");
  assert.equal(number(Infinity), "infinite");
  assert.equal(number(NaN), "none");
});

test("exact numbers lose the zeros at their end, and nothing else", () => {
  assert.equal(exact(300), "300");
  assert.equal(exact(0.5), "0.5");
  assert.equal(exact(1e9), "1\u2009×\u200910⁹");
  assert.equal(exact(10.25), "10.25");
});

test("units as they are printed", () => {
  assert.equal(unitInPrint("m s-1"), "m/s");
  assert.equal(unitInPrint("kg m2 s-1"), "kg\u202fm²/s");
  assert.equal(unitInPrint("N m"), "N\u202fm");
  assert.equal(unitInPrint("s-1"), "1/s");
  assert.equal(unitInPrint("kg m-1 s-2"), "kg/(m\u202fs²)");
  assert.equal(unitInPrint("1"), "");
  assert.equal(quantity(2, "m s-1", 3), "2.00\u202fm/s");
});

test("decimals of a time tell neighbouring frames apart", () => {
  assert.equal(timeDecimals(0.01), 2);
  assert.equal(timeDecimals(0.0025), 4);
  assert.equal(timeDecimals(1), 1);
  assert.equal(timeDecimals(0), 3);
});

test("counts and speeds", () => {
  assert.equal(count(1, "body", "bodies"), "1 body");
  assert.equal(count(12345, "point"), "12\u202f345 points");
  assert.equal(times(0.05), "0.05×");
});
