import { describe, expect, it } from "vitest";
import type { State } from "../../link/messages";
import { LostSources, sendingOf } from "./lost_sources";

const rex = (trust: number, source = "Mira 10.0.0.7", layer = "tracker"): State["characters"] =>
  ({ rex: { label: "Rex", layers: { [layer]: { source, trust } } } }) as never;

describe("lost sources", () => {
  it("are told once, and once when they are back", () => {
    const sources = new LostSources();
    const sentences = [1, 0.5, 0, 0, 0.5, 1, 1].map((trust) => sources.receive(rex(trust)));
    const [lost, back] = ["Mira (tracker of Rex) is lost.", "Mira (tracker of Rex) is back."];
    expect(sentences).toEqual(["", "", lost, "", "", back, ""]);
  });

  it("are not told where a source fades and returns before it is lost", () => {
    const sources = new LostSources();
    expect([1, 0.3, 1].map((trust) => sources.receive(rex(trust)))).toEqual(["", "", ""]);
  });

  it("are not told of one that comes, goes away for good, or ends by itself", () => {
    const sources = new LostSources();
    const sentences = [rex(0), rex(1), rex(0, ""), rex(0)].map((characters) => sources.receive(characters));
    const recording = [rex(1, "take", "playback"), rex(0, "take", "playback")].map((characters) =>
      sources.receive(characters),
    );
    const speech = [1, 0.5, 0, 0, 1, 0].map((trust) => sources.receive(rex(trust, "speech", "lips")));
    expect([...sentences, ...recording, ...speech].join("")).toBe("");
  });

  it("are told of lips that a microphone moves, though a speech beside them ends", () => {
    const sources = new LostSources();
    const lips = (microphone: number, speech: number): State["characters"] => {
      const both = [
        { source: "Desk", trust: microphone },
        { source: "speech", trust: speech },
      ];
      return { rex: { label: "Rex", layers: { lips: { sources: both } } } } as never;
    };
    const sentences = [lips(1, 1), lips(1, 0), lips(0, 0)].map((characters) => sources.receive(characters));
    expect(sentences).toEqual(["", "", "Desk (lips of Rex) is lost."]);
  });

  it("are not told while their layer is off, as after a panic", () => {
    const sources = new LostSources();
    const off = (trust: number): State["characters"] =>
      ({ rex: { label: "Rex", layers: { tracker: { source: "Mira 10.0.0.7", trust, on: false } } } }) as never;
    const sentences = [rex(1), rex(0), off(0), off(1), rex(1), off(1), off(0), rex(0), rex(1)].map((characters) =>
      sources.receive(characters),
    );
    expect(sentences.filter((sentence) => sentence !== "")).toEqual(["Mira (tracker of Rex) is lost."]);
  });

  it("are not told while their source sends, as with another measure", () => {
    const sources = new LostSources();
    const sending = sendingOf([{ name: "Mira 10.0.0.7", found: true, rate: 30 }] as never);
    expect([1, 0, 1].map((trust) => sources.receive(rex(trust), sending))).toEqual(["", "", ""]);
    const blind = sendingOf([{ name: "Mira 10.0.0.7", found: false, rate: 30 }] as never);
    expect([1, 0].map((trust) => sources.receive(rex(trust), blind))).toEqual(["", "Mira (tracker of Rex) is lost."]);
  });
});
