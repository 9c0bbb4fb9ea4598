import { expect, it } from "vitest";
import { listenWord, sendWord } from "./switch_words";

it("spells a tracker as the command line does", () => {
  expect(listenWord("vmc", 39539, 39539, "")).toBe("vmc");
  expect(listenWord("vmc", 5000, 39539, " ")).toBe("vmc:5000");
  expect(listenWord("ifacialmocap", 49983, 49983, " 192.168.1.30 ")).toBe("ifacialmocap@192.168.1.30");
  expect(listenWord("mediapipe", null, null, "")).toBe("mediapipe");
});

it("spells a receiver as the command line does", () => {
  expect(sendWord("livelink", " 10.0.0.5", 11111, "")).toBe("livelink:10.0.0.5:11111");
  expect(sendWord("vmc", "10.0.0.5", 39539, "dog")).toBe("vmc:10.0.0.5:39539=dog");
});
