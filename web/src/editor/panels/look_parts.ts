/** What of a look can be chosen, in the order of the panel, and the colours that are proposed. */

/** A number of a look, 0 to 1 where nothing else is said. */
export interface Trait {
  readonly name: string;
  readonly label: string;
  readonly hint: string;
  readonly low?: number;
  readonly high?: number;
}

/** Colours with what they are called. */
type Swatches = readonly (readonly [colour: string, called: string])[];

export const COLOURS = {
  hair: [
    ["#120c0a", "black"],
    ["#2b1c16", "dark brown"],
    ["#4a3324", "brown"],
    ["#7a4a26", "chestnut"],
    ["#8f3b1e", "red"],
    ["#b98d52", "dark blond"],
    ["#d9bd84", "blond"],
    ["#8d8a86", "grey"],
    ["#cdc6bd", "white"],
    ["#6b3145", "plum"],
  ],
  skin: [
    ["#f5cbb4", "rosy"],
    ["#f1cdb5", "light"],
    ["#dcae92", "medium"],
    ["#d9a68a", "tanned"],
    ["#b9835e", "olive"],
    ["#9a6a4b", "brown"],
    ["#714a39", "dark brown"],
    ["#4a2f26", "deep"],
  ],
  blush: [
    ["#e0787a", "rose"],
    ["#cf6f5e", "coral"],
    ["#c56f60", "brick"],
    ["#733a2e", "dark"],
  ],
  iris: [
    ["#2c1a10", "dark brown"],
    ["#5a4632", "brown"],
    ["#8a6a34", "amber"],
    ["#5f7a4a", "green"],
    ["#5b6b73", "grey"],
    ["#6d8894", "light blue"],
    ["#2f7fb8", "blue"],
  ],
  lip: [
    ["#cf7568", "light"],
    ["#b8625a", "natural"],
    ["#c9585c", "rose"],
    ["#d9304f", "red"],
    ["#8e2f3a", "wine"],
    ["#7c3f38", "brown"],
  ],
  cloth: [
    ["#222226", "black"],
    ["#5b5f66", "grey"],
    ["#ded8cb", "white"],
    ["#8a6a44", "camel"],
    ["#31527a", "blue"],
    ["#2a3550", "navy"],
    ["#b3324a", "red"],
    ["#3f6b4f", "green"],
    ["#e3c27c", "gold"],
  ],
} as const satisfies Record<string, Swatches>;

/** A part of a face: its colours and numbers by their names in a look. */
export interface LookPart {
  /** "" for hair, whose styles stand above. */
  readonly title: string;
  readonly colours: readonly { readonly name: string; readonly label: string; readonly kind: keyof typeof COLOURS }[];
  readonly traits: readonly Trait[];
}

/** What goes with a garment, which is chosen above it. */
export const GARMENT_PART: LookPart = {
  title: "Garment",
  colours: [
    { name: "cloth", label: "Colour of the cloth", kind: "cloth" },
    { name: "trim", label: "Second colour", kind: "cloth" },
  ],
  traits: [
    { name: "pinstripes", label: "Pinstripes", hint: "How much of the second colour they show" },
    { name: "checks", label: "Checks", hint: "How much of the second colour they show" },
    { name: "dots", label: "Dots", hint: "How much of the second colour they show" },
  ],
};

export const LOOK_PARTS: readonly LookPart[] = [
  { title: "", colours: [{ name: "hair", label: "Colour of the hair", kind: "hair" }], traits: [] },
  {
    title: "Brows",
    colours: [{ name: "brow", label: "Colour of the brows", kind: "hair" }],
    traits: [{ name: "brows", label: "Thickness", hint: "0 % none, 100 % bushy" }],
  },
  {
    title: "Skin",
    colours: [
      { name: "skin", label: "Colour of the skin", kind: "skin" },
      { name: "blush", label: "Colour of the cheeks", kind: "blush" },
    ],
    traits: [
      { name: "freckles", label: "Freckles", hint: "How many show" },
      { name: "age", label: "Lines", hint: "Lines and spots of age" },
      { name: "pores", label: "Pores", hint: "How coarse the skin is" },
      { name: "stubble", label: "Stubble", hint: "A beard's shadow" },
    ],
  },
  {
    title: "Eyes",
    colours: [{ name: "iris", label: "Colour of the eyes", kind: "iris" }],
    traits: [
      { name: "iris_size", label: "Iris", hint: "Its size over a person's", low: 0.5, high: 2 },
      { name: "slit", label: "Slit", hint: "0 % a round pupil, 100 % a cat's" },
      { name: "makeup", label: "Make-up", hint: "A line and a shadow round the eyes" },
    ],
  },
  {
    title: "Lashes",
    colours: [],
    traits: [{ name: "lashes", label: "Lashes", hint: "How many, and how long" }],
  },
  {
    title: "Lips",
    colours: [{ name: "lip", label: "Colour of the lips", kind: "lip" }],
    traits: [{ name: "gloss", label: "Gloss", hint: "How wet they shine" }],
  },
];
