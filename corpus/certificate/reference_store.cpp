#include "corpus/certificate/reference_store.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

#include "corpus/case/case.hpp"
#include "corpus/certificate/reference_json.hpp"
#include "corpus/file/text_input.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// The finaliser of SplitMix64: one-to-one, and every bit of x reaches every bit of the result.
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

std::uint64_t hash_of(const std::string& text, std::uint64_t seed) {
  std::uint64_t hash = mixed(seed);
  for (const char c : text) hash = mixed(hash ^ static_cast<unsigned char>(c)) + seed;
  return hash;
}

/// 128 bits, so that chance never gives two texts the same. No defence against malice.
std::string fingerprint(const std::string& text) {
  return fmt::format("{:016x}{:016x}", hash_of(text, 0x9e3779b97f4a7c15U), hash_of(text, 0xd1b54a32d192ed03U));
}

/// What a file says was asked. The decimals are one-to-one with the doubles' bits, so that equal texts are equal pairs.
Json question_json(const Pair& pair, const char* field, std::string_view asked) {
  Json out{{"format", "plumb/reference-1"}, {field, asked}, {"bodies", bodies_json(pair)}};
  if (asked == name(Problem::first_touch)) out["motion"] = vector_json(pair.motion);
  return out;
}

/// A reference without its proof.
struct KeptReference {
  using Answer = Reference;
  Effort effort;

  [[nodiscard]] Json question(const Pair& pair) const { return question_json(pair, "effort", name(effort)); }
  [[nodiscard]] Reference compute(const Pair& pair) const {
    Reference found = find_reference(pair, effort);
    found.cover = {};
    found.meridian = {};
    found.nearest.reset();
    return found;
  }
  static Json to_json(const Reference& answer) { return reference_json(answer); }
  static Reference read(const Field& field) { return read_reference(field); }
};

struct KeptOther {
  using Answer = Solution;
  Problem problem;

  [[nodiscard]] Json question(const Pair& pair) const { return question_json(pair, "problem", name(problem)); }
  [[nodiscard]] Solution compute(const Pair& pair) const { return find_problem_reference(pair, problem); }
  static Json to_json(const Solution& answer) { return solution_json(answer); }
  static Solution read(const Field& field) { return read_solution(field); }
};

/// An object's text with its checksum as a last member.
std::string sealed(std::string object) {
  const std::string checksum = fingerprint(object);
  object.back() = ',';
  return object + " \"checksum\": \"" + checksum + "\"}\n";
}

/// What was sealed, where no byte has changed since.
std::optional<std::string> unsealed(const std::string& text) {
  const std::size_t seal = sealed("}").size();
  if (text.size() < seal) return std::nullopt;
  std::string object = text.substr(0, text.size() - seal) + "}";
  if (sealed(object) != text) return std::nullopt;
  return object;
}

std::string entry_text(Json question, Json answer) {
  question["reference"] = std::move(answer);
  return sealed(write_json(question));
}

/// Throws whatever the text is not.
template <class Kept>
std::optional<typename Kept::Answer> parse_entry(const std::string& text, const std::string& question) {
  const std::optional<std::string> object = unsealed(text);
  if (!object) return std::nullopt;
  Json entry = read_json(*object);
  const Json answer = entry.at("reference");
  entry.erase("reference");
  if (write_json(entry) != question) return std::nullopt;
  return Kept::read(Field(answer));
}

template <class Kept>
std::optional<typename Kept::Answer> read_entry(const fs::path& file, const std::string& question) {
  try {
    if (!fs::is_regular_file(file)) return std::nullopt;
    return parse_entry<Kept>(read_text(file), question);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

fs::path path_under(const fs::path& folder, const std::string& question) {
  const std::string name = fingerprint(question);
  return folder / name.substr(0, 2) / (name.substr(2) + ".json");
}

/// Not to the end of the disk's own buffers: what a power cut takes is a miss.
bool write_new(const fs::path& file, const std::string& text) {
  std::FILE* const out = std::fopen(file.c_str(), "wbx");
  if (out == nullptr) return false;
  const bool written = std::fwrite(text.data(), 1, text.size(), out) == text.size();
  return std::fclose(out) == 0 && written;
}

}  // namespace

ReferenceStore::ReferenceStore(const fs::path& dir) : folder_(dir / PLUMB_REFERENCE_CODE) {}

void ReferenceStore::prepare() const {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) throw InputFailure("--cache", 0, folder_.parent_path().string(), error.message());
}

template <class Kept>
typename Kept::Answer ReferenceStore::find_kept(const Pair& pair, const Kept& kept) const {
  if (!is_valid(pair)) {  // JSON holds no number that is not finite
    ++misses_;
    return kept.compute(pair);
  }
  const Json question = kept.question(pair);
  const std::string asked = write_json(question);
  const fs::path file = path_under(folder_, asked);
  if (auto stored = read_entry<Kept>(file, asked)) {
    ++hits_;
    return std::move(*stored);
  }
  ++misses_;
  typename Kept::Answer found = kept.compute(pair);
  if (!write(file, entry_text(question, Kept::to_json(found)))) ++unstored_;
  return found;
}

Reference ReferenceStore::find(const Pair& pair, Effort effort) const {
  return find_kept(pair, KeptReference{effort});
}

Solution ReferenceStore::find_other(const Pair& pair, Problem problem) const {
  return find_kept(pair, KeptOther{problem});
}

fs::path ReferenceStore::file_of(const Pair& pair, Effort effort) const {
  return path_under(folder_, write_json(KeptReference{effort}.question(pair)));
}

/// By way of a file of its own name in the same folder: whoever reads sees all of an entry or none.
bool ReferenceStore::write(const fs::path& file, const std::string& text) const {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  const std::string own = "." + std::to_string(::getpid()) + "." + std::to_string(++written_) + ".tmp";
  const fs::path temporary = file.string() + own;
  bool stored = write_new(temporary, text);
  if (stored) fs::rename(temporary, file, error);
  stored = stored && !error;
  if (!stored) fs::remove(temporary, error);
  return stored;
}

std::shared_ptr<const ReferenceStore> open_store(const std::string& dir) {
  if (dir.empty()) return nullptr;
  auto store = std::make_shared<const ReferenceStore>(dir);
  store->prepare();
  return store;
}

ReferenceSource references_of(const std::shared_ptr<const ReferenceStore>& store) {
  if (!store) return {};
  return {[store](const Pair& pair, Effort effort, const Reference*) { return store->find(pair, effort); },
          [store](const Pair& pair, Problem problem) { return store->find_other(pair, problem); }};
}

std::string in_words(const StoreCounts& counts) {
  const std::string lost = counts.unstored == 0 ? "" : fmt::format(", {} of them not stored", counts.unstored);
  return fmt::format("references: {} from the cache, {} computed{}", counts.hits, counts.misses, lost);
}

}  // namespace plumb
