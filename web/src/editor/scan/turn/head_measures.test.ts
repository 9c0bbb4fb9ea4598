import { describe, expect, it } from "vitest";
import { LANDMARK_COUNT } from "../../../face_mesh/face_mesh";
import type { Landmarks } from "../../../face_mesh/landmark_messages";
import { judgeFrame } from "./frame_faults";
import { measureHead, speedBetween } from "./head_measures";

interface Head {
  yaw?: number;
  pitch?: number;
  roll?: number;
  mouth?: number;
  /** Of the right and the left eye. */
  lids?: [number, number];
  size?: number;
  x?: number;
  light?: number;
  time?: number;
  width?: number;
  height?: number;
}

/** Places on a head that looks straight ahead, in heights of its face: x to its left, y down, z back. */
function head(mouth: number, lids: [number, number]): Record<number, [number, number, number]> {
  const back = Math.tan((6 * Math.PI) / 180);
  const eye = (x: number, open: number): [number, number, number][] => [
    [x - 0.12, -0.15, 0],
    [x + 0.12, -0.15, 0],
    [x, -0.15 - 0.12 * open, 0],
    [x, -0.15 + 0.12 * open, 0],
  ];
  const [right, left] = [eye(-0.22, lids[0]), eye(0.22, lids[1])];
  const rows: Record<number, [number, number, number]> = { 10: [0, -0.5, 0], 152: [0, 0.5, back] };
  [33, 133, 159, 145].forEach((row, at) => {
    rows[row] = right[at] as [number, number, number];
  });
  [362, 263, 386, 374].forEach((row, at) => {
    rows[row] = left[at] as [number, number, number];
  });
  const tall = Math.hypot(1, back);
  return {
    ...rows,
    13: [0, 0.25, 0],
    14: [0, 0.25 + mouth * tall, 0],
    ...{ 234: [-0.45, 0, 0.3], 454: [0.45, 0, 0.3], 127: [-0.44, -0.1, 0.3], 356: [0.44, -0.1, 0.3] },
  };
}

/** Landmarks of a head before a camera that sees it from afar; rows without a place lie in the middle of the face. */
function seen(pose: Head = {}): Landmarks {
  const { mouth = 0.01, lids = [0.3, 0.3], size = 0.5, x = 0.5, light = 0.5, time = 100 } = pose;
  const { width = 640, height = 360 } = pose;
  const [yaw, pitch, roll] = [pose.yaw ?? 0, pose.pitch ?? 0, pose.roll ?? 0].map(
    (degrees) => (degrees * Math.PI) / 180,
  );
  const rows = head(mouth, lids);
  const points = new Float32Array(3 * LANDMARK_COUNT);
  for (let row = 0; row < LANDMARK_COUNT; row++) {
    const place = turned(rows[row] ?? [0, 0, 0], yaw as number, pitch as number, roll as number);
    const [across, down, back] = place.map((part) => part * size * height) as [number, number, number];
    points.set([x + across / width, 0.5 + down / height, back / width], 3 * row);
  }
  return { time, width, height, points, light, cost: 1 };
}

function turned([x, y, z]: [number, number, number], yaw: number, pitch: number, roll: number) {
  const [y1, z1] = [y * Math.cos(pitch) + z * Math.sin(pitch), z * Math.cos(pitch) - y * Math.sin(pitch)];
  const [x2, z2] = [x * Math.cos(yaw) - z1 * Math.sin(yaw), z1 * Math.cos(yaw) + x * Math.sin(yaw)];
  return [x2 * Math.cos(roll) - y1 * Math.sin(roll), y1 * Math.cos(roll) + x2 * Math.sin(roll), z2];
}

