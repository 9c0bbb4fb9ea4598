/** The editor page: authored once, played on every face. */

import { showAccess } from "../access/access_banner";
import { missingRole, readAccess } from "../access/page_access";
import { Library } from "../link/assets";
import { askedItem, editorAddress } from "../link/editor_address";
import { keep, randomId, readKept } from "../ui/browser_storage";
import { LongRequestsView } from "../ui/long_requests_view";
import { loadPortraits } from "../ui/portraits";
import { ShowNoticesView } from "../ui/show_notices_view";
import { THUMBNAIL_SIZE, Thumbnails } from "../ui/thumbnails";
import type { EditorContext } from "./controls/editor_element";
import { EditorPage } from "./editor_page";
import { EditorLink, type Identity } from "./link/editor_link";
import { DraftStore } from "./session/draft_store";
import { openItem } from "./session/item_commands";
import { ThumbnailRenderer } from "./session/thumbnail_renderer";
import { keepViewSettings } from "./session/view_settings";

/** Pixels of a thumbnail as it is drawn, somewhat less than it is shown at: what is shown first is usable first. */
const SMALL = { width: Math.round(0.75 * THUMBNAIL_SIZE.width), height: Math.round(0.75 * THUMBNAIL_SIZE.height) };

/** Milliseconds between two drawings, and after which one is made even where the page never rests. */
const PAUSE = 60;
const PATIENCE = 1000;

/** Where the browser keeps who sits at this page: an id, so that a reload finds its draft, and a name for the others. */
const ID = "omote-editor";
const NAME = "omote-editor-name";
const BROWSER = (): Storage => localStorage;

let pressed = false;
for (const kind of ["pointerdown", "pointerup", "pointercancel"] as const)
  globalThis.addEventListener?.(
    kind,
    () => {
      pressed = kind === "pointerdown";
    },
    true,
  );

/** Waits until no hand holds anything, no answer is to come, and the page has nothing else to do. */
async function whenIdle(store: DraftStore): Promise<void> {
  do {
    await new Promise((done) => setTimeout(done, PAUSE));
    if ("requestIdleCallback" in globalThis)
      await new Promise((done) => requestIdleCallback(done, { timeout: PATIENCE }));
  } while (pressed || store.dragging || store.waiting);
}

/** Keeps the cast as new as the items: what has been saved is there to begin from, to wear, to lay under. */
function followCast(store: DraftStore): void {
  let last = "";
  store.listen("items", () => {
    const { library, digest } = store;
    if (library === null || digest === "" || digest === last) return;
    last = digest;
    void library.renew().then((same) => {
      if (same) store.setCast(library);
      else location.reload(); // a server with another built-in cast
    });
  });
}

/** The address names the open item, so that a reload opens it again. */
function followAddress(store: DraftStore): void {
  let asked = askedItem(location);
  if (asked !== null) store.setOpening(asked.name); // until the show has told what there is
  const follow = (): void => {
    const { item } = store;
    if (item !== null) history.replaceState(null, "", editorAddress(item.kind, item.name));
  };
  store.listen("draft", follow);
  store.listen("items", follow); // the list tells of a new item only after its draft has come
  store.listen("items", () => {
    const wanted = asked;
    if (wanted === null) return;
    const item = store.items.find(
      ({ kind, name, deleted }) => name === wanted.name && kind === (wanted.kind ?? kind) && !deleted,
    );
    asked = null; // once, at the first greeting
    store.setOpening("");
    if (item === undefined) store.say(`There is no ${wanted.kind ?? "item"} "${wanted.name}" in this show any more.`);
    else if (store.draft === null) void openItem(store, item.id);
  });
}

/** Two windows of one browser are one editor: they share their drafts. Where nothing is kept, each load is a new one. */
function readIdentity(): Identity {
  const editor = readKept(BROWSER, ID) || randomId();
  keep(BROWSER, ID, editor);
  return { editor, name: readKept(BROWSER, NAME) || `Editor ${editor.slice(-3).toUpperCase()}` };
}

function connect(shown: ShowNoticesView): { store: DraftStore; link: EditorLink; name: () => string } {
  const who = readIdentity();
  let { name } = who;
  const store: DraftStore = new DraftStore((request) => link.ask(request));
  const link = new EditorLink(who, {
    greeted: (greeted) => store.receive(greeted),
    message: (message) => {
      if (message.type === "notices") shown.notices.receive(message.notices);
      else if (message.type === "progress") store.longRequests.receive(message);
      else if (message.type !== "draft" || message.item === store.draft?.item) store.receive(message); // of what is open
    },
    connected: (up) => store.setOnline(up),
    revoked: () => location.reload(), // the server then asks for another token
  });
  store.longRequests.send = (message) => link.cancel(message);
  const rename = link.rename.bind(link);
  link.rename = (next: string) => {
    name = next;
    keep(BROWSER, NAME, next);
    rename(next);
  };
  return { store, link, name: () => name };
}

async function start(): Promise<void> {
  const shown = new ShowNoticesView();
  const { store, link, name } = connect(shown);
  keepViewSettings(store);
  followCast(store);
  followAddress(store);
  let thumbnailRenderer: ThumbnailRenderer | null = null;
  const thumbnails = new Thumbnails(() => whenIdle(store));
  void loadPortraits().then((portraits) => thumbnails.give(portraits));
  const context: EditorContext = {
    store,
    thumbnails,
    thumbnailRenderer: () => thumbnailRenderer,
    name,
    rename: (next) => link.rename(next),
  };
  const page = new EditorPage();
  page.context = context;
  shown.classList.add("in-page");
  page.notices = shown;
  document.getElementById("loading")?.remove();
  document.body.append(page, new LongRequestsView(store.longRequests));
  void readAccess().then((access) => showAccess(missingRole(access, "edit", "editing")));
  store.setCast(await Library.open());
  thumbnailRenderer = await ThumbnailRenderer.open(store.library as Library);
  thumbnails.open((sitting) => (thumbnailRenderer as ThumbnailRenderer).picture(sitting, SMALL.width, SMALL.height));
}

void start();
