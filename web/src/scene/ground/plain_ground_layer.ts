// The ground as software renderers draw it: one flat colour, and its lines as strokes, so that few pixels cost
// anything.

import { BufferGeometry, Color, Group, LinearSRGBColorSpace, Mesh, PlaneGeometry, ShaderMaterial } from 'three';
import type { SceneBox } from '../../protocol/messages';
import { FatLines } from '../drawing/fat_lines';
import { leaveOutOpenings } from '../drawing/openings';
import type { Palette } from '../drawing/palette';
import { kerbGeometry } from './kerb';

/** Lines a metre apart are left out in worlds with more of them. */
const kFineMost = 600;

/** Multiples of `spacing` strictly between two numbers. */
export function between(low: number, high: number, spacing: number): number[] {
  const found: number[] = [];
  for (let i = Math.floor(low / spacing) + 1; i * spacing < high - 1e-9; ++i) found.push(i * spacing);
  return found;
}

function flatMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: { uColour: { value: new Color() } },
    vertexShader: 'void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
    fragmentShader: 'uniform vec3 uColour;\nvoid main() { gl_FragColor = vec4(uColour, 1.0); }',
  });
}

export class PlainGroundLayer {
  readonly group = new Group();
  private readonly floor_: Mesh<PlaneGeometry, ShaderMaterial>;
  private readonly fine_ = new FatLines({ width: 1, renderOrder: -3 });
  private readonly coarse_ = new FatLines({ width: 1.25, renderOrder: -2 });
  private readonly edge_ = new FatLines({ width: 2.4, renderOrder: -1 });
  private readonly kerb_ = new Mesh(new BufferGeometry(), flatMaterial());
  private box_: SceneBox = { min: [-1, -1], max: [1, 1] };
  private palette_: Palette | null = null;

  constructor() {
    this.floor_ = new Mesh(new PlaneGeometry(1, 1), leaveOutOpenings(flatMaterial()));
    for (const lines of [this.fine_, this.coarse_]) leaveOutOpenings(lines.mesh.material);
    this.group.add(this.floor_, ...this.lines().map((lines) => lines.mesh), this.kerb_);
  }

  setBox(box: SceneBox): void {
    this.box_ = box;
    this.floor_.position.set((box.min[0] + box.max[0]) / 2, (box.min[1] + box.max[1]) / 2, 0);
    this.floor_.scale.set(box.max[0] - box.min[0], box.max[1] - box.min[1], 1);
    this.kerb_.geometry.dispose();
    this.kerb_.geometry = kerbGeometry(box);
    this.rule();
  }

  setPalette(palette: Palette): void {
    this.palette_ = palette;
    // Written as they are: the shader converts nothing.
    (this.floor_.material.uniforms['uColour']?.value as Color).setStyle(palette.ground, LinearSRGBColorSpace);
    (this.kerb_.material.uniforms['uColour']?.value as Color).setStyle(palette.kerb, LinearSRGBColorSpace);
    this.rule();
  }

  setSize(width: number, height: number, ratio: number): void {
    for (const lines of this.lines()) lines.setSize(width, height, ratio);
  }

  /** Lines fade where they would crowd. */
  setScale(pixelsPerMetre: number): void {
    this.fine_.fade = Math.min(1, Math.max(0, (pixelsPerMetre - 7) / 10));
    this.fine_.mesh.visible = this.fine_.count > 0 && pixelsPerMetre > 7;
    this.coarse_.fade = Math.min(1, Math.max(0, (pixelsPerMetre - 1.4) / 2));
  }

  dispose(): void {
    for (const lines of this.lines()) lines.dispose();
    for (const { geometry, material } of [this.floor_, this.kerb_]) {
      geometry.dispose();
      material.dispose();
    }
  }

  private lines(): FatLines[] {
    return [this.fine_, this.coarse_, this.edge_];
  }

  private rule(): void {
    const palette = this.palette_;
    if (!palette) return;
    const [x0, y0] = this.box_.min;
    const [x1, y1] = this.box_.max;
    const few = x1 - x0 + y1 - y0 < kFineMost;
    const metres = (low: number, high: number): number[] => between(low, high, 1).filter((at) => at % 5 !== 0);
    draw(this.fine_, this.box_, few ? metres(x0, x1) : [], few ? metres(y0, y1) : [], palette.lineFine, 1);
    draw(this.coarse_, this.box_, between(x0, x1, 5), between(y0, y1, 5), palette.lineCoarse, 1);
    draw(this.edge_, this.box_, [x0, x1], [y0, y1], palette.edge, 0.9);
  }
}

/** Lines across the box at these x and y. */
function draw(
  lines: FatLines,
  box: SceneBox,
  xs: readonly number[],
  ys: readonly number[],
  hex: string,
  alpha: number,
): void {
  lines.reserve(xs.length + ys.length);
  let index = 0;
  for (const x of xs) lines.setLine(index++, x, box.min[1], 0, x, box.max[1], 0);
  for (const y of ys) lines.setLine(index++, box.min[0], y, 0, box.max[0], y, 0);
  for (let i = 0; i < index; ++i) lines.setTint(i, hex, alpha);
  lines.flush(true);
}
