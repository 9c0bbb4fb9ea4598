/** The cue page: connects the show to the store, and the store to the page. */

import { readAccess } from "../../access/page_access";
import { Library } from "../../link/assets";
import { readBus } from "../../link/bus";
import { type LinkHandlers, ShowLink } from "../../link/show_link";
import { randomId } from "../../ui/browser_storage";
import { FramePainter } from "../../ui/frame_painter";
import { loadPortraits } from "../../ui/portraits";
import { Thumbnails } from "../../ui/thumbnails";
import { WakeLock } from "../../ui/wake_lock";
import { ConsoleName } from "../console_name";
import { CueStore } from "../cues/cue_store";
import { seatToken } from "../leases/seat_token";
import { showPreviewBar } from "../panels/preview_bar";
import { ConsoleStore } from "../store/console_store";
import { openThumbnails } from "../thumbnail_drawing";
import { CuesPage, EDITED } from "./cues_page";

const PAGE = randomId();
/** Who sits here: whom the console of the same tab was for. */
const SEAT = seatToken(() => sessionStorage, randomId);

const ownName = new ConsoleName(
  () => localStorage,
  () => sessionStorage,
);

/** The link of a page that plays cues as consoles play faces. */
function connect(store: ConsoleStore): ShowLink {
  const handlers: LinkHandlers = {
    every: (message) => store.receive(message),
    welcome: ({ name }) => ownName.receive(name),
    cast: () => void Library.open().then(({ manifest }) => store.setManifest(manifest)),
    connected: (up) => store.setOnline(up),
    revoked: () => location.reload(), // the server then asks for another token
  };
  return new ShowLink("console", handlers, ownName.read, PAGE, SEAT, store.bus);
}

/** The pictures of what cues leave standing; without them numbers and labels are enough to play. */
async function openPictures(thumbnails: Thumbnails, store: ConsoleStore): Promise<void> {
  try {
    const library = await Library.open();
    store.setManifest(library.manifest);
    thumbnails.give(await loadPortraits());
    thumbnails.open(await openThumbnails(library));
  } catch (error) {
    console.warn("No thumbnails:", error);
  }
}

function start(): void {
  const store = new ConsoleStore(
    (message) => link.send(message),
    () => performance.now(),
    PAGE,
  );
  store.bus = readBus(location.search);
  const parameters = new URLSearchParams(location.search);
  const page = new CuesPage();
  page.cues = new CueStore(store, parameters.get("list") ?? "");
  page.cues.resume(parameters.get(EDITED));
  parameters.delete(EDITED);
  history.replaceState(null, "", `?${parameters}`);
  page.thumbnails = new Thumbnails();
  page.painter = new FramePainter();
  page.far = parameters.has("far");
  const link = connect(store);
  const { painter } = page;
  painter.add({ paint: () => store.flush() });
  document.body.append(page);
  showPreviewBar(store);
  painter.start();
  new WakeLock(); // a tablet's screen stays on
  void readAccess().then((access) => page.cues.setAccess(access));
  if (!page.far) void openPictures(page.thumbnails, store);
}

start();
