// Joints as symbols at their anchors, turned with body A; rods between the ends of distance joints.

import { Color, GreaterDepth, Group, InstancedMesh, Matrix4, Quaternion, ShaderMaterial, Vector3 } from "three";
import type { Moment } from "../../player";
import type { Link, Recording, Track } from "../../recording";
import type { World } from "../../world";
import { anchor, turned } from "../pose";
import type { Store } from "../settings";
import { Sticks } from "./sticks";
import { SYMBOLS } from "./symbols";
import { TINTED } from "./tinted";

const TINT = new Color("#12a37f");
const UP = new Vector3(0, 0, 1);
const NOWHERE = new Matrix4().makeScale(0, 0, 0);

const VERTEX = `
  varying vec3 vNormal;
  void main() {
    vNormal = normalMatrix * (mat3(instanceMatrix) * normal);
    gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(position, 1.0);
  }`;

/** All joints of one kind. What lies behind bodies is drawn faintly by the second mesh. */
interface Kind {
  joints: readonly Link[];
  meshes: readonly InstancedMesh[];
}

export class JointDrawing {
  private readonly group = new Group();
  private readonly kinds: Kind[] = [];
  private readonly rods = new Sticks(false, 0.15);
  private readonly broken: Track | null;
  private readonly size: number;
  private readonly a = new Vector3();
  private readonly b = new Vector3();
  private readonly turn = new Quaternion();
  private readonly matrix = new Matrix4();
  private readonly scale = new Vector3();

  constructor(
    recording: Recording,
    private readonly world: World,
    store: Store,
  ) {
    this.size = 0.32 * world.bodySize;
    this.scale.setScalar(this.size);
    this.broken = recording.track("joints/broken");
    for (const [kind, joints] of byKind(recording.joints)) this.kinds.push(this.make(kind, joints));
    this.group.add(this.rods.group);
    world.overlay.add(this.group);
    store.watch(["joints"], () => {
      this.group.visible = store.now.joints && recording.joints.length > 0;
      world.redraw();
    });
    world.onFrame((moment) => {
      if (this.group.visible && recording.frames > 0) this.update(moment);
    });
  }

  private make(kind: string, joints: readonly Link[]): Kind {
    const shape = (SYMBOLS[kind] ?? SYMBOLS.fixed)();
    const meshes = [1, 0.22].map((opacity) => {
      const mesh = new InstancedMesh(shape, symbolMaterial(opacity), joints.length);
      mesh.frustumCulled = false;
      mesh.renderOrder = opacity < 1 ? 4 : 3;
      this.group.add(mesh);
      return mesh;
    });
    return { joints, meshes };
  }

  private update(moment: Moment): void {
    this.rods.clear();
    for (const { joints, meshes } of this.kinds) {
      for (let i = 0; i < joints.length; i++) this.put(moment, joints[i], meshes, i);
      for (const mesh of meshes) mesh.instanceMatrix.needsUpdate = true;
    }
    this.rods.commit();
  }

  private put(moment: Moment, joint: Link, meshes: readonly InstancedMesh[], i: number): void {
    const isBroken = this.broken?.at(moment.frame, joint.index, 0) === 1;
    anchor(moment, joint, 0, this.a);
    this.world.toView(this.a.x, this.a.y, this.a.z, this.a);
    const stands = !isBroken && Number.isFinite(this.a.x);
    if (stands) this.place(moment, joint);
    for (const mesh of meshes) mesh.setMatrixAt(i, stands ? this.matrix : NOWHERE);
    if (stands && joint.kind === "distance") this.addRod(moment, joint);
  }

  private place(moment: Moment, joint: Link): void {
    this.turn.identity();
    if (joint.axis) {
      turned(moment, joint.bodies[0], joint.axis, this.b);
      this.turn.setFromUnitVectors(UP, this.b.normalize());
    }
    this.matrix.compose(this.a, this.turn, this.scale);
  }

  private addRod(moment: Moment, joint: Link): void {
    anchor(moment, joint, 1, this.b);
    this.world.toView(this.b.x, this.b.y, this.b.z, this.b).sub(this.a);
    this.rods.add(this.a.x, this.a.y, this.a.z, this.b.x, this.b.y, this.b.z, 0.08 * this.size, TINT);
  }
}

function byKind(joints: readonly Link[]): Map<string, Link[]> {
  const sorted = new Map<string, Link[]>();
  for (const joint of joints) sorted.set(joint.kind, [...(sorted.get(joint.kind) ?? []), joint]);
  return sorted;
}

function symbolMaterial(opacity: number): ShaderMaterial {
  const behind = opacity < 1;
  return new ShaderMaterial({
    vertexShader: VERTEX, fragmentShader: TINTED, uniforms: { tint: { value: TINT }, opacity: { value: opacity } },
    transparent: behind, depthWrite: !behind, ...(behind ? { depthFunc: GreaterDepth } : {}),
  });
}
