#include "solver/python/strided_batch.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <span>
#include <system_error>
#include <thread>
#include <vector>

namespace plumb::python {
namespace {

/// Of pairs, `first` on.
struct Range {
  std::size_t first, count;
};

constexpr std::size_t block_size = 256;

template <class T>
using Slot = std::array<T, block_size>;

template <class T>
[[nodiscard]] std::span<const T> load(const Column<const T>& from, Range range, Slot<T>& slot) {
  if (from.data == nullptr) return {};
  const T* const first = from.data + static_cast<std::ptrdiff_t>(range.first) * from.stride;
  if (from.stride == 1) return {first, range.count};
  for (std::size_t i = 0; i < range.count; ++i) slot[i] = first[static_cast<std::ptrdiff_t>(i) * from.stride];
  return {slot.data(), range.count};
}

/// A copy, also of what stands side by side: the batch may write where it came from.
template <class T>
[[nodiscard]] std::span<const T> copy(const Column<const T>& from, Range range, Slot<T>& slot) {
  const std::span<const T> found = load(from, range, slot);
  if (found.empty()) return {};
  if (found.data() != slot.data()) std::ranges::copy(found, slot.begin());
  return {slot.data(), range.count};
}

/// Where the batch writes a column: its own place, or the slot.
template <class T>
[[nodiscard]] std::span<T> place(const Column<T>& to, Range range, Slot<T>& slot) {
  if (to.data == nullptr) return {};
  return {to.stride == 1 ? to.data + range.first : slot.data(), range.count};
}

template <class T>
void store(const Column<T>& to, Range range, const Slot<T>& slot) {
  if (to.data == nullptr || to.stride == 1) return;
  T* const first = to.data + static_cast<std::ptrdiff_t>(range.first) * to.stride;
  for (std::size_t i = 0; i < range.count; ++i) first[static_cast<std::ptrdiff_t>(i) * to.stride] = slot[i];
}

class BodyBlock {
 public:
  [[nodiscard]] BodyArrays load(const BodyColumns& from, Range range) {
    std::array<std::span<const double>, 12> s;
    for (std::size_t k = 0; k < s.size(); ++k) s[k] = python::load(from[k], range, slots_[k]);
    return {{s[0], s[1], s[2]}, s[10], s[11], {s[3], s[4], s[5]}, {s[6], s[7], s[8], s[9]}};
  }

 private:
  std::array<Slot<double>, 12> slots_;
};

/// What was known of each pair before it is solved again.
class LastBlock {
 public:
  void load(const ChartColumns<const double>& from, Range range) {
    for (std::size_t k = 0; k < slots_.size(); ++k) loaded_[k] = copy(from[k], range, slots_[k]);
  }
  [[nodiscard]] ChartArrays last() const { return step(0); }
  [[nodiscard]] ChartArrays before_last() const { return step(6); }
  /// The last step is the one before for the next. Of a cold batch none is known.
  void store(const ChartColumns<double>& to, Range range) const {
    for (std::size_t k = 0; k < 6; ++k) {
      if (to[6 + k].data == nullptr) continue;
      double* const first = to[6 + k].data + static_cast<std::ptrdiff_t>(range.first) * to[6 + k].stride;
      for (std::size_t i = 0; i < range.count; ++i)
        first[static_cast<std::ptrdiff_t>(i) * to[6 + k].stride] =
            loaded_[k].empty() ? std::numeric_limits<double>::quiet_NaN() : loaded_[k][i];
    }
  }

 private:
  [[nodiscard]] ChartArrays step(std::size_t first) const {
    const auto of = [&](std::size_t k) { return loaded_[first + k]; };
    return {{of(0), of(1), of(2)}, {of(3), of(4), of(5)}};
  }

