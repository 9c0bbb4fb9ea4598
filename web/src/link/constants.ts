// Written by tools/messages.py from the Python tables that it imports. Do not edit: run `python tools/messages.py`.

/** The name of the first character of a new show. */
export const FIRST_CHARACTER = "one";
/** In the place of a character: all of them; a framing: of all that are on the stage. */
export const ALL = "*";
/** Between the names of the characters of a framing. */
export const FRAMING_JOINT = "+";
/** Characters that a scene holds at most. */
export const MOST_CHARACTERS = 8;
/** What people may do: each role all that those before it may. */
export const ACCESS_ROLES = ["view", "operate", "edit", "admin"] as const;
/** How a link is closed whose token is not valid any more. */
export const REVOKED_CODE = 4401;
/** The lights that a show can call, in the order of the console. */
export const LIGHT_NAMES = ["theatre", "portrait", "flat"] as const;
/** The light that a show begins with. */
export const FIRST_LIGHT = "theatre";
/** The backgrounds that have a name. */
export const BACKGROUNDS = {"green": "#00b140", "blue": "#0047bb", "black": "#000000", "grey": "#808080", "white": "#ffffff"} as const;
/** The regions of a face in which an expression can be called alone. */
export const PLAY_REGIONS = ["brows", "eyes", "mouth", "rest"] as const;
/** The layers of a character, lowest first. */
export const LAYERS = ["breath", "gaze", "emotion", "blink", "tracker", "lips", "playback", "hands"] as const;
/** What an influence of a layer is of. */
export const LAYER_PARTS = ["brows", "eyes", "mouth", "rest", "head", "gaze"] as const;
/** The layers that sources drive. */
export const DRIVEN_LAYERS = ["breath", "gaze", "blink", "tracker", "lips", "playback"] as const;
/** The influence of lips at first, by part; all others have 1 on all. */
export const LIPS_INFLUENCE = [0.0, 0.0, 0.7, 0.0, 0.0, 0.0] as const;
/** The easings of a call. */
export const EASING_NAMES = ["smooth", "gentle", "sharp", "early", "late"] as const;
/** The easing of a call that names none. */
export const DEFAULT_EASING = "smooth";
/** The levels of quality, from the cheapest to the best. */
export const LEVELS = ["lowest", "low", "medium", "good", "high"] as const;
/** The lowest and the highest weight of a channel. */
export const CHANNEL_RANGE = [-0.5, 1.5] as const;
/** A face's gains where it sets none, by region, in the order of the panels. */
export const NEUTRAL_GAINS = {"brows": 1.0, "eyes": 1.0, "nose": 1.0, "cheeks": 1.0, "mouth": 1.0, "jaw": 1.0, "ears": 0.0, "head": 0.0} as const;
/** The lowest and the highest gain. */
export const GAIN_RANGE = [0.0, 4.0] as const;
/** The points of a scan that people are asked for; left is the character's own. */
export const LANDMARKS = ["left_eye_outer", "left_eye_inner", "right_eye_inner", "right_eye_outer", "nose_tip", "mouth_left", "mouth_right"] as const;
/** Pairs of points between the edges of lids and lips that corrective shapes keep apart. */
export const RUNGS = 32;
/** In radii of an eyeball: skin below keeps its height over it exactly. */
export const SOCKET_NEAR = 1.12;
/** In radii of an eyeball: skin above moves freely. */
export const SOCKET_FAR = 1.6;
/** Metres in which the warp of the handles counts lengths. */
export const WARP_UNIT = 0.05;
/** The layers of the skin's picture, from the top. */
export const SKIN_LAYERS = ["mask", "marks", "patches", "relief", "finish", "pelt"] as const;
/** How far a face may turn or stretch one piece of a strand of hair, of its own length. */
export const STRETCH = 0.75;
/** Radians from straight ahead, and the metres over the eyes where hair begins. */
export const HAIRLINE = [[0.0, 0.079], [0.35, 0.077], [0.6, 0.071], [0.76, 0.06], [0.9, 0.04], [1.02, 0.02], [1.12, 0.0], [1.24, -0.006], [1.34, 0.008], [1.6, 0.022], [1.9, 0.0], [2.2, -0.045], [3.2, -0.07]] as const;
/** Metres from the front teeth back to the middle of the dental arch. */
export const ARCH = 0.034;
/** Radians along the arch within which vertices belong to one tooth's height. */
export const TOOTH_REACH = 0.16;
/** Metres behind the front teeth that the teeth's texture spans. */
export const ARCH_DEPTH = 0.05;
