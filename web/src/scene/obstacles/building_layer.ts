// Buildings and other still obstacles: one mesh of all that are solid, and one of those that thin out, as they hide
// characters from the camera.

import { type BufferGeometry, BufferAttribute, DynamicDrawUsage, Group, Mesh, type MeshLambertMaterial } from 'three';
import type { Vec2 } from '../../protocol/generated/commands';
import type { SceneObstacle } from '../../protocol/messages';
import type { CameraController } from '../camera/camera_controller';
import type { GeometryBuilder } from '../drawing/geometry_builder';
import { bodyMaterial, type ShadeUniforms } from '../drawing/shade';
import { kCutHeight, outlineOf } from './obstacle_geometry';
import type { Standing } from './tree_layer';

/** Opacity of a building that hides a character. */
const kThin = 0.34;
/** Share of the difference to the wanted opacity that each picture makes up. */
const kFollow = 0.16;
/** Height of the middle of a figure, and how near one is to a spot behind a building [m]. */
const kPerson = 0.9;
const kReach = 0.75;
/** Steps of the spots that are looked at, along an outline and away from it [m]. */
const kAlong = 1.1;
const kAway = 0.9;
/** Lower ones hide nobody [m]. */
const kLow = 1.1;
/** So many buildings are looked at for one picture. */
const kLooks = 24;
/** A larger one would take too long to look at [spots]. */
const kSpots = 400;

interface Building {
  /** Its corners in the geometry: from, to. */
  readonly from: number;
  readonly to: number;
  readonly height: number;
  /** Spots on its outline, so far apart that nobody stands between two of them unseen. */
  readonly spots: readonly Vec2[];
  wanted: number;
  solid: number;
}

export class BuildingLayer {
  readonly group = new Group();
  private readonly solid_: MeshLambertMaterial;
  private readonly thin_: MeshLambertMaterial;
  private buildings_: Building[] = [];
  private share_ = new BufferAttribute(new Float32Array(0), 1);
  private thinMesh_: Mesh | null = null;
  private next_ = 0;

  constructor(shade: ShadeUniforms) {
    this.solid_ = shareMaterial(shade, 'if (vShare < 0.995) discard;', 'solid');
    this.thin_ = shareMaterial(shade, 'if (vShare >= 0.995) discard;\ndiffuseColor.a *= vShare;', 'thin');
    this.thin_.transparent = true;
  }

  /** Opacity of each building, 0 to 1. */
  get solid(): readonly number[] {
    return this.buildings_.map(({ solid }) => solid);
  }

  /** Takes the geometry of these obstacles; `ends`: its triangles after each of them. */
  build(builder: GeometryBuilder, obstacles: readonly SceneObstacle[], ends: readonly number[], glow: string): void {
    this.thin_.emissive.set(glow);
    if (builder.triangleCount === 0) return;
    const geometry: BufferGeometry = builder.build();
    this.share_ = new BufferAttribute(new Float32Array(3 * builder.triangleCount).fill(1), 1);
    this.share_.setUsage(DynamicDrawUsage);
    geometry.setAttribute('aShare', this.share_);
    this.buildings_ = obstacles.map((obstacle, i) => ({
      from: 3 * (ends[i - 1] ?? 0),
      to: 3 * (ends[i] ?? 0),
      height: Math.min(kCutHeight, obstacle.height),
      spots: obstacle.height < kLow ? [] : spotsOf(outlineOf(obstacle)),
      wanted: 1,
      solid: 1,
    }));
    const mesh = new Mesh(geometry, this.solid_);
    mesh.castShadow = mesh.receiveShadow = true;
    // After people and water.
    this.thinMesh_ = new Mesh(geometry, this.thin_);
    this.thinMesh_.renderOrder = 5;
    this.thinMesh_.receiveShadow = true;
    this.thinMesh_.visible = false;
    this.group.add(mesh, this.thinMesh_);
  }

