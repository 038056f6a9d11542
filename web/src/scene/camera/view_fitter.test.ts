import { describe, expect, it } from 'vitest';
import { sceneOf } from '../../protocol/test_scene';
import { CameraController } from './camera_controller';
import { ViewFitter } from './view_fitter';

const kScene = sceneOf({ name: 'one', box: { min: [-50, -50], max: [50, 50] } });
const kCrowd = [20, 20, 24, 20, 24, 24, 20, 24];

function opened(): { camera: CameraController; fitter: ViewFitter } {
  const camera = new CameraController();
  camera.resize(1280, 800);
  const fitter = new ViewFitter(camera);
  fitter.open(kScene);
  return { camera, fitter };
}

describe('ViewFitter', () => {
  it('opens a world on its crowd, once', () => {
    const { camera, fitter } = opened();
    fitter.show(() => kCrowd, []);
    const pose = { ...camera.pose };
    expect(Math.abs(pose.targetX - 22)).toBeLessThan(8);
    fitter.show(
      () => kCrowd.map((x) => -x),
      [],
    );
    expect(camera.pose).toEqual(pose);
  });

  it('leaves a pose alone that was taken before the first picture', () => {
    const { camera, fitter } = opened();
    const pose = { targetX: -10, targetY: 5, distance: 30, turn: 0.5, pitch: 0.8 };
    camera.glideToPose(pose, 0, 0);
    fitter.show(() => kCrowd, []);
    camera.update(1);
    expect(camera.pose.targetX).toBeCloseTo(-10, 9);
    expect(camera.pose.distance).toBeCloseTo(30, 9);
  });

  it('opens the next world on its crowd again', () => {
    const { camera, fitter } = opened();
    camera.glideToPose({ targetX: -10, targetY: 5, distance: 30, turn: 0.5, pitch: 0.8 }, 0, 0);
    fitter.open(kScene);
    fitter.show(() => kCrowd, []);
    expect(Math.abs(camera.pose.targetX - 22)).toBeLessThan(8);
  });
});
