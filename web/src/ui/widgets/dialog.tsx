// A modal dialog with a form in it, as a component: it is open while it is drawn.

import { Component, type ComponentChildren, type VNode } from 'preact';
import { Icon } from './buttons';

export interface DialogProps {
  readonly title: string;
  /** It closes, however that came. */
  readonly close: () => void;
  /** The form is sent; it closes then, unless this says false. */
  readonly submit: () => boolean;
  readonly children: ComponentChildren;
}

export class Dialog extends Component<DialogProps> {
  private root_: HTMLDialogElement | null = null;

  override componentDidMount(): void {
    this.root_?.showModal();
  }

  /** Closed by hand, so that the focus goes back to where it was. */
  override componentWillUnmount(): void {
    const root = this.root_;
    this.root_ = null;
    root?.close();
  }

  private readonly closed = (): void => {
    if (this.root_) this.props.close();
  };

  /** The browser tells the end of a dialog later, when it may have been opened once more: so Escape ends it here. */
  private readonly cancelled = (event: Event): void => {
    event.preventDefault();
    this.closed();
  };

  override render({ title, submit, children }: DialogProps): VNode {
    const id = `dialog-${title.toLowerCase().replace(/\W+/g, '-')}`;
    return (
      <dialog
        class="help shape-dialog"
        aria-labelledby={id}
        ref={(made) => void (made && (this.root_ = made))}
        onClose={this.closed}
        onCancel={this.cancelled}
        onClick={({ target }) => target === this.root_ && this.closed()}
      >
        <header>
          <h2 id={id}>{title}</h2>
          <button type="button" aria-label="Close" onClick={this.closed}>
            <Icon name="close" />
          </button>
        </header>
        <form
          method="dialog"
          class="shape-form"
          onSubmit={(event) => {
            event.preventDefault();
            if (submit()) this.closed();
          }}
        >
          {children}
        </form>
      </dialog>
    );
  }
}

/** An input with its label. */
export function Field({ label, children }: { readonly label: string; readonly children: ComponentChildren }): VNode {
  return (
    <label class="shape-field">
      <span>{label}</span>
      {children}
    </label>
  );
}
