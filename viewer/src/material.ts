// The surface of bodies: matt, coloured by instance, with patterns that turn with the body.

import { MeshLambertMaterial } from "three";

/** How much darker the second shade of a pattern is. */
const SHADE = 0.72;

const VERTEX_HEAD = `
attribute float pattern;
varying vec3 vOwn;
varying float vPattern;
`;
const VERTEX = `
vOwn = position;
vPattern = pattern;
`;
const FRAGMENT_HEAD = `
varying vec3 vOwn;
varying float vPattern;

float secondShade(vec3 d) {
  if (vPattern < 0.5) return 0.0;
  if (vPattern < 1.5) return step(0.0, d.x);
  if (vPattern < 2.5) return step(0.5, fract(2.0 * atan(d.y, d.x) / 3.14159265));
  if (vPattern < 3.5) return step(0.0, d.x * d.y * d.z);
  return step(0.5, fract(2.5 * acos(clamp(d.z, -1.0, 1.0)) / 3.14159265 + 0.25));
}
`;

/** Patterns are drawn by direction from the mesh's origin: the same on a body of any size. */
export function bodyMaterial(): MeshLambertMaterial {
  const material = new MeshLambertMaterial();
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = VERTEX_HEAD + shader.vertexShader.replace("#include <begin_vertex>", `#include <begin_vertex>${VERTEX}`);
    shader.fragmentShader =
      FRAGMENT_HEAD +
      shader.fragmentShader.replace(
        "#include <color_fragment>",
        `#include <color_fragment>\ndiffuseColor.rgb *= 1.0 - ${(1 - SHADE).toFixed(2)} * secondShade(normalize(vOwn));`,
      );
  };
  return material;
}
