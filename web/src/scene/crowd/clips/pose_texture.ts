// Poses on the graphics card: two texels per joint (its turn, where it is), many poses side by side in each row.

import { DataTexture, FloatType, NearestFilter, RGBAFormat } from 'three';
import { kPoseFloats } from '../bodies/rig';

/** Poses side by side; the shader has the same number. */
export const kPosesAcross = 24;
const kWidth = (kPosesAcross * kPoseFloats) / 4;

export class PoseTexture {
  /** kPoseFloats per pose; write here, then `send()`. */
  data: Float32Array;
  texture: DataTexture;

  constructor(poses: number) {
    [this.data, this.texture] = made(poses);
  }

  /** Grows to hold so many poses. Growing loses what was written. */
  reserve(poses: number): void {
    if (poses * kPoseFloats <= this.data.length) return;
    this.texture.dispose();
    [this.data, this.texture] = made(Math.ceil(1.5 * poses));
  }

  send(): void {
    this.texture.needsUpdate = true;
  }

  dispose(): void {
    this.texture.dispose();
  }
}

function made(poses: number): [Float32Array, DataTexture] {
  const rows = Math.max(1, Math.ceil(poses / kPosesAcross));
  const data = new Float32Array(rows * kWidth * 4);
  const texture = new DataTexture(data, kWidth, rows, RGBAFormat, FloatType);
  texture.minFilter = NearestFilter;
  texture.magFilter = NearestFilter;
  return [data, texture];
}
