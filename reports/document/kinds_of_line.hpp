// Reports whose JSON lines are of several kinds: `run` first, `interrupted` last, none twice.
#pragma once

#include <filesystem>
#include <vector>

#include "corpus/json/fields.hpp"

namespace plumb::reports {

/// Puts a line into the document; throws FieldError.
using Take = void (*)(Json& out, const Field& line);

/// Lines of one kind: what tells them apart, and who takes them.
struct Kind {
  const char* name;
  std::vector<const char*> key;
  Take take;
};

/// `out`: the document without any line, its "host" null and "interrupted" false. `run` takes the first line and sets "host". `of`:
/// the command whose lines they are. Throws InputFailure.
[[nodiscard]] Json read_kinds(const std::filesystem::path& file, Json out, Take run, const std::vector<Kind>& kinds,
                              const char* of);

}  // namespace plumb::reports
