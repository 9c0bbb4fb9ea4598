import { expect, it } from "vitest";
import { writeLandmarkFrame } from "./landmark_frame";

const frame = (points: Float32Array<ArrayBuffer>) =>
  writeLandmarkFrame({ time: 12.5, width: 640, height: 480, points, light: 0, cost: 0 });

it("writes what the show reads", () => {
  const points = new Float32Array(3 * 478).map((_, place) => place / 7);
  const view = new DataView(frame(points));
  expect(String.fromCharCode(...new Uint8Array(view.buffer, 0, 4))).toBe("OMLM");
  expect([4, 6, 8, 10].map((place) => view.getUint16(place, true))).toEqual([1, 640, 480, 478]);
  expect(view.getFloat64(12, true)).toBe(12.5);
  expect(view.byteLength).toBe(20 + 12 * 478);
  expect(view.getFloat32(20 + 4 * 1433, true)).toBe(points[1433]);
});

it("says where no face was found", () => {
  const view = new DataView(frame(new Float32Array()));
  expect([view.getUint16(10, true), view.byteLength]).toEqual([0, 20]);
});
