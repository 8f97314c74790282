#!/usr/bin/env bash
# .clusterfuzzlite/build.sh: builds the fuzz targets by the contract of OSS-Fuzz and ClusterFuzzLite: compilers, flags and engine
# come from the environment (CC, CXX, CFLAGS, CXXFLAGS, LIB_FUZZING_ENGINE), the sources are in SRC/plumb, what is between in WORK.
# OUT gets fuzz-TARGET, its seeds as a .zip, its dictionary and options, and the libraries that the runner does not have.
set -euo pipefail
cd -P "$SRC/plumb"
# shellcheck source=.ci/setup.sh
source .ci/setup.sh

.clusterfuzzlite/configure "$WORK/build"
cmake --build "$WORK/build" --target fuzzers

mkdir -p "$OUT/lib"
for fuzzer in "$WORK"/build/bin/fuzz-*; do
  name=${fuzzer##*/}
  target=${name#fuzz-}
  seeds=$(plumb_seeds "$target")
  cp "$fuzzer" "$OUT/"
  rm -f "$OUT/${name}_seed_corpus.zip"
  zip -q -j -r "$OUT/${name}_seed_corpus.zip" "$seeds"
  for kind in dict options; do
    [[ ! -e fuzz/engine/$target.$kind ]] || cp "fuzz/engine/$target.$kind" "$OUT/$name.$kind"
  done
  if [[ $target == files ]]; then  # the words of effects too, which the schema has
    grep -oE '"[a-z_0-9]+": \{' corpus/scene/scene-1.schema.json | sed -E 's/"(.*)": \{/"\\"\1\\""/' | sort -u >>"$OUT/$name.dict"
  fi
  ldd "$fuzzer" | sed -nE 's/.* => (.*\/lib(gmp|mpfi|mpfr)\.so[^ ]*) .*/\1/p' | xargs -r cp -L -t "$OUT/lib"
done
