import { afterEach, expect, it, vi } from "vitest";
import { readPhotograph, smaller } from "./photograph_files";

afterEach(() => vi.unstubAllGlobals());

it("makes what is large smaller, with its shape, and leaves what is not", () => {
  expect(smaller(640, 480)).toEqual([640, 480]);
  expect(smaller(2048, 1)).toEqual([2048, 1]);
  expect(smaller(4000, 3000)).toEqual([2048, 1536]);
  expect(smaller(3000, 4000)).toEqual([1536, 2048]);
  expect(smaller(20000, 2)).toEqual([2048, 1]);
});

it("says of a file that is no picture what to do", async () => {
  vi.stubGlobal("createImageBitmap", () => Promise.reject(new Error("no")));
  const decode = vi.fn(() => Promise.resolve(new Blob()));
  await expect(readPhotograph(new File(["x"], "anna.heic"), decode)).rejects.toThrow("anna.heic is no picture");
  expect(decode).toHaveBeenCalledOnce();
  const refused = (): Promise<Blob> => Promise.reject(new Error("anna.heic: cut off"));
  await expect(readPhotograph(new File(["x"], "anna.heic"), refused)).rejects.toThrow("cut off");
});
