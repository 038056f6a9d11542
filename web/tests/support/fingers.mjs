// Real fingers through the browser's own input pipeline.

const wait = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

export class Fingers {
  constructor(cdp) {
    this.cdp = cdp;
    this.at = new Map();
  }

  async send(type, ids) {
    const touchPoints = ids.map((id) => ({ id, ...this.at.get(id), radiusX: 8, radiusY: 8, force: 1 }));
    await this.cdp.send('Input.dispatchTouchEvent', { type, touchPoints });
  }

  /** `points`: {id: {x, y}} in CSS px; all come down at once. */
  async down(points) {
    const ids = Object.keys(points).map(Number);
    for (const id of ids) this.at.set(id, points[id]);
    await this.send('touchStart', ids);
  }

  /** Moves fingers to `targets` in `steps` over `ms`. */
  async move(targets, { steps = 12, ms = 240 } = {}) {
    const ids = Object.keys(targets).map(Number);
    const from = new Map(ids.map((id) => [id, this.at.get(id)]));
    for (let i = 1; i <= steps; ++i) {
      for (const id of ids) {
        const a = from.get(id);
        const b = targets[id];
        this.at.set(id, { x: a.x + ((b.x - a.x) * i) / steps, y: a.y + ((b.y - a.y) * i) / steps });
      }
      await this.send('touchMove', ids);
      await wait(ms / steps);
    }
  }

  async up(ids = [...this.at.keys()]) {
    for (const id of ids) {
      await this.send('touchEnd', [id]);
      this.at.delete(id);
    }
  }
}
