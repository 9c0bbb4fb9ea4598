import { beforeEach, describe, expect, it, vi } from "vitest";
import type { Triple } from "../math/vectors";
import { Aspect } from "../scene/viewports";
import { Sight } from "./camera_control";

describe("Sight", () => {
  let aspect: Aspect;
  let sight: Sight;
  const redraw = vi.fn();
  const centre: Triple = [0, 0, 0.06];

  beforeEach(() => {
    aspect = new Aspect({ clientWidth: 400, clientHeight: 400, width: 400, height: 400 } as HTMLCanvasElement);
    aspect.share(0);
    sight = new Sight({ aspect, work: { bounds: { centre, radius: 0.13 } }, redraw });
    redraw.mockClear();
  });

  it("keeps under the pointer what one comes nearer to", () => {
    const camera = sight.camera;
    const point: Triple = [0.03, -0.04, 0.06];
    const [x, y] = (camera as NonNullable<typeof camera>).project(point);
    sight.zoomAt([x, y], 2);
    const [nx, ny] = (sight.camera as NonNullable<typeof camera>).project(point);
    expect(Math.hypot(nx - x, ny - y)).toBeLessThan(0.5);
    expect(aspect.view.zoom).toBe(2);
    expect(redraw).toHaveBeenCalled();
  });

  it("shifts what is seen with the pointer", () => {
    const before = sight.camera?.project(centre) as Triple;
    sight.pan(30, -12);
    const after = sight.camera?.project(centre) as Triple;
    expect(after[0] - before[0]).toBeCloseTo(30, 3);
    expect(after[1] - before[1]).toBeCloseTo(-12, 3);
  });

  it("comes nearer as two fingers part, and forgets them when they leave", () => {
    sight.pinch([
      [150, 200],
      [250, 200],
    ]);
    sight.pinch([
      [100, 200],
      [300, 200],
    ]);
    expect(aspect.view.zoom).toBeCloseTo(2, 9);
    sight.release();
    expect(sight.pinching).toBe(false);
    sight.pinch([
      [100, 200],
      [110, 200],
    ]);
    expect(aspect.view.zoom).toBeCloseTo(2, 9);
  });

  it("turns the head, and all is as at first again", () => {
    sight.orbit(50, 20);
    expect(aspect.view.yaw).toBeLessThan(0);
    expect(aspect.view.pitch).toBeGreaterThan(0);
    sight.reset();
    expect(aspect.view).toEqual({ yaw: 0, pitch: 0, zoom: 1, pan: [0, 0] });
  });
});
