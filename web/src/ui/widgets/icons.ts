// The studio's icons, drawn on a grid of 20 with lines of 1.6.

const kShapes = {
  chevron: '<path d="m6.5 8.5 3.5 3.5 3.5-3.5"/>',
  mesh: '<path d="M6 3.5h8l3 13H3Z M6 3.5l4 13 4-13 M4.4 10h11.2"/>',
  places: '<circle cx="5" cy="6" r="2.3"/><circle cx="15" cy="6" r="2.3"/><circle cx="10" cy="14.5" r="2.3"/>',
  paths:
    '<path d="M3.5 15.5c5 .8 5-4 8.2-6.6 1.6-1.3 2.9-2.2 4.4-3.6"/><circle cx="3.6" cy="15.6" r="1.4" fill="currentColor"/><circle cx="16.3" cy="4.9" r="1.9" fill="currentColor"/>',
  field:
    '<circle cx="10" cy="10" r="2.2"/><path d="M10 1.8v3 M10 15.2v3 M1.8 10h3 M15.2 10h3 M4.2 4.2l2.1 2.1 M13.7 13.7l2.1 2.1 M4.2 15.8l2.1-2.1 M13.7 6.3l2.1-2.1"/>',
  cost: '<circle cx="10" cy="10" r="1.7"/><path d="M5.4 12.6a5.2 5.2 0 0 1 4.2-7.8 M14.7 7.6a5.2 5.2 0 0 1-4 7.7 M2.8 7.8A7.8 7.8 0 0 1 14.2 3.4 M17.3 12.2A7.8 7.8 0 0 1 6.4 16.9"/>',
  density: '<path d="M3 16.5v-4 M6.5 16.5v-8 M10 16.5v-13 M13.5 16.5V9 M17 16.5v-5" stroke-width="2"/>',
  moon: '<path d="M16.2 12.3A7 7 0 0 1 7.7 3.8a7 7 0 1 0 8.5 8.5Z"/>',
  sun: '<circle cx="10" cy="10" r="3.4"/><path d="M10 1.8v2 M10 16.2v2 M1.8 10h2 M16.2 10h2 M4.2 4.2l1.4 1.4 M14.4 14.4l1.4 1.4 M4.2 15.8l1.4-1.4 M14.4 5.6l1.4-1.4"/>',
  help: '<path d="M6.8 7.2a3.2 3.2 0 1 1 4.9 2.7c-1.2.8-1.7 1.3-1.7 2.6"/><circle cx="10" cy="15.9" r="1.2" fill="currentColor" stroke="none"/>',
  directors:
    '<circle cx="7" cy="6.600" r="2.600"/><path d="M2.200 16.200c0-3.400 2-5.200 4.800-5.200s4.800 1.800 4.800 5.200"/><circle cx="14" cy="7.600" r="2"/><path d="M14 11.600c2.300 0 3.800 1.500 3.800 4.200"/>',
  link: '<path d="M8.400 11.600a3 3 0 0 0 4.300 0l3-3a3 3 0 0 0-4.300-4.300l-1 1 M11.600 8.400a3 3 0 0 0-4.300 0l-3 3a3 3 0 0 0 4.300 4.300l1-1"/>',
  plus: '<path d="M10 3.5v13 M3.5 10h13"/>',
  restart: '<path d="M4.1 11.2a6.1 6.1 0 1 0 1.5-5.1L3.6 8 M3.4 4v4.2h4.2"/>',
  play: '<path d="M6.5 4.2v11.6L16 10Z" fill="currentColor" stroke-linejoin="round"/>',
  pause: '<path d="M7 4.5v11 M13 4.5v11" stroke-width="3.4"/>',
  watch:
    '<path d="M1.8 10S4.6 4.9 10 4.9 18.2 10 18.2 10 15.4 15.1 10 15.1 1.8 10 1.8 10Z"/><circle cx="10" cy="10" r="2.3" fill="currentColor"/>',
  step: '<path d="M4.5 4.5v11L12.8 10Z M16 4v12" stroke-linejoin="round"/>',
  takes:
    '<rect x="2.2" y="4.2" width="15.6" height="11.6" rx="2.4"/><path d="M8.4 7.4v5.2l4.4-2.6Z" fill="currentColor" stroke-width=".8"/>',
  layers: '<path d="m10 2.8 7.4 3.9L10 10.6 2.6 6.7Z M2.6 10.2 10 14.1l7.4-3.9 M2.6 13.6 10 17.4l7.4-3.8"/>',
  more: '<g fill="currentColor" stroke="none"><circle cx="4" cy="10" r="1.9"/><circle cx="10" cy="10" r="1.9"/><circle cx="16" cy="10" r="1.9"/></g>',
  lost: '<path d="M2.5 8.2a11 11 0 0 1 5-2.8 M10.9 5a11 11 0 0 1 6.6 3.2 M5.2 11.2a7 7 0 0 1 3.1-1.8 M12.4 9.8a7 7 0 0 1 2.4 1.4 M8 14a3.2 3.2 0 0 1 4 0 M3.4 3.2l13.2 13.6"/>',
  warning:
    '<path d="M10 3 18 16.8H2Z M10 8v4.4" stroke-linejoin="round"/><circle cx="10" cy="14.6" r="1" fill="currentColor" stroke="none"/>',
  info: '<circle cx="10" cy="10" r="7.6"/><path d="M10 9.2v5"/><circle cx="10" cy="6.2" r="1" fill="currentColor" stroke="none"/>',
  error:
    '<path d="M6.9 2.4h6.200l4.5 4.500v6.200l-4.5 4.500H6.900l-4.5-4.500V6.900Z M7.4 7.400l5.2 5.2 M12.6 7.400l-5.2 5.2" stroke-linejoin="round"/>',
  leave: '<path d="M8.5 3.500h-4v13h4 M8 10h9 M13.6 6.4 17.2 10l-3.6 3.6" stroke-linejoin="round"/>',
  steer:
    '<path d="M7.2 10.2V4.1a1.5 1.5 0 0 1 3 0v4.700l3.800.9c1.300.3 2 1.200 1.800 2.500l-.6 4.300H8.400l-3.600-4.600c-.5-.7-.4-1.500.2-1.900.6-.5 1.400-.4 2.200.2Z" stroke-linejoin="round"/>',
  order:
    '<path d="M3 5.500h14 M10 16.500V8.500 M6.600 11.600 10 8.200l3.400 3.400" stroke-linejoin="round"/><circle cx="3" cy="5.500" r="1.300" fill="currentColor"/><circle cx="17" cy="5.500" r="1.300" fill="currentColor"/>',
  cut: '<circle cx="5" cy="5.200" r="2.200"/><circle cx="5" cy="14.800" r="2.200"/><path d="M6.900 6.400 17 13.500 M6.900 13.600 17 6.500"/>',
  words: '<path d="M3 4.500h14v9.500H9.500L6 17.200V14H3Z M6.500 8h7 M6.500 10.800h4.500" stroke-linejoin="round"/>',
  stop: '<rect x="5" y="5" width="10" height="10" rx="1.500" fill="currentColor"/>',
  hold: '<path d="M6 11V5.2a1.2 1.2 0 0 1 2.4 0V9.500 M8.4 9.500V3.900a1.2 1.2 0 0 1 2.400 0v5.600 M10.800 9.500V4.700a1.2 1.2 0 0 1 2.400 0v5 M13.200 9.700V6.600a1.2 1.2 0 0 1 2.400 0v5.800c0 3-2 5-4.900 5-2.300 0-3.700-1-4.700-2.700l-2.300-3.500c-.6-.9.700-2 1.500-1.200L6 11" stroke-width="1.400"/>',
  resume: '<path d="M4 10h11 M11 5.500 15.500 10 11 14.500" stroke-linejoin="round"/>',
  patrol:
    '<path d="M3.500 8.500A6.700 6.700 0 0 1 15.600 6 M16.500 11.500A6.700 6.700 0 0 1 4.400 14 M15.900 2.600V6.200h-3.600 M4.100 17.400v-3.600h3.600" stroke-linejoin="round"/>',
  undo: '<path d="M7 4 3.500 7.500 7 11 M3.800 7.500h7.700a4.500 4.500 0 0 1 0 9H8" stroke-linejoin="round"/>',
  redo: '<path d="m13 4 3.500 3.500L13 11 M16.200 7.500H8.500a4.500 4.500 0 0 0 0 9H12" stroke-linejoin="round"/>',
  follow:
    '<circle cx="14.500" cy="5.500" r="2.400"/><circle cx="4.800" cy="14.500" r="2.400" fill="currentColor"/><path d="M6.800 12.600 11 8.600" stroke-dasharray="2 2.600"/>',
  guard:
    '<path d="M10 2.800 16 5v4.600c0 3.700-2.500 6.200-6 7.600-3.500-1.400-6-3.900-6-7.600V5Z" stroke-linejoin="round"/>',
  wait: '<path d="M5 3.500h10 M5 16.500h10 M6.500 3.500c0 3.500 7 9.500 7 13 M13.500 3.500c0 3.500-7 9.500-7 13" stroke-linejoin="round"/>',
  dials: '<path d="M3 6h8 M15 6h2 M3 14h2 M9 14h8"/><circle cx="13" cy="6" r="2"/><circle cx="7" cy="14" r="2"/>',
  earlier: '<path d="M16 10H5 M9 5.500 4.500 10 9 14.500" stroke-linejoin="round"/>',
  later: '<path d="M4 10h11 M11 5.500 15.500 10 11 14.500" stroke-linejoin="round"/>',
  fit: '<path d="M3 7V3h4 M13 3h4v4 M17 13v4h-4 M7 17H3v-4" stroke-linejoin="round"/><circle cx="10" cy="10" r="2.2" fill="currentColor"/>',
  camera:
    '<rect x="2" y="5.500" width="10.500" height="9" rx="2"/><path d="m12.500 9 5-3v8l-5-3" stroke-linejoin="round"/>',
  arrow: '<path d="M4 10h11 M10.500 5 15.500 10l-5 5" stroke-linejoin="round"/>',
  show: '<path d="M3 12V5a2 2 0 0 1 2-2h10a2 2 0 0 1 2 2v7 M3 16.500h14" stroke-linejoin="round"/>',
  close: '<path d="m5 5 10 10 M15 5 5 15"/>',
  download: '<path d="M10 3v9.5 M6 9l4 4 4-4 M3.5 16.5h13"/>',
  export: '<path d="M10 12V3.2 M6.200 7 10 3.200 13.800 7 M7 9.500H4v7h12v-7h-3"/>',
  open: '<path d="M2.8 15.8V4.8h5l1.8 2.2h7.6v8.8Z" stroke-linejoin="round"/>',
  character: '<circle cx="10" cy="5" r="2.7"/><path d="M4.5 17c.3-4.200 2-6.400 5.5-6.400s5.200 2.200 5.5 6.400"/>',
  rename:
    '<path d="M4 16l.8-3.600L13 4.200a1.700 1.700 0 0 1 2.400 0l.4.4a1.700 1.700 0 0 1 0 2.400L7.600 15.200Z M11.600 5.600l2.800 2.800" stroke-linejoin="round"/>',
  copy: '<rect x="7" y="7" width="9.500" height="9.500" rx="2"/><path d="M13 4.500a1 1 0 0 0-1-1H5.500a2 2 0 0 0-2 2V12a1 1 0 0 0 1 1"/>',
  place:
    '<path d="M10 17.500s-5.500-5.200-5.500-9.500a5.500 5.500 0 0 1 11 0c0 4.300-5.500 9.500-5.500 9.500Z" stroke-linejoin="round"/><circle cx="10" cy="8" r="1.900"/>',
  build:
    '<path d="M3.500 16.500v-8L10 3.500l6.500 5v3 M3.500 16.500h6 M7.500 16.500v-5h3" stroke-linejoin="round"/><path d="M15 12.500v5.500 M12.250 15.250h5.500"/>',
  measure: '<path d="M10 2.5v15 M3 10h13.500 M13 6.500l3.500 3.500-3.500 3.500" stroke-linejoin="round"/>',
  check: '<path d="m4 10.5 4 4 8-9"/>',
  empty:
    '<path d="M10 1.5 12.7 5H7.3Z M10 18.5 7.3 15h5.4Z M1.5 10 5 7.3v5.4Z M18.5 10 15 12.7V7.3Z M10 5v10 M5 10h10"/>',
} as const;

export type IconName = keyof typeof kShapes;

/** What is inside of an icon's svg. */
export function iconBody(name: IconName): string {
  return kShapes[name];
}

const kLogoPlaces = [
  [15, 5],
  [10, 13.5],
  [20, 13.5],
  [5, 22],
  [15, 22],
  [25, 22],
] as const;

/** What is inside of the mark of Muster: a small crowd in a wedge, one of them in the accent. */
export const kLogoBody = kLogoPlaces
  .map(([x, y], i) => `<circle cx="${x}" cy="${y}" r="3" ${i === 2 ? 'class="logo-accent"' : ''}/>`)
  .join('');
