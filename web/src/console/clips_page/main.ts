/** The page of clips: connects the show to the store, and the store to the page. */

import { readAccess } from "../../access/page_access";
import { Library } from "../../link/assets";
import { type LinkHandlers, ShowLink } from "../../link/show_link";
import { randomId } from "../../ui/browser_storage";
import { FramePainter } from "../../ui/frame_painter";
import { WakeLock } from "../../ui/wake_lock";
import { ClipStore } from "../clips/clip_store";
import { PageMarks } from "../clips/page_marks";
import { ConsoleName } from "../console_name";
import { seatToken } from "../leases/seat_token";
import { ConsoleStore } from "../store/console_store";
import { ClipsPage } from "./clips_page";

const PAGE = randomId();
/** Who sits here: whom the console of the same tab was for. */
const SEAT = seatToken(() => sessionStorage, randomId);

const ownName = new ConsoleName(
  () => localStorage,
  () => sessionStorage,
);

/** The link of a page that records what shows on air. */
function connect(store: ConsoleStore): ShowLink {
  const handlers: LinkHandlers = {
    every: (message) => store.receive(message),
    welcome: ({ name }) => ownName.receive(name),
    cast: () => void Library.open().then(({ manifest }) => store.setManifest(manifest)),
    connected: (up) => store.setOnline(up),
    revoked: () => location.reload(), // the server then asks for another token
  };
  return new ShowLink("console", handlers, ownName.read, PAGE, SEAT, "air");
}

function start(): void {
  const store = new ConsoleStore(
    (message) => link.send(message),
    () => performance.now(),
    PAGE,
  );
  const page = new ClipsPage();
  const marks = new PageMarks(
    () => localStorage,
    () => sessionStorage,
  );
  page.clips = new ClipStore(store, PAGE, undefined, undefined, marks);
  page.painter = new FramePainter();
  const link = connect(store);
  page.painter.add({ paint: () => store.flush() });
  document.body.append(page);
  page.painter.start();
  new WakeLock(); // a tablet's screen stays on
  void readAccess().then((access) => page.clips.setAccess(access));
}

start();
