// One mesh of a body on the graphics card, drawn once for all who have it.

import type { BodyMesh } from '../file/figures_reader';
import { addAttribute, type Gl } from './gl';

/** Numbers per character: place, heading, size; shirt, slot of the pose; skin, hair. */
export const kInstanceFloats = 10;
const kFirstOfInstance = 5;
const kParts = [4, 4, 2] as const;

export class BodyPart {
  count = 0;
  private readonly vertices_: WebGLVertexArrayObject;
  private readonly buffer_: WebGLBuffer;
  private readonly corners_: number;
  private readonly instances_: Float32Array;

  constructor(
    private readonly gl_: Gl,
    mesh: BodyMesh,
    most: number,
  ) {
    this.corners_ = mesh.indices.length;
    this.instances_ = new Float32Array(kInstanceFloats * most);
    this.vertices_ = gl_.createVertexArray();
    gl_.bindVertexArray(this.vertices_);
    addAttribute(gl_, { index: 0, size: 3, data: mesh.positions });
    addAttribute(gl_, { index: 1, size: 3, data: normalsOf(mesh) });
    addAttribute(gl_, { index: 2, size: 4, data: mesh.joints, integer: true });
    addAttribute(gl_, { index: 3, size: 4, data: mesh.weights, shares: true });
    addAttribute(gl_, { index: 4, size: 1, data: mesh.regions });
    gl_.bindBuffer(gl_.ELEMENT_ARRAY_BUFFER, gl_.createBuffer());
    gl_.bufferData(gl_.ELEMENT_ARRAY_BUFFER, mesh.indices, gl_.STATIC_DRAW);
    this.buffer_ = addInstances(gl_, kFirstOfInstance, this.instances_.byteLength);
    gl_.bindVertexArray(null);
  }

  add(instance: Float32Array): void {
    this.instances_.set(instance, kInstanceFloats * this.count++);
  }

  /** Sends those that were added. */
  send(): void {
    if (this.count === 0) return;
    const gl = this.gl_;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer_);
    gl.bufferSubData(gl.ARRAY_BUFFER, 0, this.instances_, 0, kInstanceFloats * this.count);
  }

  draw(): void {
    if (this.count === 0) return;
    const gl = this.gl_;
    gl.bindVertexArray(this.vertices_);
    gl.drawElementsInstanced(gl.TRIANGLES, this.corners_, gl.UNSIGNED_SHORT, 0, this.count);
    gl.bindVertexArray(null);
  }
}

/** Attributes that go on once per instance, from one buffer. */
export function addInstances(gl: Gl, first: number, bytes: number): WebGLBuffer {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, bytes, gl.DYNAMIC_DRAW);
  let offset = 0;
  kParts.forEach((size, k) => {
    gl.enableVertexAttribArray(first + k);
    gl.vertexAttribPointer(first + k, size, gl.FLOAT, false, 4 * kInstanceFloats, 4 * offset);
    gl.vertexAttribDivisor(first + k, 1);
    offset += size;
  });
  return buffer;
}

/** Normals, smooth where triangles share corners; larger triangles count more. */
export function normalsOf({ positions, indices }: BodyMesh): Float32Array {
  const normals = new Float32Array(positions.length);
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const [a, b, c] = [3 * indices[t]!, 3 * indices[t + 1]!, 3 * indices[t + 2]!];
    const side = (to: number, k: number): number => positions[to + k]! - positions[a + k]!;
    for (let k = 0; k < 3; ++k) {
      const [m, n] = [(k + 1) % 3, (k + 2) % 3];
      const across = side(b, m) * side(c, n) - side(b, n) * side(c, m);
      for (const corner of [a, b, c]) normals[corner + k]! += across;
    }
  }
  for (let v = 0; v < normals.length; v += 3) {
    const length = Math.hypot(normals[v]!, normals[v + 1]!, normals[v + 2]!);
    for (let k = 0; k < 3; ++k) normals[v + k] = length > 0 ? normals[v + k]! / length : k === 2 ? 1 : 0;
  }
  return normals;
}
