#include "corpus/dump/dump_columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "corpus/json/json_text.hpp"

namespace plumb {
namespace {

/// What a column can be, and the names that it goes by beside its own. Names with brackets are those of a compute
/// property/atom: they do not say what it computes, so that whoever reads them is told.
struct Role {
  std::string_view name;
  std::array<std::string_view, 4> others;
};
constexpr std::array<Role, 24> roles{{{"id", {}},
                                      {"x", {}},
                                      {"y", {}},
                                      {"z", {}},
                                      {"xu", {}},
                                      {"yu", {}},
                                      {"zu", {}},
                                      {"xs", {}},
                                      {"ys", {}},
                                      {"zs", {}},
                                      {"xsu", {}},
                                      {"ysu", {}},
                                      {"zsu", {}},
                                      {"shapex", {"c_shape[1]", "c_diameter[1]"}},
                                      {"shapey", {"c_shape[2]", "c_diameter[2]"}},
                                      {"shapez", {"c_shape[3]", "c_diameter[3]"}},
                                      {"block1", {"blockiness1", "c_block[1]"}},
                                      {"block2", {"blockiness2", "c_block[2]"}},
                                      {"quatw", {"quat1", "c_q[1]", "c_quat[1]", "c_orient[1]"}},
                                      {"quati", {"quat2", "c_q[2]", "c_quat[2]", "c_orient[2]"}},
                                      {"quatj", {"quat3", "c_q[3]", "c_quat[3]", "c_orient[3]"}},
                                      {"quatk", {"quat4", "c_q[4]", "c_quat[4]", "c_orient[4]"}},
                                      {"radius", {}},
                                      {"diameter", {}}}};

using Place = std::optional<std::size_t>;

class Finder {
 public:
  Finder(std::span<const std::string> names, const DumpOptions& options) : names_(names), options_(options) {}

  /// Throws FieldError where two columns have the name.
  Place find(std::string_view role_name) {
    if (const auto asked = options_.columns.find(std::string(role_name)); asked != options_.columns.end())
      return use(asked->second, role_name, true);
    if (const Place place = use(role_name, role_name, false)) return place;
    const auto* const role = std::ranges::find(roles, role_name, &Role::name);
    for (const std::string_view other : role->others)
      if (const Place place = other.empty() ? Place() : use(other, role_name, false)) return place;
    return {};
  }

  /// All of them or none; throws FieldError where some are there.
  template <std::size_t N>
  std::optional<std::array<std::size_t, N>> find_all(const std::array<std::string_view, N>& names) {
    std::array<Place, N> places;
    std::ranges::transform(names, places.begin(), [&](std::string_view name) { return find(name); });
    const auto missing = std::ranges::find(places, Place());
    if (missing == places.end()) {
      std::array<std::size_t, N> out{};
      std::ranges::transform(places, out.begin(), [](const Place& place) { return *place; });
      return out;
    }
    const auto there = std::ranges::find_if(places, [](const Place& place) { return place.has_value(); });
    if (there == places.end()) return {};
    const auto name_at = [&](const auto& place) { return names[static_cast<std::size_t>(place - places.begin())]; };
    throw FieldError(std::string(name_at(missing)), fmt::format("no such column, but one for {}", name_at(there)));
  }

  [[nodiscard]] bool uses(std::string_view name) const { return std::ranges::find(used_, name) != used_.end(); }
  [[nodiscard]] std::vector<std::string>& notes() { return notes_; }

 private:
  /// Whether a column has the name, bare or as LAMMPS writes a compute's, a fix's, a variable's or a custom property's.
  static bool has_name(const std::string& column, std::string_view name) {
    constexpr std::array<std::string_view, 4> marks{"c_", "f_", "v_", "d_"};
    if (column == name) return true;
    return column.size() == name.size() + 2 && column.ends_with(name) &&
           std::ranges::find(marks, std::string_view(column).substr(0, 2)) != marks.end();
  }

