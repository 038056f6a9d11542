// Notices controls that begin or change their kind.

import { ControlKind } from '../protocol/messages';
import type { StudioFrame } from './studio_frame';
import type { HintStep } from './studio_state';

export interface ControlNews {
  /** Index into the frame's groups. */
  readonly index: number;
  readonly control: number;
  readonly client: number;
  readonly kind: ControlKind;
}

export const kKindNames: Record<ControlKind, string> = {
  [ControlKind.Point]: 'Point',
  [ControlKind.Line]: 'Line',
  [ControlKind.Area]: 'Area',
};

/** What a visitor has tried by such a control. */
export const kTriedBy: Record<ControlKind, HintStep> = {
  [ControlKind.Point]: 'point',
  [ControlKind.Line]: 'line',
  [ControlKind.Area]: 'area',
};
/** "line"; null without a control. */
export function heldWord(control: { readonly kind: ControlKind } | null | undefined): string | null {
  return control ? kKindNames[control.kind].toLowerCase() : null;
}

export class ControlWatch {
  private known_ = new Map<string, ControlKind>();

  /** Controls that began or changed their kind since the last frame. */
  observe(frame: StudioFrame): ControlNews[] {
    const news: ControlNews[] = [];
    const now = new Map<string, ControlKind>();
    frame.groups.forEach((group, index) => {
      for (const { id, kind, client } of group.controls) {
        const key = `${group.id} ${id}`;
        now.set(key, kind);
        if (this.known_.get(key) !== kind) news.push({ index, control: id, client, kind });
      }
    });
    this.known_ = now;
    return news;
  }
}
