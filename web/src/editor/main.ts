/** The editor page: authored once, played on every face. */

import { PICTURE, Portraits } from "../console/portraits";
import { Library } from "../link/assets";
import { openItem } from "./deeds";
import { EditingLink } from "./editing_link";
import { EditorPage } from "./editor_page";
import type { EditorRig } from "./element";
import { Studio } from "./studio";
import { keepName, whoIsHere } from "./who";
import { Workbench } from "./workbench";

/** Milliseconds between two thumbnails; none is begun while a hand drags. */
const PAUSE = 60;

/** Waits until drawing something small would disturb nobody. */
async function idle(bench: Workbench): Promise<void> {
  do await new Promise((done) => setTimeout(done, PAUSE));
  while (bench.dragging || bench.waiting);
}

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
  let opening = location.hash.slice(1);
  bench.listen("draft", () => {
    const name = bench.item?.name;
    if (name !== undefined) history.replaceState(null, "", `#${name}`);
  });
  bench.listen("items", () => {
    const item = bench.items.find(({ name, deleted }) => name === opening && !deleted);
    opening = ""; // once, at the first greeting
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
  portraits.open((sitting) => (studio as Studio).picture(sitting, PICTURE.width, PICTURE.height));
}

void start();
