# One dummy of each thing, added as reports/docs/pages/extending.md says: what is new stands in new/THING/ under its path in the
# repository, what one edits is copied to the build folder with one more row. The programs here are built of that and of the
# libraries as they are, so that whatever has the dummy has read the list.
set(extended ${CMAKE_CURRENT_BINARY_DIR}/extended)
foreach(thing method family law effect)
  file(GLOB_RECURSE new_${thing} CONFIGURE_DEPENDS RELATIVE ${folder}/new/${thing} ${folder}/new/${thing}/*)
  set(touched_${thing} ${new_${thing}})
endforeach()

# To whole_FILE: FILE with TEXT put in before the one place where PLACE stands, or at the end where PLACE is empty.
function(plumb_add_to thing file place text)
  if(NOT file IN_LIST touched_${thing})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${file})
    file(READ ${PROJECT_SOURCE_DIR}/${file} whole_${file})
    set(touched_${thing} ${touched_${thing}} ${file} PARENT_SCOPE)
  endif()
  set(whole "${whole_${file}}")
  string(FIND "${whole}" "${place}" first)
  string(FIND "${whole}" "${place}" last REVERSE)
  if(place STREQUAL "")
    string(APPEND whole "${text}")
  elseif(first EQUAL -1 OR NOT first EQUAL last)
    message(FATAL_ERROR "${file}: a row is added before \"${place}\", which does not stand there once")
  else()
    string(REPLACE "${place}" "${text}${place}" whole "${whole}")
  endif()
  set(whole_${file} "${whole}" PARENT_SCOPE)
endfunction()

plumb_add_to(method solver/method/method_rows.inc "" [[
PLUMB_METHOD(dummy, "dummy", common_normal, "Nobody 2000", "#010203", "#040506", "diamond-tall", "a method for tests")
]])
plumb_add_to(family properties/generators/family_rows.inc "" [[
PLUMB_FAMILY(draw_dummy, "dummy", 10, 20, "a family for tests")
]])
plumb_add_to(law properties/laws/laws.cpp [[#include "properties/laws/laws_problem.hpp"]] [[
#include "properties/laws/laws_dummy.hpp"
]])
plumb_add_to(law properties/laws/laws.cpp [[    Law{"evaluations",]] [[
    Law{"dummy", "no answer takes 13 iterations", law::iterations_are_not_thirteen, Needs::nothing},
]])
plumb_add_to(effect solver/scene/effects.hpp [[#include "solver/scene/effect/across/friction.hpp"]] [[
#include "solver/scene/effect/dummy.hpp"
]])
plumb_add_to(effect solver/scene/effects.hpp "  ROW(Drag, drag)" "  ROW(Dummy, dummy) \\\n")
plumb_add_to(effect corpus/scene/scene-1.schema.json [[        "drag": {]] [[
        "dummy": {
          "type": "object",
          "properties": {"push": {"description": "force", "type": "number", "minimum": 0}},
          "required": ["push"],
          "patternProperties": {"^x_": true},
          "additionalProperties": false
        },
]])
foreach(thing method family law effect)
  foreach(file IN LISTS touched_${thing})
    if(DEFINED whole_${file})
      file(CONFIGURE OUTPUT ${extended}/${file} CONTENT "${whole_${file}}" @ONLY)
    endif()
  endforeach()
endforeach()

# The lists of methods, families and laws with the dummies in them; all else is the libraries' own.
set(lists)
foreach(thing method family law)
  foreach(file IN LISTS new_${thing})
    if(file MATCHES "\\.cpp$")
      list(APPEND lists ${folder}/new/${thing}/${file})
    endif()
  endforeach()
endforeach()
add_library(extended_lists OBJECT ${PROJECT_SOURCE_DIR}/solver/method/methods.cpp ${PROJECT_SOURCE_DIR}/properties/generators/families.cpp
            ${extended}/properties/laws/laws.cpp ${lists})
set_target_properties(extended_lists PROPERTIES UNITY_BUILD OFF)
target_link_libraries(extended_lists PRIVATE plumb_properties plumb_flags fmt::fmt)
target_include_directories(extended_lists BEFORE PRIVATE ${extended} ${folder}/new/method ${folder}/new/law)
target_sources(test_extending PRIVATE $<TARGET_OBJECTS:extended_lists>)
target_link_libraries(test_extending PRIVATE plumb_campaign_report plumb_study fmt::fmt)
foreach(thing method family law effect)
  list(JOIN touched_${thing} "," files)
  target_compile_definitions(test_extending PRIVATE PLUMB_TOUCHED_${thing}="${files}")
endforeach()

# What `plumb methods` and `plumb families` print of them.
add_executable(extended-methods ${PROJECT_SOURCE_DIR}/corpus/command/methods_main.cpp $<TARGET_OBJECTS:extended_lists>)
add_executable(extended-families ${PROJECT_SOURCE_DIR}/fuzz/campaign/families_main.cpp $<TARGET_OBJECTS:extended_lists>)
foreach(program extended-methods extended-families)
  target_link_libraries(${program} PRIVATE plumb_fuzz plumb_command plumb_flags fmt::fmt)
  set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  add_test(NAME extending/${program} COMMAND ${program})
endforeach()
set_tests_properties(extending/extended-methods PROPERTIES PASS_REGULAR_EXPRESSION "\ndummy +common_normal +a method for tests\n")
set_tests_properties(extending/extended-families PROPERTIES PASS_REGULAR_EXPRESSION "\ndummy +a family for tests\n")

# An effect changes what a scene is, so that all that knows scenes is built anew; unoptimised, which is quicker.
plumb_read_effects(effects ${extended}/solver/scene/effects.hpp)
plumb_write_effect_rows(${extended} ${effects})
get_target_property(scene_sources plumb_scene SOURCES)
list(TRANSFORM scene_sources REPLACE "^scene/" "${PROJECT_SOURCE_DIR}/solver/scene/")
set(files_sources scene_file scene_report scene_view mesh_file wall_json)
list(TRANSFORM files_sources REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/corpus/scene/\\1.cpp")
set(decoder_sources decode decode_scene layout_fields)
list(TRANSFORM decoder_sources REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/fuzz/layouts/\\1.cpp")
file(GLOB effect_tests CONFIGURE_DEPENDS ${folder}/effect/*.cpp)
add_executable(test_extending_effect tests/main.cpp ${effect_tests} ${folder}/new/effect/solver/scene/effect/dummy.cpp ${scene_sources}
               ${files_sources} ${decoder_sources} ${PROJECT_SOURCE_DIR}/properties/tests/scene_files/scene_schema.cpp)
target_include_directories(test_extending_effect BEFORE PRIVATE ${extended} ${folder}/new/effect)
target_include_directories(test_extending_effect SYSTEM PRIVATE ${Boost_INCLUDE_DIRS})
target_link_libraries(test_extending_effect PRIVATE plumb_corpus plumb_batch plumb_flags fmt::fmt GTest::gtest)
target_compile_options(test_extending_effect PRIVATE -O0 -Wno-unknown-pragmas)  # OpenMP's
set_target_properties(test_extending_effect PROPERTIES DISABLE_PRECOMPILE_HEADERS ON)
set_source_files_properties(${PROJECT_SOURCE_DIR}/solver/scene/effects.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
target_compile_definitions(test_extending_effect PRIVATE PLUMB_SOURCE_DIR="${extended}")
gtest_discover_tests(test_extending_effect TEST_FILTER "ExtendingEffect.*:*HasEveryEffect*" TEST_PREFIX "extending/" DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 300)
