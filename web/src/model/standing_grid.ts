// A cell list of the characters, for queries about small spots in large crowds.

/** Edge of a cell [m]; wider where the crowd would take too many. */
const kCell = 2;
const kMostAcross = 512;

export class StandingGrid {
  private cell_ = kCell;
  private left_ = 0;
  private bottom_ = 0;
  private across_ = 0;
  private up_ = 0;
  /** Where each cell's people begin in `sorted_`, one more than there are cells. */
  private starts_ = new Uint32Array(1);
  private sorted_ = new Float32Array(0);

  /** Takes x, y of `count` people, the first two of every `stride` numbers. */
  fill(places: Float32Array, stride: number, count: number): void {
    this.bound(places, stride, count);
    const cells = this.across_ * this.up_;
    if (this.starts_.length < cells + 1) this.starts_ = new Uint32Array(cells + 1);
    if (this.sorted_.length < 2 * count) this.sorted_ = new Float32Array(2 * count);
    const starts = this.starts_.fill(0, 0, cells + 1);
    for (let i = 0; i < count; ++i) starts[this.cellOf(places[stride * i]!, places[stride * i + 1]!)]! += 1;
    let sum = 0;
    for (let c = 0; c <= cells; ++c) starts[c] = sum += c < cells ? starts[c]! : 0;
    // Each cell is filled from its end, which leaves its start.
    for (let i = 0; i < count; ++i) {
      const x = places[stride * i]!,
        y = places[stride * i + 1]!;
      const at = --starts[this.cellOf(x, y)]!;
      this.sorted_[2 * at] = x;
      this.sorted_[2 * at + 1] = y;
    }
  }

  someoneNear(x: number, y: number, reach: number): boolean {
    const [low, high] = [this.column(x - reach), this.column(x + reach)];
    for (let row = this.row(y - reach); row <= this.row(y + reach); ++row) {
      const last = this.starts_[row * this.across_ + high + 1]!;
      for (let i = this.starts_[row * this.across_ + low]!; i < last; ++i) {
        const dx = this.sorted_[2 * i]! - x,
          dy = this.sorted_[2 * i + 1]! - y;
        if (dx * dx + dy * dy < reach * reach) return true;
      }
    }
    return false;
  }

  private bound(places: Float32Array, stride: number, count: number): void {
    let left = Infinity,
      bottom = Infinity,
      right = -Infinity,
      top = -Infinity;
    for (let i = 0; i < count; ++i) {
      const x = places[stride * i]!,
        y = places[stride * i + 1]!;
      left = Math.min(left, x);
      right = Math.max(right, x);
      bottom = Math.min(bottom, y);
      top = Math.max(top, y);
    }
    if (count === 0) [left, right, bottom, top] = [0, 0, 0, 0];
    this.cell_ = Math.max(kCell, (right - left) / (kMostAcross - 1), (top - bottom) / (kMostAcross - 1));
    [this.left_, this.bottom_] = [left, bottom];
    this.across_ = Math.floor((right - left) / this.cell_) + 1;
    this.up_ = Math.floor((top - bottom) / this.cell_) + 1;
  }

  private column(x: number): number {
    return Math.min(this.across_ - 1, Math.max(0, Math.floor((x - this.left_) / this.cell_)));
  }

  private row(y: number): number {
    return Math.min(this.up_ - 1, Math.max(0, Math.floor((y - this.bottom_) / this.cell_)));
  }

  private cellOf(x: number, y: number): number {
    return this.row(y) * this.across_ + this.column(x);
  }
}
