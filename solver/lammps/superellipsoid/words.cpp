#include "solver/lammps/superellipsoid/words.hpp"

#include <algorithm>

namespace plumb::lammps {
namespace {

using Words = std::vector<std::string>;

/// As a script has it: a word with a space in quotes.
std::string line_of(std::string_view command, const Words& words) {
  std::string out(command);
  for (const std::string& word : words) {
    const bool is_quoted = word.empty() || word.find(' ') != std::string::npos;
    out += is_quoted ? " \"" + word + "\"" : " " + word;
  }
  return out;
}

/// set STYLE ID ..: exponents and densities are custom vectors. A mass stays, whatever becomes of the shape, but where the density is set.
Words set_in_older_words(const Words& words) {
  Words out;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string& name = words[k];
    const std::size_t after = k < 2 ? 0 : words.size() - k - 1;
    if (name == "block" && after >= 2) {
      out.insert(out.end(), {"d_n1", words[k + 1], "d_n2", words[k + 2], "d_density", "0"});
      k += 2;
    } else if (name == "shape" && after >= 3) {
      out.insert(out.end(), {name, words[k + 1], words[k + 2], words[k + 3], "d_density", "0"});
      k += 3;
    } else if (name == "mass" && after >= 1) {
      out.insert(out.end(), {name, words[k + 1], "d_density", "0"});
      k += 1;
    } else if (name == "density" && after >= 1) {
      out.insert(out.end(), {name, words[k + 1], "d_density", words[k + 1]});
      k += 1;
    } else {
      out.push_back(name);
    }
  }
  return out;
}

/// fix and compute ID GROUP STYLE ..
Words with_style(Words words, std::string_view from, const char* to) {
  if (words.size() > 2 && words[2] == from) words[2] = to;
  return words;
}

Words compute_in_older_words(const Words& words) {
  Words out = with_style(words, "erotate/asphere", "plumb/erotate");
  if (out.size() < 3 || out[2] != "property/atom") return out;
  std::replace(out.begin() + 3, out.end(), std::string("block1"), std::string("d_n1"));
  std::replace(out.begin() + 3, out.end(), std::string("block2"), std::string("d_n2"));
  return out;
}

}  // namespace

std::vector<std::string> shapes_of_superellipsoids() {
  return {"fix " + std::string(superellipsoids_fix) + " all property/atom d_n1 d_n2 d_density ghost yes",
          "neigh_modify every 1 delay 0 check yes"};  // as of 2026 where nothing is said
}

std::vector<std::string> in_older_words(std::string_view command, std::span<const std::string> all,
                                        bool has_superellipsoids) {
  const Words words(all.begin(), all.end());
  if (command == "atom_style" && words == Words{"ellipsoid", "superellipsoid"}) {
    std::vector<std::string> out = shapes_of_superellipsoids();
    out.insert(out.begin(), "atom_style ellipsoid");
    return out;
  }
  if (!has_superellipsoids) return {};
  if (command == "read_restart")  // what atoms have comes to a fix that is made after it
    return {"unfix " + std::string(superellipsoids_fix), line_of(command, words)};
  Words out = words;
  if (command == "set") out = set_in_older_words(words);
  if (command == "fix") out = with_style(words, "nve/asphere", "plumb/nve");
  if (command == "compute") out = compute_in_older_words(words);
  return out == words ? std::vector<std::string>{} : std::vector<std::string>{line_of(command, out)};
}

}  // namespace plumb::lammps
