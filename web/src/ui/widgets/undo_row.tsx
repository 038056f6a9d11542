// What was removed can be brought back: the button has the focus as soon as it is there.

import { Component, type VNode } from 'preact';
import { Icon } from './buttons';

export interface UndoRowProps {
  readonly title: string;
  readonly back: () => void;
}

export class UndoRow extends Component<UndoRowProps> {
  private button_: HTMLElement | null = null;

  override componentDidMount(): void {
    this.button_?.focus();
  }

  override render({ title, back }: UndoRowProps): VNode {
    return (
      <div class="shelf-undo">
        <span>“{title}” is removed.</span>
        <button type="button" class="soft" ref={(made) => void (this.button_ = made)} onClick={back}>
          <Icon name="undo" />
          Bring it back
        </button>
      </div>
    );
  }
}
