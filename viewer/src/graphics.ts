// The drawing surface: WebGL where there is one.

import { WebGLRenderer } from "three";

export interface Graphics {
  readonly renderer: WebGLRenderer;
  /** The processor draws, without help of a graphics card. */
  readonly software: boolean;
}

/** Above so many solids the edges of software drawings stay rough: smoothing takes twice the time. */
const MANY_SOLIDS = 200;

/** A renderer that fills its element; null where the browser has no WebGL 2. */
export function graphicsFor(solids: number): Graphics | null {
  const software = drawsInSoftware();
  if (software === null) return null;
  try {
    const antialias = !(software && solids > MANY_SOLIDS);
    const canvas = document.createElement("canvas");
    // Three.js would ask for a canvas that can be seen through, which takes longer to put on the page.
    const context = canvas.getContext("webgl2", { alpha: false, antialias, depth: true, powerPreference: "high-performance" });
    return context && { renderer: new WebGLRenderer({ canvas, context }), software };
  } catch {
    return null;
  }
}

function drawsInSoftware(): boolean | null {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return null;
  const known = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(known ? known.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}
