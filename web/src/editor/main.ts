/** The editor page: authored once, played on every face. */

import { Library } from "../link/assets";
import { askedItem, editorAddress } from "../link/editor_address";
import { PICTURE, Portraits } from "../ui/thumbnails";
import type { EditorRig } from "./controls/editor_element";
import { EditorPage } from "./editor_page";
import { EditingLink } from "./link/editor_link";
import { keepName, whoIsHere } from "./link/identity";
import { Workbench } from "./session/draft_store";
import { idle } from "./session/idle_queue";
import { openItem } from "./session/item_commands";
import { Studio } from "./session/thumbnail_renderer";
import { keepView } from "./session/view_settings";

/** Pixels of a thumbnail as it is drawn, somewhat less than it is shown at: what is shown first is usable first. */
const SMALL = { width: Math.round(0.75 * PICTURE.width), height: Math.round(0.75 * PICTURE.height) };

/** Keeps the cast as new as the items: what has been saved is there to begin from, to wear, to lay under. */
function followCast(bench: Workbench): void {
  let last = "";
  bench.listen("items", () => {
    const { library, digest } = bench;
    if (library === null || digest === "" || digest === last) return;
    last = digest;
    void library.renew().then((same) => {
      if (same) bench.setCast(library);
      else location.reload(); // a server with another built-in cast
    });
  });
}

/** The address names the open item, so that a reload opens it again. */
function followAddress(bench: Workbench): void {
  let asked = askedItem(location);
  const follow = (): void => {
    const { item } = bench;
    if (item !== null) history.replaceState(null, "", editorAddress(item.kind, item.name));
  };
  bench.listen("draft", follow);
  bench.listen("items", follow); // the list tells of a new item only after its draft has come
  bench.listen("items", () => {
    const wanted = asked;
    if (wanted === null) return;
    const item = bench.items.find(
      ({ kind, name, deleted }) => name === wanted.name && kind === (wanted.kind ?? kind) && !deleted,
    );
    asked = null; // once, at the first greeting
    if (item !== undefined && bench.draft === null) void openItem(bench, item.id);
  });
}

function connect(): { bench: Workbench; link: EditingLink; name: () => string } {
  const who = whoIsHere();
  let { name } = who;
  const bench: Workbench = new Workbench((request) => link.ask(request));
  const link = new EditingLink(who, {
    greeted: (greeted) => bench.receive(greeted),
    message: (message) => bench.receive(message),
    connected: (up) => bench.setOnline(up),
  });
  const rename = link.rename.bind(link);
  link.rename = (next: string) => {
    name = next;
    keepName(next);
    rename(next);
  };
  return { bench, link, name: () => name };
}

async function start(): Promise<void> {
  const { bench, link, name } = connect();
  keepView(bench);
  followCast(bench);
  followAddress(bench);
  let studio: Studio | null = null;
  const portraits = new Portraits(() => idle(bench));
  const rig: EditorRig = { bench, portraits, studio: () => studio, name, rename: (next) => link.rename(next) };
  const page = new EditorPage();
  page.rig = rig;
  document.body.append(page);
  bench.setCast(await Library.open());
  studio = await Studio.open(bench.library as Library);
  portraits.open((sitting) => (studio as Studio).picture(sitting, SMALL.width, SMALL.height));
}

void start();
