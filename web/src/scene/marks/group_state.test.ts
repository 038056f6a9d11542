import { describe, expect, it } from 'vitest';
import type { GroupView } from '../../model/frame_view';
import { GroupState } from './group_state';
import { type PlaceLayer, kRing } from './place_layer';
import { madeGroup } from '../../model/test_frames';

/** Remembers the styles of the rings it is given. */
class FakeRings {
  styles: number[] = [];
  room = 0;
  begin(count: number): void {
    this.styles = [];
    this.room = count;
  }
  setTint(): void {}
  add(_x: number, _y: number, style: number): void {
    this.styles.push(style);
  }
  end(): void {}
}

const { whole, dashed, crossed } = kRing;

function group(id: number, meshVersion: number, fit: readonly number[] = [1, 1]): GroupView {
  return madeGroup(id, [], { meshVersion, places: [0, 0, 1, 0], fit });
}

function stylesAt(picture: GroupState, groups: readonly GroupView[], now: number): number[] {
  const rings = new FakeRings();
  picture.update(groups);
  picture.showPlaces(rings as unknown as PlaceLayer, true, ['#112233', '#445566'], now);
  expect(rings.room).toBe(rings.styles.length);
  return rings.styles;
}

describe('places of a formation', () => {
  it('are dashed for 0.6 s after a change, not when a group is first seen', () => {
    const picture = new GroupState();
    expect(stylesAt(picture, [group(1, 4)], 0)).toEqual([whole, whole]);
    expect(stylesAt(picture, [group(1, 5)], 1000)).toEqual([dashed, dashed]);
    expect(stylesAt(picture, [group(1, 5)], 1590)).toEqual([dashed, dashed]);
    expect(stylesAt(picture, [group(1, 5)], 1610)).toEqual([whole, whole]);
  });

  it('stay crossed where nobody finds room, also while they are new', () => {
    const picture = new GroupState();
    stylesAt(picture, [group(1, 4)], 0);
    expect(stylesAt(picture, [group(1, 5, [1, 0])], 1000)).toEqual([dashed, crossed]);
  });

  it('of other groups stay as they are', () => {
    const picture = new GroupState();
    stylesAt(picture, [group(1, 1), group(2, 1)], 0);
    expect(stylesAt(picture, [group(1, 1), group(2, 2)], 100)).toEqual([whole, whole, dashed, dashed]);
  });

  it('are whole in a world that began anew, or another one', () => {
    const picture = new GroupState();
    stylesAt(picture, [group(1, 7)], 0);
    expect(stylesAt(picture, [group(1, 1)], 100)).toEqual([whole, whole]);
    picture.clear();
    expect(stylesAt(picture, [group(1, 9)], 200)).toEqual([whole, whole]);
  });

  it('are counted as seen while the layer is off', () => {
    const picture = new GroupState();
    const rings = new FakeRings();
    picture.update([group(1, 1)]);
    picture.showPlaces(rings as unknown as PlaceLayer, false, [], 0);
    expect(rings.styles).toEqual([]);
    expect(stylesAt(picture, [group(1, 2)], 50)).toEqual([dashed, dashed]);
  });
});
