// A bright rim around the body that is selected.

import { BackSide, Group, Mesh, ShaderMaterial, Color, Matrix4, Vector3, type BufferGeometry } from "three";
import type { Placed } from "./recording";
import type { Batch } from "./batch";

/** Width of the rim in pixels of the page. */
const WIDTH = 2.5;

const VERTEX = `
uniform float width;
uniform vec2 size;
uniform vec3 middle;
void main() {
  vec4 place = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  vec4 centre = projectionMatrix * modelViewMatrix * vec4(middle, 1.0);
  vec2 out2 = place.xy / place.w - centre.xy / centre.w;
  vec2 direction = out2 * size;
  float far = length(direction);
  if (far > 0.0) place.xy += direction / far * width * 2.0 / size * place.w;
  gl_Position = place;
}
`;
const FRAGMENT = `
uniform vec3 colour;
void main() {
  gl_FragColor = vec4(colour, 1.0);
  #include <colorspace_fragment>
}
`;

/** Draws the backs of the body's solids a little larger. */
export class Outline {
  readonly group = new Group();
  private readonly colour = { value: new Color("#ff8c00") };
  private readonly size = { value: [1, 1] };
  private shown: { mesh: Mesh; batch: Batch; instance: number }[] = [];
  private readonly matrix = new Matrix4();

  constructor(
    private readonly placed: readonly Placed[],
    private readonly batches: readonly Batch[],
  ) {}

  /** The body whose rim is drawn, null for none. */
  set(body: number | null): void {
    for (const { mesh } of this.shown) (mesh.material as ShaderMaterial).dispose();
    this.group.clear();
    this.shown = body === null ? [] : this.solidsOf(body);
    for (const { mesh } of this.shown) this.group.add(mesh);
  }

  /** Before each picture. */
  move(width: number, height: number): void {
    this.size.value[0] = width;
    this.size.value[1] = height;
    for (const { mesh, batch, instance } of this.shown) {
      batch.instances.getMatrixAt(instance, this.matrix);
      mesh.matrix.copy(this.matrix);
      mesh.matrixWorldNeedsUpdate = true;
    }
  }

  setColour(colour: string): void {
    this.colour.value.set(colour);
  }

  private solidsOf(body: number): { mesh: Mesh; batch: Batch; instance: number }[] {
    return this.batches.flatMap((batch) =>
      batch.numbers.flatMap((number, instance) =>
        this.placed[number].body === body ? [{ mesh: this.rim(batch.geometry), batch, instance }] : [],
      ),
    );
  }

  private rim(geometry: BufferGeometry): Mesh {
    geometry.computeBoundingBox();
    const middle = geometry.boundingBox?.getCenter(new Vector3()) ?? new Vector3();
    const uniforms = { width: { value: WIDTH }, size: this.size, middle: { value: middle }, colour: this.colour };
    const material = new ShaderMaterial({ vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms, side: BackSide });
    const mesh = new Mesh(geometry, material);
    mesh.matrixAutoUpdate = false;
    mesh.frustumCulled = false;
    return mesh;
  }
}
