// Reading the fields of a JSON tree with errors that say where: each function throws FieldError with the field's path.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "corpus/json/json_text.hpp"
#include "solver/contact.hpp"

namespace plumb {

/// A place in a tree that outlives it.
class Field {
 public:
  /// `path`: what errors call the root itself.
  explicit Field(const Json& root, std::string path = "") : value_(&root), path_(std::move(path)) {}

  [[nodiscard]] const Json& value() const { return *value_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[noreturn]] void fail(const std::string& reason) const { throw FieldError(path_, reason); }

  /// The path of a member, whether it is there or not.
  [[nodiscard]] std::string path_of(std::string_view key) const;
  [[nodiscard]] bool has(std::string_view key) const;
  [[nodiscard]] Field member(std::string_view key) const;
  [[nodiscard]] std::optional<Field> find(std::string_view key) const;

  /// Refuses anything but an object whose members are all known or begin with "x_".
  void require_object(std::span<const std::string_view> known) const;
  void require_object(std::initializer_list<std::string_view> known) const {
    require_object(std::span(known.begin(), known.size()));
  }
  /// Element of an array of exactly `size` values; `what` names them in the error ("numbers").
  [[nodiscard]] Field element(std::size_t index, std::size_t size, const char* what) const;

  /// Every element of an array of any size.
  [[nodiscard]] std::vector<Field> elements() const;

  /// The members of an object, of whatever names.
  [[nodiscard]] std::vector<std::pair<std::string, Field>> members() const;

  [[nodiscard]] double number() const;
  [[nodiscard]] bool flag() const;
  /// Exact where a double is not: a seed has 64 bits.
  [[nodiscard]] std::uint64_t natural(std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) const;
  /// A number without a fraction, between the two.
  [[nodiscard]] int whole_number(int least, int most) const;
  [[nodiscard]] int count() const { return whole_number(0, std::numeric_limits<int>::max()); }
  [[nodiscard]] std::string text() const;
  /// Refuses any text but this one.
  void require_text(const std::string& only) const;
  template <std::size_t N>
  [[nodiscard]] std::array<double, N> numbers() const {
    std::array<double, N> out;
    for (std::size_t i = 0; i < N; ++i) out[i] = element(i, N, "numbers").number();
    return out;
  }
  [[nodiscard]] Vec3<double> vector() const;

 private:
  const Json* value_;
  std::string path_;
};

/// What Field::vector reads.
[[nodiscard]] Json vector_json(const Vec3<double>& v);

}  // namespace plumb
