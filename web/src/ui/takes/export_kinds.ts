// What a take can become, and what a visitor chooses of it.

/** Something that a take can become. */
export interface ExportKind {
  readonly name: string;
  readonly label: string;
  readonly about: string;
  /** Made by the page: pictures of what is seen. */
  readonly here?: boolean;
  /** Many pictures: they have a size, and a part of the take. */
  readonly series?: boolean;
  /** Needs an encoder of films. */
  readonly film?: boolean;
  /** Its frames a second can be chosen. */
  readonly frames?: boolean;
  /** Frames a second that suit it. */
  readonly fps?: number;
}

/** Players draw as many pictures as the display shows between the frames of the file. */
const kPlayerFps = 15;

/** By what they are for. */
export const kExportKinds: Readonly<Record<string, readonly ExportKind[]>> = {
  'To watch': [
    { name: 'film', label: 'Film', about: 'MP4 or WebM of what you see', here: true, series: true, film: true },
    { name: 'picture', label: 'Picture', about: 'PNG of the shown moment', here: true },
    {
      name: 'pictures',
      label: 'People without background',
      about: 'A PNG with transparency for each moment, in a ZIP',
      here: true,
      series: true,
    },
    {
      name: 'player-page',
      label: 'Web page',
      about: 'One HTML file that plays in any browser',
      fps: kPlayerFps,
    },
    {
      name: 'player-folder',
      label: 'Web page for a site',
      about: 'Page, script and crowd in a ZIP, with the lines to copy',
      fps: kPlayerFps,
    },
  ],
  'To animate': [
    { name: 'glb', label: 'glTF', about: 'People in motion on their ground, in metres', frames: true },
    {
      name: 'usdc',
      label: 'USD',
      about: 'The same for Houdini, Maya, Omniverse, in metres',
      frames: true,
    },
    {
      name: 'usda',
      label: 'USD as text',
      about: 'The same to read; more than twice as large',
      frames: true,
    },
    {
      name: 'bvh',
      label: 'BVH',
      about: 'One motion file per person, in centimetres, in a ZIP',
      frames: true,
    },
  ],
  'For research': [
    {
      name: 'csv',
      label: 'Table',
      about: 'CSV: time, person, group, place in metres, heading, speed, motion',
      frames: true,
    },
    { name: 'jupedsim', label: 'JuPedSim', about: 'Trajectories as SQLite, in metres', frames: true },
    { name: 'pedpy', label: 'PedPy', about: 'Trajectories as text, in metres', frames: true },
  ],
};

export const kFilmSizes: Readonly<Record<string, readonly [number, number]>> = {
  '1280 × 720': [1280, 720],
  '1920 × 1080': [1920, 1080],
  '1080 × 1920': [1080, 1920],
  '1080 × 1080': [1080, 1080],
};

export interface ExportGroup {
  readonly id: number;
  readonly name: string;
}

/** What a take offers to choose from. */
export interface ExportRange {
  readonly title: string;
  /** The shown part [s]. */
  readonly from: number;
  readonly to: number;
  /** Its end [s]. */
  readonly end: number;
  /** None where they are not known. */
  readonly groups: readonly ExportGroup[];
}

export interface ExportChoice {
  readonly kind: ExportKind;
  readonly fps: number;
  readonly size: readonly [number, number];
  /** Without meshes, places and paths. */
  readonly clean: boolean;
  readonly sky: boolean;
  readonly shadows: boolean;
  /** [s] */
  readonly from: number;
  readonly to: number;
  /** Ids; none: all. */
  readonly groups: readonly number[];
  /** First and last number; null: all. */
  readonly people: readonly [number, number] | null;
}
