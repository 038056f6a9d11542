// SVG files of strangers: only shapes and their looks are let in, nothing that runs or is loaded from elsewhere.

const kElements = new Set(
  'svg g path rect circle ellipse line polyline polygon text tspan defs use symbol style title desc'.split(' '),
);
const kAttributes = new Set(
  (
    'id class style transform d x y x1 y1 x2 y2 cx cy r rx ry width height points viewBox preserveAspectRatio fill ' +
    'fill-rule fill-opacity stroke stroke-width stroke-opacity stroke-linecap stroke-linejoin stroke-dasharray opacity ' +
    'display visibility color font-size font-family font-weight text-anchor dx dy href xlink:href version xmlns ' +
    'xmlns:xlink'
  ).split(' '),
);
/** Words of a style sheet that could load something. */
const kLoads = /url\s*\(|@import|expression|\\|image-set|javascript:/i;

function cleaned(node: Element): void {
  for (const { name, value } of [...node.attributes]) {
    const link = name === 'href' || name === 'xlink:href';
    if (!kAttributes.has(name) || kLoads.test(value) || (link && !/^#[\w-]+$/.test(value))) node.removeAttribute(name);
  }
  for (const child of [...node.children]) {
    const bad =
      !kElements.has(child.localName) || (child.localName === 'style' && kLoads.test(child.textContent ?? ''));
    if (bad) child.remove();
    else cleaned(child);
  }
}

/** What would run; browsers complain of it as soon as they read it. */
const kRuns = /\son\w+\s*=\s*("[^"]*"|'[^']*')/gi;

/** The drawing without all else; null where the text is none. */
export function cleanSvg(text: string): Element | null {
  const root = new DOMParser().parseFromString(text.replace(kRuns, ''), 'image/svg+xml').documentElement;
  if (root.localName !== 'svg' || root.querySelector('parsererror')) return null;
  cleaned(root);
  return root;
}
