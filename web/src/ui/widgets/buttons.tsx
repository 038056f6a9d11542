// Icons and buttons of panels.

import type { ComponentChildren, ComponentProps, VNode } from 'preact';
import { iconBody, kLogoBody, type IconName } from './icons';

export function Icon({ name, size = 20 }: { readonly name: IconName; readonly size?: number }): VNode {
  return (
    <svg
      width={size}
      height={size}
      viewBox="0 0 20 20"
      aria-hidden="true"
      fill="none"
      stroke="currentColor"
      stroke-width="1.6"
      stroke-linecap="round"
      stroke-linejoin="round"
      dangerouslySetInnerHTML={{ __html: iconBody(name) }}
    />
  );
}

export function Logo(): VNode {
  return (
    <svg
      class="logo"
      width="30"
      height="30"
      viewBox="0 0 30 30"
      aria-hidden="true"
      fill="currentColor"
      dangerouslySetInnerHTML={{ __html: kLogoBody }}
    />
  );
}

export interface ToolButtonProps {
  readonly icon?: IconName;
  readonly iconSize?: number;
  /** Its name; also written out unless `iconOnly`. */
  readonly label: string;
  readonly iconOnly?: boolean;
  /** What is written out, where that is not its name. */
  readonly word?: string;
  readonly wordClass?: string;
  /** A sentence for the tooltip; the label where absent. */
  readonly tip?: string;
  /** As the help shows it. */
  readonly shortcut?: string | undefined;
  readonly class?: string;
  readonly pressed?: boolean | undefined;
  readonly disabled?: boolean;
  /** It says that it does nothing at present, and can have the focus. */
  readonly idle?: boolean;
  readonly hidden?: boolean;
  readonly inert?: boolean;
  readonly data?: Readonly<Record<`data-${string}`, string>>;
  readonly button?: (made: HTMLButtonElement | null) => void;
  readonly act?: (event: MouseEvent) => void;
  readonly before?: ComponentChildren;
  readonly children?: ComponentChildren;
}

/** A button with icon, label, tooltip and key. Layouts may hide the label, which still names it. */
export function ToolButton(props: ToolButtonProps): VNode {
  const { icon, iconSize = 20, label, iconOnly = false, word = label, shortcut } = props;
  return (
    <button
      type="button"
      ref={props.button ?? null}
      class={props.class}
      hidden={props.hidden}
      inert={props.inert}
      disabled={props.disabled}
      aria-label={label}
      aria-pressed={props.pressed}
      aria-disabled={props.idle}
      aria-keyshortcuts={shortcut || undefined}
      aria-description={props.tip}
      data-tip={props.tip ?? label}
      data-key={shortcut || undefined}
      onClick={props.act}
      {...props.data}
    >
      {props.before}
      {icon && <Icon name={icon} size={iconSize} />}
      <span class={iconOnly ? 'unseen' : (props.wordClass ?? 'label')}>{word}</span>
      {props.children}
    </button>
  );
}

/** The same as a row of a list of tools. */
export function toolButton(
  icon: IconName,
  label: string,
  act: (event: MouseEvent) => void,
  more: Omit<ToolButtonProps, 'icon' | 'label' | 'act'> = {},
): VNode {
  return <ToolButton icon={icon} label={label} act={act} {...more} />;
}

export interface ButtonProps extends Omit<ComponentProps<'button'>, 'icon'> {
  readonly icon?: IconName;
  readonly act?: () => void;
}

/** A button with words; soft where no other class is given. */
export function Button({ icon, act, children, class: name = 'soft', ...more }: ButtonProps): VNode {
  return (
    <button type="button" class={name} onClick={() => act?.()} {...more}>
      {icon && <Icon name={icon} />}
      {children}
    </button>
  );
}
