import { expect, it } from "vitest";
import { DIRECTIONS, type DirectionName, directionAt, nextWanted } from "./turn_directions";
import { guideTo } from "./turn_words";

const all = (): Set<DirectionName> => new Set(DIRECTIONS.map(({ name }) => name));
const only = (name: DirectionName) => new Set([name]);

it("asks for the front first, then once to the left and over to the right", () => {
  const [wanted, asked] = [all(), [] as string[]];
  for (let next = nextWanted(wanted); next !== null; next = nextWanted(wanted)) {
    asked.push(next.name);
    wanted.delete(next.name);
  }
  expect(asked).toEqual(["front", "half left", "left", "half right", "right"]);
});

it("knows the direction of every yaw, none between two, and both sides alike", () => {
  for (const { name, yaw } of DIRECTIONS) expect(directionAt(yaw)?.name).toBe(name);
  expect([11, -11, 29.5, -29.5, 60, -60].map(directionAt)).toEqual(Array(6).fill(null));
  for (let yaw = 0; yaw < 60; yaw++) {
    const [left, right] = [directionAt(yaw), directionAt(-yaw)];
    expect(right?.name).toBe(left?.name.replace("left", "right"));
  }
});

it("says which way to turn, how far it still is, and when to hold still", () => {
  expect(guideTo(only("front"), 30)).toBe("Look straight into the camera.");
  expect(guideTo(only("left"), 0)).toBe("Turn your head slowly to your left.");
  expect(guideTo(only("half left"), 0)).toBe("Turn your head slowly to your left.");
  expect(guideTo(only("half left"), 42)).toBe("Turn your head slowly to your right."); // back from the left
  expect(guideTo(only("left"), 25)).toBe("A little further to your left.");
  expect(guideTo(only("left"), 55)).toBe("A little further to your right.");
  expect(guideTo(only("right"), -30)).toBe("A little further to your right.");
  for (const { name, yaw } of DIRECTIONS) expect(guideTo(only(name), yaw)).toBe("Hold still …");
  expect(guideTo(new Set<DirectionName>(["front", "left"]), 38)).toBe("Hold still …"); // whatever is asked for next
  expect(guideTo(new Set(), 0)).toBe("All are taken.");
});
