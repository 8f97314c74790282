// Case files, formats plumb/case-1 and plumb/case-2: the one reader and writer. Format and meaning: corpus/formats/case.md.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "corpus/json/json_text.hpp"
#include "corpus/json/object_reader.hpp"
#include "solver/contact.hpp"
#include "solver/shape/convex.hpp"

namespace plumb {

/// What a case promises; every field may be absent. Status and finding are about the method; verdict, overlap, normal and
/// points are about the pair and hold for every method that answers the same problem.
struct Expect {
  std::optional<std::string> method;  ///< the method that the expectations are about; default auto
  std::optional<std::string> status;
  std::optional<std::string> verdict;
  std::optional<std::string> finding;
  std::optional<std::array<double, 2>> overlap;  ///< [lower, upper]
  std::optional<Vec3<double>> normal;
  std::optional<double> normal_radius;  ///< rad
  std::optional<std::array<Vec3<double>, 2>> points;

  [[nodiscard]] bool empty() const;
};

struct Case {
  std::string name;
  Pair pair;
  Expect expect;
  Json provenance;  ///< anything; null when absent
  Json extra;       ///< the top-level fields whose names begin with "x_", as an object; null when there are none
  /// Where a shape is no superellipsoid's; `pair` says nothing then. Only who asks for every shape gets such a case.
  std::optional<ConvexPair> convex = {};
};

/// What a reader of cases can do: it refuses the others.
enum class CaseShapes { superellipsoids, every };

/// Unusable input or output: what() is the one line "FILE:LINE: FIELD: REASON" (line in .jsonl only).
class InputFailure : public std::runtime_error {
 public:
  InputFailure(const std::string& file, int line, const std::string& field, const std::string& reason);
};

/// Throws the InputFailure of an errno.
[[noreturn]] void fail_with(const std::string& file, int error);

class Field;

/// The two bodies of an object that holds "bodies" as a case file does, legal ones; throws FieldError.
[[nodiscard]] Pair read_pair(const Field& object);

/// The bodies as files hold them: position and quaternion.
[[nodiscard]] Json bodies_json(const Pair& pair);

/// Reads one case from JSON text; `file` and `line` (0: none) name the source in errors. Euler angles and placement are
/// evaluated in 50 digits and each component is rounded once to the nearest double.
[[nodiscard]] Case parse_case(const std::string& text, const std::string& file, int line = 0,
                              CaseShapes shapes = CaseShapes::superellipsoids);

/// The case as one line of JSON, in the oldest format that has its shapes: position and quaternion only, each number the shortest that reads back the same.
[[nodiscard]] std::string format_case(const Case& c);

/// A source of cases read one after the other: a .json file holds one, a .jsonl file and standard input ("-") hold one a line
/// or a single one over several. The cases before a bad line are handed out before it throws.
class CaseReader {
 public:
  explicit CaseReader(const std::string& path, CaseShapes shapes = CaseShapes::superellipsoids);
  /// nullopt at the end; throws InputFailure.
  [[nodiscard]] std::optional<Case> next();
  /// Line of the case that next() handed out last; 0 in a file that is one case.
  [[nodiscard]] int line() const { return objects_.line(); }
  /// As errors name it.
  [[nodiscard]] const std::string& file() const { return objects_.file(); }

 private:
  ObjectReader objects_;
  CaseShapes shapes_;
};

/// Every case file at or under the paths, sorted by path: a file that is named is one whatever its name, in a folder *.json
/// and *.jsonl are, except a campaign's summary.json. Throws InputFailure for a path that is missing.
[[nodiscard]] std::vector<std::filesystem::path> find_case_files(const std::vector<std::string>& paths);

/// An OutputFile (corpus/file/output_file.hpp) of that text. Throws InputFailure.
void write_file(const std::filesystem::path& path, const std::string& text);

}  // namespace plumb