  /** Thins out buildings that hide a character; true while they change. */
  reveal(people: Standing, camera: CameraController): boolean {
    this.look(people, camera);
    let [changes, thin] = [false, false];
    for (const one of this.buildings_) {
      if (one.solid !== one.wanted) {
        changes = true;
        one.solid += (one.wanted - one.solid) * kFollow;
        if (Math.abs(one.wanted - one.solid) < 0.01) one.solid = one.wanted;
        (this.share_.array as Float32Array).fill(one.solid, one.from, one.to);
      }
      thin ||= one.solid < 1;
    }
    if (changes) this.share_.needsUpdate = true;
    if (this.thinMesh_) this.thinMesh_.visible = thin;
    return changes;
  }

  /** Makes all opaque at once. */
  solidify(): void {
    for (const one of this.buildings_) one.solid = one.wanted = 1;
    (this.share_.array as Float32Array).fill(1);
    this.share_.needsUpdate = true;
  }

  clear(): void {
    for (const mesh of this.group.children) if (mesh instanceof Mesh) (mesh as Mesh<BufferGeometry>).geometry.dispose();
    this.group.clear();
    this.thinMesh_ = null;
    this.buildings_ = [];
    this.next_ = 0;
  }

  dispose(): void {
    this.clear();
    this.solid_.dispose();
    this.thin_.dispose();
  }

  /** Looks behind the next few of them. */
  private look(people: Standing, camera: CameraController): void {
    const count = Math.min(kLooks, this.buildings_.length);
    const { eye } = camera.basis();
    for (let k = 0; k < count; ++k) {
      const one = this.buildings_[(this.next_ + k) % this.buildings_.length]!;
      one.wanted = hides(one, people, eye) ? kThin : 1;
    }
    if (count > 0) this.next_ = (this.next_ + count) % this.buildings_.length;
  }
}

/** True where somebody stands so close behind it that the line of sight to the eye meets it. */
function hides({ spots, height }: Building, people: Standing, eye: readonly [number, number, number]): boolean {
  return spots.some(([x, y]) => {
    const [dx, dy] = [x - eye[0], y - eye[1]];
    const flat = Math.hypot(dx, dy);
    if (flat < 1e-6 || eye[2] <= height) return false;
    const behind = ((height - kPerson) * flat) / (eye[2] - height);
    for (let away = 0.4; away < behind + kAway; away += kAway) {
      const at = Math.min(away, behind);
      if (people.someoneNear(x + (dx / flat) * at, y + (dy / flat) * at, kReach)) return true;
    }
    return false;
  });
}

/** Spots along an outline; none where there would be too many. */
function spotsOf(outline: readonly Vec2[]): readonly Vec2[] {
  const spots: Vec2[] = [];
  outline.forEach((a, i) => {
    const b = outline[(i + 1) % outline.length] as Vec2;
    const parts = Math.max(1, Math.ceil(Math.hypot(b[0] - a[0], b[1] - a[1]) / kAlong));
    for (let k = 0; k < parts; ++k) {
      spots.push([a[0] + ((b[0] - a[0]) * k) / parts, a[1] + ((b[1] - a[1]) * k) / parts]);
    }
  });
  const stride = Math.ceil(spots.length / kSpots);
  return stride > 1 ? spots.filter((_, i) => i % stride === 0) : spots;
}

/** The hatched material of bodies, with a line of the fragment that decides by the share of each corner. */
function shareMaterial(shade: ShadeUniforms, code: string, name: string): MeshLambertMaterial {
  const material = bodyMaterial(shade, true);
  const before = material.onBeforeCompile.bind(material);
  material.onBeforeCompile = (shader, renderer): void => {
    before(shader, renderer);
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', '#include <common>\nattribute float aShare;\nvarying float vShare;')
      .replace('#include <begin_vertex>', '#include <begin_vertex>\nvShare = aShare;');
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', '#include <common>\nvarying float vShare;')
      .replace('#include <color_fragment>', `#include <color_fragment>\n${code}`);
  };
  material.customProgramCacheKey = (): string => `building-${name}`;
  return material;
}
