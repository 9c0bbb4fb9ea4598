import { decode, encode } from "@msgpack/msgpack";
import { expect, test } from "vitest";
import { ACCESS_ROLES } from "../link/constants";
import { missingRole, PeopleList, readAccess, roleAllows } from "./page_access";

const answering = (body: unknown, status = 200) => {
  const asked: [string, RequestInit | undefined][] = [];
  const request = (async (address: string, options?: RequestInit) => {
    asked.push([address, options]);
    return new Response(typeof body === "string" ? body : encode(body), { status });
  }) as typeof fetch;
  return { asked, request };
};

test("each role may do what those before it may", () => {
  for (const [i, held] of ACCESS_ROLES.entries())
    for (const [j, needed] of ACCESS_ROLES.entries()) expect(roleAllows(held, needed)).toBe(i >= j);
});

test("a page learns who it is, and goes on where nobody says", async () => {
  const ada = { role: "view", name: "Ada", asked: true };
  expect(await readAccess(answering(ada).request)).toEqual(ada);
  expect((await readAccess(answering("no", 500).request)).asked).toBe(false);
  expect((await readAccess((() => Promise.reject(new Error("gone"))) as typeof fetch)).asked).toBe(false);
});

test("who may not is told both roles, and nobody else is told anything", () => {
  const said = missingRole({ role: "view", name: "Ada", asked: true }, "operate", "playing");
  expect(said).toContain('"view", Ada');
  expect(said).toContain('needs "operate"');
  expect(missingRole({ role: "edit", name: "", asked: true }, "operate", "playing")).toBeNull();
  expect(missingRole({ role: "view", name: "", asked: false }, "operate", "playing")).toBeNull();
});

test("tokens are made, shown and revoked", async () => {
  const code = { id: "a/b", address: "http://10.0.0.7/", picture: "data:," };
  const { asked, request } = answering(code);
  const wish = { name: "Ada", role: "operate", hours: null } as const;
  expect(await new PeopleList(request).make(wish)).toEqual(code);
  expect(decode(asked[0]?.[1]?.body as Uint8Array)).toEqual(wish);
  await new PeopleList(request).code("a/b");
  expect(asked[1]?.[0]).toBe("/people/a%2Fb/code");
  const left = answering({ people: [] });
  expect(await new PeopleList(left.request).revoke("x")).toEqual([]);
  expect(left.asked[0]?.[1]?.method).toBe("DELETE");
});

test("the show's own sentence is what an admin reads", async () => {
  await expect(new PeopleList(answering("there is one already.", 409).request).read()).rejects.toThrow("one already");
  const silent = (() => Promise.reject(new Error("gone"))) as typeof fetch;
  await expect(new PeopleList(silent).read()).rejects.toThrow("did not answer");
});
