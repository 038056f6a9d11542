// Which of the layouts suits the window.

export type Layout = 'desktop' | 'landscape' | 'portrait' | 'phone' | 'short';

/** By the window's size [CSS px]; 200 % zoom halves it. */
export function chooseLayout(width: number, height: number): Layout {
  if (width < 600 && height >= 480) return 'phone';
  if (height < 560) return 'short';
  if (width >= 1200) return 'desktop';
  return width >= height && width >= 900 ? 'landscape' : 'portrait';
}