  Place use(std::string_view name, std::string_view role, bool is_asked) {
    const auto has = [&](const std::string& column) { return is_asked ? column == name : has_name(column, name); };
    const auto at = std::ranges::find_if(names_, has);
    if (at == names_.end()) {
      if (is_asked) throw FieldError(std::string(role), fmt::format("no column {}", name));
      return {};
    }
    if (std::find_if(at + 1, names_.end(), has) != names_.end())
      throw FieldError(std::string(role), fmt::format("two columns for it: {}", name));
    used_.emplace_back(name);
    if (!is_asked && name.ends_with(']')) notes_.push_back(fmt::format("{} is taken for {}", name, role));
    return static_cast<std::size_t>(at - names_.begin());
  }

  std::span<const std::string> names_;
  const DumpOptions& options_;
  std::vector<std::string> used_, notes_;
};

using Names3 = std::array<std::string_view, 3>;

void find_position(Finder& finder, DumpColumns& out) {
  constexpr std::array<Names3, 4> kinds{
      {{"x", "y", "z"}, {"xu", "yu", "zu"}, {"xs", "ys", "zs"}, {"xsu", "ysu", "zsu"}}};
  for (std::size_t kind = 0; kind < kinds.size(); ++kind)
    if (const auto places = finder.find_all(kinds[kind])) {
      out.position = *places;
      out.is_scaled = kind >= 2;
      return;
    }
  throw FieldError("x", "no columns of a position: x y z, xu yu zu, xs ys zs or xsu ysu zsu");
}

DumpFormat format_of(const Finder& finder, const DumpOptions& options, bool has_shape) {
  if (options.format != DumpFormat::by_columns) return options.format;
  constexpr std::array<std::string_view, 6> liggghts{"quat1", "quat2", "quat3", "quat4", "blockiness1", "blockiness2"};
  if (std::ranges::any_of(liggghts, [&](std::string_view name) { return finder.uses(name); }))
    return DumpFormat::liggghts;
  constexpr std::array<std::string_view, 7> lammps{"quatw",       "block1",     "c_q[1]",    "c_quat[1]",
                                                   "c_orient[1]", "c_block[1]", "c_shape[1]"};
  const bool is_lammps = std::ranges::any_of(lammps, [&](std::string_view name) { return finder.uses(name); });
  if (is_lammps || !has_shape) return DumpFormat::lammps;
  throw FieldError("shapex", "a diameter in LAMMPS's dumps and a semi-axis in LIGGGHTS's: --format says which");
}

void find_size(Finder& finder, DumpColumns& out) {
  out.shape = finder.find_all(Names3{"shapex", "shapey", "shapez"});
  out.exponents = finder.find_all(std::array<std::string_view, 2>{"block1", "block2"});
  out.quaternion = finder.find_all(std::array<std::string_view, 4>{"quatw", "quati", "quatj", "quatk"});
  out.radius = finder.find("radius");
  if (!out.radius) {
    out.radius = finder.find("diameter");
    out.radius_is_diameter = true;
  }
  if (!out.shape && !out.radius)
    throw FieldError("shapex", "no columns of a size: shapex shapey shapez, radius or diameter");
  if (out.shape && !out.exponents) finder.notes().emplace_back("no columns block1 block2: every shape is an ellipsoid");
}

}  // namespace

std::vector<std::string> dump_roles() {
  std::vector<std::string> out;
  for (const Role& role : roles) out.emplace_back(role.name);
  return out;
}

DumpColumns find_columns(std::span<const std::string> names, const DumpOptions& options) {
  Finder finder(names, options);
  DumpColumns out;
  out.width = names.size();
  const Place id = finder.find("id");
  if (!id) throw FieldError("id", "no such column: cases are named by it");
  out.id = *id;
  find_position(finder, out);
  find_size(finder, out);
  out.format = format_of(finder, options, out.shape.has_value());
  out.notes = finder.notes();
  return out;
}

}  // namespace plumb
