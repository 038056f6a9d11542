// Characters drawn at once: for each its number in the crowd and the row of a whole pose, or -1, in one number.

import { DynamicDrawUsage, InstancedBufferAttribute, type InstancedBufferGeometry } from 'three';
import { forgetInstances } from './instances';

/** Bits of the number in the crowd; above them is the row, from 1 on. */
export const kWhoBits = 20;

export class InstanceList {
  count = 0;
  private data_ = new Uint32Array(0);
  private attribute_: InstancedBufferAttribute | null = null;

  /** `geometries` are all drawn with these. */
  constructor(private readonly geometries_: readonly InstancedBufferGeometry[]) {}

  /** Empties the list and grows it to hold `most` entries. */
  begin(most: number): void {
    this.count = 0;
    if (most <= this.data_.length) return;
    this.data_ = new Uint32Array(Math.ceil(1.3 * most));
    this.attribute_ = new InstancedBufferAttribute(this.data_, 1);
    this.attribute_.setUsage(DynamicDrawUsage);
    for (const geometry of this.geometries_) {
      forgetInstances(geometry);
      geometry.setAttribute('aWho', this.attribute_);
    }
  }

  add(who: number, slot: number): void {
    this.data_[this.count++] = who | ((slot + 1) << kWhoBits);
  }

  /** Sends what was written. */
  end(): void {
    for (const geometry of this.geometries_) geometry.instanceCount = this.count;
    if (!this.attribute_ || this.count === 0) return;
    this.attribute_.clearUpdateRanges();
    this.attribute_.addUpdateRange(0, this.count);
    this.attribute_.needsUpdate = true;
  }
}
