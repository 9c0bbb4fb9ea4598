import { beforeEach, describe, expect, it, vi } from "vitest";
import type { Triple } from "../math/vectors";
import { Viewports } from "../scene/viewports";
import { CameraControl } from "./camera_control";

describe("CameraControl", () => {
  let viewports: Viewports;
  let cameraControl: CameraControl;
  const redraw = vi.fn();
  const centre: Triple = [0, 0, 0.06];

  beforeEach(() => {
    viewports = new Viewports({ clientWidth: 400, clientHeight: 400, width: 400, height: 400 } as HTMLCanvasElement);
    viewports.share(0);
    cameraControl = new CameraControl({ viewports, work: { bounds: { centre, radius: 0.13 } }, redraw });
    redraw.mockClear();
  });

  it("keeps under the pointer what one comes nearer to", () => {
    const camera = cameraControl.camera;
    const point: Triple = [0.03, -0.04, 0.06];
    const [x, y] = (camera as NonNullable<typeof camera>).project(point);
    cameraControl.zoomAt([x, y], 2);
    const [nx, ny] = (cameraControl.camera as NonNullable<typeof camera>).project(point);
    expect(Math.hypot(nx - x, ny - y)).toBeLessThan(0.5);
    expect(viewports.view.zoom).toBe(2);
    expect(redraw).toHaveBeenCalled();
  });

  it("shifts what is seen with the pointer", () => {
    const before = cameraControl.camera?.project(centre) as Triple;
    cameraControl.pan(30, -12);
    const after = cameraControl.camera?.project(centre) as Triple;
    expect(after[0] - before[0]).toBeCloseTo(30, 3);
    expect(after[1] - before[1]).toBeCloseTo(-12, 3);
  });

  it("comes nearer as two fingers part, and forgets them when they leave", () => {
    cameraControl.pinch([
      [150, 200],
      [250, 200],
    ]);
    cameraControl.pinch([
      [100, 200],
      [300, 200],
    ]);
    expect(viewports.view.zoom).toBeCloseTo(2, 9);
    cameraControl.release();
    expect(cameraControl.pinching).toBe(false);
    cameraControl.pinch([
      [100, 200],
      [110, 200],
    ]);
    expect(viewports.view.zoom).toBeCloseTo(2, 9);
  });

  it("turns the head, and all is as at first again", () => {
    cameraControl.orbit(50, 20);
    expect(viewports.view.yaw).toBeLessThan(0);
    expect(viewports.view.pitch).toBeGreaterThan(0);
    viewports.zoom(3);
    viewports.pan(0.01, 0.02);
    const { yaw, pitch } = viewports.view;
    viewports.whole();
    expect(viewports.view).toEqual({ yaw, pitch, zoom: 1, pan: [0, 0] });
    cameraControl.reset();
    expect(viewports.view).toEqual({ yaw: 0, pitch: 0, zoom: 1, pan: [0, 0] });
  });
});
