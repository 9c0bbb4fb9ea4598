/** The page for one person: connects the show to the store, and the store to the page. */

import { missingRole, readAccess } from "../../access/page_access";
import { readBus } from "../../link/bus";
import type { ShowLink } from "../../link/show_link";
import { loadPortraits } from "../../ui/portraits";
import { WakeLock } from "../../ui/wake_lock";
import { connectPage, newIdentity, openContext } from "../console_context";
import { CueStore } from "../cues/cue_store";
import { PageCast } from "../page_cast";
import { showPreviewBar } from "../panels/preview_bar";
import { layoutName } from "../show_file/layout_storage";
import { SoloPage } from "./solo_page";

/** The layout of this page where the address names none: a console keeps its own beside it. */
const USUAL = "Solo";

const IDENTITY = newIdentity(readBus(location.search), layoutName(location.search, USUAL));

async function start(): Promise<void> {
  const context = openContext(() => link, IDENTITY);
  const { store } = context;
  const cast = new PageCast(store);
  const link: ShowLink = connectPage(context, cast, IDENTITY);
  const page = new SoloPage();
  page.context = context;
  page.cues = new CueStore(store, "");
  document.body.append(page);
  showPreviewBar(store);
  void readAccess().then((access) => {
    page.cues.setAccess(access);
    page.restrict(missingRole(access, "operate", "playing"));
  });
  context.painter.start();
  context.devices.start(context.painter);
  void loadPortraits().then((portraits) => context.thumbnails.give(portraits));
  new WakeLock(); // a tablet's screen stays on
  const library = await cast.open(() => context.layouts.open());
  await page.open(library);
  cast.openThumbnails(context.thumbnails);
}

void start();
