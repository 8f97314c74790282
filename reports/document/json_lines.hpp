// Files of JSON lines that other reports left: what does not fit is refused with file, line and field.
#pragma once

#include <filesystem>
#include <functional>

#include "corpus/json/fields.hpp"

namespace plumb::reports {

/// Throws InputFailure for a FieldError of `take`.
void for_each_line(const std::filesystem::path& file, const std::function<void(const Field&)>& take);

}  // namespace plumb::reports
