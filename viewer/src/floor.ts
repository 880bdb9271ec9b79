// A floor: a disc that fades out into the background.

import {
  BufferAttribute, CircleGeometry, Color, Group, Mesh, MeshBasicMaterial, MeshLambertMaterial, RingGeometry, type BufferGeometry,
  type Vector3,
} from "three";
import { lightOn } from "./lights";

/** A floor reaches so many radii of the scene, and fades out over so many more. */
const REACH = 5;
const FADE = 12;
const SIDES = 48;

export class Floor {
  readonly group = new Group();
  readonly surface: Mesh;
  /** Light falls on a floor the same everywhere: without shadows one colour will do, which takes less time. */
  private readonly lit = new MeshLambertMaterial();
  private readonly plain = new MeshBasicMaterial();
  private readonly rim = new MeshBasicMaterial({ transparent: true, vertexColors: true, depthWrite: false });

  /** normal: where its upper side looks. */
  constructor(radius: number, private readonly normal: Vector3) {
    this.surface = new Mesh(new CircleGeometry(REACH * radius, SIDES), this.plain);
    this.surface.receiveShadow = true;
    this.group.add(this.surface, new Mesh(rimOf(radius), this.rim));
  }

  setColour(colour: string): void {
    this.lit.color.set(colour);
    for (const material of [this.plain, this.rim]) material.color.set(colour).multiply(lightOn(this.normal, new Color()));
  }

  setShadows(shown: boolean): void {
    this.surface.material = shown ? this.lit : this.plain;
  }
}

/** Around a floor: its colour, more and more seen through. */
function rimOf(radius: number): BufferGeometry {
  const rim = new RingGeometry(REACH * radius, (REACH + FADE) * radius, SIDES, 6);
  const places = rim.getAttribute("position");
  const colours = new Float32Array(4 * places.count).fill(1);
  for (let k = 0; k < places.count; k++) {
    const away = (Math.hypot(places.getX(k), places.getY(k)) / radius - REACH) / FADE;
    colours[4 * k + 3] = Math.max(0, 1 - away) ** 2;
  }
  rim.setAttribute("color", new BufferAttribute(colours, 4));
  return rim;
}
