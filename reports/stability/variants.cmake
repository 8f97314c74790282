# `auto` once more for each compiler that there is and each of these options, as a shared library whose name says so; what plumb
# report-stability finds in bin/variants it solves the hard cases with. With the machine's own instructions multiplications and
# additions may also be fused, which no other build of plumb allows: these two are always built, because they differ most. The
# others take a minute of a processor, and are built at night and for reports/record (PLUMB_ALL_VARIANTS).
set(plumb_variant_options "-O0 -ffp-contract=off" "-O2 -ffp-contract=off" "-O3 -ffp-contract=off"
    "-O3 -march=native -ffp-contract=fast")
set(plumb_variants)
foreach(compiler g++ clang++-19)
  string(MAKE_C_IDENTIFIER PLUMB_${compiler} found)
  find_program(${found} ${compiler})
  if(NOT ${found})
    message(STATUS "no ${compiler}: plumb report-stability goes without its builds")
    continue()
  endif()
  foreach(options IN LISTS plumb_variant_options)
    string(REPLACE " -ffp-contract=off" "" name "${compiler} ${options}")
    string(REPLACE " " "_" name "${name}")
    set(library ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/variants/${name}.so)
    if(NOT PLUMB_ALL_VARIANTS AND NOT options MATCHES "native")
      file(REMOVE ${library})  # of an older source, perhaps: what lies there is taken
      continue()
    endif()
    separate_arguments(flags UNIX_COMMAND "${options}")
    add_custom_command(
      OUTPUT ${library}
      COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/variants
      COMMAND ${${found}} -std=c++20 -w -DNDEBUG ${flags} -fPIC -shared
              -I ${PROJECT_SOURCE_DIR} -isystem "$<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>" -MD -MF ${CMAKE_CURRENT_BINARY_DIR}/${name}.d -MT ${library}
              ${CMAKE_CURRENT_SOURCE_DIR}/stability/variant.cpp -o ${library}
      DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/stability/variant.cpp
      DEPFILE ${CMAKE_CURRENT_BINARY_DIR}/${name}.d
      VERBATIM)
    list(APPEND plumb_variants ${library})
  endforeach()
endforeach()
add_custom_target(variants DEPENDS ${plumb_variants})
