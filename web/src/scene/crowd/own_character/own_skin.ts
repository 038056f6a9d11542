// A visitor's skin as it stands in the file, on our axes and our joints.

import {
  Bone,
  BufferAttribute,
  BufferGeometry,
  Color,
  type InterleavedBufferAttribute,
  type Material,
  Matrix3,
  Matrix4,
  Mesh,
  type Object3D,
  SkinnedMesh,
  type Texture,
  Vector3,
} from 'three';
import { type BodyPart, kRegion } from '../bodies/body';
import { pointToOurs, type OwnRig } from './own_rig';

type Attribute = BufferAttribute | InterleavedBufferAttribute;
type Painted = Material & { readonly color?: Color; readonly map?: Texture | null };

/** Meshes that move with the skeleton: skins, and what is fastened to a joint. */
export function movingMeshes(root: Object3D): Mesh[] {
  const found: Mesh[] = [];
  root.traverse((node) => {
    if (!(node instanceof Mesh) || !node.visible) return;
    if (node instanceof SkinnedMesh || boneAbove(node)) found.push(node as Mesh);
  });
  return found;
}

function boneAbove(node: Object3D): Object3D | null {
  let at = node.parent;
  while (at && !(at instanceof Bone)) at = at.parent;
  return at;
}

/** Where a corner of a mesh stands, in the file's axes. */
class Stander {
  private readonly matrices_: Matrix4[];
  private readonly skin_: Attribute | null;
  private readonly weight_: Attribute | null;
  private readonly sum_ = new Matrix4();

  constructor(private readonly mesh_: Mesh) {
    const skinned = mesh_ instanceof SkinnedMesh ? mesh_ : null;
    this.skin_ = skinned ? (mesh_.geometry.attributes['skinIndex'] as Attribute) : null;
    this.weight_ = skinned ? (mesh_.geometry.attributes['skinWeight'] as Attribute) : null;
    this.matrices_ = skinned
      ? skinned.skeleton.bones.map((bone, b) =>
          bone.matrixWorld.clone().multiply(skinned.skeleton.boneInverses[b]!).multiply(skinned.bindMatrix),
        )
      : [mesh_.matrixWorld];
  }

  matrix(corner: number): Matrix4 {
    if (!this.skin_ || !this.weight_) return this.matrices_[0]!;
    const sum = this.sum_.elements.fill(0);
    let total = 0;
    for (let k = 0; k < 4; ++k) {
      const weight = this.weight_.getComponent(corner, k);
      const matrix = this.matrices_[this.skin_.getComponent(corner, k)];
      if (weight <= 0 || !matrix) continue;
      total += weight;
      for (let e = 0; e < 16; ++e) sum[e]! += weight * matrix.elements[e]!;
    }
    if (total <= 0) return this.mesh_.matrixWorld;
    for (let e = 0; e < 16; ++e) sum[e]! /= total;
    return this.sum_;
  }
}

/** Lowest corner of all, in the file's axes. */
export function lowestOf(meshes: readonly Mesh[]): number {
  let lowest = Infinity;
  const at = new Vector3();
  for (const mesh of meshes) {
    const position = mesh.geometry.attributes['position'] as Attribute;
    const stander = new Stander(mesh);
    for (let i = 0; i < position.count; ++i) {
      at.fromBufferAttribute(position, i).applyMatrix4(stander.matrix(i));
      lowest = Math.min(lowest, at.y);
    }
  }
  return lowest;
}

/** Collects corners of meshes that share a picture. */
class PartBuilder {
  readonly numbers: Record<'position' | 'normal' | 'uv' | 'joints' | 'weights' | 'tint', number[]> = {
    position: [],
    normal: [],
    uv: [],
    joints: [],
    weights: [],
    tint: [],
  };
  readonly indices: number[] = [];

  constructor(private readonly own_: OwnRig) {}

