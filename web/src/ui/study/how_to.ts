// How each control is used, in a few lines for people.

type Line = readonly [withWhat: string, does: string];

const kTouch: readonly Line[] = [
  ['One finger on the crowd', 'drags it along the way you draw; you may lift the finger'],
  ['Two or three fingers together', 'hold a line or an area; spread them to widen it'],
  ['Pull two fingers apart', 'tears the crowd in two'],
  ['A stroke across the crowd', 'divides it; a loop round parts joins them'],
  ['Two taps on the crowd', 'give it its square back'],
  ['Two taps where nobody stands', 'call whoever is nearest there'],
];
const kPaper: readonly Line[] = [
  ['Right button: drag a box', 'selects the characters in it'],
  ['Left button: click', 'sends them there'],
];
const kFull: readonly Line[] = [
  ['Left button: drag a box', 'selects; Shift adds, Ctrl takes away'],
  ['Left button: click, or twice', 'selects one character, or its whole group'],
  ['Right button: click', 'sends the selected; with Shift afterwards'],
  ['Ctrl and a digit, the digit', 'keep a selection, and bring it back'],
  ['S', 'stops the selected'],
];
const kMesh: readonly Line[] = [
  ['Drag the crowd', 'pulls it along'],
  ['Shift + drag, Ctrl + drag', 'span a line, lasso an area; then drag these'],
  ['Drag from outside across the crowd', 'divides it'],
  ['P, Delete', 'pin the control, take it away'],
];

export function linesOf(scheme: string): readonly Line[] {
  if (scheme === 'mouse-paper') return kPaper;
  if (scheme === 'mouse-mesh') return kMesh;
  return scheme.startsWith('mouse') ? kFull : kTouch;
}
