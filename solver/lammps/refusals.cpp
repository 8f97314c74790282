#include "solver/lammps/refusals.hpp"

#include <compute.h>
#include <domain.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

#include "solver/lammps/fix_plumb_wall.hpp"

namespace plumb::lammps {
namespace {

using LAMMPS_NS::Fix;

struct GhostsOf : LAMMPS_NS::Comm {
  static bool is_all(const LAMMPS_NS::Comm& comm) { return comm.*(&GhostsOf::bordergroup) == 0; }
};

template <std::size_t N>
bool is_one_of(std::string_view style, const std::array<std::string_view, N>& styles) {
  return std::ranges::find(styles, style) != styles.end();
}

std::span<Fix*> fixes_of(const Beginning& run) {
  return {run.lammps.modify->fix, static_cast<std::size_t>(run.lammps.modify->nfix)};
}

[[noreturn]] void refuse(const Beginning& run, const std::string& reason) {
  run.lammps.error->all(FLERR, reason);
}

[[noreturn]] void refuse(const Beginning& run, const Fix& fix, std::string_view reason) {
  refuse(run, fmt::format("pair_style {}: fix {}: {} {}", run.style, fix.id, fix.style, reason));
}

/// Over all processes.
bool is_any_atom(const Beginning& run, const std::function<bool(int)>& holds) {
  int here = 0, all = 0;
  for (int i = 0; i < run.lammps.atom->nlocal; ++i) here |= holds(i) ? 1 : 0;
  MPI_Allreduce(&here, &all, 1, MPI_INT, MPI_MAX, run.lammps.world);
  return all != 0;
}

bool has_bodies(const Beginning& run, int groups) {
  return is_any_atom(run, [&](int i) { return run.is_body(i) && (run.lammps.atom->mask[i] & groups) == groups; });
}

void refuse_settings(const Beginning& run) {
  const LAMMPS_NS::Force& force = *run.lammps.force;
  const auto require = [&](bool holds, const char* reason) {
    if (!holds) refuse(run, fmt::format("pair_style {}: {}", run.style, reason));
  };
  require(run.lammps.domain->dimension == 3, "needs three dimensions");
  require(GhostsOf::is_all(*run.lammps.comm), "needs the ghosts of all atoms: no `comm_modify group`");
  require(std::strcmp(force.pair_style, "hybrid/scaled") != 0, "has forces that pair_style hybrid/scaled cannot scale");
  const bool is_moving_others =
      is_any_atom(run, [&](int i) { return !run.is_body(i) && (run.lammps.atom->mask[i] & run.motion.groupbit) != 0; });
  require(!is_moving_others, "fix plumb/nve has atoms in its group that are of another pair style");
}

/// Of time integration, and of what makes, moves or holds atoms as points.
void refuse_integrators(const Beginning& run) {
  constexpr std::array<std::string_view, 7> of_points{"gcmc", "widom", "atom/swap", "charge/regulation",
                                                      "srd",  "shake", "rattle"};
  for (const Fix* fix : fixes_of(run)) {
    if (is_one_of(fix->style, of_points)) refuse(run, *fix, "takes atoms for points");
    if (fix == &run.motion || fix->time_integrate == 0) continue;
    const bool may_move_fixed = std::string_view(fix->style) == "move";
    if (has_bodies(run, fix->groupbit | (may_move_fixed ? run.motion.groupbit : 0)))
      refuse(run, *fix, "moves atoms that fix plumb/nve moves, or of which it knows nothing");
  }
}

void refuse_forces_before_dashpots(const Beginning& run) {
  for (const Fix* fix : fixes_of(run)) {
    if (fix == &run.motion) return;
    const bool is_replacing = replaces_forces(fix->style) && std::string_view(fix->style) != "freeze";
    if (run.has_dashpots && is_replacing && has_bodies(run, fix->groupbit | run.motion.groupbit))
      refuse(run, *fix, "must stand after fix plumb/nve, which adds dashpots to the forces before it");
  }
}

/// A fixed body has no motion of its own, but what its surface does where it turns would be felt.
void refuse_frozen_that_turn(const Beginning& run) {
  const auto turns = [&](int i) {
    const double* const angmom = run.lammps.atom->angmom[i];
    const int mask = run.lammps.atom->mask[i];
    const bool is_held = (mask & run.frozen) != 0 && (mask & run.motion.groupbit) != 0;
    return is_held && run.is_body(i) && (angmom[0] != 0 || angmom[1] != 0 || angmom[2] != 0);
  };
  if (run.frozen != 0 && is_any_atom(run, turns))
    refuse(run, fmt::format("pair_style {}: fix freeze holds bodies that turn: set their angmom to 0", run.style));
}

/// LAMMPS's formulas for ellipsoids, from semi-axes and mass.
void refuse_formulas_of_ellipsoids(const Beginning& run) {
  constexpr std::array<std::string_view, 2> computes{"erotate/asphere", "temp/asphere"};
  if (!is_any_atom(run, [&](int i) { return run.is_body(i) && !run.is_ellipsoid(i); })) return;
  for (const Fix* fix : fixes_of(run))
    if (std::string_view(fix->style) == "langevin") refuse(run, *fix, "takes bodies for ellipsoids");
  for (const LAMMPS_NS::Compute* compute :
       std::span(run.lammps.modify->compute, static_cast<std::size_t>(run.lammps.modify->ncompute)))
    if (is_one_of(compute->style, computes))
      refuse(run, fmt::format("pair_style {}: compute {}: {} takes bodies for ellipsoids: f_{} is their energy "
                              "of turning",
                              run.style, compute->id, compute->style, run.motion.id));
}

/// A body at the other side of the box does not meet it.
void warn_of_borders(const Beginning& run, const FixPlumbWall& fix) {
  const LAMMPS_NS::Domain& domain = *run.lammps.domain;
  const scene::Wall& wall = fix.wall();
  const double extent = scene::extent_of(wall.shape);
  for (int axis = 0; axis < 3 && !wall.is_plane(); ++axis) {
    const bool is_within =
        wall.point[axis] - extent > domain.boxlo[axis] && wall.point[axis] + extent < domain.boxhi[axis];
    if (is_within || domain.periodicity[axis] == 0) continue;
    if (run.lammps.comm->me == 0)
      run.lammps.error->warning(
          FLERR, fmt::format("fix {}: {} is there once: a periodic border does not repeat it", fix.id, fix.style));
    return;
  }
}

void refuse_walls(const Beginning& run) {
  const bool has_others = is_any_atom(run, [&](int i) { return !run.is_body(i); });
  for (const Fix* fix : fixes_of(run)) {
    const std::string_view style = fix->style;
    if ((style.starts_with("wall/") || style == "indent") && has_bodies(run, fix->groupbit))
      refuse(run, *fix, "takes atoms for points: use fix plumb/wall");
    const auto* wall = dynamic_cast<const FixPlumbWall*>(fix);
    if (wall == nullptr) continue;
    if (has_others) refuse(run, *fix, "is for all atoms, and some are of another pair style");
    for (int axis = 0; axis < 3; ++axis)
      if (wall->wall().is_plane() && wall->wall().normal[axis] != 0 && run.lammps.domain->periodicity[axis] != 0)
        refuse(run, *fix, "is a plane across an axis along which the box is periodic");
    warn_of_borders(run, *wall);
  }
}

}  // namespace

bool replaces_forces(std::string_view style) {
  constexpr std::array<std::string_view, 5> styles{"setforce", "aveforce", "lineforce", "planeforce", "freeze"};
  return is_one_of(style, styles);
}

void refuse_what_goes_wrong(const Beginning& run) {
  refuse_settings(run);
  refuse_integrators(run);
  refuse_forces_before_dashpots(run);
  refuse_frozen_that_turn(run);
  refuse_formulas_of_ellipsoids(run);
  refuse_walls(run);
}

}  // namespace plumb::lammps
