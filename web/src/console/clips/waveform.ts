/** A sound to be drawn: how loud it is, at equal steps, as the browser decodes it: every format that a stage can play. */

const POINTS = 400;

export interface Waveform {
  readonly key: string;
  readonly seconds: number;
  /** 0..1, of the loudest. */
  readonly peaks: readonly number[];
}

/** The loudest of each of so many parts of a sound, 0..1 of the loudest of all. */
export function peaksOf(samples: Float32Array, points = POINTS): number[] {
  const peaks = Array.from({ length: points }, (_, place) => {
    const part = samples.subarray(
      Math.floor((place * samples.length) / points),
      Math.ceil(((place + 1) * samples.length) / points),
    );
    return part.reduce((most, sample) => Math.max(most, Math.abs(sample)), 0);
  });
  const most = Math.max(...peaks);
  return most === 0 ? peaks : peaks.map((peak) => peak / most);
}

/** The path of a sound in a box of 1000 in width and 100 in height, about its middle. */
export function wavePath(peaks: readonly number[]): string {
  const last = Math.max(1, peaks.length - 1);
  const edge = (way: 1 | -1) =>
    peaks.map((peak, place) => `${((1000 * place) / last).toFixed(1)} ${(50 - way * 46 * peak).toFixed(1)}`);
  return peaks.length === 0 ? "" : `M${[...edge(1), ...edge(-1).reverse()].join("L")}Z`;
}

/** Fetches and decodes a sound of the show; null where it is not there, or the browser cannot play it. */
export async function fetchWaveform(key: string): Promise<Waveform | null> {
  try {
    const answer = await fetch(`/sounds/${encodeURIComponent(key)}`);
    if (!answer.ok) return null;
    const decoder = new OfflineAudioContext(1, 1, 8000);
    const sound = await decoder.decodeAudioData(await answer.arrayBuffer());
    return { key, seconds: sound.duration, peaks: peaksOf(sound.getChannelData(0)) };
  } catch {
    return null;
  }
}
