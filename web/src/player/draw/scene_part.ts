// Ground, obstacles and patches on the graphics card.

import type { SceneMesh } from '../file/mesh_maker';
import type { Scene } from '../file/scene_reader';
import { addAttribute, type Gl, type Program } from './gl';
import { isSeeThrough } from './player_palette';

const kGround = 0;
const kStill = Float32Array.of(0, 0, 1, 0);

/** Corners of one mesh: first the ground, then what is solid, then what is seen through. */
interface Range {
  readonly vertices: WebGLVertexArrayObject;
  readonly ground: number;
  readonly solid: number;
  readonly all: number;
}

export class ScenePart {
  private readonly still_: Range;
  private readonly moving_: readonly Range[];

  constructor(
    private readonly gl_: Gl,
    scene: Scene,
  ) {
    this.still_ = this.range(scene.still);
    this.moving_ = scene.moving.map((mesh) => this.range(mesh));
  }

  /** `things`: x, y, angle of each moving thing. */
  drawSolid(program: Program, things: Float32Array): void {
    this.draw(program, things, (range) => [0, range.solid]);
  }

  drawSeeThrough(program: Program, things: Float32Array): void {
    this.draw(program, things, (range) => [range.solid, range.all]);
  }

  /** What throws shadows. */
  drawShadows(program: Program, things: Float32Array): void {
    this.draw(program, things, (range) => [range.ground, range.solid]);
  }

  private draw(program: Program, things: Float32Array, part: (range: Range) => readonly [number, number]): void {
    const gl = this.gl_;
    const place = program.at('uPlace');
    const one = (range: Range): void => {
      const [from, to] = part(range);
      if (to <= from) return;
      gl.bindVertexArray(range.vertices);
      gl.drawArrays(gl.TRIANGLES, from, to - from);
    };
    gl.uniform4fv(place, kStill);
    one(this.still_);
    this.moving_.forEach((range, k) => {
      const angle = things[3 * k + 2] ?? 0;
      gl.uniform4f(place, things[3 * k] ?? 0, things[3 * k + 1] ?? 0, Math.cos(angle), Math.sin(angle));
      one(range);
    });
    gl.bindVertexArray(null);
  }

  private range(mesh: SceneMesh): Range {
    const gl = this.gl_;
    const order = sorted(mesh.finishes);
    const vertices = gl.createVertexArray();
    gl.bindVertexArray(vertices);
    addAttribute(gl, { index: 0, size: 3, data: picked(mesh.positions, order.corners) });
    addAttribute(gl, { index: 1, size: 3, data: picked(mesh.normals, order.corners) });
    addAttribute(gl, { index: 2, size: 1, data: Uint8Array.from(order.corners, (k) => mesh.finishes[k]!) });
    gl.bindVertexArray(null);
    return { vertices, ground: order.ground, solid: order.solid, all: mesh.finishes.length };
  }
}

function sorted(finishes: Uint8Array): { corners: number[]; ground: number; solid: number } {
  const corners = [...finishes.keys()];
  const of = (test: (finish: number) => boolean): number[] => corners.filter((k) => test(finishes[k]!));
  const ground = of((finish) => finish === kGround);
  const solid = of((finish) => finish !== kGround && !isSeeThrough(finish));
  return {
    corners: [...ground, ...solid, ...of(isSeeThrough)],
    ground: ground.length,
    solid: ground.length + solid.length,
  };
}

function picked(values: Float32Array, corners: readonly number[]): Float32Array {
  const out = new Float32Array(3 * corners.length);
  corners.forEach((from, to) => out.set(values.subarray(3 * from, 3 * from + 3), 3 * to));
  return out;
}