  std::array<Slot<double>, 12> slots_;
  std::array<std::span<const double>, 12> loaded_;
};

class ContactBlock {
 public:
  [[nodiscard]] ContactArrays place(const ContactColumns& to, Range range) {
    std::array<std::span<double>, 13> s;
    for (std::size_t k = 0; k < s.size(); ++k) s[k] = python::place(to.numbers[k], range, numbers_[k]);
    std::array<std::span<double>, 6> charts;
    for (std::size_t k = 0; k < charts.size(); ++k) charts[k] = python::place(to.charts[k], range, charts_[k]);
    return {python::place(to.status, range, status_),
            python::place(to.verdict, range, verdict_),
            s[0],
            {s[1], s[2], s[3]},
            {s[4], s[5], s[6]},
            {s[7], s[8], s[9]},
            {s[10], s[11], s[12]},
            python::place(to.counts[0], range, counts_[0]),
            python::place(to.counts[1], range, counts_[1]),
            {charts[0], charts[1], charts[2]},
            {charts[3], charts[4], charts[5]}};
  }
  void store(const ContactColumns& to, Range range) const {
    python::store(to.status, range, status_);
    python::store(to.verdict, range, verdict_);
    for (std::size_t k = 0; k < numbers_.size(); ++k) python::store(to.numbers[k], range, numbers_[k]);
    for (std::size_t k = 0; k < counts_.size(); ++k) python::store(to.counts[k], range, counts_[k]);
    for (std::size_t k = 0; k < charts_.size(); ++k) python::store(to.charts[k], range, charts_[k]);
  }

 private:
  Slot<Status> status_;
  Slot<Verdict> verdict_;
  std::array<Slot<double>, 13> numbers_;
  std::array<Slot<int>, 2> counts_;
  std::array<Slot<double>, 6> charts_;
};

/// What one thread works with; a hundred kilobytes.
class Worker {
 public:
  explicit Worker(const StridedBatch& batch) : batch_(batch) {}

  /// How many pairs of the part were handed to `auto`.
  std::size_t solve(Range part) {
    std::size_t alone = 0;
    for (std::size_t done = 0; done < part.count; done += block_size)
      alone += solve_block({part.first + done, std::min(block_size, part.count - done)});
    return alone;
  }

 private:
  std::size_t solve_block(Range range) {
    last_.load(batch_.last, range);
    const PairArrays pairs{body1_.load(batch_.body1, range), body2_.load(batch_.body2, range), last_.last(),
                           last_.before_last()};
    const BatchReport report = solve_batch(pairs, batch_.want, contacts_.place(batch_.contacts, range));
    contacts_.store(batch_.contacts, range);
    last_.store(batch_.contacts.charts, range);
    return report.alone;
  }

  const StridedBatch& batch_;
  BodyBlock body1_, body2_;
  LastBlock last_;
  ContactBlock contacts_;
};

/// The parts that are left, for whichever thread asks next.
class Parts {
 public:
  explicit Parts(std::size_t size) : size_(size) {}

  /// Of no pairs when there is none left.
  [[nodiscard]] Range next() {
    const std::size_t first = std::min(next_.fetch_add(part_size), size_);
    return {first, std::min(part_size, size_ - first)};
  }
  void drop() { next_ = size_; }

 private:
  static constexpr std::size_t part_size = 4096;

  std::size_t size_;
  std::atomic<std::size_t> next_ = 0;
};

std::size_t solve_parts(const StridedBatch& batch, Parts& parts, const std::function<bool()>& goes_on) {
  const auto worker = std::make_unique<Worker>(batch);
  std::size_t alone = 0;
  for (Range part = parts.next(); part.count > 0 && goes_on(); part = parts.next()) alone += worker->solve(part);
  return alone;
}

}  // namespace

BatchRun solve_strided(const StridedBatch& batch, int threads, const std::function<bool()>& goes_on) {
  Parts parts(batch.size);
  std::atomic<std::size_t> alone = 0;
  BatchRun run;
  const auto help = [&] { alone += solve_parts(batch, parts, [] { return true; }); };
  const auto lead = [&] {
    run.complete = run.complete && goes_on();
    if (!run.complete) parts.drop();
    return run.complete;
  };
  {
    std::vector<std::jthread> others;
    try {
      for (int i = 1; i < threads; ++i) others.emplace_back(help);
    } catch (const std::system_error&) {  // no more threads to be had
    }
    alone += solve_parts(batch, parts, lead);
  }
  run.alone = alone;
  return run;
}

}  // namespace plumb::python
