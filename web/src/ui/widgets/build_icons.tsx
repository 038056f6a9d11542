// Icons of the tools with which one builds, on a grid of 20.

import type { VNode } from 'preact';
import type { BuildTool } from '../../model/place/drawing';

const kShapes: Readonly<Record<BuildTool | 'redo' | 'undo' | 'remove' | 'copy', string>> = {
  select: '<path d="M5 3.500v12l3.300-3 2 4.500 2-.9-2-4.400h4.200Z" stroke-linejoin="round"/>',
  box: '<rect x="4" y="5.500" width="12" height="9" rx="1"/>',
  disc: '<circle cx="10" cy="10" r="6"/>',
  polygon: '<path d="m10 3.500 6.500 5-2.500 7.500H6L3.500 8.500Z" stroke-linejoin="round"/>',
  wall: '<path d="M3 14.500 15.500 4l1.800 2.200L4.800 16.700Z" stroke-linejoin="round"/>',
  door: '<path d="M3 16.500h3v-13h8v13h3 M6 16.500l5.500 1.500V5L6 3.500" stroke-linejoin="round"/><path d="M9.300 11v.5"/>',
  gate: '<path d="M3.500 4v12.500 M16.500 4v12.500 M3.500 7h13 M3.500 13.500h13 M6.800 7v6.500 M10 7v6.500 M13.200 7v6.500"/>',
  hedge:
    '<path d="M3 15.500v-5a2.300 2.300 0 0 1 4.400-1.500 2.800 2.800 0 0 1 5.200 0A2.300 2.300 0 0 1 17 10.500v5Z M6.500 12.500h.1 M10 11.500h.1 M13.500 13h.1" stroke-linejoin="round"/>',
  water: '<path d="M3.500 8c2-2 4-2 6.500 0s4.500 2 6.500 0 M3.500 13c2-2 4-2 6.500 0s4.500 2 6.500 0"/>',
  net: '<path d="M3.500 4.500h13v11h-13Z M8 4.500v11 M12 4.500v11 M3.500 8.200h13 M3.500 11.800h13" stroke-linejoin="round"/>',
  branches:
    '<path d="M3 5.500h14 M6 5.500l-1.500 4 M9 5.500 8.500 11 M12 5.500l1 5 M15 5.500l1.300 3.500"/><path d="M3 16.500h14"/>',
  car: '<path d="M3 13.500v-3l2-1 1.500-3.500h7L15 9.500l2 1v3Z" stroke-linejoin="round"/><circle cx="6.300" cy="14" r="1.600"/><circle cx="13.700" cy="14" r="1.600"/>',
  stairs: '<path d="M3 16.500h3.500v-3.500H10V9.500h3.500V6H17" stroke-linejoin="round"/>',
  exit: '<path d="M8.500 3.500h-5v13h5 M8 10h9 M13.400 6.400 17 10l-3.600 3.600" stroke-linejoin="round"/>',
  source: '<path d="M11.500 3.500h5v13h-5 M3 10h9 M8.400 6.400 12 10l-3.600 3.600" stroke-linejoin="round"/>',
  waiting:
    '<path d="M5 3.500h10 M5 16.500h10 M6.500 3.500c0 3.500 7 9.500 7 13 M13.500 3.500c0 3.500-7 9.500-7 13" stroke-linejoin="round"/>',
  route:
    '<path d="M4 15.500c6 0 2-11 8-11" stroke-dasharray="2.500 2"/><path d="m11 2 3.500 2.500L11 7" stroke-linejoin="round"/>',
  item: '<path d="m10 3 2 4.500 5 .5-3.700 3.300 1.100 4.900L10 13.700l-4.400 2.500 1.100-4.900L3 8l5-.5Z" stroke-linejoin="round"/>',
  checkpoint: '<path d="M5.500 17V3.500h8l-2 3.200 2 3.300h-8" stroke-linejoin="round"/>',
  people: '<circle cx="10" cy="6" r="2.500"/><path d="M5 16.500c0-4 2-6 5-6s5 2 5 6"/>',
  undo: '<path d="M7 4 3.500 7.500 7 11 M3.800 7.500h7.700a4.500 4.500 0 0 1 0 9H8" stroke-linejoin="round"/>',
  redo: '<path d="m13 4 3.500 3.500L13 11 M16.200 7.500H8.500a4.500 4.500 0 0 0 0 9H12" stroke-linejoin="round"/>',
  remove: '<path d="M4 5.500h12 M8 5.500v-2h4v2 M5.500 5.500l.8 11h7.400l.8-11"/>',
  copy: '<rect x="7" y="7" width="9" height="9" rx="1.500"/><path d="M13 4.500H5.500A1.500 1.500 0 0 0 4 6v7.500"/>',
};

export function BuildIcon({ name }: { readonly name: keyof typeof kShapes }): VNode {
  return (
    <svg
      viewBox="0 0 20 20"
      width="20"
      height="20"
      fill="none"
      stroke="currentColor"
      stroke-width="1.6"
      stroke-linecap="round"
      aria-hidden="true"
      dangerouslySetInnerHTML={{ __html: kShapes[name] }}
    />
  );
}
