import { describe, expect, it } from 'vitest';
import { CameraController } from '../camera/camera_controller';
import { CrowdState } from './crowd_state';
import { pickCharacter } from './picker';
import { madeFrame } from '../../model/test_frames';

function camera(): CameraController {
  const made = new CameraController();
  made.resize(1280, 800);
  made.setPose({ targetX: 0, targetY: 0, distance: 40, turn: 0.2, pitch: 0.8 });
  return made;
}

describe('picking', () => {
  it('finds a character by feet, chest and head, and nobody far away', () => {
    const state = new CrowdState();
    state.setMembers([11, 12], [0, 0]);
    const frame = madeFrame(1, [-3, 3]);
    state.update({ from: frame, to: frame, alpha: 0 });
    const view = camera();
    for (const height of [0, 1, 1.7]) {
      expect(pickCharacter(view.worldToScreen(3, 0, height), state, view)).toBe(1);
    }
    expect(pickCharacter(view.worldToScreen(0, 0), state, view)).toBe(-1);
  });
});
