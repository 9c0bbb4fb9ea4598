/** The console page: links the show to a desk, and a desk to the instrument. */

import { Library } from "../link/assets";
import { Link } from "../link/socket";
import { CLOSE, FaceView } from "../stage/face_view";
import { resting } from "../stage/pose";
import { ConsolePage } from "./console_page";
import { Desk } from "./desk";
import type { Rig } from "./element";
import { Painter } from "./painter";
import { Portraits, type Studio } from "./portraits";

/** A name for this console, so that its calls have their own ids; `randomUUID` is not there on a LAN without https. */
const consoleId = (): string =>
  [...crypto.getRandomValues(new Uint32Array(2))].map((part) => part.toString(36)).join("");

function connect(): Desk {
  const desk: Desk = new Desk(
    (message) => link.send(message),
    () => performance.now(),
    consoleId(),
  );
  const link = new Link("console", {
    state: (state) => desk.receiveState(state),
    crew: (crew) => desk.receiveCrew(crew),
    refused: (reason) => desk.say(reason),
    connected: (up) => desk.setOnline(up),
    trip: (seconds) => desk.receiveTrip(seconds * 1000),
  });
  return desk;
}

/** Thumbnails by one view on a canvas of its own: one graphics context for all of them. */
async function openStudio(library: Library): Promise<Studio> {
  const view = await FaceView.load(document.createElement("canvas"), library, { shot: CLOSE, pixelRatio: 1 });
  view.resize(100, 120);
  return async ({ face, expression }) => {
    await view.present(resting(face, expression));
    return view.canvas;
  };
}

async function start(): Promise<void> {
  const rig: Rig = { desk: connect(), painter: new Painter(), portraits: new Portraits() };
  rig.painter.add({ paint: () => rig.desk.flush() }); // first in each frame, so that what was drawn is what was sent
  const page = new ConsolePage();
  page.rig = rig;
  document.body.append(page);
  rig.painter.start();
  const library = await Library.open();
  rig.desk.setManifest(library.manifest);
  await page.open(library);
  rig.portraits.open(await openStudio(library));
}

void start();
