#include "solver/lammps/new_bodies.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "solver/lammps/pair_arguments.hpp"
#include "solver/scene/named/named_scenes.hpp"

namespace plumb::lammps {
namespace {

NewBody read_body(std::span<char* const> words, int types) {
  std::array<double, 7> x{};
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = scene::number_of("new", words[k + 1]);
  if (!(x[0] >= 1 && x[0] <= types) || x[0] != std::floor(x[0]))
    throw scene::SceneError("new", fmt::format("needs one of the {} types of atoms", types));
  NewBody out{static_cast<int>(x[0]), {Vec3<double>(x[1], x[2], x[3]) / 2, x[4], x[5]}, x[6]};
  const Body body{out.shape};
  if (const InputError wrong = find_input_error(plumb::Pair{body, body}); !wrong.reason.empty())
    throw scene::SceneError("new", fmt::format("{}: {}", wrong.field, wrong.reason));
  if (!(std::isfinite(out.density) && out.density > 0))
    throw scene::SceneError("new", "needs a density that is a positive number");
  return out;
}

}  // namespace

std::vector<NewBody> parse_new_bodies(std::span<char* const> words, int types) {
  constexpr std::size_t words_of_one = 8;
  std::vector<NewBody> out;
  for (; !words.empty(); words = words.subspan(words_of_one)) {
    if (std::string_view(words[0]) != "new") throw scene::SceneError(words[0], "is none of its arguments: new");
    if (words.size() < words_of_one)
      throw scene::SceneError("new", "needs a type, 3 diameters, 2 exponents, a density");
    out.push_back(read_body(words, types));
  }
  return out;
}

std::array<double, 4> orientation_drawn_at(const double* position) {
  constexpr std::uint64_t factor = 0x9e3779b97f4a7c15U;  // odd: no position is lost
  std::uint64_t seed = 0;
  for (int k = 0; k < 3; ++k) seed = seed * factor + std::bit_cast<std::uint64_t>(position[k]);
  std::array<double, 4> q = scene::named::Draw(seed).orientation();
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& part : q) part /= length;
  return q;
}

}  // namespace plumb::lammps
