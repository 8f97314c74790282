// What nearly every source above solver/ reads, read once a build (corpus/CMakeLists.txt). Nobody includes this: each source
// names what it needs, and the linter reads it without.
#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "corpus/case/answer.hpp"
#include "corpus/certificate/reference_store.hpp"
#include "corpus/solvers/solver.hpp"
