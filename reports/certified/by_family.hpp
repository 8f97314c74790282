// The frame of a report that has a row, or a JSON object, for each family.
#pragma once

#include <string>

#include "corpus/command/command.hpp"
#include "corpus/command/interrupt.hpp"
#include "corpus/command/text_table.hpp"
#include "properties/generators/families.hpp"

namespace plumb::reports {

/// Of the families that `options` asks for, until interrupted: count(family, options) has the cases with a finding in `named`.
/// exit_finding where there is any.
template <class Options, class Count, class ToJson, class PrintRow>
int report_by_family(Options& options, const TextTable& columns, Count&& count, ToJson&& to_json,
                     PrintRow&& print_row) {
  bool has_finding = false;
  options.lines.print_table(columns.head());
  for (const std::string& family : family_names()) {
    if ((!options.family.empty() && options.family != family) || interrupted()) continue;
    const auto counts = count(family, options);
    options.lines.add(to_json(family, counts, options));
    has_finding = has_finding || !counts.named.empty();
    if (!options.lines.is_json()) print_row(family, counts);
    flush_output();
  }
  options.lines.write();
  return has_finding ? exit_finding : exit_done;
}

}  // namespace plumb::reports
