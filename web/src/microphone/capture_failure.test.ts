import { describe, expect, it } from "vitest";
import { explainFailure, explainMissing } from "./capture_failure";

describe("a microphone that cannot be heard", () => {
  it("says what to do, by the error of the browser", () => {
    for (const name of ["NotAllowedError", "NotFoundError", "OverconstrainedError", "NotReadableError", "AbortError"])
      expect(explainFailure(new DOMException("", name))).toMatch(/press Start again|plug it in anew|Press Start again/);
    expect(explainFailure(new Error("odd"))).toContain("odd");
    expect(explainFailure("odd")).toContain("odd");
  });

  it("says that a page is not secure, or that a browser is too old", () => {
    expect(explainMissing({ isSecureContext: false, mediaDevices: undefined }, "http://10.0.0.2:8090")).toMatch(
      /http:\/\/10\.0\.0\.2:8090 is none.*--https/,
    );
    expect(explainMissing({ isSecureContext: true, mediaDevices: undefined }, "")).toContain("current Chrome");
    expect(explainMissing({ isSecureContext: true, mediaDevices: {} }, "")).toBeNull();
  });
});
