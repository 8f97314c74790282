// Where a pair lies in the atlas, and that its counts add up.
#include "fuzz/results/parameter_histogram.hpp"

#include <gtest/gtest.h>

#include "properties/generators/families.hpp"

namespace plumb {
namespace {

Pair two_spheres(double apart) {
  Pair pair;
  pair.body1.shape.semi_axes = pair.body2.shape.semi_axes = {1, 1, 1};
  pair.body2.position = {0, 0, apart};
  return pair;
}

std::string label(Property property, const Pair& pair) {
  const Place place = place_in_atlas(pair, find_reference(pair, Effort::bounds));
  return scale_of(property).label(place[static_cast<std::size_t>(property)]);
}

TEST(Atlas, APairLiesWhereItsNumbersSay) {
  Pair pair = two_spheres(1.95);
  EXPECT_EQ(label(Property::aspect, pair), "below 1.5");
  EXPECT_EQ(label(Property::exponent, pair), "2");
  EXPECT_EQ(label(Property::tilt, pair), "below 1e-06");
  EXPECT_EQ(label(Property::overlap, pair), "0.01..0.1");
  EXPECT_EQ(label(Property::overlap, two_spheres(2)), "-1e-09..1e-09");
  EXPECT_EQ(label(Property::overlap, two_spheres(5)), "below -1");
  pair.body2.shape.semi_axes = {1, 4, 2};
  pair.body2.shape.n1 = 1.5;
  pair.body1.shape.n2 = 2.5;
  EXPECT_EQ(label(Property::aspect, pair), "3..5");
  EXPECT_EQ(label(Property::exponent, pair), "1.5..2");
  pair.body2.quaternion = {1, 1, 0, 0};
  EXPECT_EQ(label(Property::tilt, pair), "89.999 and more");
}

TEST(Atlas, EveryCellOfEveryScaleHasALabelOfItsOwn) {
  for (std::size_t i = 0; i < kProperties; ++i) {
    const Scale scale = scale_of(static_cast<Property>(i));
    for (std::size_t cell = 1; cell < scale.cells(); ++cell) {
      EXPECT_EQ(scale.cell_of(scale.edges[cell - 1]), cell) << scale.title;
      EXPECT_NE(scale.label(cell), scale.label(cell - 1)) << scale.title;
    }
  }
}

TEST(Atlas, PartsAddUpInAnyOrderAndSurviveTheirFile) {
  Atlas whole, one, two;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const Pair pair = generate("superquadric", 1, i).pair;
    const Place place = place_in_atlas(pair, find_reference(pair, Effort::bounds));
    const AtlasCell answer{1, 1, i % 3 == 0 ? 1u : 0u, i % 5 == 0 ? 1u : 0u, i};
    whole.add(place, answer);
    (i % 2 == 0 ? one : two).add(place, answer);
  }
  two.merge(one);
  EXPECT_EQ(two.to_json(), whole.to_json());
  Atlas again;
  const Json kept = whole.to_json();
  again.read(Field(kept));
  EXPECT_EQ(again.to_json(), whole.to_json());
  std::uint64_t answers = 0, iterations = 0;
  for (const auto& [at, cell] : whole.map(0)) answers += cell.answers, iterations += cell.iterations;
  EXPECT_EQ(answers, 40u);
  EXPECT_EQ(iterations, 39u * 40u / 2);
}

TEST(Atlas, ACellThatIsNotOnTheMapIsRefused) {
  Atlas atlas;
  Json json = atlas.to_json();
  json["aspect-overlap"].push_back({0, 99, 1, 1, 0, 0, 0});
  EXPECT_THROW(atlas.read(Field(json)), FieldError);
}

}  // namespace
}  // namespace plumb
