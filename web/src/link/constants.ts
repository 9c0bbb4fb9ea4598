// Written by tools/messages.py from the Python tables that it imports. Do not edit: run `python tools/messages.py`.

/** Pads of a show. */
export const MOST_PADS = 32;
/** Looks of a pad at least. */
export const FEWEST_LOOKS = 2;
/** Looks of a pad at most. */
export const MOST_LOOKS = 12;
/** Between the places of two looks of a pad, which go from -1 to 1. */
export const LEAST_APART = 0.06;
/** Letters of the name of a macro. */
export const LONGEST_MACRO = 40;
/** Targets of a macro. */
export const MOST_TARGETS = 8;
/** Knots of the curve of a target. */
export const MOST_KNOTS = 7;
/** Between two knots of a curve, of the way of its macro. */
export const NEAREST_KNOTS = 0.01;
/** Seconds of the rise and of the fall of a target. */
export const LONGEST_FOLLOWER = 5.0;
/** Letters of the name of a set-up. */
export const LONGEST_SETUP_NAME = 40;
/** The name of the first character of a new show. */
export const FIRST_CHARACTER = "one";
/** In the place of a character: all of them; a framing: of all that are on the stage. */
export const ALL = "*";
/** Between the names of the characters of a framing. */
export const FRAMING_JOINT = "+";
/** Before the size of the shot of a framing. */
export const FRAMING_SIZED = ":";
/** Characters that a scene holds at most. */
export const MOST_CHARACTERS = 8;
/** What people may do: each role all that those before it may. */
export const ACCESS_ROLES = ["view", "operate", "edit", "admin"] as const;
/** How a link is closed whose token is not valid any more. */
export const REVOKED_CODE = 4401;
/** The lights that a show can call, in the order of the console (`perform/lights.py`). */
export const LIGHTS = {"theatre": {"key": {"direction": [-0.5653322026700586, 0.6006654653369373, 0.5653322026700586], "colour": [2.05, 1.74, 1.46]}, "fill": {"direction": [0.8619342151577695, 0.0, 0.5070201265633938], "colour": [0.16, 0.17, 0.22]}, "rims": {"left": [-0.868037079906742, 0.24112141108520607, -0.434018539953371], "right": [0.8276408817690651, 0.321860342910192, -0.45980048987170286], "colour": [1.0, 1.08, 1.3]}, "sky": [0.085, 0.082, 0.095], "ground": [0.055, 0.04, 0.037], "size": 0.12, "shade": 1.0, "exposure": 1.0, "backdrop": {"edge": [0.0016, 0.0016, 0.002], "glow": [0.0105, 0.0094, 0.0118]}}, "portrait": {"key": {"direction": [-0.47237124678326464, 0.45347639691193403, 0.7557939948532234], "colour": [1.38, 1.3, 1.22]}, "fill": {"direction": [0.7960297521679914, 0.09950371902099893, 0.5970223141259935], "colour": [0.32, 0.31, 0.32]}, "rims": {"left": [-0.8447818580350777, 0.32852627812475244, -0.42239092901753883], "right": [0.8009894870819726, 0.4004947435409863, -0.4449941594899848], "colour": [0.42, 0.44, 0.5]}, "sky": [0.19, 0.19, 0.195], "ground": [0.12, 0.105, 0.098], "size": 0.3, "shade": 1.0, "exposure": 1.0, "backdrop": {"edge": [0.022, 0.024, 0.028], "glow": [0.115, 0.118, 0.124]}}, "flat": {"key": {"direction": [-0.09987523388778446, 0.2996257016633534, 0.9488147219339523], "colour": [0.55, 0.53, 0.51]}, "fill": {"direction": [0.5970223141259935, 0.09950371902099893, 0.7960297521679914], "colour": [0.0, 0.0, 0.0]}, "rims": {"left": [-0.868037079906742, 0.24112141108520607, -0.434018539953371], "right": [0.8276408817690651, 0.321860342910192, -0.45980048987170286], "colour": [0.0, 0.0, 0.0]}, "sky": [0.82, 0.8, 0.78], "ground": [0.8, 0.76, 0.73], "size": 0.3, "shade": 0.35, "exposure": 1.0, "backdrop": {"edge": [0.0, 0.4396571738409188, 0.05126945837404324], "glow": [0.0, 0.4396571738409188, 0.05126945837404324]}}} as const;
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
/** What a source can play. */
export const ROUTE_PARTS = ["brows", "eyes", "mouth", "rest", "head", "gaze", "body"] as const;
/** What a clip can give. */
export const CLIP_PARTS = ["brows", "eyes", "mouth", "rest", "head", "gaze", "body"] as const;
/** The springs of a character. */
export const SPRINGS = ["ears-sway", "ears-flap", "jowls-sway", "cheeks-bounce"] as const;
/** The faders of a character's skin. */
export const SKIN_FADERS = ["folds", "blood"] as const;
/** How far a fader of the skin goes. */
export const SKIN_LIMIT = 1.5;
/** The numbers of a complexion, with the region whose mix brings each. */
export const COMPLEXION = {"cheeks": "mouth", "nose": "rest", "forehead": "brows", "eyes": "eyes", "whole": null, "tears": "eyes", "sweat": null} as const;
/** Where blood shows on the generic head: middle, radii (metres), share. */
export const BLOOD_SPOTS = {"cheeks": [[0.042, -0.037, 0.029, 0.026, 0.5], [0.058, -0.026, 0.042, 0.028, 0.45]], "nose": [[0.0, -0.036, 0.014, 0.013, 1.0], [0.0, -0.098, 0.017, 0.012, 0.6]], "forehead": [[0.0, 0.044, 0.046, 0.027, 1.0], [0.0, 0.016, 0.015, 0.014, 0.5]], "eyes": [[0.034, -0.003, 0.022, 0.016, 1.0]]} as const;
/** What of a complexion a layer brings in one region of the head alone. */
export const COMPLEXION_OF_REGION = {"brows": ["forehead"], "eyes": ["eyes", "tears"], "nose": ["nose"], "cheeks": ["cheeks"], "skull": ["whole", "sweat"]} as const;
/** Units whose pressing of the skin counts as rest. */
export const LID_UNITS = ["eyeBlinkLeft", "eyeBlinkRight", "eyeLookDownLeft", "eyeLookDownRight", "eyeLookInLeft", "eyeLookInRight", "eyeLookOutLeft", "eyeLookOutRight", "eyeLookUpLeft", "eyeLookUpRight"] as const;
/** What 255 of the folding of a vertex stands for. */
export const FOLDING_MOST = 0.62;
/** What each part of a complexion is held in where several expressions bring it. */
export const COMPLEXION_RANGES = {"cheeks": [-0.8, 1.4], "nose": [-0.8, 1.4], "forehead": [-0.8, 1.4], "eyes": [-0.8, 1.4], "whole": [-0.8, 1.4], "tears": [0.0, 1.0], "sweat": [0.0, 1.0]} as const;
/** The layers that sources drive. */
export const DRIVEN_LAYERS = ["breath", "gaze", "blink", "tracker", "lips", "playback"] as const;
/** The source of what a character says, which ends by itself. */
export const SPEECH = "speech";
/** The influence of lips at first, by part; all others have 1 on all. */
export const LIPS_INFLUENCE = [0.0, 0.0, 0.7, 0.0, 0.0, 0.0] as const;
/** What files can hold, by their suffix; the first is what they are taken for. */
export const FILE_CONTENTS = {".ply": ["head", "shape"], ".obj": ["shape", "head"], ".stl": ["head"], ".glb": ["shape", "head"], ".gltf": ["shape", "head"], ".vrm": ["shape", "head"], ".xyz": ["head"], ".pts": ["head"], ".txt": ["head"], ".asc": ["head"], ".csv": ["head", "take"], ".json": ["document", "capture"], ".pcap": ["capture"], ".pcapng": ["capture"], ".cap": ["capture"], ".jpg": ["photograph", "companion"], ".jpeg": ["photograph", "companion"], ".png": ["photograph", "companion"], ".heic": ["photograph", "companion"], ".heif": ["photograph", "companion"], ".webp": ["photograph", "companion"], ".avif": ["photograph", "companion"], ".bmp": ["photograph", "companion"], ".tif": ["photograph", "companion"], ".tiff": ["photograph", "companion"], ".gif": ["photograph", "companion"], ".mtl": ["companion"], ".bin": ["companion"], ".tga": ["companion"]} as const;
/** The easings of a call. */
export const EASING_NAMES = ["smooth", "gentle", "sharp", "early", "late"] as const;
/** The easing of a call that names none. */
export const DEFAULT_EASING = "smooth";
/** The levels of quality, from the cheapest to the best. */
export const LEVELS = ["lowest", "low", "medium", "good", "high"] as const;
/** The parts of a figure that can do a pose of their own. */
export const POSE_REGIONS = ["head", "trunk", "arm_left", "arm_right", "stance"] as const;
/** Correctives of each joint that has some. */
export const SHAPES = 4;
/** Where limbs that bend begin, where they bend and where they end, as bones. */
export const HINGES = [["upperarm01.L", "lowerarm01.L", "wrist.L"], ["upperarm01.R", "lowerarm01.R", "wrist.R"], ["upperleg01.L", "lowerleg01.L", "foot.L"], ["upperleg01.R", "lowerleg01.R", "foot.R"]] as const;
/** The limbs: where the axis of each begins and ends, as bones, and the sense in which angles grow about it. */
export const LIMBS = [["spine05", "neck01", 1.0], ["upperarm01.L", "lowerarm01.L", -1.0], ["upperarm01.R", "lowerarm01.R", 1.0], ["lowerarm01.L", "wrist.L", -1.0], ["lowerarm01.R", "wrist.R", 1.0], ["upperleg01.L", "lowerleg01.L", -1.0], ["upperleg01.R", "lowerleg01.R", 1.0], ["lowerleg01.L", "foot.L", -1.0], ["lowerleg01.R", "foot.R", 1.0]] as const;
/** Degrees of a hinge from which on it drives a limb field, and at which it drives all of it. */
export const TENSED = [30.0, 130.0] as const;
/** What drives a limb field: the breath in the chest. */
export const BREATH = "breath";
/** Degrees from the straight limb at which these have correctives. */
export const HINGE_BENDS = [0.0, 45.0, 90.0, 130.0] as const;
/** Of each joint of a finger with correctives the bone before it and its own. */
export const FINGERS = [["metacarpal1.L", "finger2-1.L"], ["finger2-1.L", "finger2-2.L"], ["finger2-2.L", "finger2-3.L"], ["metacarpal2.L", "finger3-1.L"], ["finger3-1.L", "finger3-2.L"], ["finger3-2.L", "finger3-3.L"], ["metacarpal3.L", "finger4-1.L"], ["finger4-1.L", "finger4-2.L"], ["finger4-2.L", "finger4-3.L"], ["metacarpal4.L", "finger5-1.L"], ["finger5-1.L", "finger5-2.L"], ["finger5-2.L", "finger5-3.L"], ["metacarpal1.R", "finger2-1.R"], ["finger2-1.R", "finger2-2.R"], ["finger2-2.R", "finger2-3.R"], ["metacarpal2.R", "finger3-1.R"], ["finger3-1.R", "finger3-2.R"], ["finger3-2.R", "finger3-3.R"], ["metacarpal3.R", "finger4-1.R"], ["finger4-1.R", "finger4-2.R"], ["finger4-2.R", "finger4-3.R"], ["metacarpal4.R", "finger5-1.R"], ["finger5-1.R", "finger5-2.R"], ["finger5-2.R", "finger5-3.R"]] as const;
/** Degrees to the palm at which fingers have correctives. */
export const FINGER_BENDS = [30.0, 60.0, 85.0, 110.0] as const;
/** Where thighs begin and end. */
export const HIPS = [["upperleg01.L", "lowerleg01.L"], ["upperleg01.R", "lowerleg01.R"]] as const;
/** Degrees to the front at which hips have correctives. */
export const HIP_BENDS = [35.0, 65.0, 95.0, 125.0] as const;
/** Where upper arms begin and end. */
export const SHOULDERS = [["upperarm01.L", "lowerarm01.L"], ["upperarm01.R", "lowerarm01.R"]] as const;
/** Where a left arm points as modelled, and where shoulders have correctives. */
export const SHOULDER_WAYS = [[0.730919074, -0.681593063, 0.03447034], [0.156341499, -0.987101378, 0.03447034], [-0.055314379, -0.469695583, 0.881093854], [0.088121037, -0.960705444, -0.263210434], [0.272550082, 0.946715958, 0.171596468]] as const;
/** By how much the angle to each of these calls each corrective. */
export const SHOULDER_SHARES = [[0.5255361, 0.021439642, 0.229514673, 0.219819269], [-2.340354245, 0.49115175, 1.52992837, -0.128511818], [0.49115175, -0.664202544, -0.035398647, 0.264499277], [1.52992837, -0.035398647, -1.614410261, 0.143781812], [-0.128511818, 0.264499277, 0.143781812, -0.177251154]] as const;
/** Of the twist of an upper arm, what its second bone makes alone. */
export const TWIST_SPREAD = 0.7;
/** The poses that figures come to by themselves: no list of what people call has them. */
export const IDLE_POSES = ["breath_in", "weight_left", "weight_right", "chest_left"] as const;
/** The pose of a figure with a breath in its chest. */
export const BREATH_IN = "breath_in";
/** The pose of a figure whose chest has followed its head. */
export const CHEST = "chest_left";
/** The poses of a figure whose weight is on its left foot, and on its right. */
export const WEIGHT = ["weight_left", "weight_right"] as const;
/** In a mix of bodies: those of the faces on air, by their weights. */
export const FACES_OWN = "own";
/** How much of figures a shot shows, from heads alone to all. */
export const SHOT_SIZES = ["portrait", "head", "bust", "half", "full"] as const;
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
export const SKIN_LAYERS = ["mask", "marks", "patches", "relief", "finish", "pelt", "level_folds", "upright_folds"] as const;
/** How far a face may turn or stretch one piece of a strand of hair, of its own length. */
export const STRETCH = 0.75;
/** Radians from straight ahead, and the metres over the eyes where hair begins. */
export const HAIRLINE = [[0.0, 0.079], [0.35, 0.077], [0.6, 0.071], [0.76, 0.06], [0.9, 0.04], [1.02, 0.02], [1.12, 0.0], [1.24, -0.006], [1.34, 0.008], [1.6, 0.022], [1.9, 0.0], [2.2, -0.045], [3.2, -0.07]] as const;
/** The middle line of the left brow on the generic head, from nose to temple: x, y, half height, metres. */
export const BROW_LINE = [[0.012, 0.0176, 0.0028], [0.02, 0.0196, 0.0033], [0.03, 0.0214, 0.0031], [0.04, 0.0221, 0.0024], [0.048, 0.0204, 0.0016], [0.055, 0.017, 0.0008]] as const;
/** Metres from the mirror plane to the first and to the last hair of a brow. */
export const BROW_REACH = [0.0125, 0.0535] as const;
/** Metres from the front teeth back to the middle of the dental arch. */
export const ARCH = 0.034;
/** Radians along the arch within which vertices belong to one tooth's height. */
export const TOOTH_REACH = 0.16;
/** The measures of teeth by jaw and by whose they are, millimetres. */
export const JAWS = {"upper": {"person": {"over": 0, "inside": 0, "vault": 4, "teeth": [{"width": 8.6, "height": 10.4, "depth": 6.6, "edge": 1.3, "corner": 0.7, "power": 5, "hollow": 0.0, "over": 0.0}, {"width": 6.8, "height": 9.4, "depth": 6.0, "edge": 1.2, "corner": 0.9, "power": 4, "hollow": 0, "over": -0.45}, {"width": 7.7, "height": 10.2, "depth": 7.2, "edge": 1.4, "corner": 1.6, "power": 1.7, "hollow": 0, "over": 0.1}, {"width": 7.1, "height": 8.6, "depth": 8.6, "edge": 5.2, "corner": 1.3, "power": 2, "hollow": 1.2, "over": -0.3}, {"width": 6.9, "height": 8.2, "depth": 8.6, "edge": 5.4, "corner": 1.4, "power": 1.8, "hollow": 1.3, "over": -0.4}, {"width": 10.2, "height": 7.4, "depth": 10.0, "edge": 6.6, "corner": 1.3, "power": 2.4, "hollow": 1.5, "over": -0.4}, {"width": 9.4, "height": 7.0, "depth": 10.0, "edge": 6.6, "corner": 1.3, "power": 2.4, "hollow": 1.5, "over": -0.5}]}, "milk": {"over": 0, "inside": 0, "vault": 4, "teeth": [{"width": 8.2, "height": 5.0, "depth": 6.0, "edge": 1.4, "corner": 0.9, "power": 3.2, "hollow": 0, "over": -0.6}, {"width": 6.6, "height": 4.2, "depth": 5.6, "edge": 1.3, "corner": 1.2, "power": 3, "hollow": 0, "over": -1.2}, {"width": 7.0, "height": 0, "depth": 8.0, "edge": 0, "corner": 0, "power": 1, "hollow": 0, "over": -4.8}, {"width": 7.0, "height": 0, "depth": 8.0, "edge": 0, "corner": 0, "power": 1, "hollow": 0, "over": -4.8}, {"width": 7.6, "height": 0, "depth": 8.0, "edge": 0, "corner": 0, "power": 1, "hollow": 0, "over": -4.8}, {"width": 9.0, "height": 0, "depth": 8.0, "edge": 0, "corner": 0, "power": 1, "hollow": 0, "over": -4.8}, {"width": 9.0, "height": 0, "depth": 8.0, "edge": 0, "corner": 0, "power": 1, "hollow": 0, "over": -4.8}]}, "carnivore": {"over": 0, "inside": 0.6, "vault": 4, "teeth": [{"width": 5.0, "height": 6.0, "depth": 5.0, "edge": 1.2, "corner": 1.6, "power": 2.2, "hollow": 0, "over": -1.5}, {"width": 5.0, "height": 6.2, "depth": 5.0, "edge": 1.2, "corner": 1.8, "power": 2.2, "hollow": 0, "over": -1.3}, {"width": 5.6, "height": 7.6, "depth": 5.4, "edge": 1.0, "corner": 2.8, "power": 1.6, "hollow": 0, "over": -0.6}, {"width": 7.6, "height": 13.0, "depth": 6.6, "edge": 2.2, "corner": 8.5, "power": 1.2, "hollow": 0, "over": 4.2}, {"width": 9.5, "height": 6.6, "depth": 5.2, "edge": 1.0, "corner": 4.8, "power": 1.3, "hollow": 0, "over": -1.6}, {"width": 13.0, "height": 9.0, "depth": 6.4, "edge": 1.2, "corner": 6.2, "power": 1.25, "hollow": 0, "over": 0.2}, {"width": 9.6, "height": 6.4, "depth": 8.0, "edge": 3.6, "corner": 3.6, "power": 1.5, "hollow": 0.8, "over": -1.0}]}}, "lower": {"person": {"over": 1.6, "inside": 2.4, "vault": -1, "teeth": [{"width": 5.2, "height": 9.0, "depth": 5.8, "edge": 1.2, "corner": 0.6, "power": 4, "hollow": 0.0, "over": 0.0}, {"width": 5.8, "height": 9.2, "depth": 5.9, "edge": 1.2, "corner": 0.7, "power": 3.4, "hollow": 0.0, "over": 0.0}, {"width": 6.9, "height": 10.2, "depth": 7.0, "edge": 1.4, "corner": 1.9, "power": 1.5, "hollow": 0, "over": 0.3}, {"width": 7.0, "height": 8.6, "depth": 7.4, "edge": 4.6, "corner": 1.6, "power": 1.7, "hollow": 1.1, "over": -0.3}, {"width": 7.1, "height": 8.2, "depth": 7.8, "edge": 5.0, "corner": 1.4, "power": 1.9, "hollow": 1.2, "over": -0.5}, {"width": 11.0, "height": 7.4, "depth": 9.4, "edge": 6.4, "corner": 1.2, "power": 2.4, "hollow": 1.5, "over": -0.6}, {"width": 10.4, "height": 7.0, "depth": 9.4, "edge": 6.4, "corner": 1.2, "power": 2.4, "hollow": 1.5, "over": -0.7}]}, "milk": {"over": 1.6, "inside": 2.4, "vault": -1, "teeth": [{"width": 5.6, "height": 4.6, "depth": 5.4, "edge": 1.2, "corner": 0.7, "power": 3.2, "hollow": 0, "over": -1.4}, {"width": 5.8, "height": 4.0, "depth": 5.4, "edge": 1.2, "corner": 0.9, "power": 3, "hollow": 0, "over": -2.0}, {"width": 6.6, "height": 0, "depth": 8.0, "edge": 0, "corner": 0, "power": 1, "hollow": 0, "over": -5.6}, {"width": 6.8, "height": 0, "depth": 8.0, "edge": 0, "corner": 0, "power": 1, "hollow": 0, "over": -5.6}, {"width": 7.4, "height": 0, "depth": 8.0, "edge": 0, "corner": 0, "power": 1, "hollow": 0, "over": -5.6}, {"width": 9.0, "height": 0, "depth": 8.0, "edge": 0, "corner": 0, "power": 1, "hollow": 0, "over": -5.6}, {"width": 9.0, "height": 0, "depth": 8.0, "edge": 0, "corner": 0, "power": 1, "hollow": 0, "over": -5.6}]}, "carnivore": {"over": 1.0, "inside": 3.0, "vault": -1, "teeth": [{"width": 4.0, "height": 5.4, "depth": 4.6, "edge": 1.1, "corner": 1.3, "power": 2.2, "hollow": 0, "over": -1.8}, {"width": 4.2, "height": 5.6, "depth": 4.6, "edge": 1.1, "corner": 1.5, "power": 2.2, "hollow": 0, "over": -1.6}, {"width": 4.6, "height": 6.4, "depth": 5.0, "edge": 1.0, "corner": 2.2, "power": 1.8, "hollow": 0, "over": -1.2}, {"width": 7.0, "height": 12.5, "depth": 6.2, "edge": 2.0, "corner": 8.5, "power": 1.2, "hollow": 0, "over": 4.2}, {"width": 9.5, "height": 6.2, "depth": 4.8, "edge": 1.0, "corner": 4.4, "power": 1.3, "hollow": 0, "over": -2.0}, {"width": 13.5, "height": 8.6, "depth": 5.8, "edge": 1.1, "corner": 5.8, "power": 1.25, "hollow": 0, "over": -0.4}, {"width": 9.6, "height": 6.0, "depth": 7.0, "edge": 3.2, "corner": 3.2, "power": 1.5, "hollow": 0.8, "over": -1.6}]}}} as const;
/** Metres behind the front teeth that the teeth's texture spans. */
export const ARCH_DEPTH = 0.05;
