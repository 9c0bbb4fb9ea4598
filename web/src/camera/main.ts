/** The camera page: a performer's face, hand and body, found in the browser, play characters of the show. */

import { showAccess } from "../access/access_banner";
import { missingRole, readAccess } from "../access/page_access";
import { openBodyWorker, warmUpBodyPicture } from "../body/body_client";
import { openLandmarkWorker, warmUpPicture } from "../face_mesh/landmark_client";
import { openHandWorker, warmUpHandPicture } from "../hands/hand_client";
import { onFileDrop } from "../ui/file_import";
import { CameraPage } from "./camera_page";
import { guestName } from "./guest_name";
import { CameraSession } from "./session/camera_session";

async function start(): Promise<void> {
  const page = new CameraPage();
  const models = {
    face: openLandmarkWorker(),
    facePicture: warmUpPicture,
    openHand: openHandWorker,
    handPicture: warmUpHandPicture,
    openBody: openBodyWorker,
    bodyPicture: warmUpBodyPicture,
  };
  const [changed, reload] = [() => page.changed(), () => location.reload()]; // the server then asks for another token
  page.session = new CameraSession(models, localStorage, changed, page.drawing, reload);
  document.body.append(page);
  void readAccess().then((access) => showAccess(missingRole(access, "operate", "playing by a camera")));
  await page.session.start(guestName(Math.random));
}

onFileDrop(); // a file that slips from a hand must not take the page's place
void start();
