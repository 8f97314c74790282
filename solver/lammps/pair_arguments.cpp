#include "solver/lammps/pair_arguments.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <set>

namespace plumb::scene {
namespace {

/// The words that are still to be read.
struct Words {
  std::span<const std::string> left;

  std::string name() {
    const std::string name = left.front();
    left = left.subspan(1);
    return name;
  }
  double number(const std::string& name) {
    if (left.empty()) throw SceneError(name, "needs a number after it");
    const double number = number_of(name, left.front());
    left = left.subspan(1);
    return number;
  }
};

/// Reads the field of that name.
struct FieldReader {
  std::string name, wanted;
  Words& words;
  bool is_found = false;

  void operator()(const char* field, double& value, Range range) {
    if (field != wanted) return;
    is_found = true;
    value = words.number(name);
    if (!is_within(range, value)) throw SceneError(name, scene::words(range));
  }
  void operator()(const char* field, Vec3<double>& value, Range /*any*/) {
    if (field != wanted) return;
    is_found = true;
    for (double& x : value) x = words.number(name);
  }
  void operator()(const char* /*field*/, std::vector<WallMotion>& /*motions*/, Range /*any*/) {}
};

/// Of all bodies, or of materials.
enum class Holder { all, material };

/// Why an effect is none of the pair style's; empty where it is.
std::string_view why_not(std::string_view effect) {
  if (effect == Gravity::name) return "is fix gravity's";
  if (effect == MovingWalls::name) return "are fix plumb/wall's: velocity, amplitude, frequency";
  if (effect == PeriodicBox::name) return "is LAMMPS's own: boundary p";
  if (effect == Conduction::name) return "is not supported here: run the scene by plumb scene";
  return {};
}

template <class Parameters>
std::string_view why_not(Holder holder) {
  const bool is_mixed = Mixes<Parameters>;
  if (const std::string_view why = why_not(Parameters::name); !why.empty()) return why;
  return holder == Holder::material && !is_mixed ? "holds for all types: give it to pair_style" : "";
}

/// Whether there is such a field, which is read then.
bool read_field(const std::string& name, Effects& effects, Words& words, Holder holder) {
  bool is_found = false;
  each_effect(effects, [&](auto& effect) {
    using Parameters = typename std::remove_cvref_t<decltype(effect)>::value_type;
    const std::string prefix = std::string(Parameters::name) + ".";
    if (!name.starts_with(prefix)) return;
    if (const auto why = why_not<Parameters>(holder); !why.empty())
      throw SceneError(std::string(Parameters::name), std::string(why));
    if (!effect) effect.emplace();
    FieldReader reader{name, name.substr(prefix.size()), words};
    Parameters::each_field(*effect, reader);
    is_found = reader.is_found;
  });
  return is_found;
}

/// The first field of each effect is what it is about.
void require_first_fields(const Effects& effects, const std::set<std::string>& given) {
  each_effect(effects, [&](const auto& effect) {
    using Parameters = typename std::remove_cvref_t<decltype(effect)>::value_type;
    if (!effect) return;
    std::string first;
    Parameters::each_field(*effect, [&](const char* field, const auto& /*value*/, Range /*range*/) {
      if (first.empty()) first = std::string(Parameters::name) + "." + field;
    });
    if (!given.contains(first)) throw SceneError(first, "is required with the other fields of its effect");
  });
}

/// All words: fields of effects, and one name more, whose value `read_other` takes.
template <class ReadOther>
Effects read_effects(std::span<const std::string> words, Holder holder, std::string_view other,
                     const ReadOther& read_other) {
  Effects out;
  std::set<std::string> given;
  Words rest{words};
  while (!rest.left.empty()) {
    const std::string name = rest.name();
    if (!given.insert(name).second) throw SceneError(name, "stands there twice");
    if (name == other)
      read_other(rest);
    else if (!read_field(name, out, rest, holder))
      throw SceneError(name, "is no field of an effect");
  }
  require_first_fields(out, given);
  return out;
}

/// The shortest decimal that reads back to the same double.
std::string shortest(double x) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr};
}

/// Writes fields one after the other.
struct FieldWriter {
  std::string_view effect;
  std::string& out;

  void operator()(const char* field, double value, Range /*range*/) const {
    out += " " + std::string(effect) + "." + field + " " + shortest(value);
  }
  void operator()(const char* field, const Vec3<double>& value, Range /*any*/) const {
    out += " " + std::string(effect) + "." + field;
    for (const double x : value) out += " " + shortest(x);
  }
  void operator()(const char* /*field*/, const std::vector<WallMotion>& /*motions*/, Range /*any*/) const {}
};

/// Those that are the pair style's, a space before each word.
std::string effects_text(const Effects& effects) {
  std::string out;
  each_effect(effects, [&](const auto& effect) {
    using Parameters = typename std::remove_cvref_t<decltype(effect)>::value_type;
    if (effect && why_not(Parameters::name).empty())
      Parameters::each_field(*effect, FieldWriter{Parameters::name, out});
  });
  return out;
}

}  // namespace

double number_of(const std::string& name, const std::string& word) {
  double number = 0;
  const char* const end = word.data() + word.size();
  const auto [last, error] = std::from_chars(word.data(), end, number);
  if (error != std::errc() || last != end || !std::isfinite(number))
    throw SceneError(name, "'" + word + "' is no number");
  return number;
}

PairArguments parse_pair_arguments(std::span<const std::string> words) {
  PairArguments out;
  out.effects = read_effects(words, Holder::all, "accuracy", [&](Words& rest) {
    out.accuracy = rest.number("accuracy");
    if (!(out.accuracy > 0 && out.accuracy < 1)) throw SceneError("accuracy", "must be a number between 0 and 1");
  });
  return out;
}

std::string pair_arguments_text(const PairArguments& arguments) {
  return "accuracy " + shortest(arguments.accuracy) + effects_text(arguments.effects);
}

MaterialArguments parse_material_arguments(std::span<const std::string> words) {
  MaterialArguments out;
  out.effects = read_effects(words, Holder::material, "rigid", [&](Words& rest) {
    const std::string word = rest.left.empty() ? "" : rest.name();
    if (word != "yes" && word != "no") throw SceneError("rigid", "must be yes or no");
    out.is_rigid = word == "yes";
  });
  return out;
}

std::string material_arguments_text(const MaterialArguments& arguments) {
  return (arguments.is_rigid ? " rigid yes" : "") + effects_text(arguments.effects);
}

}  // namespace plumb::scene
