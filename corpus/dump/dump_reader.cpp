#include "corpus/dump/dump_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "corpus/case/case.hpp"
#include "corpus/command/interrupt.hpp"

namespace plumb {
namespace {

/// No length of a dump is beyond it: squares and products of lengths stay finite.
constexpr double farthest = 1e100;

void split(std::string_view line, std::vector<std::string_view>& out) {
  constexpr const char* blanks = " \t";
  out.clear();
  for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    out.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(blanks, end);
  }
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> out;
  split(line, out);
  return out;
}

/// What follows the item's name; nullopt where the line is another item.
std::optional<std::string_view> after(std::string_view line, std::string_view item) {
  if (!line.starts_with(item)) return {};
  line.remove_prefix(item.size());
  if (!line.empty() && line[0] != ' ') return {};
  return line;
}

/// What is quoted in errors: not all of a line that is no dump's.
std::string excerpt_of(std::string_view text) {
  constexpr std::size_t most = 40;
  std::string out(text.substr(0, most));
  std::ranges::replace_if(out, [](unsigned char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + out + (text.size() > most ? "...'" : "'");
}

}  // namespace

/// What stands before a frame's rows, as far as it is read.
struct DumpReader::Items {
  std::optional<std::int64_t> step, count;
  std::optional<double> time;
  std::optional<DumpBox> box;
  std::optional<DumpColumns> columns;
};

/// All of it.
struct DumpReader::Head {
  std::int64_t step, count;
  std::optional<double> time;
  DumpBox box;
  DumpColumns columns;
};

DumpReader::DumpReader(const std::string& path, DumpOptions options) : in_(path), options_(std::move(options)) {}

DumpReader::DumpReader(std::istream& in, std::string name, DumpOptions options)
    : in_(in, std::move(name)), options_(std::move(options)) {}

void DumpReader::fail(const std::string& field, const std::string& reason) const {
  throw InputFailure(in_.file(), in_.line(), field, reason);
}

bool DumpReader::read_line() {
  if (!in_.next_line(line_)) return false;
  if (line_.ends_with('\r')) line_.pop_back();
  return true;
}

void DumpReader::need_line(const char* what) {
  if (!read_line()) fail(what, "the file ends in the middle of a frame");
}

std::int64_t DumpReader::whole_number(std::string_view text, const std::string& field) const {
  std::int64_t out = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (error != std::errc() || end != text.data() + text.size() || text.empty())
    fail(field, excerpt_of(text) + " is no whole number");
  return out;
}

double DumpReader::number(std::string_view text, const std::string& field) const {
  double out = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (error != std::errc() || end != text.data() + text.size() || text.empty() || !std::isfinite(out))
    fail(field, excerpt_of(text) + " is no finite number");
  return out;
}

double DumpReader::length(std::string_view text, const std::string& field) const {
  const double out = number(text, field);
  if (std::abs(out) > farthest) fail(field, excerpt_of(text) + " is beyond 1e100");
  return out;
}

void DumpReader::read_box(Items& head, std::string_view words) {
  std::vector<std::string_view> flags = words_of(words);
  const bool is_general = flags.size() >= 2 && flags[0] == "abc" && flags[1] == "origin";
  const bool is_tilted = flags.size() >= 3 && flags[0] == "xy" && flags[1] == "xz" && flags[2] == "yz";
  if (is_general) flags.erase(flags.begin(), flags.begin() + 2);
  if (is_tilted) flags.erase(flags.begin(), flags.begin() + 3);
  if (!flags.empty() && flags.size() != 3) fail("BOX BOUNDS", "needs three boundary flags (pp, ff, ..)");
  if (flags.empty()) note({"BOX BOUNDS without boundary flags: taken as not periodic"});
  DumpBox box;
  for (std::size_t k = 0; k < flags.size(); ++k) box.is_periodic[k] = flags[k] == "pp";
  Mat3<double> rows;  // low, high, tilt of each axis; or an edge
  const std::size_t width = is_general ? 4 : is_tilted ? 3 : 2;
  for (int k = 0; k < 3; ++k) {
    need_line("BOX BOUNDS");
    const auto numbers = words_of(line_);
    if (numbers.size() != width) fail("BOX BOUNDS", fmt::format("needs {} numbers a line", width));
    rows.row(k).setZero();
    for (std::size_t n = 0; n < std::min<std::size_t>(width, 3); ++n)
      rows(k, static_cast<int>(n)) = length(numbers[n], "BOX BOUNDS");
    if (is_general) box.origin[k] = length(numbers[3], "BOX BOUNDS");
  }
  if (is_general) {
    box.edges = rows.transpose();
  } else {
    // LAMMPS writes the box around a tilted cell: what the tilts add to it is taken off (Howto_triclinic).
    const double xy = rows(0, 2), xz = rows(1, 2), yz = rows(2, 2);
    const Vec3<double> low = rows.col(0) - Vec3<double>(std::min({0.0, xy, xz, xy + xz}), std::min(0.0, yz), 0);
    const Vec3<double> high = rows.col(1) - Vec3<double>(std::max({0.0, xy, xz, xy + xz}), std::max(0.0, yz), 0);
    box.origin = low;
    box.edges << high.x() - low.x(), xy, xz, 0, high.y() - low.y(), yz, 0, 0, high.z() - low.z();
  }
  const double volume = box.edges.determinant();
  if (!is_general && (box.edges.diagonal().array() < 0).any())
    fail("BOX BOUNDS", "the low bound is above the high one");
  if (box.repeats() && !(std::abs(volume) > 0 && box.edges.inverse().allFinite()))
    fail("BOX BOUNDS", "a periodic box without volume");
  head.box = box;
}

void DumpReader::read_atoms(Items& head, std::string_view names) const {
  std::vector<std::string> columns;
  for (const std::string_view name : words_of(names)) columns.emplace_back(name);
  try {
    head.columns = find_columns(columns, options_);
  } catch (const FieldError& error) {
    fail(error.field, error.what());
  }
  if (!head.step) fail("TIMESTEP", "stands nowhere before the atoms");
  if (!head.count) fail("NUMBER OF ATOMS", "stands nowhere before the atoms");
  if (!head.box) fail("BOX BOUNDS", "stands nowhere before the atoms");
}

void DumpReader::read_item(Items& head) {
  if (const auto words = after(line_, "ITEM: BOX BOUNDS")) return read_box(head, std::string(*words));
  if (const auto names = after(line_, "ITEM: ATOMS")) return read_atoms(head, *names);
  const std::string item = line_;
  need_line(item.starts_with("ITEM: ") ? item.c_str() + 6 : "");
  if (item == "ITEM: UNITS") {
    units_ = line_;
  } else if (item == "ITEM: TIME") {
    head.time = number(line_, "TIME");
  } else if (item == "ITEM: TIMESTEP") {
    head.step = whole_number(line_, "TIMESTEP");
  } else if (item == "ITEM: NUMBER OF ATOMS") {
    head.count = whole_number(line_, "NUMBER OF ATOMS");
    if (*head.count < 0) fail("NUMBER OF ATOMS", "must not be negative");
  } else if (item != "ITEM: LABEL") {
    throw InputFailure(in_.file(), in_.line() - 1, "", excerpt_of(item) + " is no item of a dump of atoms");
  }
}

std::optional<DumpReader::Head> DumpReader::read_head() {
  Items items;
  bool any = false;
  while (!items.columns) {
    if (!read_line()) {
      if (any) fail("", "the file ends in the middle of a frame");
      return {};
    }
    if (!any && words_of(line_).empty()) continue;
    any = true;
    if (line_.starts_with("\x1f\x8b")) fail("", "is compressed: zcat FILE | plumb import -");
    if (!line_.starts_with("ITEM: ")) fail("", excerpt_of(line_) + " where 'ITEM: ..' should stand");
    read_item(items);
  }
  // The columns come last, and read_atoms has seen that the others are there.
  return Head{items.step.value_or(0), items.count.value_or(0), items.time, items.box.value_or(DumpBox{}),
              items.columns.value_or(DumpColumns{})};
}

void DumpReader::note(const std::vector<std::string>& notes) {
  for (const std::string& text : notes)
    if (std::ranges::find(notes_, text) == notes_.end()) notes_.push_back(text);
}

void DumpReader::pass_over(const Head& head) {
  for (std::int64_t row = 0; row < head.count && !interrupted(); ++row) need_line("ATOMS");
}

std::optional<Superellipsoid<double>> DumpReader::read_shape(const DumpColumns& columns,
                                                             const std::vector<std::string_view>& row) const {
  constexpr std::array<const char*, 3> names{"shapex", "shapey", "shapez"};
  Superellipsoid<double> shape{Vec3<double>::Zero()};
  if (columns.shape)
    for (std::size_t k = 0; k < 3; ++k)
      shape.semi_axes[static_cast<int>(k)] = length(row[(*columns.shape)[k]], names[k]);
  if (shape.semi_axes.isZero(0)) {
    const char* const name = columns.radius_is_diameter ? "diameter" : "radius";
    const double radius = columns.radius ? length(row[*columns.radius], name) : 0;
    if (radius < 0) fail(name, "must not be negative");
    if (radius == 0) return {};
    shape.semi_axes.setConstant(columns.radius_is_diameter ? radius / 2 : radius);
    return shape;
  }
  for (std::size_t k = 0; k < 3; ++k)
    if (!(shape.semi_axes[static_cast<int>(k)] > 0)) fail(names[k], "must be positive, or all three 0");
  if (columns.format == DumpFormat::lammps) shape.semi_axes /= 2;
  if (columns.exponents) {
    shape.n1 = number(row[(*columns.exponents)[0]], "block1");
    shape.n2 = number(row[(*columns.exponents)[1]], "block2");
    if (!(shape.n1 > 1)) fail("block1", "must be above 1");
    if (!(shape.n2 > 1)) fail("block2", "must be above 1");
  }
  return shape;
}

std::optional<DumpParticle> DumpReader::read_particle(const Head& head,
                                                      const std::vector<std::string_view>& row) const {
  const DumpColumns& columns = head.columns;
  DumpParticle out;
  out.id = whole_number(row[columns.id], "id");
  const std::array<std::string, 3> names =
      columns.is_scaled ? std::array<std::string, 3>{"xs", "ys", "zs"} : std::array<std::string, 3>{"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k)
    out.body.position[static_cast<int>(k)] = length(row[columns.position[k]], names[k]);
  if (columns.is_scaled) out.body.position = head.box.origin + head.box.edges * out.body.position;
  const auto shape = read_shape(columns, row);
  if (!shape) return {};
  out.body.shape = *shape;
  const bool is_ball = (shape->semi_axes.array() == shape->semi_axes[0]).all() && shape->n1 == 2 && shape->n2 == 2;
  if (!columns.quaternion && !is_ball)
    fail("quatw", "no columns quatw quati quatj quatk, and the particle is no sphere");
  if (columns.quaternion)
    for (std::size_t k = 0; k < 4; ++k) out.body.quaternion[k] = number(row[(*columns.quaternion)[k]], "quatw");
  // LAMMPS writes zeros where a particle has no orientation, and a sphere needs none.
  if (is_ball && out.body.quaternion == std::array<double, 4>{}) out.body.quaternion = {1, 0, 0, 0};
  if (out.body.quaternion == std::array<double, 4>{}) fail("quatw", "must not be 0, nor the other three");
  if (const InputError error = find_input_error({out.body, out.body}); !error.reason.empty())
    fail(std::string(error.field), std::string(error.reason));
  return out;
}

DumpFrame DumpReader::read_rows(const Head& head) {
  DumpFrame frame{head.step, head.time, units_, head.columns.format, head.box, {}, 0};
  std::vector<std::string_view> row;
  for (std::int64_t k = 0; k < head.count && !interrupted(); ++k) {
    need_line("ATOMS");
    split(line_, row);
    if (row.size() != head.columns.width)
      fail("ATOMS", fmt::format("{} values in a row of {} columns", row.size(), head.columns.width));
    if (const auto particle = read_particle(head, row))
      frame.particles.push_back(*particle);
    else
      ++frame.points;
  }
  sort_particles(frame);
  return frame;
}

void DumpReader::sort_particles(DumpFrame& frame) const {
  std::ranges::sort(frame.particles, {}, &DumpParticle::id);
  const auto twice = std::ranges::adjacent_find(frame.particles, {}, &DumpParticle::id);
  if (twice != frame.particles.end()) fail("id", fmt::format("{} stands twice in the frame that ends here", twice->id));
}

std::optional<DumpFrame> DumpReader::next(const std::function<bool(std::int64_t)>& is_wanted) {
  while (const auto head = read_head()) {
    if (interrupted()) break;
    if (is_wanted(head->step)) {
      note(head->columns.notes);
      return read_rows(*head);
    }
    pass_over(*head);
  }
  return {};
}

}  // namespace plumb
