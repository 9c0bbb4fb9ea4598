import { afterEach, describe, expect, it, vi } from "vitest";
import type { Cancel } from "../link/messages";
import { CancelledError, LongRequests, progressWords } from "./long_requests";

afterEach(() => vi.unstubAllGlobals());

/** A server that answers when it is told to. */
function serve() {
  const asked: string[] = [];
  const answers: ((response: Response) => void)[] = [];
  vi.stubGlobal("fetch", (address: string) => {
    asked.push(address);
    return new Promise<Response>((done) => answers.push(done));
  });
  return { asked, answer: (response: Response) => answers.shift()?.(response) };
}

describe("a long request", () => {
  it("is shown with its progress until it is answered", async () => {
    const { asked, answer } = serve();
    const requests = new LongRequests();
    let changes = 0;
    const deaf = requests.listen(() => (changes += 1));
    const done = requests.fetch("Import of a.glb", "/imports/a.glb?as=face", {});
    const id = requests.all[0]?.id ?? "";
    expect(asked).toEqual([`/imports/a.glb?as=face&request=${id}`]);
    requests.receive({ type: "progress", request: "another's", done: 1, total: 2, what: "cry" });
    requests.receive({ type: "progress", request: id, done: 1, total: 3, what: "smile" });
    expect(requests.all).toEqual([{ id, title: "Import of a.glb", done: 1, total: 3, what: "smile", ending: false }]);
    answer(new Response("yes"));
    expect(await (await done)?.text()).toBe("yes");
    expect(requests.all).toEqual([]);
    expect(changes).toBe(3);
    deaf();
  });

  it("is ended over the link, and what was done before the end is done", async () => {
    const { answer } = serve();
    const requests = new LongRequests();
    const sent: Cancel[] = [];
    const [first, second] = [requests.fetch("A", "/a", {}), requests.fetch("B", "/b", {})];
    const [one, two] = requests.all.map(({ id }) => id) as [string, string];
    requests.cancel(one);
    expect(
      requests.all.some(({ ending }) => ending),
      "the link is lost: it can be tried again",
    ).toBe(false);
    requests.send = (message) => sent.push(message) > 0;
    requests.cancel(one);
    requests.cancel(two);
    expect(sent.map(({ request }) => request)).toEqual([one, two]);
    expect(requests.all.every(({ ending }) => ending)).toBe(true);
    answer(new Response(null, { status: 204 }));
    answer(new Response("in time"));
    await expect(first).rejects.toBeInstanceOf(CancelledError);
    expect(await (await second)?.text()).toBe("in time");
  });

  it("says how far it is", () => {
    const request = { id: "", title: "", done: 0, total: 0, what: "", ending: false };
    expect(progressWords(request)).toBe("It begins ...");
    expect(progressWords({ ...request, what: "the file is sent" })).toBe("the file is sent ...");
    expect(progressWords({ ...request, done: 1, total: 3, what: "smile" })).toBe("2 of 3: smile");
    expect(progressWords({ ...request, done: 3, total: 3, what: "the file is written" })).toBe("the file is written");
    expect(progressWords({ ...request, ending: true })).toContain("cancelled");
  });
});
