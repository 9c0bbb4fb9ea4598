import { describe, expect, it } from "vitest";
import type { CallState } from "../../link/messages";
import { barView } from "./t_bar_view";

const call = (change: Partial<CallState>): CallState => ({
  target: "old",
  progress: 0.4,
  remaining: 1.2,
  by_hand: false,
  fader: 0,
  start: { old: 1 },
  pickup: 0.4,
  ...change,
});
const byHand = { by_hand: true, remaining: null };

describe("a T-bar", () => {
  it("rests where the hand left it while nothing runs", () => {
    expect(barView(null, 0.7, false, null)).toMatchObject({ mode: "idle", value: 0.7, target: null });
  });

  it("shows a timed call beside the hand that does not touch it", () => {
    expect(barView(call({}), 0, false, null)).toMatchObject({ mode: "running", value: 0.4, flipped: false });
  });

  it("waits for a hand to meet the value, and says how far it is", () => {
    const view = barView(call({}), 0.1, true, null);
    expect(view.mode).toBe("waiting");
    expect(view.gap).toBeCloseTo(-0.3, 12);
  });

  it("belongs to the hand once the server says so", () => {
    const running = barView(call({}), 0.4, true, null);
    expect(barView(call({ ...byHand, pickup: 0.42, progress: 0.42 }), 0.5, true, running).mode).toBe("waiting");
    const untouched = barView(call({}), 0.4, false, null);
    expect(barView(call({ ...byHand }), 0.9, false, untouched).mode).toBe("held");
  });

  it("is picked up by a hand that meets the value, or jumps over it between two frames", () => {
    const waiting = barView(call(byHand), 0.1, true, null);
    expect(waiting.mode).toBe("waiting");
    expect(barView(call(byHand), 0.41, true, waiting).mode).toBe("held");
    expect(barView(call(byHand), 0.9, true, waiting).mode).toBe("held");
  });

  it("stays picked up while the value glides after a fast hand", () => {
    const held = barView(call(byHand), 0.4, true, null);
    expect(held.mode).toBe("held");
    expect(barView(call(byHand), 0.95, true, held).mode).toBe("held");
  });

  it("has to be picked up anew by the next call", () => {
    const held = barView(call(byHand), 0.4, true, null);
    expect(barView(call({ ...byHand, target: "child" }), 0.95, true, held).mode).toBe("waiting");
  });

  it("runs from the top when it was left there", () => {
    const flipped = barView(call({ progress: 0.1, pickup: 0.9 }), 1, false, null);
    expect(flipped.flipped).toBe(true);
    const half = call({ progress: 0.5, pickup: 0.5 });
    expect(barView(half, 0.5, true, flipped).flipped).toBe(true); // half way both readings agree
    expect(barView(half, 0.5, true, null).flipped).toBe(false);
  });
});
