// Checkpoints: all that a run needs to go on after kill -9, in one binary file that is replaced as a whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "solver/scene/simulation.hpp"

namespace plumb::scene {

struct Checkpoint {
  std::uint64_t key = 0;  ///< of the scene and its plan: run_key()
  Snapshot snapshot;
  std::map<std::string, std::uint64_t> lengths;  ///< of each output file
  std::map<std::string, double> seconds;         ///< spent so far, by owner
  std::string record;                            ///< what the recorder keeps
};

/// FNV-1a of bytes.
[[nodiscard]] std::uint64_t hash_of_text(std::string_view text);

/// Format plumb/checkpoint-1: magic, version, the fields in their order (numbers as this machine has them: little-endian), and
/// a checksum of it all.
[[nodiscard]] std::string format_checkpoint(const Checkpoint& checkpoint);
/// Throws InputFailure for what is damaged, cut short or of another version.
[[nodiscard]] Checkpoint parse_checkpoint(const std::string& bytes, const std::string& file);

/// nullopt where there is none. Throws InputFailure.
[[nodiscard]] std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& path);

}  // namespace plumb::scene
