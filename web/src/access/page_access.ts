/** Who this page is to the show, and the tokens of its people, for an admin. */

import { decode, encode } from "@msgpack/msgpack";
import { ACCESS_ROLES } from "../link/constants";
import type { AccessDocument, CodeDocument, NewPerson, PeopleDocument, PersonDocument } from "../link/messages";

export type AccessRole = AccessDocument["role"];

/** A show that asks nobody. */
const OPEN: AccessDocument = { role: "admin", name: "", asked: false };

/** Whether a role may do what needs another. */
export const roleAllows = (held: AccessRole, needed: AccessRole): boolean =>
  ACCESS_ROLES.indexOf(held) >= ACCESS_ROLES.indexOf(needed);

/** Who this page is; where the server does not say, its rejections will. */
export async function readAccess(request: typeof fetch = fetch): Promise<AccessDocument> {
  try {
    const answer = await request("/access", { cache: "no-store" });
    return answer.ok ? (decode(await answer.arrayBuffer()) as AccessDocument) : OPEN;
  } catch {
    return OPEN;
  }
}

/** What a page says of a role that may not do all that the page is for; null where it may. */
export function missingRole({ role, name, asked }: AccessDocument, needed: AccessRole, what: string): string | null {
  if (!asked || roleAllows(role, needed)) return null;
  const who = name === "" ? "" : `, ${name}`;
  return `You are here with the role "${role}"${who}: ${what} needs "${needed}". Ask whoever runs the show for a token.`;
}

/** The list of people, changed over HTTP; every method throws an Error with a sentence where the show says no. */
export class PeopleList {
  constructor(private readonly request: typeof fetch = fetch) {}

  async read(): Promise<PersonDocument[]> {
    return (await this.#ask<PeopleDocument>("/people", {})).people;
  }

  make(person: NewPerson): Promise<CodeDocument> {
    return this.#ask<CodeDocument>("/people", { method: "POST", body: encode(person) as Uint8Array<ArrayBuffer> });
  }

  async revoke(id: string): Promise<PersonDocument[]> {
    return (await this.#ask<PeopleDocument>(`/people/${encodeURIComponent(id)}`, { method: "DELETE" })).people;
  }

  code(id: string): Promise<CodeDocument> {
    return this.#ask<CodeDocument>(`/people/${encodeURIComponent(id)}/code`, {});
  }

  async #ask<Answer>(address: string, options: RequestInit): Promise<Answer> {
    const request = this.request;
    const answer = await request(address, { cache: "no-store", ...options }).catch(() => null);
    if (answer === null) throw new Error("The show did not answer; try again.");
    if (!answer.ok) throw new Error(await answer.text());
    return decode(await answer.arrayBuffer()) as Answer;
  }
}
