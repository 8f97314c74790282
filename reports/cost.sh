# shellcheck shell=bash
# What a solve costs, held to a table: the half of reports/gate that callgrind counts. Sourced in the repository's top folder; it
# defines functions and runs nothing. A table's rows are those of reports/callgrind.sh: set, method, start, instructions.
# shellcheck source=reports/callgrind.sh
source reports/callgrind.sh

cost_pairs=50

# cost_rows FOLDER SET: every method of plumb's own, cold; auto warm and moving as well; the batch cold and moving. Rows to FOLDER/SET.txt.
cost_rows() {
  local pairs=$1/$2.jsonl method
  print_pairs "$1" "$2" "$cost_pairs"
  {
    for method in $(build/release/bin/plumb methods | awk '!/^peer_/ { print $1 }'); do
      per_solve "$pairs" "$method" cold
    done
    per_batch "$pairs" cold
    per_batch "$pairs" moving
    per_solve "$pairs" auto warm
    per_solve "$pairs" auto moving
  } >"$1/$2.txt"
}

# count_cost FOLDER: the rows of all sets, which share the processors, to FOLDER/measured.txt.
count_cost() {
  local sets=(spheroid ellipsoid exponents-8 whole exponents-40)
  rm -rf "$1"
  mkdir -p "$1"
  printf '%s\n' "${sets[@]}" |
    xargs -P "$(nproc)" -I{} bash -euo pipefail -c 'source reports/cost.sh; cost_rows "$@"' cost_rows "$1" {} || return 2
  (cd "$1" && cat "${sets[@]/%/.txt}" >measured.txt)
}

# The versions that counts depend on beside plumb's own code. The processor is not among it: to the program, valgrind is one with AVX2 and
# FMA wherever the real one has them.
cost_toolchain() { printf '%s, g++ %s, %s' "$(valgrind --version)" "$(g++ -dumpfullversion)" "$(getconf GNU_LIBC_VERSION)"; }

# check_cost_table TABLE: exit 2 and one line when a row is none.
check_cost_table() {
  [[ -r $1 ]] || { complain "$1: cannot be read; reports/gate --update writes it"; return 2; }
  awk '
    /^#/ || NF == 0 { next }
    NF != 4 { print FILENAME ":" NR ": " $1 ": has " NF " words; they are set, method, start, instructions"; exit 2 }
    $4 !~ /^[1-9][0-9]*$/ { print FILENAME ":" NR ": instructions: \"" $4 "\" is not a whole number above 0"; exit 2 }
    ($1, $2, $3) in seen { print FILENAME ":" NR ": " $1 " " $2 " " $3 ": stands there twice"; exit 2 }
    { seen[$1, $2, $3] = 1 }' "$1" >&2
}

# cost_deviations TABLE MEASURED: a line for each count that is not in (0.97 c, 1.01 c]; exit 1: there is one. Counts repeat exactly
# while neither plumb nor the toolchain changes; 1 % is below what a clock shows, 3 % gained is worth being held to.
cost_deviations() {
  awk '
    /^#/ || NF == 0 { next }
    FILENAME == ARGV[1] { wanted[$1 " " $2 " " $3] = $4; next }
    { row = $1 " " $2 " " $3; what = "" }
    !(row in wanted) { what = "not in the table, reports/gate --update adds it" }
    row in wanted && $4 > 1.01 * wanted[row] { what = "worse" }
    row in wanted && $4 <= 0.97 * wanted[row] { what = "better, reports/gate --update records it" }
    what != "" {
      failed = 1
      counts = row in wanted ? wanted[row] " in the table, " $4 " measured: " : ""
      print row " instructions: " counts what
    }
    { delete wanted[row] }
    END {
      for (row in wanted) { failed = 1; print row " instructions: in the table, but not measured: reports/gate --update drops it" }
      exit failed
    }' "$1" "$2"
}

# updated_cost TABLE MEASURED: the table that is to hold: measured rows, in each the count before where that holds.
updated_cost() {
  printf '# reports/gate --update writes this table; reports/gate, which CI runs, holds plumb to it.\n'
  printf '# Instructions of a solve, counted by callgrind: mean of %s pairs of each set of plumb bench; to lie in (0.97 c, 1.01 c].\n' \
    "$cost_pairs"
  printf '# counted with %s\n' "$(cost_toolchain)"
  printf '%-14s%-28s%-6s%12s\n' '# set' method start instructions
  awk '
    /^#/ || NF == 0 { next }
    FILENAME == ARGV[1] { before[$1, $2, $3] = $4; next }
    { c = before[$1, $2, $3]; if (!(c > 0 && $4 <= 1.01 * c && $4 > 0.97 * c)) c = $4 }
    { printf "%-14s%-28s%-6s%12d\n", $1, $2, $3, c }' "$1" "$2"
}

# gate_cost TABLE [--update]: exit 0: the counts are as the table says, or it was written; 1: they are not; 2: unusable.
gate_cost() {
  local folder=build/gate failed=0 counted_with
  [[ ${2-} == --update && ! -e $1 ]] || check_cost_table "$1" || return 2
  command -v valgrind >/dev/null || { complain "no valgrind: costs are not checked"; return 0; }
  count_cost "$folder" || return 2
  if [[ ${2-} == --update ]]; then
    [[ -e $1 ]] || touch "$1"
    updated_cost "$1" "$folder/measured.txt" >"$folder/updated.txt"
    cp "$folder/updated.txt" "$1"
    return
  fi
  cost_deviations "$1" "$folder/measured.txt" >"$folder/deviations.txt" || failed=1
  cat "$folder/deviations.txt"
  printf '%d counts, %d deviations from %s\n' "$(wc -l <"$folder/measured.txt")" "$(wc -l <"$folder/deviations.txt")" "$1"
  counted_with=$(sed -n 's/^# counted with //p' "$1")
  [[ $failed == 0 || $counted_with == "$(cost_toolchain)" ]] ||
    printf 'the table was counted with %s, this with %s\n' "$counted_with" "$(cost_toolchain)"
  return "$failed"
}
