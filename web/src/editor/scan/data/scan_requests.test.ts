import { encode } from "@msgpack/msgpack";
import { afterEach, describe, expect, it, vi } from "vitest";
import { CancelledError, LongRequests } from "../../../ui/long_requests";
import type { SeenScan } from "./scan_document";
import { bringScan, dropScan, fitAgain, sentence, takeFace } from "./scan_requests";

const SCAN = { token: "t" } as SeenScan;
const EMPTY = new Uint8Array();
const SENT = {
  token: "t",
  file: "anna.ply",
  placement: [1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0],
  unit: "metres",
  doubts: [],
  notes: [],
  given: {},
  found: {},
  positions: EMPTY,
  triangles: EMPTY,
  colours: EMPTY,
  face: null,
  residual: null,
  figures: null,
  shut: null,
  hair_style: "",
  hair: "#000000",
};

function answering(...answers: (() => Response)[]) {
  const asked = vi.fn(async (_address: string, _options?: RequestInit) => (answers.shift() as () => Response)());
  vi.stubGlobal("fetch", asked);
  return asked;
}

afterEach(() => vi.unstubAllGlobals());

describe("what is asked of the server", () => {
  it("brings all files at once, and what comes back is read", async () => {
    const asked = answering(() => new Response(encode(SENT)));
    const files = ["anna.obj", "anna.mtl"].map((name) => new File(["x"], name));
    const scan = await bringScan(files, new LongRequests());
    const [address, options] = asked.mock.calls[0] as [string, RequestInit];
    expect(address).toMatch(/^\/scans\?request=/);
    const names = [...(options.body as FormData).getAll("file")].map((file) => (file as File).name);
    expect(names).toEqual(["anna.obj", "anna.mtl"]);
    expect(scan.file).toBe("anna.ply");
  });

  it("sends points and what is said of the eyes, and as what the face is taken", async () => {
    const taken = { items: [{ name: "anna_2", label: "Anna 2" }] };
    const asked = answering(
      () => new Response(encode(SENT)),
      () => Response.json(taken),
    );
    await fitAgain(SCAN, { nose_tip: [1, 2, 3] }, true, new LongRequests());
    const taking = { label: "Anna", hair_style: "", hair: "#112233", replaced: 3 };
    expect(await takeFace(SCAN, taking, new LongRequests())).toEqual({ name: "anna_2", label: "Anna 2" });
    const bodies = asked.mock.calls.map(([, options]) => JSON.parse(String(options?.body)));
    expect(bodies).toEqual([{ points: { nose_tip: [1, 2, 3] }, shut: true }, taking]);
    expect(asked.mock.calls.map(([address]) => address.split("?")[0])).toEqual(["/scans/t", "/scans/t/face"]);
  });

  it("tells in sentences what is refused, and what was cancelled as that", async () => {
    answering(
      () => new Response("anna.ply: the file is empty", { status: 400 }),
      () => new Response(null, { status: 204 }),
    );
    const bring = (): Promise<SeenScan> => bringScan([new File([], "anna.ply")], new LongRequests());
    await expect(bring()).rejects.toThrow("anna.ply: the file is empty.");
    await expect(bring()).rejects.toThrow(CancelledError);
    vi.stubGlobal("fetch", () => Promise.reject(new TypeError("gone")));
    await expect(bring()).rejects.toThrow("does not answer");
  });

  it("throws a scan away though the page closes", () => {
    const asked = answering(() => new Response(null, { status: 204 }));
    dropScan(SCAN);
    expect(asked).toHaveBeenCalledWith("/scans/t", { method: "DELETE", keepalive: true });
  });

  it("makes sentences of what the server says", () => {
    expect(sentence("there is no hair")).toBe("There is no hair.");
    expect(sentence("Done!")).toBe("Done!");
    expect(sentence("notes.ply: the file is no PLY")).toBe("notes.ply: the file is no PLY.");
  });
});
