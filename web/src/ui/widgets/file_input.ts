// Lets the visitor choose files; it is unseen, and pressed by a button that stands elsewhere.

import { element } from './dom';

export interface FileInput {
  readonly label: string;
  readonly accept: string;
  readonly multiple?: boolean;
  readonly chosen: (files: readonly File[]) => void;
}

export function fileInput({ label, accept, multiple, chosen }: FileInput): HTMLInputElement {
  const input = element('input', { type: 'file', accept, multiple, hidden: true, 'aria-label': label, tabindex: -1 });
  input.addEventListener('change', () => {
    const files = [...(input.files ?? [])];
    // The same file may be chosen again.
    input.value = '';
    if (files.length > 0) chosen(files);
  });
  return input;
}
