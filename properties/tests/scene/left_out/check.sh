#!/usr/bin/env bash
# check.sh ALL WITHOUT EFFECT TYPE: the step loop of a scene that does not ask for EFFECT, in the program that has every effect
# (ALL) and in one that was linked without the effect's file (WITHOUT): the same hash, counts of instructions that agree to
# 0.1 %, and no function of plumb::scene::TYPE called.
set -euo pipefail
all=$1 without=$2 effect=$3 type=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# count PROGRAM NAME: the instructions of the loop into NAME.count, the hash into NAME.hash, the functions called into NAME.functions.
count() {
  valgrind --tool=callgrind --toggle-collect='*count_steps*' --callgrind-out-file="$work/$2.out" "$1" "$effect" \
    >"$work/$2.hash" 2>"$work/$2.log" || { cat "$work/$2.log"; exit 2; }
  awk '/^(totals|summary):/ { print $2; exit }' "$work/$2.out" >"$work/$2.count"
  callgrind_annotate --threshold=100 "$work/$2.out" >"$work/$2.functions"
}
count "$all" all
count "$without" without

nm -C "$without" >"$work/symbols"
if grep -q "install(plumb::scene::$type const&" "$work/symbols"; then
  echo "$effect: the program without its file has it"
  exit 1
fi
if grep -q "scene::$type const&" "$work/all.functions"; then
  echo "$effect: called though no scene asks for it:"
  grep "scene::$type const&" "$work/all.functions"
  exit 1
fi
grep -q 'solve_contacts' "$work/all.functions" || { echo "$effect: the loop was not counted"; exit 1; }
cmp "$work/all.hash" "$work/without.hash"
awk -v effect="$effect" -v a="$(cat "$work/all.count")" -v b="$(cat "$work/without.count")" 'BEGIN {
  share = (a - b) / b
  printf "%s: %d instructions, %d without the file, %+.4f %%\n", effect, a, b, 100 * share
  exit !(b > 0 && share <= 0.001 && share >= -0.001)
}'
