/** The console page: links the show to a desk, and a desk to the instrument. */

import { FaceView } from "../face/face_view";
import type { Shot } from "../face/framing";
import { resting } from "../face/pose/pose";
import { Library } from "../link/assets";
import { Link } from "../link/show_link";
import { Painter } from "../ui/frame_painter";
import { PICTURE, Portraits, type Studio } from "../ui/thumbnails";
import { ConsolePage } from "./console_page";
import type { Rig } from "./controls/console_element";
import { Desk } from "./store/console_store";
import { LayoutKeeper, layoutName } from "./store/layout_sync";

/** Close on brows, eyes and mouth: what tells one expression from another on a picture as small as a thumb. */
const THUMB: Shot = { centre: [0, -0.014, 0.05], height: 0.185, width: 0.185 };

/** A name for this console, so that its calls have their own ids; `randomUUID` is not there on a LAN without https. */
const consoleId = (): string =>
  [...crypto.getRandomValues(new Uint32Array(2))].map((part) => part.toString(36)).join("");

/** What the page has fetched of the cast; none before the server has answered. */
let library: Library | null = null;
/** It may be another than was fetched: the server said so meanwhile. */
let stale = false;

/** The cast is another: takes it in and goes on; a page of another built-in cast must begin anew. */
async function recast(desk: Desk): Promise<void> {
  stale = library === null;
  if (library === null) return;
  if (!(await library.renew())) location.reload();
  else if (library.manifest !== desk.manifest) desk.setManifest(library.manifest);
}

function connect(): { desk: Desk; link: Link } {
  const desk: Desk = new Desk(
    (message) => link.send(message),
    () => performance.now(),
    consoleId(),
  );
  const link = new Link("console", {
    welcome: ({ digest }) => {
      if (desk.manifest !== null && desk.manifest.digest !== digest) void recast(desk);
    },
    cast: () => void recast(desk),
    state: (state) => desk.receiveState(state),
    crew: (crew) => desk.receiveCrew(crew),
    kept: (kept) => desk.receiveKept(kept),
    refused: (reason) => desk.say(reason),
    connected: (up) => desk.setOnline(up),
    trip: (seconds) => desk.receiveTrip(seconds * 1000),
  });
  return { desk, link };
}

/** Thumbnails by one view on a canvas of its own: one graphics context for all of them. */
async function openStudio(library: Library): Promise<Studio> {
  const view = await FaceView.load(document.createElement("canvas"), library, { shot: THUMB, pixelRatio: 1 });
  view.resize(PICTURE.width, PICTURE.height);
  return async ({ face, expression }) => {
    await view.present(resting(face, expression));
    if (!view.alive) throw new Error("the graphics context is lost for a moment");
    return createImageBitmap(view.canvas);
  };
}

/** Keeps a tablet's screen on while the page is seen; only where the browser allows it (https or this machine). */
function stayAwake(): void {
  const ask = (): void => {
    if (document.visibilityState === "visible") navigator.wakeLock?.request("screen").catch(() => undefined);
  };
  document.addEventListener("visibilitychange", ask);
  ask();
}

async function start(): Promise<void> {
  const { desk, link } = connect();
  const rig: Rig = { desk, painter: new Painter(), portraits: new Portraits() };
  rig.painter.add({ paint: () => rig.desk.flush() }); // first in each frame, so that what was drawn is what was sent
  const page = new ConsolePage();
  page.rig = rig;
  document.body.append(page);
  rig.painter.start();
  stayAwake();
  library = await Library.open();
  await new LayoutKeeper(desk, layoutName(location.search), (message) => link.send(message)).open();
  desk.setManifest(library.manifest);
  if (stale) void recast(rig.desk);
  await page.open(library);
  openStudio(library).then(
    (studio) => rig.portraits.open(studio),
    (error: unknown) => console.warn("No thumbnails:", error), // names and hot keys are enough to play
  );
}

void start();
