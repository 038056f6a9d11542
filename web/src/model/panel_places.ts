// Which panel stands in which area of the page, at each layout. Areas have room of their own, so that no panel covers another;
// where they lie in the window is in layout.css.

import type { Layout } from './layout';

export const kAreas = [
  'head',
  'bar',
  'left',
  'note',
  'right',
  'wide',
  'foot',
  'low',
  'transport',
  'stat',
  'sheet',
  'top',
] as const;
/** `foot` holds `low`, `transport` and `stat`; `sheet` begins with `top`. */
export type Area = (typeof kAreas)[number];

export type PanelName =
  | 'scenario'
  | 'groups'
  | 'layers'
  | 'directors'
  | 'phone-bar'
  | 'formations'
  | 'orders'
  | 'queue'
  | 'hint'
  | 'legend'
  | 'readout'
  | 'scale'
  | 'view-bar'
  | 'playback'
  | 'tabs'
  | 'banners'
  | 'empty'
  | 'build'
  | 'measures'
  | 'words'
  | 'paths'
  | 'sequence'
  | 'try'
  | 'placing'
  | 'take-card'
  | 'time-line';

/** Of what is going on at present, above the transport. */
const kNow: readonly PanelName[] = ['try', 'placing', 'sequence', 'take-card', 'hint', 'time-line'];

/** In the order in which they stand. A panel that is named nowhere is not shown at that layout. */
type Places = Readonly<Partial<Record<Area, readonly PanelName[]>>>;

export const kPlaces: Readonly<Record<Layout, Places>> = {
  desktop: {
    head: ['scenario', 'groups', 'directors', 'layers'],
    left: ['build', 'measures', 'formations', 'legend'],
    note: ['banners', 'paths', 'empty'],
    right: ['orders'],
    wide: [...kNow, 'queue', 'words'],
    low: ['view-bar', 'scale'],
    transport: ['playback'],
    stat: ['readout'],
  },
  landscape: {
    head: ['scenario', 'groups', 'directors', 'layers'],
    left: ['build', 'measures', 'legend', 'formations'],
    note: ['banners', 'paths', 'empty'],
    right: ['orders', 'playback'],
    wide: [...kNow, 'queue', 'words'],
    low: ['view-bar', 'scale'],
    stat: ['readout'],
  },
  portrait: {
    head: ['scenario', 'groups'],
    bar: ['layers', 'directors', 'readout'],
    left: ['view-bar'],
    note: ['banners', 'paths', 'empty'],
    right: ['orders'],
    low: ['scale', 'legend'],
    wide: [...kNow, 'queue', 'words', 'measures'],
    sheet: ['build', 'formations', 'playback'],
  },
  phone: {
    head: ['scenario', 'directors', 'phone-bar'],
    note: ['banners', 'legend', 'paths', 'empty'],
    wide: [...kNow, 'words', 'measures'],
    top: ['groups', 'readout'],
    sheet: ['build', 'tabs', 'formations', 'queue', 'orders', 'view-bar', 'playback'],
  },
  short: {
    head: ['scenario', 'groups', 'directors', 'phone-bar'],
    left: ['build', 'measures', 'view-bar'],
    note: ['banners', 'legend', 'paths', 'empty'],
    right: ['orders'],
    wide: [...kNow, 'queue', 'words'],
    stat: ['readout'],
    sheet: ['formations', 'playback'],
  },
};
