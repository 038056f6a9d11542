// Characters drawn at once: sixteen numbers each, as the shader of people reads them.

import { DynamicDrawUsage, InstancedInterleavedBuffer, InterleavedBufferAttribute, type InstancedBufferGeometry } from 'three';
import { forgetInstances } from './instances';

/** Numbers of one character: aPlace, aNow, aBefore, aLook. */
export const kInstanceFloats = 16;
const kNames = ['aPlace', 'aNow', 'aBefore', 'aLook'] as const;

export class InstanceList {
  data = new Float32Array(0);
  count = 0;
  private buffer_: InstancedInterleavedBuffer | null = null;
  private capacity_ = 0;

  /** `geometries` are all drawn with these. */
  constructor(private readonly geometries_: readonly InstancedBufferGeometry[]) {}

  /** Empties the list and makes room. */
  begin(most: number): void {
    this.count = 0;
    if (most <= this.capacity_) return;
    this.capacity_ = Math.ceil(1.3 * most);
    this.data = new Float32Array(kInstanceFloats * this.capacity_);
    this.buffer_ = new InstancedInterleavedBuffer(this.data, kInstanceFloats, 1);
    this.buffer_.setUsage(DynamicDrawUsage);
    for (const geometry of this.geometries_) {
      forgetInstances(geometry);
      kNames.forEach((name, i) => geometry.setAttribute(name, new InterleavedBufferAttribute(this.buffer_!, 4, 4 * i)));
    }
  }

  /** Where the next one's numbers go in `data`. */
  next(): number {
    return kInstanceFloats * this.count++;
  }

  /** Sends what was written. */
  end(): void {
    for (const geometry of this.geometries_) geometry.instanceCount = this.count;
    if (!this.buffer_ || this.count === 0) return;
    this.buffer_.clearUpdateRanges();
    this.buffer_.addUpdateRange(0, kInstanceFloats * this.count);
    this.buffer_.needsUpdate = true;
  }
}
