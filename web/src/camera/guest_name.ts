/** A name for a performer who has typed none yet. */

const COLOURS =
  "Amber Ash Azure Blue Bronze Cherry Copper Coral Crimson Ebony Golden Green Grey Hazel Indigo Ivory Jade Lemon Lilac Linen Mint Olive Pearl Plum Rose Ruby Sable Silver Teal White".split(
    " ",
  );
const ANIMALS =
  "Badger Bear Bee Crane Deer Dove Eagle Falcon Finch Fox Hare Heron Ibis Jay Koala Lark Lynx Mole Moth Newt Otter Owl Panda Raven Robin Seal Stork Swan Tiger Wren".split(
    " ",
  );

/** A name that two browsers seldom share: of two pages with one name only the newer plays. `random`: 0 to 1, below 1. */
export function guestName(random: () => number): string {
  const choose = (words: readonly string[]): string => words[Math.floor(words.length * random())] ?? "";
  return `${choose(COLOURS)} ${choose(ANIMALS)}`;
}