  add(mesh: Mesh, paint: Painted): void {
    const first = this.numbers.position.length / 3;
    const { geometry } = mesh;
    if (!geometry.attributes['normal']) geometry.computeVertexNormals();
    const position = geometry.attributes['position'] as Attribute;
    const stander = new Stander(mesh);
    for (let i = 0; i < position.count; ++i) this.corner(mesh, stander.matrix(i), paint, i);
    const count = geometry.index?.count ?? position.count;
    for (let i = 0; i < count; ++i) this.indices.push(first + (geometry.index ? geometry.index.getX(i) : i));
  }

  private corner(mesh: Mesh, matrix: Matrix4, paint: Painted, i: number): void {
    const { attributes } = mesh.geometry;
    const { numbers } = this;
    const { axes } = this.own_;
    const at = new Vector3().fromBufferAttribute(attributes['position'] as BufferAttribute, i).applyMatrix4(matrix);
    numbers.position.push(...pointToOurs(axes, at));
    const turn = new Matrix3().setFromMatrix4(matrix);
    const n = new Vector3()
      .fromBufferAttribute(attributes['normal'] as BufferAttribute, i)
      .applyMatrix3(turn)
      .normalize();
    numbers.normal.push(axes.facing * n.z, axes.facing * n.x, n.y);
    const uv = attributes['uv'];
    numbers.uv.push(uv ? uv.getX(i) : 0, uv ? uv.getY(i) : 0);
    const colour = attributes['color'];
    const base = (paint.color ?? new Color(1, 1, 1)).toArray();
    for (const [k, part] of base.entries()) numbers.tint.push(part * (colour ? colour.getComponent(i, k) : 1));
    this.hang(mesh, i);
  }

  /** Joints become roles; weights of those that share one add up. */
  private hang(mesh: Mesh, i: number): void {
    const { bones, carriers } = this.own_;
    const sums = new Map<number, number>();
    if (mesh instanceof SkinnedMesh) {
      const { attributes } = mesh.geometry as BufferGeometry;
      const skin = attributes['skinIndex'] as Attribute;
      const weight = attributes['skinWeight'] as Attribute;
      for (let k = 0; k < 4; ++k) {
        const bone = mesh.skeleton.bones[skin.getComponent(i, k)];
        const role = bone ? (carriers[bones.indexOf(bone)] ?? 0) : 0;
        sums.set(role, (sums.get(role) ?? 0) + weight.getComponent(i, k));
      }
    } else {
      const bone = boneAbove(mesh);
      sums.set(bone ? (carriers[bones.indexOf(bone)] ?? 0) : 0, 1);
    }
    const total = [...sums.values()].reduce((a, b) => a + b, 0) || 1;
    const list = [...sums].sort((a, b) => b[1] - a[1]).slice(0, 4);
    for (let k = 0; k < 4; ++k) {
      this.numbers.joints.push(list[k]?.[0] ?? 0);
      this.numbers.weights.push((list[k]?.[1] ?? 0) / total);
    }
  }

  build(): BufferGeometry {
    const geometry = new BufferGeometry();
    const sizes = { position: 3, normal: 3, uv: 2, joints: 4, weights: 4, tint: 3 } as const;
    for (const name of Object.keys(sizes) as (keyof typeof sizes)[]) {
      geometry.setAttribute(name, new BufferAttribute(Float32Array.from(this.numbers[name]), sizes[name]));
    }
    const count = this.numbers.position.length / 3;
    geometry.setAttribute('region', new BufferAttribute(new Float32Array(count).fill(kRegion.own), 1));
    geometry.setIndex(this.indices);
    return geometry;
  }
}

/** The skin in as few parts as it has pictures. */
export function partsOf(meshes: readonly Mesh[], own: OwnRig): BodyPart[] {
  const builders = new Map<Texture | null, PartBuilder>();
  for (const mesh of meshes) {
    const paint = (Array.isArray(mesh.material) ? mesh.material[0] : mesh.material) as Painted;
    const map = paint.map ?? null;
    let builder = builders.get(map);
    if (!builder) builders.set(map, (builder = new PartBuilder(own)));
    builder.add(mesh, paint);
  }
  return [...builders].map(([map, builder]) => ({ geometry: builder.build(), map }));
}
