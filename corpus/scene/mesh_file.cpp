#include "corpus/scene/mesh_file.hpp"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "corpus/case/case.hpp"

namespace plumb::scene {
namespace {

constexpr std::size_t stl_head = 80, stl_triangle = 50;
/// Of one file: what a machine of today holds.
constexpr std::size_t most_triangles = 20'000'000;

/// Lines of words, with errors that say which.
class Words {
 public:
  Words(std::string_view text, std::string file) : left_(text), file_(std::move(file)) {}

  [[noreturn]] void fail(const std::string& field, const std::string& reason) const {
    throw InputFailure(file_, line_, field, reason);
  }
  /// The next line that holds a word; false at the end.
  [[nodiscard]] bool next_line() {
    while (!left_.empty()) {
      const std::size_t end = std::min(left_.find('\n'), left_.size());
      rest_ = left_.substr(0, end);
      left_.remove_prefix(std::min(end + 1, left_.size()));
      ++line_;
      skip_blanks();
      if (!rest_.empty()) return true;
    }
    return false;
  }
  /// The line's next word; empty where there is none.
  [[nodiscard]] std::string_view word() {
    const std::size_t end = std::min(rest_.find_first_of(" \t\r"), rest_.size());
    const std::string_view out = rest_.substr(0, end);
    rest_.remove_prefix(end);
    skip_blanks();
    return out;
  }
  [[nodiscard]] double number(const std::string& field) {
    std::string_view text = word();
    if (text.starts_with('+')) text.remove_prefix(1);
    double out = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    if (text.empty() || error != std::errc{} || end != text.data() + text.size() || !std::isfinite(out))
      fail(field, "must be a finite number");
    return out;
  }
  [[nodiscard]] Vec3<double> vector(const std::string& field) {
    Vec3<double> out;
    for (double& x : out) x = number(field);
    return out;
  }
  void require_end(const std::string& field) const {
    if (!rest_.empty()) fail(field, "has more words than it should");
  }
  /// The line's next words, and nothing after them.
  void require(std::initializer_list<std::string_view> words) {
    for (const std::string_view one : words)
      if (word() != one) fail(std::string(*words.begin()), "is missing");
    require_end(std::string(*words.begin()));
  }
  void require_line(std::initializer_list<std::string_view> words) {
    if (!next_line()) fail(std::string(*words.begin()), "is missing: the file ends");
    require(words);
  }

 private:
  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r"), rest_.size())); }

  std::string_view left_, rest_;
  std::string file_;
  int line_ = 0;
};

double float_at(std::string_view bytes, std::size_t at) {
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < 4; ++k) bits |= std::uint32_t{static_cast<unsigned char>(bytes[at + k])} << (8 * k);
  return std::bit_cast<float>(bits);
}

std::size_t count_at(std::string_view bytes) {
  std::size_t out = 0;
  for (std::size_t k = 0; k < 4; ++k) out |= std::size_t{static_cast<unsigned char>(bytes[stl_head + k])} << (8 * k);
  return out;
}

bool is_binary(std::string_view bytes) {
  return bytes.size() >= stl_head + 4 && bytes.size() == stl_head + 4 + stl_triangle * count_at(bytes);
}

std::string name_of_triangle(std::size_t k) {
  return "triangles[" + std::to_string(k) + "]";
}

std::vector<Triangle> parse_binary_stl(std::string_view bytes, const std::string& file) {
  const std::size_t count = count_at(bytes);
  if (count > most_triangles) throw InputFailure(file, 0, "triangles", "are more than 20000000");
  std::vector<Triangle> out(count);
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t corner = 0; corner < 3; ++corner)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = float_at(bytes, stl_head + 4 + stl_triangle * k + 12 + 12 * corner + 4 * axis);
        if (!std::isfinite(x)) throw InputFailure(file, 0, name_of_triangle(k), "must be finite numbers");
        out[k][corner][static_cast<int>(axis)] = x;
      }
  return out;
}

Triangle read_facet(Words& words) {
  if (words.word() != "normal") words.fail("facet", "must be followed by normal");
  (void)words.vector("normal");  // what it is follows from the corners
  words.require_end("normal");
  words.require_line({"outer", "loop"});
  Triangle out;
  for (Vec3<double>& corner : out) {
    if (!words.next_line() || words.word() != "vertex") words.fail("vertex", "is missing");
    corner = words.vector("vertex");
    words.require_end("vertex");
  }
  words.require_line({"endloop"});
  words.require_line({"endfacet"});
  return out;
}

