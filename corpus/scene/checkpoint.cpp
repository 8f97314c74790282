#include "corpus/scene/checkpoint.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <type_traits>

#include "corpus/case/case.hpp"
#include "corpus/file/text_input.hpp"

namespace plumb::scene {
namespace {

static_assert(std::endian::native == std::endian::little, "checkpoints hold numbers as the machine has them");

constexpr std::string_view magic = "plumb-checkpoint";
constexpr std::uint64_t version = 2;

class Packer {
 public:
  std::string bytes;

  template <class Number>
  void number(Number x) {
    static_assert(std::is_arithmetic_v<Number> && sizeof(Number) == 8);
    const auto bits = std::bit_cast<std::array<char, 8>>(x);
    bytes.append(bits.data(), bits.size());
  }
  void text(std::string_view text) {
    number(std::uint64_t{text.size()});
    bytes += text;
  }
  template <class Number>
  void numbers(std::span<const Number> values) {
    number(std::uint64_t{values.size()});
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }
  template <class Value>
  void table(const std::map<std::string, Value>& values) {
    number(std::uint64_t{values.size()});
    for (const auto& [name, value] : values) {
      text(name);
      number(value);
    }
  }
};

struct Damaged {
  const char* field;
  const char* reason;
};

/// Throws Damaged, of the field that was entered last, where the bytes end too early or say what no run writes.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : rest_(bytes) {}

  void enter(const char* field) { field_ = field; }
  [[noreturn]] void fail(const char* reason) const { throw Damaged{field_, reason}; }

  template <class Number>
  [[nodiscard]] Number number() {
    std::array<char, 8> bits{};
    const std::string_view taken = take(bits.size());
    std::ranges::copy(taken, bits.data());
    return std::bit_cast<Number>(bits);
  }
  [[nodiscard]] std::string text() { return std::string(take(number<std::uint64_t>())); }
  /// Of a column, a file or an owner of time: letters that any text may hold.
  [[nodiscard]] std::string name() {
    const std::string out = text();
    if (!std::ranges::all_of(out, [](char c) { return c >= ' ' && c <= '~'; })) fail("holds a name that no run has");
    return out;
  }
  [[nodiscard]] std::int64_t total() {
    constexpr std::int64_t greatest = std::int64_t{1} << 53;
    const auto out = number<std::int64_t>();
    if (out < 0 || out > greatest) fail("must be a whole number from 0 to 2^53");
    return out;
  }
  template <class Number>
  [[nodiscard]] std::vector<Number> numbers() {
    const auto count = number<std::uint64_t>();
    if (count > rest_.size() / sizeof(Number)) fail(too_early);
    std::vector<Number> out(count);
    const std::string_view taken = take(count * sizeof(Number));
    std::ranges::copy(taken, reinterpret_cast<char*>(out.data()));
    return out;
  }
  template <class Value>
  [[nodiscard]] std::map<std::string, Value> table() {
    std::map<std::string, Value> out;
    for (auto left = number<std::uint64_t>(); left > 0; --left) {
      const std::string owner = name();
      out[owner] = number<Value>();
    }
    return out;
  }
  /// Takes the checksum from the end of `bytes`, the whole file, whose rest this is.
  void require_seal(std::string_view bytes) {
    constexpr std::size_t size = 8;
    enter("");
    if (rest_.size() < size) fail(not_sealed);
    rest_.remove_suffix(size);
    const std::string_view summed = bytes.substr(0, bytes.size() - size);
    if (Unpacker(bytes.substr(summed.size())).number<std::uint64_t>() != hash_of_text(summed)) fail(not_sealed);
  }
  void require_end() const {
    if (!rest_.empty()) fail("is longer than it may be");
  }

 private:
  static constexpr const char* too_early = "ends too early";
  static constexpr const char* not_sealed = "is damaged: its checksum does not fit, or its end is missing";

  std::string_view take(std::uint64_t count) {
    if (count > rest_.size()) fail(too_early);
    const std::string_view out = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return out;
  }
  std::string_view rest_;
  const char* field_ = "version";
};

void pack(Packer& out, const Snapshot& snapshot) {
  out.number(snapshot.step);
  for (const std::int64_t total : {snapshot.totals.solves, snapshot.totals.evaluations, snapshot.totals.failed,
                                   snapshot.totals.failed_warm, snapshot.totals.lists})
    out.number(total);
  out.numbers(std::span<const std::array<std::uint32_t, 2>>(snapshot.pairs));
  out.number(std::uint64_t{snapshot.columns.size()});
  for (const auto& [name, values] : snapshot.columns) {
    out.text(name);
    out.numbers(std::span<const double>(values));
  }
}

Snapshot unpack_snapshot(Unpacker& in) {
  Snapshot out;
  in.enter("snapshot.step");
  out.step = in.total();
  in.enter("snapshot.totals");
  for (std::int64_t* total :
       {&out.totals.solves, &out.totals.evaluations, &out.totals.failed, &out.totals.failed_warm, &out.totals.lists})
    *total = in.total();
  in.enter("snapshot.pairs");
  out.pairs = in.numbers<std::array<std::uint32_t, 2>>();
  in.enter("snapshot.columns");
  for (auto left = in.number<std::uint64_t>(); left > 0; --left) {
    std::string name = in.name();
    out.columns.emplace_back(std::move(name), in.numbers<double>());
  }
  return out;
}

std::map<std::string, double> unpack_seconds(Unpacker& in) {
  in.enter("seconds");
  auto out = in.table<double>();
  for (const auto& [owner, spent] : out)
    if (!std::isfinite(spent) || spent < 0) in.fail("must be finite and not below 0");
  return out;
}

/// What stands between version and checksum.
Checkpoint unpack(Unpacker& in) {
  Checkpoint out;
  in.enter("key");
  out.key = in.number<std::uint64_t>();
  out.snapshot = unpack_snapshot(in);
  in.enter("lengths");
  out.lengths = in.table<std::uint64_t>();
  out.seconds = unpack_seconds(in);
  in.enter("record");
  out.record = in.text();
  in.require_end();
  return out;
}

}  // namespace

std::uint64_t hash_of_text(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

std::string format_checkpoint(const Checkpoint& checkpoint) {
  Packer out;
  out.bytes = magic;
  out.number(version);
  out.number(checkpoint.key);
  pack(out, checkpoint.snapshot);
  out.table(checkpoint.lengths);
  out.table(checkpoint.seconds);
  out.text(checkpoint.record);
  out.number(hash_of_text(out.bytes));
  return std::move(out.bytes);
}

Checkpoint parse_checkpoint(const std::string& bytes, const std::string& file) {
  if (!bytes.starts_with(magic))
    throw InputFailure(file, 0, "", "is no checkpoint of plumb, or its beginning is damaged");
  try {
    Unpacker in(std::string_view(bytes).substr(magic.size()));
    const auto found = in.number<std::uint64_t>();
    if (found != version)
      throw InputFailure(file, 0, "version", "is " + std::to_string(found) + ", must be " + std::to_string(version));
    in.require_seal(bytes);
    return unpack(in);
  } catch (const Damaged& damage) {
    throw InputFailure(file, 0, damage.field, damage.reason);
  }
}

std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  constexpr std::size_t longest = std::size_t{16} * longest_text;  // a scene's state, with that of its contacts
  return parse_checkpoint(read_text(path, longest), path.string());
}

}  // namespace plumb::scene
