import { describe, expect, it } from "vitest";
import type { CharacterState, FigureState } from "../../link/messages";
import type { ConsoleStore } from "../store/console_store";
import { bodiesOf, bodyOf, callBody, posesComing, posesFound, poseWeight } from "./pose_commands";

const call = (target: string) => ({ target, remaining: 1, progress: 0.5, by_hand: false }) as never;

/** A character whose figure does this. */
function doing(figure: Partial<FigureState> | null): CharacterState {
  const still: FigureState = {
    poses: { stand: 1 },
    regions: {},
    bodies: { own: 1 },
    pose_call: null,
    region_calls: {},
    body_call: null,
    fader: 0,
  };
  return { figure: figure && { ...still, ...figure } } as CharacterState;
}

function store(sent: unknown[]): ConsoleStore {
  const poses = ["bow", "point_up", "stand"].map((name) => ({ name, label: name.replace("_", " ") }));
  return {
    poses,
    manifest: { figures: { poses, bodies: [{ name: "kaori" }, { name: "heavy" }] } },
    timing: { face: { seconds: 2, easing: "smooth" }, expression: { seconds: 0.5, easing: "gentle" } },
    played: { targets: ["one", "two"] },
    ask: (message: unknown) => sent.push(message),
  } as unknown as ConsoleStore;
}

describe("poses on a console", () => {
  it("are found by their words, the stand first, and bodies are the faces' own and all others", () => {
    expect(posesFound(store([]), "").map(({ name }) => name)).toEqual(["stand", "bow", "point_up"]);
    expect(posesFound(store([]), "up POINT").map(({ name }) => name)).toEqual(["point_up"]);
    expect(bodiesOf(store([]))).toEqual(["own", "kaori", "heavy"]);
  });

  it("have bodies that are called on all who are played, in the time of faces", () => {
    const sent: unknown[] = [];
    callBody(store(sent), "heavy");
    const call = { type: "call_body", name: "heavy", seconds: 2, easing: "smooth" };
    expect(sent).toEqual(["one", "two"].map((character) => ({ ...call, character })));
  });

  it("weigh as much as the whole or a region does them; a figure that was told nothing stands in its own body", () => {
    expect([poseWeight(null, "stand"), poseWeight(doing(null), "stand"), poseWeight(doing(null), "bow")]).toEqual([
      0, 1, 0,
    ]);
    const mixed = doing({ poses: { bow: 0.25, stand: 0.75 }, regions: { trunk: { bow: 0.5, stand: 0.5 } } });
    expect([poseWeight(mixed, "bow"), poseWeight(mixed, "stand")]).toEqual([0.5, 0.75]);
    expect([...posesComing(doing({ pose_call: call("bow"), region_calls: { head: call("stand") } }))]).toEqual([
      "bow",
      "stand",
    ]);
    expect([bodyOf(doing(null)), bodyOf(doing({ bodies: { heavy: 0.6, own: 0.4 } }))]).toEqual(["own", "heavy"]);
    expect(bodyOf(doing({ bodies: { heavy: 0.6, own: 0.4 }, body_call: call("own") }))).toBe("own");
  });
});
