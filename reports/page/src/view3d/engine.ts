/** All that needs three: loaded when the first view comes into sight. */
export { PlaybackView } from "./playback_view";
export { hasWebGl } from "./renderer";
export { View3d } from "./view";
