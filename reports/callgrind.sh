# shellcheck shell=bash
# Counting instructions: what reports/record and reports/gate share. Sourced in the repository's top folder; it defines functions
# and runs nothing. The pairs come from a file because valgrind computes long double, and so the draw, with fewer digits.

# collected ARGUMENTS...: the instructions that callgrind counts in plumb bench --count-only ARGUMENTS.
collected() {
  valgrind --tool=callgrind --callgrind-out-file=/dev/null build/release/bin/plumb-bench --count-only "$@" 2>&1 >/dev/null |
    sed -n 's/.*Collected : //p'
}

# count_row FILE METHOD START ARGUMENTS...: a row: the instructions of a run that solves less those of one that does not, by the
# solves ("0 x 50 cold solves by auto") of the pairs of FILE, SET.jsonl.
count_row() {
  local pairs=$1 method=$2 start=$3 with without solves
  shift 3
  with=$(collected --pairs "$pairs" "$@" --times 1)
  without=$(collected --pairs "$pairs" "$@" --times 0)
  solves=$(build/release/bin/plumb-bench --count-only --pairs "$pairs" "$@" --times 0 | awk '{ print $3 }')
  printf '%-14s%-28s%-6s%12d\n' "$(basename "$pairs" .jsonl)" "$method" "$start" $(((with - without) / solves))
}

# per_solve FILE METHOD START: the row of a method.
per_solve() {
  local start=()
  [[ $3 == cold ]] || start=("--$3")
  count_row "$@" --method "$2" "${start[@]}"
}

# per_batch FILE START: the row of a batch by the best instruction set.
per_batch() {
  local start=()
  [[ $2 == cold ]] || start=("--$2")
  count_row "$1" batch "$2" --batch "${start[@]}"
}

# print_pairs FOLDER SET CASES: the pairs of a set of plumb bench to FOLDER/SET.jsonl.
print_pairs() { build/release/bin/plumb bench --print --set "$2" --cases "$3" >"$1/$2.jsonl"; }
