// Trees: trunks, and crowns that turn transparent where they hide characters. One draw call for all trunks, one for all
// crowns.

import {
  DynamicDrawUsage,
  Group,
  InstancedBufferAttribute,
  InstancedMesh,
  Matrix4,
  type Mesh,
  MeshLambertMaterial,
  Quaternion,
  Vector3,
  type Material,
} from 'three';
import { lookOf } from '../crowd/look';
import type { SceneObstacle } from '../../protocol/messages';
import type { CameraController } from '../camera/camera_controller';
import { makeCrownGeometry, makeTrunkGeometry } from './obstacle_geometry';
import type { Palette } from '../drawing/palette';

/** Height of the middle of a crown, and its reach, for a tree of size 1 [m]. */
const kCrownHeight = 2.9;
const kCrownReach = 1.75;
/** Height of the middle of a figure [m]. */
const kPerson = 0.9;
/** Opacity of a crown that hides a character. */
const kThin = 0.1;
/** Share of the difference to the wanted opacity that each picture makes up. */
const kFollow = 0.2;

interface Crown {
  readonly x: number;
  readonly y: number;
  readonly size: number;
}

/** Characters that crowns must not hide. */
export interface Standing {
  /** True where one of them is within `reach` of a spot [m]. */
  someoneNear(x: number, y: number, reach: number): boolean;
}

export class TreeLayer {
  readonly group = new Group();
  private readonly material_: MeshLambertMaterial;
  private crowns_: Crown[] = [];
  private solid_ = new InstancedBufferAttribute(new Float32Array(0), 1);

  constructor() {
    this.material_ = new MeshLambertMaterial({ vertexColors: true, transparent: true });
    this.material_.onBeforeCompile = (shader): void => {
      shader.vertexShader = shader.vertexShader
        .replace('#include <common>', '#include <common>\nattribute float aSolid;\nvarying float vSolid;')
        .replace('#include <begin_vertex>', '#include <begin_vertex>\nvSolid = aSolid;');
      shader.fragmentShader = shader.fragmentShader
        .replace('#include <common>', '#include <common>\nvarying float vSolid;')
        .replace('#include <color_fragment>', '#include <color_fragment>\ndiffuseColor.a *= vSolid;');
    };
    this.material_.customProgramCacheKey = (): string => 'crown';
  }

  /** How solid each crown is drawn, 0 to 1. */
  get solid(): ArrayLike<number> {
    return this.solid_.array;
  }

  build(trees: readonly SceneObstacle[], palette: Palette, trunkMaterial: Material): void {
    if (trees.length === 0) return;
    const trunks = new InstancedMesh(makeTrunkGeometry(palette), trunkMaterial, trees.length);
    const crowns = new InstancedMesh(makeCrownGeometry(palette), this.material_, trees.length);
    this.solid_ = new InstancedBufferAttribute(new Float32Array(trees.length).fill(1), 1);
    this.solid_.setUsage(DynamicDrawUsage);
    crowns.geometry.setAttribute('aSolid', this.solid_);
    const up = new Vector3(0, 0, 1);
    this.crowns_ = trees.map((tree, i) => {
      const look = lookOf(tree.id + 77);
      const size = Math.min(1.6, Math.max(0.75, 0.6 + tree.radius)) * (0.9 + 0.25 * look.size);
      const turn = new Quaternion().setFromAxisAngle(up, look.size * 6.28);
      const [x, y] = tree.centre;
      const matrix = new Matrix4().compose(new Vector3(x, y, 0), turn, new Vector3(size, size, 0.95 * size));
      for (const mesh of [trunks, crowns]) mesh.setMatrixAt(i, matrix);
      return { x, y, size };
    });
    for (const mesh of [trunks, crowns]) {
      mesh.castShadow = true;
      mesh.receiveShadow = true;
      mesh.frustumCulled = false;
    }
    // After people and water.
    crowns.renderOrder = 5;
    this.group.add(trunks, crowns);
  }

  /** Makes crowns transparent that hide a character; true while they change. */
  reveal(people: Standing, camera: CameraController): boolean {
    if (this.crowns_.length === 0) return false;
    const { forward } = camera.basis();
    const flat = Math.hypot(forward[0], forward[1]);
    const slope = flat / Math.max(0.05, -forward[2]);
    const [ux, uy] = flat > 1e-6 ? [forward[0] / flat, forward[1] / flat] : [0, 0];
    let changes = false;
    this.crowns_.forEach(({ x, y, size }, i) => {
      // On the ground, where the line of sight through the crown's middle meets people.
      const away = (kCrownHeight * size - kPerson) * slope;
      const wanted = people.someoneNear(x + ux * away, y + uy * away, kCrownReach * size) ? kThin : 1;
      const now = this.solid_.array[i]!;
      if (Math.abs(wanted - now) < 0.01) return;
      changes = true;
      this.solid_.array[i] = now + (wanted - now) * kFollow;
    });
    if (changes) this.solid_.needsUpdate = true;
    return changes;
  }

  /** Makes all opaque at once. */
  solidify(): void {
    this.solid_.array.fill(1);
    this.solid_.needsUpdate = true;
  }

  clear(): void {
    for (const mesh of [...this.group.children]) {
      if (!(mesh instanceof InstancedMesh)) continue;
      (mesh as Mesh).geometry.dispose();
      mesh.dispose();
    }
    this.group.clear();
    this.crowns_ = [];
  }

  dispose(): void {
    this.clear();
    this.material_.dispose();
  }
}
