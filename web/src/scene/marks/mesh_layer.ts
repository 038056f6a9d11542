// The meshes of all groups: fill, inside lines and rim, each a draw for all groups; lines show faintly through bodies.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DynamicDrawUsage,
  Group,
  LinearSRGBColorSpace,
  Mesh,
  ShaderMaterial,
} from 'three';
import { FatLines } from '../drawing/fat_lines';
import type { Numbers } from '../../model/frame_view';
import type { MeshTopology } from './mesh_topology';

/** Above the ground [m]. */
const kHeight = 0.014;
const kFillAlpha = 0.09;
/** Lines of meshes whose places draw a word or a picture are so much fainter. */
const kDrawn = 0.35;
/** Where a metre is this small, lines inside are not seen; where it is twice as large, fully [CSS px]. */
const kDense = 6;

export interface ShownMesh {
  readonly topology: MeshTopology;
  readonly vertices: Numbers;
  readonly colour: string;
}

export class MeshLayer {
  readonly group = new Group();
  private readonly inside_ = new FatLines({ width: 1, renderOrder: 4 });
  private readonly insideBehind_ = new FatLines({ width: 1, renderOrder: 4, behind: true, as: this.inside_ });
  private readonly rim_ = new FatLines({ width: 2, renderOrder: 4 });
  private readonly rimBehind_ = new FatLines({ width: 2, renderOrder: 4, behind: true, as: this.rim_ });
  private readonly fill_ = new Mesh(new BufferGeometry(), fillMaterial());
  private built_: readonly ShownMesh[] = [];
  private positions_ = new Float32Array(0);
  private fade_ = 1;

  constructor() {
    this.fill_.frustumCulled = false;
    this.fill_.renderOrder = 3;
    this.group.add(this.fill_);
    for (const lines of this.lines()) this.group.add(lines.mesh);
  }

  /** Lines inside fade away where they would lie so close that they are noise; by the size of a metre [CSS px]. */
  setScale(pixelsPerMetre: number): void {
    this.fade_ = Math.min(1, Math.max(0, (pixelsPerMetre - kDense) / kDense));
    this.showInside();
  }

  /** Lines inside are seen. */
  get insideSeen(): boolean {
    return this.fade_ > 0;
  }

  private showInside(): void {
    for (const lines of [this.inside_, this.insideBehind_]) {
      lines.fade = this.fade_;
      lines.mesh.visible = this.insideSeen && lines.count > 0;
    }
  }

  setSize(width: number, height: number, ratio: number): void {
    for (const lines of this.lines()) lines.setSize(width, height, ratio);
  }

  /** Shows these meshes as their vertices lie now. */
  update(meshes: readonly ShownMesh[]): void {
    const fresh = !this.sameAsBuilt(meshes);
    if (fresh) this.rebuild(meshes);
    let inside = 0;
    let rim = 0;
    let vertex = 0;
    for (const { topology, vertices } of meshes) {
      if (this.insideSeen) inside = moveLines(this.inside_, inside, topology.inside, vertices);
      rim = moveLines(this.rim_, rim, topology.rim, vertices);
      for (let i = 0; i + 1 < vertices.length; i += 2) {
        this.positions_[vertex++] = vertices[i] ?? 0;
        this.positions_[vertex++] = vertices[i + 1] ?? 0;
        this.positions_[vertex++] = kHeight;
      }
    }
    for (const lines of this.lines()) lines.flush(fresh);
    this.showInside();
    const position = this.fill_.geometry.attributes['position'];
    if (position) position.needsUpdate = true;
  }

  dispose(): void {
    for (const lines of this.lines()) lines.dispose();
    this.fill_.geometry.dispose();
    this.fill_.material.dispose();
  }

  private lines(): FatLines[] {
    return [this.inside_, this.insideBehind_, this.rim_, this.rimBehind_];
  }

  /** True where only vertices have moved: groups may share a version and a count of triangles. */
  private sameAsBuilt(meshes: readonly ShownMesh[]): boolean {
    return (
      meshes.length === this.built_.length &&
      meshes.every((mesh, i) => {
        const built = this.built_[i];
        return (
          mesh.topology === built?.topology &&
          mesh.colour === built.colour &&
          mesh.vertices.length === built.vertices.length
        );
      })
    );
  }

  private rebuild(meshes: readonly ShownMesh[]): void {
    this.built_ = meshes;
    const sum = (size: (mesh: ShownMesh) => number): number => meshes.reduce((total, mesh) => total + size(mesh), 0);
    const insideCount = sum((mesh) => mesh.topology.inside.length / 2);
    const rimCount = sum((mesh) => mesh.topology.rim.length / 2);
    for (const lines of [this.inside_, this.insideBehind_]) lines.reserve(insideCount);
    for (const lines of [this.rim_, this.rimBehind_]) lines.reserve(rimCount);
    let inside = 0;
    let rim = 0;
    for (const { topology, colour } of meshes) {
      const strength = topology.drawn ? kDrawn : 1;
      for (let i = 0; i < topology.inside.length; i += 2, ++inside) {
        this.inside_.setTint(inside, colour, 0.34 * strength);
        this.insideBehind_.setTint(inside, colour, 0.14 * strength);
      }
      for (let i = 0; i < topology.rim.length; i += 2, ++rim) {
        this.rim_.setTint(rim, colour, 0.85 * strength);
        this.rimBehind_.setTint(rim, colour, 0.28 * strength);
      }
    }
    this.rebuildFill(meshes);
  }

  private rebuildFill(meshes: readonly ShownMesh[]): void {
    const vertexCount = meshes.reduce((total, mesh) => total + mesh.vertices.length / 2, 0);
    this.positions_ = new Float32Array(3 * vertexCount);
    const colours = new Float32Array(3 * vertexCount);
    const indices: number[] = [];
    let first = 0;
    for (const { topology, vertices, colour } of meshes) {
      const rgb = new Color().setStyle(colour, LinearSRGBColorSpace);
      for (let i = 0; i < vertices.length / 2; ++i) colours.set([rgb.r, rgb.g, rgb.b], 3 * (first + i));
      for (const index of topology.triangles) indices.push(first + index);
      first += vertices.length / 2;
    }
    this.fill_.geometry.dispose();
    const geometry = new BufferGeometry();
    const position = new BufferAttribute(this.positions_, 3);
    position.setUsage(DynamicDrawUsage);
    geometry.setAttribute('position', position);
    geometry.setAttribute('color', new BufferAttribute(colours, 3));
    geometry.setIndex(indices);
    this.fill_.geometry = geometry;
    this.fill_.visible = indices.length > 0;
  }
}

function moveLines(lines: FatLines, first: number, pairs: Uint32Array, vertices: Numbers): number {
  let index = first;
  for (let i = 0; i < pairs.length; i += 2, ++index) {
    const a = 2 * (pairs[i] ?? 0);
    const b = 2 * (pairs[i + 1] ?? 0);
    lines.setLine(
      index,
      vertices[a] ?? 0,
      vertices[a + 1] ?? 0,
      kHeight,
      vertices[b] ?? 0,
      vertices[b + 1] ?? 0,
      kHeight,
    );
  }
  return index;
}

function fillMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    vertexColors: true,
    side: 2,
    polygonOffset: true,
    polygonOffsetFactor: -2,
    polygonOffsetUnits: -4,
    vertexShader: `
varying vec3 vColour;
void main() { vColour = color; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,
    fragmentShader: `
varying vec3 vColour;
void main() {
  gl_FragColor = vec4(vColour, ${kFillAlpha.toFixed(2)});
}`,
  });
}
