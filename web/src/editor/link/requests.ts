/** What an editor asks of the server, and what it is answered. */

import type { Cancel, FromEditor, Greet, ToEditor } from "../../link/editing_messages";

type Unnumbered<R> = R extends unknown ? Omit<R, "request"> : never;
/** A request before the link has numbered it. */
export type Request = Unnumbered<Exclude<FromEditor, Greet | Cancel>>;
/** What a request is answered with when it is not refused. */
export type EditorAnswer = Exclude<ToEditor, { type: "greeted" | "items" | "refused" | "progress" }>;
type Part<R> = R extends { item: number } ? Omit<R, "item"> : never;
/** A request about the open item, before the store has named it. */
export type ItemChange = Part<Request>;
/** Sends a request; rejects with a sentence when it is refused or cannot be sent. */
export type Ask = (request: Request) => Promise<EditorAnswer>;
