// The cursor of the keys draws as a mouse does while somebody builds.

import type { BuildTool } from '../../model/place/drawing';
import type { Contact } from '../../tools/contact';
import type { BuildStroke } from '../../tools/build_pointer';
import type { CursorUser } from '../steer/lazy_cursor';
import type { BuildStroking } from './build_strokes';

/** One Enter is all. */
const kSpots: readonly BuildTool[] = ['polygon', 'door', 'item'];

export function cursorOver(strokes: BuildStroking, tool: () => BuildTool): CursorUser {
  let still = true;
  // Its steps are coarse: it takes a thing from as far as a finger does.
  const stroke = ({ screen, ground, shift }: Contact): BuildStroke => {
    return { screen, ground: ground!, touch: true, shift, free: false };
  };
  return {
    choose: () => ({
      begin: (contact) => {
        still = true;
        strokes.begin(stroke(contact));
      },
      move: (contacts) => {
        still = false;
        for (const contact of contacts) strokes.move(stroke(contact), false);
      },
      end: (contact, cancelled) => {
        if (cancelled) strokes.cancel();
        else strokes.end(stroke(contact), still);
      },
    }),
    // A thing that is taken is moved by arrows then.
    picks: () => kSpots.includes(tool()) || strokes.dragging || !strokes.busy,
  };
}
