// The methods of the made-up data.
export const METHODS = [
  "auto",
  "new_cn",
  "corrected_cn",
  "original_cn",
  "geometric_potential",
  "geometric_potential_midway",
  "peer_libccd_epa",
  "peer_libccd_mpr",
  "peer_fcl",
  "newton_gauss",
  "trust_region",
  "alternating",
  "support_descent",
];

export const LOOKS = [
  ["auto", "", "#0072b2", "#56b4f5", "circle"],
  ["new_cn", "Kildashti, Dong & Samali 2018", "#00795a", "#27c39a", "square"],
  ["corrected_cn", "Kildashti, Dong & Samali 2018", "#a86d00", "#f0b030", "diamond"],
  ["original_cn", "Lin & Ng 1995", "#c44e00", "#ff8a45", "triangle-up"],
  ["geometric_potential", "Houlsby 2009", "#b0508a", "#e79bc8", "triangle-down"],
  ["geometric_potential_midway", "Podlozhnyuk, Pirker & Kloss 2017", "#6a51a3", "#b7a1ef", "pentagon"],
  ["minimum_distance", "Wellmann, Lillie & Wriggers 2008", "#5f6b14", "#c3cf5a", "hexagon"],
  ["first_touch", "Cleary, Stokes & Hurley 1997", "#9b1d3f", "#ff7d93", "star-diamond"],
].map(([name, published_by, light, dark, symbol]) => ({
  name,
  published_by,
  problem: name.startsWith("geometric") ? "deepest_points" : name === "first_touch" ? name : "common_normal",
  light,
  dark,
  symbol,
}));

/** How often a method fails, by its place in the list: auto hardly ever. */
export const weakness = (method) =>
  [1e-4, 0.02, 0.55, 0.75, 0.06, 0.01, 0.9, 0.97, 0.88][METHODS.indexOf(method)] ?? 0.2;
