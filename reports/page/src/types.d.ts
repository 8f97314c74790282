declare module "plotly.js-cartesian-dist-min" {
  export * from "plotly.js";
}
declare module "*/LICENSE" {
  const text: string;
  export default text;
}
