// The surface of bodies: matt, in the colour of each solid, with patterns that turn with the body.

import { Color, MeshLambertMaterial, ShaderMaterial, Vector3 } from "three";
import { SOLIDS_IN_A_ROW, type Texels } from "./geometry";
import { GROUND_LIGHT, SKY_LIGHT, SUN_DIRECTION, SUN_LIGHT } from "./lights";

/** The second shade of a pattern is so much darker. */
const DARKER = 0.28;

/** By direction from the mesh's origin: the same on a body of any size. */
const PATTERN = `
float shaded(float pattern, vec3 d) {
  float dark = step(0.5, fract(2.5 * acos(clamp(d.z, -1.0, 1.0)) / 3.14159265 + 0.25));
  if (pattern < 1.5) dark = step(0.0, d.x);
  else if (pattern < 2.5) dark = step(0.5, fract(2.0 * atan(d.y, d.x) / 3.14159265));
  else if (pattern < 3.5) dark = step(0.0, d.x * d.y * d.z);
  return 1.0 - ${DARKER} * dark;
}
`;

/** The light of `lights.ts` without shadows. */
const LIGHT = `
uniform vec3 sun;
uniform vec3 below;
vec3 lit(vec3 colour, vec3 n) {
  vec3 sky = mix(below, vec3(1.0), 0.5 * n.z + 0.5) * ${SKY_LIGHT.toFixed(2)};
  return colour * (sky + ${SUN_LIGHT.toFixed(2)} * max(0.0, dot(n, sun))) / 3.14159265;
}
`;

/** Matrix, colour and pattern of the solid that a vertex belongs to. */
const LOOK_UP = `
attribute float solid;
uniform highp sampler2D matrices;
uniform highp sampler2D tints;
mat4 matrixOf() {
  int k = int(solid + 0.5);
  ivec2 at = ivec2(4 * (k % ${SOLIDS_IN_A_ROW}), k / ${SOLIDS_IN_A_ROW});
  return mat4(
    texelFetch(matrices, at, 0), texelFetch(matrices, at + ivec2(1, 0), 0),
    texelFetch(matrices, at + ivec2(2, 0), 0), texelFetch(matrices, at + ivec2(3, 0), 0)
  );
}
vec4 tintOf() {
  int k = int(solid + 0.5);
  return texelFetch(tints, ivec2(k % ${SOLIDS_IN_A_ROW}, k / ${SOLIDS_IN_A_ROW}), 0);
}
`;

const SIMPLE_VERTEX = `
varying vec3 vColour;
varying vec3 vOwn;
varying float vPattern;
${LOOK_UP}
${LIGHT}
void main() {
  mat4 whole = matrixOf();
  mat3 m = mat3(whole);
  vec3 n = normalize(m * (normal / max(vec3(dot(m[0], m[0]), dot(m[1], m[1]), dot(m[2], m[2])), 1e-30)));
  vec4 tint = tintOf();
  vColour = lit(tint.rgb, n);
  vPattern = tint.a;
  vOwn = position;
  gl_Position = projectionMatrix * (modelViewMatrix * (whole * vec4(position, 1.0)));
}
`;
const SIMPLE_FRAGMENT = `
varying vec3 vColour;
varying vec3 vOwn;
varying float vPattern;
${PATTERN}
void main() {
  gl_FragColor = vec4(vPattern < 0.5 ? vColour : vColour * shaded(vPattern, normalize(vOwn)), 1.0);
  #include <colorspace_fragment>
}
`;

const DISC_VERTEX = `
varying vec3 vColour;
varying vec2 vAt;
varying float vPattern;
varying mat3 vToWorld;
varying mat3 vToBody;
${LOOK_UP}
void main() {
  mat4 whole = matrixOf();
  float radius = length(whole[0].xyz);
  vec4 place = modelViewMatrix * whole[3];
  vec3 ahead = normalize(-place.xyz);
  vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), ahead));
  vec3 up = cross(ahead, right);
  vec4 tint = tintOf();
  vColour = tint.rgb;
  vPattern = tint.a;
  vAt = position.xy;
  vToWorld = transpose(mat3(viewMatrix)) * mat3(right, up, ahead);
  vToBody = transpose(mat3(whole)) * vToWorld;
  gl_Position = projectionMatrix * vec4(place.xyz + radius * (position.x * right + position.y * up), 1.0);
}
`;
const DISC_FRAGMENT = `
varying vec3 vColour;
varying vec2 vAt;
varying float vPattern;
varying mat3 vToWorld;
varying mat3 vToBody;
${PATTERN}
${LIGHT}
void main() {
  float square = dot(vAt, vAt);
  if (square > 1.0) discard;
  vec3 n = vec3(vAt, sqrt(1.0 - square));
  vec3 colour = lit(vColour, vToWorld * n);
  gl_FragColor = vec4(vPattern < 0.5 ? colour : colour * shaded(vPattern, normalize(vToBody * n)), 1.0);
  #include <colorspace_fragment>
}
`;

/** Of instances: light on every pixel, shadows. Attribute `tint`: colour and pattern. */
export function bodyMaterial(): MeshLambertMaterial {
  const material = new MeshLambertMaterial();
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = `attribute vec4 tint;\nvarying vec4 vTint;\nvarying vec3 vOwn;\n${shader.vertexShader.replace(
      "#include <begin_vertex>",
      "#include <begin_vertex>\nvTint = tint;\nvOwn = position;",
    )}`;
    shader.fragmentShader = `varying vec4 vTint;\nvarying vec3 vOwn;\n${PATTERN}\n${shader.fragmentShader.replace(
      "#include <color_fragment>",
      "diffuseColor.rgb = vTint.a < 0.5 ? vTint.rgb : vTint.rgb * shaded(vTint.a, normalize(vOwn));",
    )}`;
  };
  return material;
}

/** Of merged solids: light at the corners only, no shadows. discs: squares become discs that face the viewer, shaded
 *  like spheres. A disc through the middle of a sphere hides what the sphere hides, and is hidden by what hides the
 *  sphere, as long as bodies do not overlap. */
export function simpleMaterial(matrices: Texels, tints: Texels, discs: boolean): ShaderMaterial {
  return new ShaderMaterial({
    vertexShader: discs ? DISC_VERTEX : SIMPLE_VERTEX,
    fragmentShader: discs ? DISC_FRAGMENT : SIMPLE_FRAGMENT,
    uniforms: {
      matrices: { value: matrices.texture },
      tints: { value: tints.texture },
      sun: { value: new Vector3(...SUN_DIRECTION) },
      below: { value: new Color(GROUND_LIGHT) },
    },
  });
}
