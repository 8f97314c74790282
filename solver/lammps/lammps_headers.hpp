// LAMMPS's headers as Debian packages them (20220106). They call fmt 8's make_args_checked, which fmt 9 no longer has; the library has
// another fmt inside, so that its messages are given as whole strings (fmt::format) and this is never called.
#pragma once

#include <fmt/format.h>

namespace fmt {
template <class... Args, class Format>
auto make_args_checked(const Format& /*format*/, const std::remove_reference_t<Args>&... args) {
  return make_format_args(args...);
}
}  // namespace fmt

#include <atom.h>
#include <comm.h>
#include <error.h>
#include <fix.h>
#include <force.h>
#include <group.h>
#include <input.h>
#include <lammps.h>
#include <memory.h>
#include <modify.h>
#include <neigh_list.h>
#include <neighbor.h>
#include <pair.h>
#include <update.h>
#include <utils.h>

#include <vector>

namespace plumb::lammps {

/// All fixes of a kind, in the order of the script.
template <class Kind>
[[nodiscard]] std::vector<Kind*> fixes_of(const LAMMPS_NS::Modify& modify) {
  std::vector<Kind*> out;
  for (int k = 0; k < modify.nfix; ++k)
    if (auto* fix = dynamic_cast<Kind*>(modify.fix[k])) out.push_back(fix);
  return out;
}

}  // namespace plumb::lammps
