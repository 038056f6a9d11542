// What a banner says, with its sign before it and its buttons after it.

import type { ComponentChildren, VNode } from 'preact';
import { Icon } from './buttons';
import type { IconName } from './icons';

export interface BannerProps {
  readonly icon: IconName;
  readonly title: string;
  readonly text?: string;
  readonly children?: ComponentChildren;
}

export function Banner({ icon, title, text, children }: BannerProps): VNode {
  return (
    <>
      <Icon name={icon} size={24} />
      <div class="banner-words">
        <strong>{title}</strong>
        {text && <span class="secondary">{text}</span>}
      </div>
      {children}
    </>
  );
}