describe("the measures of a head", () => {
  it("are its turns, whatever the shape of the picture", () => {
    for (const size of [
      { width: 640, height: 360 },
      { width: 360, height: 640 },
    ])
      for (const yaw of [-45, -20, 0, 20, 45]) expect(measureHead(seen({ yaw, ...size })).yaw).toBeCloseTo(yaw, 3);
    for (const pitch of [-20, 0, 15]) expect(measureHead(seen({ pitch })).pitch).toBeCloseTo(pitch, 3);
    for (const roll of [-15, 0, 30]) expect(measureHead(seen({ roll })).roll).toBeCloseTo(roll, 3);
  });

  it("are the gaps of lips and lids, which turns do not change", () => {
    for (const turn of [{}, { yaw: 40 }, { yaw: -40, roll: 10 }, { pitch: 15 }]) {
      const { mouth, lids } = measureHead(seen({ ...turn, mouth: 0.08, lids: [0.2, 0.2] }));
      expect([mouth, lids]).toEqual([expect.closeTo(0.08, 4), expect.closeTo(0.2, 4)]);
    }
  });

  it("are of the less open eye, but not of one that lies behind the nose", () => {
    const wink: [number, number] = [0.3, 0.05];
    expect(measureHead(seen({ lids: wink })).lids).toBeCloseTo(0.05, 4);
    expect(measureHead(seen({ lids: wink, yaw: 30 })).lids).toBeCloseTo(0.3, 4);
    expect(measureHead(seen({ lids: wink, yaw: -30 })).lids).toBeCloseTo(0.05, 4);
  });

  it("have a speed in heights of the face, however large it is", () => {
    for (const size of [0.4, 0.8]) {
      const [before, now] = [seen({ size }), seen({ size, x: 0.5 + (0.1 * size * 360) / 640, time: 600 })];
      expect(speedBetween(before, now)).toBeCloseTo(0.2 / Math.hypot(1, Math.tan((6 * Math.PI) / 180)), 3);
    }
    expect(speedBetween(seen(), seen())).toBe(Number.POSITIVE_INFINITY); // no time between them
    const nobody = { ...seen(), points: new Float32Array() };
    expect(speedBetween(nobody, seen({ time: 200 }))).toBe(Number.POSITIVE_INFINITY);
  });
});

describe("a picture of the camera", () => {
  const judged = (pose: Head, before: Landmarks | null = seen({ ...pose, time: 0 })) =>
    judgeFrame(seen({ ...pose, time: 100 }), before).fault;

  it("is good where a face at rest is near, upright, light and still, in every direction that is wanted", () => {
    for (const yaw of [-40, -20, 0, 20, 40]) expect(judged({ yaw, size: 0.6 })).toBeNull();
    expect(judged({ pitch: 15, roll: 8 })).toBeNull();
  });

  it("says the one thing that is wrong", () => {
    expect(judged({ light: 0.05 })).toBe("Too dark. Put a light in front of you, not behind.");
    expect(judged({ light: 0.99 })).toContain("Too bright");
    expect(judged({ size: 0.26 })).toBe("Too far: come nearer.");
    expect(judged({ x: 0.1 })).toContain("Move to the middle.");
    expect(judged({ roll: 25 })).toBe("Hold your head upright.");
    expect(judged({ pitch: 32 })).toBe("Lower your chin a little.");
    expect(judged({ pitch: -32 })).toBe("Raise your chin a little.");
    expect(judged({ mouth: 0.07 })).toBe("Close your mouth.");
    expect(judged({ lids: [0.08, 0.08] })).toBe("Open your eyes.");
    expect(judged({}, seen({ x: 0.46, time: 0 }))).toBe("Slower: the picture blurs while you move.");
    const nobody = { ...seen({ light: 0.5 }), points: new Float32Array() };
    expect(judgeFrame(nobody, null).fault).toContain("Sit before the camera");
    expect(judgeFrame({ ...nobody, light: 0.05 }, null).fault).toContain("It is dark");
  });

  it("is not taken as the first, nor after one without a face: whether it is still is not known", () => {
    expect(judged({}, null)).toBe("Hold still …");
    expect(judged({}, { ...seen({ time: 0 }), points: new Float32Array() })).toBe("Hold still …");
  });

  it("is not taken after one with a fault, whose landmarks it still has in part", () => {
    for (const fault of [{ light: 0.05 }, { pitch: 28 }, { mouth: 0.07 }, { lids: [0.08, 0.08] as [number, number] }])
      expect(judged({ pitch: 25 }, seen({ pitch: 25, ...fault, time: 0 }))).toBe("Hold still …");
    expect(judged({ pitch: 25 })).toBeNull();
  });
});
