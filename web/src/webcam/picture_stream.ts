/**
 * Every new picture of a camera. A browser draws no video of a page that nobody sees (another tab, a window in front),
 * and a performer's page is often behind another: where the browser hands out the pictures themselves, they are taken.
 */

/** Takes a picture: `grab` makes a copy, null where it has gone meanwhile; time: ms of the page's clock. */
export type TakePicture = (grab: () => Promise<ImageBitmap | null>, time: number) => Promise<void>;

interface TrackProcessor {
  readonly readable: ReadableStream<VideoFrame>;
}

/** Takes pictures until the function that it returns is called. video: shows the stream. */
export function takePictures(stream: MediaStream, video: HTMLVideoElement, take: TakePicture): () => void {
  const track = stream.getVideoTracks()[0];
  const { MediaStreamTrackProcessor: Processor } = globalThis as unknown as {
    MediaStreamTrackProcessor?: new (options: { track: MediaStreamTrack; maxBufferSize: number }) => TrackProcessor;
  };
  if (Processor === undefined || track === undefined) return takeDrawn(video, take);
  return takeFrames(new Processor({ track, maxBufferSize: 1 }).readable.getReader(), take);
}

function takeFrames(reader: ReadableStreamDefaultReader<VideoFrame>, take: TakePicture): () => void {
  const read = async (): Promise<void> => {
    for (let next = await reader.read(); !next.done; next = await reader.read()) {
      const frame = next.value;
      await take(() => createImageBitmap(frame).catch(() => null), performance.now());
      frame.close();
    }
  };
  read().catch(() => undefined); // the camera has gone, which its track says too
  return () => void reader.cancel().catch(() => undefined);
}

function takeDrawn(video: HTMLVideoElement, take: TakePicture): () => void {
  let ended = false;
  const next = (time: number): void => {
    if (ended) return;
    void take(() => createImageBitmap(video).catch(() => null), time);
    video.requestVideoFrameCallback(next);
  };
  video.requestVideoFrameCallback(next);
  return () => {
    ended = true;
  };
}
