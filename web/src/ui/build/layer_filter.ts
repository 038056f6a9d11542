// Kinds of things that are hidden while somebody builds, or cannot be taken hold of.

import { isNobody } from '../../model/place/areas';
import type { Thing, ThingKind } from '../../model/place/things';
import type { SceneFacts } from '../../protocol/scene';

export class LayerFilter {
  private readonly sets_ = { hidden: new Set<ThingKind>(), locked: new Set<ThingKind>() };

  toggle(kind: ThingKind, what: 'hidden' | 'locked', on: boolean): void {
    if (on) this.sets_[what].add(kind);
    else this.sets_[what].delete(kind);
  }

  get hidesSome(): boolean {
    return this.sets_.hidden.size > 0;
  }

  readonly sees = (one: Thing): boolean => !this.sets_.hidden.has(one.kind) && !isNobody(one);

  readonly takes = (one: Thing): boolean => this.sees(one) && !this.sets_.locked.has(one.kind);

  /** The scene without what is hidden. */
  of(scene: SceneFacts): SceneFacts {
    const { hidden } = this.sets_;
    return {
      ...scene,
      obstacles: hidden.has('obstacle') ? [] : scene.obstacles,
      patches: hidden.has('patch') ? [] : scene.patches,
      areas: hidden.has('area') ? [] : scene.areas,
      items: hidden.has('item') ? [] : scene.items,
      checkpoints: hidden.has('checkpoint') ? [] : scene.checkpoints,
    };
  }
}
