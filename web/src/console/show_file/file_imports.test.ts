import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { FromClient } from "../../link/messages";
import type { TakenIn } from "../../ui/file_import";
import { LongRequests } from "../../ui/long_requests";
import { ConsoleStore } from "../store/console_store";
import { FileImports } from "./file_imports";
import { OwnItems } from "./own_items";

const GRIN: TakenIn = { kind: "expression", name: "grin", label: "Grin", known: false };
const file = (name: string) => new File(["words"], name);
const brings = (...items: TakenIn[]) =>
  Response.json({ items, said: items.map(({ label }) => `${label}, from a.json`) });

let sent: FromClient[];
let store: ConsoleStore;
let requests: LongRequests;
let imports: FileImports;
/** The names of the files that the show was sent, and what answers them in turn. */
let receivedFiles: string[];
let answers: ((response: Response) => void)[];

beforeEach(() => {
  [sent, receivedFiles, answers] = [[], [], []];
  store = new ConsoleStore(
    (message) => sent.push(message),
    () => 0,
    "me",
  );
  store.setOnline(true);
  requests = new LongRequests();
  requests.send = (message) => sent.push(message) > 0;
  imports = new FileImports(store, new OwnItems(store, () => 0), requests);
  vi.stubGlobal("fetch", (_: string, { body }: { body: File }) => {
    receivedFiles.push(body.name);
    return new Promise<Response>((done) => answers.push(done));
  });
});
afterEach(() => vi.unstubAllGlobals());

describe("files that come in", () => {
  it("go one after the other, and tell how far the one under way is", async () => {
    const all = imports.add([file("a.json"), file("b.glb")], "expression");
    expect(imports.running).toMatchObject({ file: "a.json", waiting: 1 });
    const request = imports.running?.request?.id as string;
    requests.receive({ type: "progress", request, what: "smile", done: 3, total: 51 });
    expect(imports.running?.request).toMatchObject({ what: "smile", done: 3, total: 51 });
    await imports.add([file("c.json")], "expression");
    expect([receivedFiles, imports.running?.waiting]).toEqual([["a.json"], 2]);
    answers[0]?.(brings(GRIN));
    for (const next of [1, 2]) {
      await expect.poll(() => receivedFiles.length).toBe(next + 1);
      answers[next]?.(new Response("it is no expression.", { status: 400 }));
    }
    await all;
    expect(receivedFiles).toEqual(["a.json", "b.glb", "c.json"]);
    expect(imports.running).toBeNull();
    expect(store.logEntries.map(({ text }) => text)).toEqual([
      "Taken in, under Own: Grin, from a.json.",
      "b.glb was not taken in: it is no expression. Faces come in by Set-up or the editor.",
      "c.json was not taken in: it is no expression. Faces come in by Set-up or the editor.",
    ]);
    store.undo();
    expect(sent.at(-1)).toMatchObject({ type: "delete_item", name: "grin" });
  });

  it.each(["in time", "late"])("are ended %s, those that wait are not sent, and what came in is told", async (when) => {
    const all = imports.add([file("a.glb"), file("b.glb")], "face");
    const request = imports.running?.request?.id;
    imports.cancel();
    expect(sent.at(-1)).toEqual({ type: "cancel", request });
    expect(imports.running).toMatchObject({ waiting: 0, request: { ending: true } });
    answers[0]?.(when === "late" ? brings(GRIN) : new Response(null, { status: 204 }));
    await all;
    expect(store.notice).toMatch(when === "late" ? /^Taken in/ : /^Import of a.glb: cancelled/);
    expect([receivedFiles, imports.running]).toEqual([["a.glb"], null]);
    imports.cancel();
    expect(sent).toHaveLength(1);
  });

  it("are not ended while the link is lost, and that is told", async () => {
    const all = imports.add([file("a.glb")], "face");
    requests.send = () => false;
    imports.cancel();
    expect(store.notice).toMatch(/^Not cancelled/);
    answers[0]?.(brings(GRIN));
    await all;
  });

  it("that are there already are told of, and both are kept only where one says so", async () => {
    const all = imports.add([file("a.json")], "expression");
    answers[0]?.(brings({ ...GRIN, known: true }));
    await all;
    expect(store.notice).toBe("Nothing new in a.json: Grin is there already.");
    expect([sent, store.history.next("undo")]).toEqual([[], null]);
    const [both] = store.offers;
    if (both !== undefined && "act" in both) both.act();
    expect(sent).toMatchObject([{ type: "copy_item", kind: "expression", name: "grin" }]);
  });
});
