#!/usr/bin/env bash
# .clusterfuzzlite/build.sh: builds the fuzz targets by the contract of OSS-Fuzz and ClusterFuzzLite: compilers, flags and engine
# come from the environment (CC, CXX, CFLAGS, CXXFLAGS, LIB_FUZZING_ENGINE), the sources are in SRC/plumb, what is between in WORK.
# OUT gets fuzz-TARGET, its seeds as a .zip, its dictionary and options, and the libraries that the runner does not have.
set -euo pipefail
cd -P "$SRC/plumb"
# shellcheck source=.ci/setup.sh
source .ci/setup.sh

# libc++ has no std::experimental::simd, in which the solver holds two bodies: libstdc++, in the program, and fmt from its headers. What
# is then left of libraries is C.
export CXXFLAGS="${CXXFLAGS/-stdlib=libc++/} -DFMT_HEADER_ONLY"
# The environment's flags alone: a build type of no meaning adds none. The old kind of path is the one that libmpfi.so's own needs follow.
cmake -S . -B "$WORK/build" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 \
  -DPLUMB_FUZZERS=ON -DPLUMB_TESTS=OFF -DPLUMB_PEERS=OFF -DPLUMB_FUZZING_ENGINE="$LIB_FUZZING_ENGINE" \
  -DCMAKE_BUILD_RPATH="\$ORIGIN/lib" -DCMAKE_EXE_LINKER_FLAGS="-static-libstdc++ -static-libgcc -Wl,--as-needed,--disable-new-dtags"
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
  ldd "$fuzzer" | sed -nE 's/.* => (.*\/lib(gmp|mpfi|mpfr|sleef)\.so[^ ]*) .*/\1/p' | xargs -r cp -L -t "$OUT/lib"
done
