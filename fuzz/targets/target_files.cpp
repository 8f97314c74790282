// Bytes as a file that users hand to plumb: the first byte says which kind, the rest is the file. Its reader refuses with
// InputFailure or reads; what it reads survives writing and reading, and what is done with it next ends well.
//
//   % 7 = 0 scene (plumb/scene-1), 1 answer (plumb check --answer), 2 proof (plumb/proof-1), 3 counts of a campaign
//   (campaign.bins), 4 reference (of plumb/reference-1, its checksum taken off), 5 checkpoint (plumb/checkpoint-1),
//   6 checkpoint between its head and its checksum, which are put on
//
// From 128 on: a dump of particles (LAMMPS, LIGGGHTS), written as frames of all its bodies; its pairs are found.
#include <fmt/format.h>

#include <array>
#include <sstream>
#include <stdexcept>

#include "corpus/case/answer.hpp"
#include "corpus/case/case.hpp"
#include "corpus/certificate/proof_file.hpp"
#include "corpus/certificate/reference_json.hpp"
#include "corpus/dump/dump_pairs.hpp"
#include "corpus/dump/dump_reader.hpp"
#include "corpus/dump/dump_text.hpp"
#include "corpus/json/fields.hpp"
#include "corpus/scene/checkpoint.hpp"
#include "corpus/scene/scene_file.hpp"
#include "fuzz/results/results.hpp"
#include "fuzz/targets/target.hpp"

namespace plumb {
namespace {

/// Reads the text and writes what it read. Throws InputFailure.
using Rewrite = std::string (*)(const std::string& text);

std::string rewrite_scene(const std::string& text) {
  const scene::SceneFile file = scene::parse_scene(text, "input");
  (void)scene::plan_scene(file.scene, {}, "input");
  return format_scene(file);
}

std::string rewrite_answer(const std::string& text) {
  const GivenAnswer given = parse_answer(text, "input");
  Answer answer{given.name, {}, {}, given.contact, {}};
  answer.contact.method = given.method;
  return write_json(answer_json(answer));
}

/// The claim is rounded outwards on its way into a file, and inwards on its way back: no fixed point.
std::string rewrite_proof(const std::string& text) {
  StoredProof stored = parse_proof(text, "input", 0);
  (void)verify_stored(stored.pair, stored);
  stored.claim = {0, 1};
  return format_proof(stored);
}

std::string rewrite_bins(const std::string& text) {
  return format_bins(parse_bins(text, "input"));
}

std::string rewrite_reference(const std::string& text) {
  try {
    const Json tree = read_json(text);
    return write_json(reference_json(read_reference(Field(tree))));
  } catch (const FieldError& e) {
    throw InputFailure("input", 0, e.field, e.what());
  }
}

/// What checkpoints of other files are restored to.
scene::Scene three_bodies_that_meet() {
  scene::Scene out;
  out.bodies.resize(3);
  for (std::size_t k = 0; k < out.bodies.size(); ++k) out.bodies[k].body.position.x() = 1.9 * static_cast<double>(k);
  out.bodies[1].body.shape = {{1, 0.9, 0.8}, 4, 4};
  out.effects.linear = scene::Linear{100};
  out.effects.friction = scene::Friction{0.5};
  out.run.duration = 1;
  out.run.time_step = 0.1;
  return out;
}

std::string rewrite_checkpoint(const std::string& bytes) {
  const scene::Checkpoint checkpoint = scene::parse_checkpoint(bytes, "input");
  const scene::Scene scene = three_bodies_that_meet();
  scene::Simulation run(scene, make_plan(scene));
  if (run.restore(checkpoint.snapshot) && !run.is_done()) run.step();
  return format_checkpoint(checkpoint);
}

/// The head is that of any checkpoint: what stands before its key.
std::string rewrite_sealed_checkpoint(const std::string& bytes) {
  constexpr std::size_t head = 16 + 8;
  const std::string body = scene::format_checkpoint({}).substr(0, head) + bytes;
  const std::uint64_t sum = scene::hash_of_text(body);
  std::string seal;
  for (int byte = 0; byte < 8; ++byte) seal += static_cast<char>(sum >> (8 * byte) & 255);
  return rewrite_checkpoint(body + seal);
}

/// Bodies alone, by LAMMPS's columns: ids, boxes and units are no part of what is written.
std::string rewrite_dump(const std::string& text) {
  constexpr std::size_t few = 12;  // whose pairs are looked at
  std::istringstream in(text);
  DumpReader reader(in, "input", {});
  std::string out;
  while (const auto frame = reader.next([](std::int64_t) { return true; })) {
    try {
      if (frame->particles.size() <= few) each_touching_pair(*frame, 0, [](const DumpPair&) {});
    } catch (const std::invalid_argument& error) {
      throw InputFailure("input", 0, "", error.what());
    }
    const DumpBounds unit{Vec3<double>::Zero(), Vec3<double>::Ones()};
    out += dump_head(frame->step, {}, frame->particles.size(), unit, dump_column_names(DumpFormat::lammps));
    for (const DumpParticle& particle : frame->particles) {
      add_dump_body(out, DumpFormat::lammps, out.size(), 1, particle.body);
      out += "\n";
    }
  }
  return out;
}

struct Reader {
  const char* name;
  Rewrite rewrite;
  Rewrite again;  ///< for what rewrite() returned
};
constexpr std::array<Reader, 7> readers{{{"scene", rewrite_scene, rewrite_scene},
                                         {"answer", rewrite_answer, rewrite_answer},
                                         {"proof", rewrite_proof, rewrite_proof},
                                         {"campaign.bins", rewrite_bins, rewrite_bins},
                                         {"reference", rewrite_reference, rewrite_reference},
                                         {"checkpoint", rewrite_checkpoint, rewrite_checkpoint},
                                         {"sealed checkpoint", rewrite_sealed_checkpoint, rewrite_checkpoint}}};

constexpr Reader dump_reader{"dump", rewrite_dump, rewrite_dump};

Outcome outcome_of(bool stop, const Reader& reader, const std::string& words) {
  return {stop, fmt::format("{}: {}", reader.name, words)};
}

Outcome examine_written(const Reader& reader, const std::string& written) {
  try {
    if (reader.again(written) != written) return outcome_of(true, reader, "writing and reading changed it");
  } catch (const InputFailure& e) {
    return outcome_of(true, reader, fmt::format("the writer wrote what the reader refuses: {}", e.what()));
  }
  return outcome_of(false, reader, "read, and the same after writing and reading");
}

}  // namespace

Outcome examine(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return {false, "no file"};
  const Reader& reader = bytes[0] < 128 ? readers[bytes[0] % readers.size()] : dump_reader;
  try {
    return examine_written(reader, reader.rewrite(std::string(bytes.begin() + 1, bytes.end())));
  } catch (const InputFailure& e) {
    return outcome_of(false, reader, fmt::format("refused: {}", e.what()));
  } catch (const std::exception& e) {
    return outcome_of(true, reader, fmt::format("the reader threw what it must not: {}", e.what()));
  }
}

}  // namespace plumb
