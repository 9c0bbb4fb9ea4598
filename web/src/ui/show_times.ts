/** Times as people read them from afar: the clock on the wall, and how long something takes already. */

/** Hours, minutes and seconds of this place. */
export const clockOf = (time: Date): string => time.toLocaleTimeString([], { hour12: false });

const two = (number: number): string => String(number).padStart(2, "0");

/** Hours, minutes and seconds that have passed: `0:04:09`. */
export function sinceOf(seconds: number): string {
  const whole = Math.max(0, Math.floor(seconds));
  return `${Math.floor(whole / 3600)}:${two(Math.floor(whole / 60) % 60)}:${two(whole % 60)}`;
}

/** How old something is, in words; "" where it has just been. */
export function ageOf(seconds: number): string {
  if (seconds < 60) return "";
  if (seconds < 3600) return `${Math.floor(seconds / 60)} min ago`;
  const hours = Math.floor(seconds / 3600);
  return hours < 48 ? `${hours} h ago` : `${Math.floor(hours / 24)} days ago`;
}
