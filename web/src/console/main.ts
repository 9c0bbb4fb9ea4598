/** The console page: connects the show to the store, and the store to the page. */

import { missingRole, readAccess } from "../access/page_access";
import { readBus } from "../link/bus";
import type { ShowLink } from "../link/show_link";
import { loadPortraits } from "../ui/portraits";
import { ShowNoticesView } from "../ui/show_notices_view";
import { WakeLock } from "../ui/wake_lock";
import { connectPage, newIdentity, openContext } from "./console_context";
import { ConsolePage } from "./console_page";
import { PageCast } from "./page_cast";
import { showPreviewBar } from "./panels/preview_bar";
import { layoutName } from "./show_file/layout_storage";

const IDENTITY = newIdentity(readBus(location.search), layoutName(location.search));

async function start(): Promise<void> {
  const shown = new ShowNoticesView();
  shown.classList.add("in-place");
  const context = openContext(() => link, IDENTITY);
  const { store } = context;
  const cast = new PageCast(store);
  const link: ShowLink = connectPage(context, cast, IDENTITY);
  store.hear("notices", ({ notices }) => shown.notices.receive(notices));
  shown.addEventListener("change", () => store.tell("crew"));
  const page = new ConsolePage();
  page.context = context;
  page.notices = shown;
  shown.openLog = () => page.show("log");
  document.body.append(page);
  showPreviewBar(store);
  void readAccess().then((access) => {
    page.restrict(missingRole(access, "operate", "playing"));
    context.leases.barred = missingRole(access, "admin", "switching leases on or off");
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
