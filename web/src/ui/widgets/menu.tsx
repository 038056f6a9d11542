// A button and what it opens above everything else.

import { Component, type ComponentChildren, type VNode } from 'preact';
import type { Placement } from '@floating-ui/dom';
import { Icon, ToolButton, type ToolButtonProps } from './buttons';
import type { IconName } from './icons';
import { Popover } from './popover';

export interface MenuProps {
  readonly opener: Omit<ToolButtonProps, 'button' | 'act'>;
  /** Of what it opens. */
  readonly class: string;
  readonly label: string;
  readonly placement?: Placement;
  /** It stands beside the whole panel of its button. */
  readonly besidePanel?: boolean;
  /** `close` closes it, as a choice does. */
  readonly children: (close: () => void) => ComponentChildren;
}

export class Menu extends Component<MenuProps> {
  private button_: HTMLButtonElement | null = null;
  private panel_: HTMLElement | null = null;
  private popover_: Popover | null = null;

  override componentDidMount(): void {
    const button = this.button_!;
    const beside = (): Element => (this.props.besidePanel && button.closest('.panel')) || button;
    this.popover_ = new Popover(button, this.panel_!, this.props.placement, beside);
  }

  private readonly close = (): void => this.popover_?.close(true);

  override render({ opener, class: name, label, children }: MenuProps): VNode {
    return (
      <>
        <ToolButton {...opener} button={(made) => (this.button_ = made)} />
        <div class={`${name} panel`} role="group" aria-label={label} ref={(made) => void (this.panel_ = made)}>
          {children(this.close)}
        </div>
      </>
    );
  }
}

export interface MenuItemProps {
  readonly icon: IconName;
  readonly label: string;
  readonly hidden?: boolean;
  readonly class?: string;
  readonly close: () => void;
  readonly act: () => void;
}

/** A choice, which closes its menu. */
export function MenuItem({ icon, label, hidden = false, class: name = 'menu-item', close, act }: MenuItemProps): VNode {
  const chosen = (): void => {
    close();
    act();
  };
  return (
    <button type="button" class={name} hidden={hidden} onClick={chosen}>
      <Icon name={icon} />
      {label}
    </button>
  );
}