std::vector<Triangle> parse_ascii_stl(std::string_view text, const std::string& file) {
  Words words(text, file);
  if (!words.next_line() || words.word() != "solid") words.fail("solid", "is missing");
  std::vector<Triangle> out;
  while (words.next_line()) {
    const std::string_view word = words.word();
    if (word == "endsolid") {
      if (words.next_line()) words.fail("endsolid", "must be the end: one solid a file");
      return out;
    }
    if (word != "facet") words.fail(std::string(word), "is none of facet, endsolid");
    if (out.size() == most_triangles) words.fail("facet", "is one of more than 20000000");
    out.push_back(read_facet(words));
  }
  words.fail("endsolid", "is missing: the file ends");
}

/// A corner of a face: "7", "7/1", "7//2" or "7/1/2", counted from 1, or back from the last where negative.
std::size_t corner_index(Words& words, std::size_t corners) {
  const std::string_view text = words.word(), first = text.substr(0, text.find('/'));
  long long index = 0;
  const auto [end, error] = std::from_chars(first.data(), first.data() + first.size(), index);
  const auto count = static_cast<long long>(corners);
  if (first.empty() || error != std::errc{} || end != first.data() + first.size())
    words.fail("f", "must hold three corners");
  if (index == 0 || index > count || index < -count) words.fail("f", "has a corner that is not there");
  return static_cast<std::size_t>(index > 0 ? index - 1 : count + index);
}

bool is_of_no_matter(std::string_view word) {
  constexpr std::array<std::string_view, 9> known{"vn", "vt", "o", "g", "s", "usemtl", "mtllib", "l", "p"};
  return word.starts_with('#') || std::ranges::find(known, word) != known.end();
}

}  // namespace

std::vector<Triangle> parse_stl(std::string_view bytes, const std::string& file) {
  if (is_binary(bytes)) return parse_binary_stl(bytes, file);
  if (bytes.starts_with("solid")) return parse_ascii_stl(bytes, file);
  if (bytes.size() < stl_head + 4) throw InputFailure(file, 0, "", "is no STL file: it ends within its head");
  throw InputFailure(file, 0, "triangles",
                     "are " + std::to_string(count_at(bytes)) +
                         " by its head, and the file's length is that of another number");
}

std::vector<Triangle> parse_obj(std::string_view text, const std::string& file) {
  Words words(text, file);
  std::vector<Vec3<double>> corners;
  std::vector<Triangle> out;
  while (words.next_line()) {
    const std::string_view word = words.word();
    if (word == "v") {
      corners.push_back(words.vector("v"));  // a weight or a colour may follow
    } else if (word == "f") {
      Triangle& triangle = out.emplace_back();
      for (Vec3<double>& corner : triangle) corner = corners[corner_index(words, corners.size())];
      if (!words.word().empty()) words.fail("f", "has more than three corners: cut it into triangles");
      if (out.size() > most_triangles) words.fail("f", "is one of more than 20000000");
    } else if (!is_of_no_matter(word)) {
      words.fail(std::string(word), "is no line of an OBJ file that is known");
    }
  }
  return out;
}

std::vector<Triangle> read_mesh_file(const std::string& path) {
  std::string kind = std::filesystem::path(path).extension().string();
  for (char& c : kind) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (kind != ".stl" && kind != ".obj") throw InputFailure(path, 0, "", "its name must end in .stl or .obj");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in || std::filesystem::is_directory(path)) fail_with(path, errno == 0 ? EISDIR : errno);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  return kind == ".stl" ? parse_stl(bytes, path) : parse_obj(bytes, path);
}

MeshWall made_mesh(std::vector<Triangle> triangles, const std::string& file) {
  try {
    MeshWall out;
    out.mesh = std::make_shared<const Mesh>(std::move(triangles));
    return out;
  } catch (const std::invalid_argument& error) {
    const std::string_view words = error.what();
    const std::size_t colon = words.find(": ");
    throw InputFailure(file, 0, std::string(words.substr(0, colon)), std::string(words.substr(colon + 2)));
  }
}

}  // namespace plumb::scene
