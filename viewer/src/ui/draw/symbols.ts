// A symbol for each kind of joint, of size 1 about the origin, its axis along z.

import {
  BoxGeometry, BufferGeometry, CatmullRomCurve3, ConeGeometry, CylinderGeometry, OctahedronGeometry, RingGeometry,
  SphereGeometry, TorusGeometry, TubeGeometry, Vector3,
} from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";

const QUARTER = Math.PI / 2;

/** The kinds that have a symbol; others are drawn as `fixed`. */
export const SYMBOLS: Record<string, () => BufferGeometry> = {
  hinge: () => joined(pin(2.4, 0.14), torus(0.62, 0.1)),
  ball: () => joined(new SphereGeometry(0.34, 16, 12), torus(0.62, 0.07), torus(0.62, 0.07).rotateX(QUARTER)),
  slider: () => joined(rail(2.4), tip(1.2), tip(-1.2)),
  cylindrical: () => joined(pin(2, 0.1), tip(1.1), tip(-1.1), torus(0.5, 0.09)),
  screw: () => joined(pin(2.2, 0.08), thread()),
  universal: () => joined(pin(1.8, 0.13), pin(1.8, 0.13).rotateX(QUARTER), new SphereGeometry(0.26, 12, 8)),
  planar: () => joined(new BoxGeometry(1.7, 1.7, 0.06), pin(0.8, 0.09).translate(0, 0, 0.4), tip(0.8)),
  cone: () => joined(rings(), pin(1.1, 0.07).translate(0, 0, 0.55)),
  distance: () => new SphereGeometry(0.2, 12, 8),
  gear: () => new TorusGeometry(0.5, 0.14, 8, 10),
  fixed: () => joined(new OctahedronGeometry(0.42), new BoxGeometry(0.9, 0.12, 0.12), new BoxGeometry(0.12, 0.9, 0.12)),
};

function joined(...parts: BufferGeometry[]): BufferGeometry {
  for (const part of parts) for (const name of ["uv", "uv1"]) part.deleteAttribute(name);
  return mergeGeometries(parts.map((part) => (part.index ? part.toNonIndexed() : part)));
}

function pin(length: number, radius: number): BufferGeometry {
  return new CylinderGeometry(radius, radius, length, 12).rotateX(QUARTER);
}

function rail(length: number): BufferGeometry {
  return new BoxGeometry(0.16, 0.16, length);
}

/** An arrowhead at this height, pointing away from the middle. */
function tip(height: number): BufferGeometry {
  const cone = new ConeGeometry(0.28, 0.55, 12).rotateX(height > 0 ? QUARTER : -QUARTER);
  return cone.translate(0, 0, height);
}

function torus(radius: number, thick: number): BufferGeometry {
  return new TorusGeometry(radius, thick, 8, 28);
}

/** A cone that opens along z, as hoops: one sees through. */
function rings(): BufferGeometry {
  const hoops = [0.25, 0.5, 0.75, 1].map((share) => torus(0.6 * share, 0.045).translate(0, 0, share));
  return mergeGeometries([...hoops, new RingGeometry(0, 0.05).translate(0, 0, 0)].map((one) => one.toNonIndexed()));
}

function thread(): BufferGeometry {
  const points = Array.from({ length: 65 }, (_, i) => {
    const angle = (2 * Math.PI * i) / 16;
    return new Vector3(0.3 * Math.cos(angle), 0.3 * Math.sin(angle), i / 40 - 0.8);
  });
  return new TubeGeometry(new CatmullRomCurve3(points), 128, 0.07, 6);
}
