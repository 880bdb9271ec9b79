// One colour, lighter where a surface faces the eye: what joints and springs are drawn in.

/** Fragment shader; the vertex shader gives `vNormal` in the eye's axes. */
export const TINTED = `
  uniform vec3 tint;
  uniform float opacity;
  varying vec3 vNormal;
  void main() {
    gl_FragColor = vec4(tint * (0.4 + 0.6 * abs(normalize(vNormal).z)), opacity);
    #include <colorspace_fragment>
  }`;
