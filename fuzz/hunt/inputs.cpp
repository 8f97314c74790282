#include "fuzz/hunt/inputs.hpp"

#include <algorithm>

#include "fuzz/layouts/decode.hpp"
#include "fuzz/layouts/decode_contact.hpp"
#include "fuzz/layouts/layout_fields.hpp"

namespace plumb::hunting {
namespace {

void fit(Superellipsoid<double>& shape, const Abilities& abilities) {
  if (abilities.shapes == Shapes::spheres) shape.semi_axes.setConstant(shape.semi_axes.maxCoeff());
  if (abilities.shapes != Shapes::superellipsoids) shape.n1 = shape.n2 = 2;
  const auto [least, greatest] = abilities.exponents;
  for (double* exponent : {&shape.n1, &shape.n2}) *exponent = std::clamp(*exponent, least, greatest);
}

Case pair_case(const Input& input, const Abilities& abilities) {
  PairRecipe recipe = decode_recipe(input.bytes);
  fit(recipe.pair.body1.shape, abilities);
  fit(recipe.pair.body2.shape, abilities);
  Case c;
  c.name = "decoded bytes";
  c.pair = placed(recipe);
  c.provenance = Json{{"layout", input.layout->name}, {"bytes", layout::hex(input.bytes)}};
  return c;
}

}  // namespace

std::vector<const Layout*> layouts_for(const Abilities& abilities) {
  if (abilities.shapes == Shapes::spheres) return {&pair_layout()};
  return {&pair_layout(), &contact_layout()};
}

Input drawn(const std::vector<const Layout*>& layouts, Stream& stream) {
  Input out{layouts[stream.below(layouts.size())], {}};
  for (std::size_t i = 0; i < out.layout->size; ++i) out.bytes.push_back(static_cast<std::uint8_t>(stream.bits()));
  return out;
}

void bring_home(Input& input) {
  for (const Stroke& stroke : input.layout->strokes)
    if (stroke.name == "at home")
      for (const auto& [offset, value] : stroke.bytes) input.bytes[offset] = value;
}

Case case_of(const Input& input, const Abilities& abilities) {
  if (input.layout == &pair_layout()) return pair_case(input, abilities);
  const bool round = abilities.shapes == Shapes::ellipsoids;
  return contact_case(decode_contact(input.bytes, round ? ContactShapes::ellipsoids : ContactShapes::all), input.bytes);
}

}  // namespace plumb::hunting
