import { expect, it } from "vitest";
import { writeBodyFrame } from "./body_frame";

const frame = (body: Float32Array<ArrayBuffer>) =>
  writeBodyFrame({ time: 12.5, width: 640, height: 480, body, cost: 0 });

it("writes what the show reads", () => {
  const body = new Float32Array(6 * 33).map((_, place) => place / 7);
  const view = new DataView(frame(body));
  expect(String.fromCharCode(...new Uint8Array(view.buffer, 0, 4))).toBe("OMBL");
  expect([4, 6, 8, 10].map((place) => view.getUint16(place, true))).toEqual([1, 640, 480, 33]);
  expect(view.getFloat64(12, true)).toBe(12.5);
  expect(view.byteLength).toBe(20 + 24 * 33);
  expect(view.getFloat32(20 + 4 * 197, true)).toBe(body[197]);
});

it("says where no body was found", () => {
  const view = new DataView(frame(new Float32Array()));
  expect([view.getUint16(10, true), view.byteLength]).toEqual([0, 20]);
});
