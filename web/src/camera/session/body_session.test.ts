import { expect, it } from "vitest";
import { BODY_NUMBERS, BODY_POINTS, VISIBLE } from "../../body/body_messages";
import { adviseOnBody, whatIsSeen } from "./body_session";

const body = (...hidden: number[]) => {
  const values = new Float32Array(BODY_NUMBERS * BODY_POINTS);
  for (let point = 0; point < BODY_POINTS; point++) values[BODY_NUMBERS * point + VISIBLE] = 0.9;
  for (const point of hidden) values[BODY_NUMBERS * point + VISIBLE] = 0.1;
  return whatIsSeen({ body: values });
};

it("says which arm is not seen, and nothing of hips, which most cameras do not see", () => {
  expect(adviseOnBody(body())).toBe("");
  expect(adviseOnBody(body(23, 24))).toBe("");
  expect(adviseOnBody(body(15))).toContain("Your left arm is not in the picture");
  expect(adviseOnBody(body(14))).toContain("Your right arm is");
  expect(adviseOnBody(body(15, 16))).toContain("Your arms are");
  expect(adviseOnBody(body(11))).toContain("No body is seen");
  expect(adviseOnBody(whatIsSeen({ body: new Float32Array() }))).toContain("No body is seen");
  expect(adviseOnBody(null)).toBe("");
});
