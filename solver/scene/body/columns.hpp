// The state as named columns: so many numbers for each body (walls after the bodies), for each pair of the contact list, or once.
// What is kept goes into checkpoints and the hash, whoever owns it. A contact's answer goes into checkpoints, and what is known of pairs
// apart: where a step finds none, the last one stands (in a part of a scene until its list is new). The rest is made anew in each step.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string_view>
#include <vector>

#include "solver/contact.hpp"

namespace plumb::scene {

struct ColumnKind {
  enum Of { body, pair, scene } of = body;
  int width = 1;  ///< numbers an entry
  bool is_kept = false;
  double initial = 0;      ///< of an entry that is new
  bool forgets = false;    ///< a pair that does not touch has the initial value again
  bool is_answer = false;  ///< of the solver, made of its answer alone, or that no answer is needed

  [[nodiscard]] bool is_saved() const { return is_kept || is_answer; }
};

/// What a contact remembers for as long as it lasts.
[[nodiscard]] inline ColumnKind history(int width) {
  return {.of = ColumnKind::pair, .width = width, .is_kept = true, .forgets = true};
}

class Column {
 public:
  using Vector = Eigen::Map<Vec3<double>>;
  using ConstVector = Eigen::Map<const Vec3<double>>;

  Column(std::string_view name, std::string_view owner, ColumnKind kind) : name_(name), owner_(owner), kind_(kind) {}

  [[nodiscard]] std::string_view name() const { return name_; }
  /// The effect, "state", "contacts" or "solver".
  [[nodiscard]] std::string_view owner() const { return owner_; }
  [[nodiscard]] const ColumnKind& kind() const { return kind_; }

  [[nodiscard]] double& operator[](std::size_t i) { return values_[i]; }
  [[nodiscard]] double operator[](std::size_t i) const { return values_[i]; }
  /// Of a column three wide.
  [[nodiscard]] Vector vector(std::size_t i) { return Vector(values_.data() + 3 * i); }
  [[nodiscard]] ConstVector vector(std::size_t i) const { return ConstVector(values_.data() + 3 * i); }
  [[nodiscard]] std::span<double> entry(std::size_t i) { return {values_.data() + width() * i, width()}; }
  [[nodiscard]] std::span<const double> entry(std::size_t i) const { return {values_.data() + width() * i, width()}; }
  [[nodiscard]] std::size_t width() const { return static_cast<std::size_t>(kind_.width); }
  [[nodiscard]] std::size_t size() const { return values_.size() / width(); }

  /// So many entries, all new.
  void renew(std::size_t entries) { values_.assign(entries * width(), kind_.initial); }
  void fill(double value) { std::fill(values_.begin(), values_.end(), value); }
  [[nodiscard]] std::vector<double>& values() { return values_; }
  [[nodiscard]] const std::vector<double>& values() const { return values_; }

 private:
  std::string_view name_, owner_;
  ColumnKind kind_;
  std::vector<double> values_;
};

/// All there are; what add() hands out stays where it is.
class Columns {
 public:
  [[nodiscard]] Column& add(std::string_view name, std::string_view owner, ColumnKind kind) {
    return columns_.emplace_back(name, owner, kind);
  }
  /// nullptr when there is none of that name.
  [[nodiscard]] Column* find(std::string_view name);
  [[nodiscard]] const Column* find(std::string_view name) const;
  [[nodiscard]] auto begin() { return columns_.begin(); }
  [[nodiscard]] auto end() { return columns_.end(); }
  [[nodiscard]] auto begin() const { return columns_.begin(); }
  [[nodiscard]] auto end() const { return columns_.end(); }
  void renew(ColumnKind::Of of, std::size_t entries);

 private:
  std::deque<Column> columns_;
};

/// FNV-1a of the bits, 64 of them, -0 as 0 and every NaN as one.
[[nodiscard]] std::uint64_t hash_of(std::span<const double> values, std::uint64_t seed = 0xcbf29ce484222325U);

}  // namespace plumb::scene
