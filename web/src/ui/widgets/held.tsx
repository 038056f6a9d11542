// Something that is no component, inside of one.

import { Component, type VNode } from 'preact';

export interface HeldProps {
  readonly make: () => Node;
}

/** It is made once; give another `key` for another one. */
export class Held extends Component<HeldProps> {
  private holder_: HTMLElement | null = null;

  override componentDidMount(): void {
    this.holder_!.append(this.props.make());
  }

  override shouldComponentUpdate(): boolean {
    return false;
  }

  override render(): VNode {
    return <span class="held" ref={(made) => void (this.holder_ = made)} />;
  }
}
