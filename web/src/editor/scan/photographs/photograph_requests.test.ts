import { encode } from "@msgpack/msgpack";
import { afterEach, expect, it, vi } from "vitest";
import { LongRequests } from "../../../ui/long_requests";
import { PhotographPoints } from "./photograph_points";
import { bringPhotographs, fitPhotographsAgain } from "./photograph_requests";

const bytes = (values: Float32Array | Uint32Array): Uint8Array => new Uint8Array(values.buffer);
const SENT = {
  token: "t",
  doubts: ["Look."],
  off: [1.5],
  spread: 4.25,
  seen: 0.5,
  positions: bytes(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0])),
  triangles: bytes(new Uint32Array([0, 1, 2])),
  colours: new Uint8Array([9, 9, 9, 8, 8, 8, 7, 7, 7]),
  face: bytes(new Float32Array(9)),
  shown: new Uint8Array([0, 1, 255]),
  hair_style: "bob",
  hair: "#123456",
};
const points = (): PhotographPoints =>
  new PhotographPoints([
    {
      name: "anna.png",
      file: "1.jpg",
      picture: new Blob(["picture"]),
      address: "",
      width: 640,
      height: 480,
      points: new Float32Array([1 / 3, 0.5, -0.25, 0, 1, 2]),
    },
  ]);
const DESCRIBED = [
  {
    file: "1.jpg",
    name: "anna.png",
    width: 640,
    height: 480,
    points: [
      [0.33333, 0.5, -0.25],
      [0, 1, 2],
    ],
  },
];

function answering() {
  const asked = vi.fn(async (_address: string, _options?: RequestInit) => new Response(encode(SENT)));
  vi.stubGlobal("fetch", asked);
  return asked;
}

afterEach(() => vi.unstubAllGlobals());

it("brings pictures and their landmarks together, and reads what is shown", async () => {
  const asked = answering();
  const seen = await bringPhotographs(points(), new LongRequests());
  const [address, options] = asked.mock.calls[0] as [string, RequestInit];
  expect(address).toMatch(/^\/photographs\?request=/);
  const files = [...(options.body as FormData).getAll("file")] as File[];
  expect(files.map(({ name }) => name)).toEqual(["1.jpg", "landmarks.json"]);
  expect(JSON.parse(await (files[1] as File).text())).toEqual(DESCRIBED);
  expect(seen.surface.normals).toEqual(new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1]));
  expect(seen.face.residual).toEqual(new Float32Array([Number.NaN, 0, 0]));
  expect([seen.token, seen.spread, seen.seen, seen.hair.style]).toEqual(["t", 4.25, 0.5, "bob"]);
});

it("sends landmarks alone for another fit", async () => {
  const asked = answering();
  const seen = await bringPhotographs(points(), new LongRequests());
  await fitPhotographsAgain(seen, points(), new LongRequests());
  const [address, options] = asked.mock.calls[1] as [string, RequestInit];
  expect(address).toMatch(/^\/photographs\/t\?request=/);
  expect(JSON.parse(String(options.body))).toEqual(DESCRIBED);
});
