// The small picture of a recorded take: of its world, even where it has gone by the end.

import type { StudioFrame } from '../../model/studio_frame';
import type { StudioStore } from '../../model/studio_store';
import { keptPicture } from '../../scene/scene_picture';
import type { StudioScene } from '../../scene/studio_scene';

/** While recording the scene is pictured so often, in case another scenario ends the recording [ms]. */
const kEvery = 3000;

export interface PictureParts {
  readonly store: StudioStore;
  readonly view: StudioScene;
  readonly canvas: HTMLCanvasElement;
}

export class RecordingPicture {
  private last_: { readonly scenario: string; readonly blob: Blob } | null = null;
  crowd: Pick<StudioFrame, 'x' | 'y'> | null = null;

  constructor(private readonly parts_: PictureParts) {
    window.setInterval(() => void this.whileRecording(), kEvery);
  }

  async of(scenario: string): Promise<Blob | null> {
    const last = this.last_;
    this.last_ = null;
    if (scenario !== this.parts_.store.state.title) return last?.scenario === scenario ? last.blob : null;
    return (await this.taken()) ?? last?.blob ?? null;
  }

  private taken(): Promise<Blob | null> {
    const { view, canvas } = this.parts_;
    return keptPicture(view, canvas, this.crowd);
  }

  private async whileRecording(): Promise<void> {
    const { recorded, title } = this.parts_.store.state;
    if (recorded < 0 || document.hidden) return;
    const blob = await this.taken();
    if (blob) this.last_ = { scenario: title, blob };
  }
}
