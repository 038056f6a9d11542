// Modal dialogs as components: one is open while it is drawn.

import { Component, type ComponentChildren, type VNode } from 'preact';
import { Icon } from './buttons';

export interface ModalProps {
  readonly title: string;
  readonly class: string;
  /** What its button says that closes it; empty for none. */
  readonly closes?: string;
  /** It closes, however that came. */
  readonly close: () => void;
  readonly children: ComponentChildren;
}

export class Modal extends Component<ModalProps> {
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

  override render({ title, class: name, closes = 'Close', children }: ModalProps): VNode {
    const id = `${name.split(' ').pop()}-title`;
    return (
      <dialog
        class={name}
        aria-labelledby={id}
        ref={(made) => void (made && (this.root_ = made))}
        onClose={this.closed}
        onCancel={this.cancelled}
        onClick={({ target }) => target === this.root_ && this.closed()}
      >
        <header>
          <h2 id={id}>{title}</h2>
          {closes && (
            <button type="button" aria-label={closes} onClick={this.closed}>
              <Icon name="close" />
            </button>
          )}
        </header>
        {children}
      </dialog>
    );
  }
}

export interface DialogProps extends Pick<ModalProps, 'title' | 'close' | 'children'> {
  /** The form is sent; it closes then, unless this says false. */
  readonly submit: () => boolean;
}

/** A dialog with a form in it. */
export function Dialog({ title, close, submit, children }: DialogProps): VNode {
  return (
    <Modal title={title} class="help shape-dialog" close={close}>
      <form
        method="dialog"
        class="shape-form"
        onSubmit={(event) => {
          event.preventDefault();
          if (submit()) close();
        }}
      >
        {children}
      </form>
    </Modal>
  );
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
