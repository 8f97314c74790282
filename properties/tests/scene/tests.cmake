# The step loop with every effect, and with each one's file left out: the linker takes of plumb_scene's archive only what the list
# of effects names, and each program brings a list of its own.
set(left_out ${folder}/left_out)
add_library(count_steps OBJECT ${left_out}/main.cpp)
target_link_libraries(count_steps PRIVATE plumb_scene plumb_flags)
get_target_property(effects plumb_scene PLUMB_EFFECTS)
set(variants none ${effects})
if(PLUMB_ONE_COMPILATION)
  set(variants none)  # one will do for the linter
endif()
foreach(effect IN LISTS variants)
  set(rows ${effects})
  list(REMOVE_ITEM rows ${effect})
  plumb_write_effect_rows(${CMAKE_CURRENT_BINARY_DIR}/without_${effect} ${rows})
  add_executable(count_steps_without_${effect} $<TARGET_OBJECTS:count_steps> ${PROJECT_SOURCE_DIR}/solver/scene/effects.cpp)
  target_include_directories(count_steps_without_${effect} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/without_${effect})
  target_link_libraries(count_steps_without_${effect} PRIVATE plumb_scene plumb_flags)
  set_target_properties(count_steps_without_${effect} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
endforeach()
find_program(PLUMB_VALGRIND valgrind REQUIRED)
list(REMOVE_ITEM variants none)
foreach(effect IN LISTS variants)
  string(REGEX MATCHALL "[^_]+" words ${effect})
  set(type "")
  foreach(word IN LISTS words)
    string(SUBSTRING ${word} 0 1 first)
    string(TOUPPER ${first} first)
    string(SUBSTRING ${word} 1 -1 rest)
    string(APPEND type ${first}${rest})
  endforeach()
  add_test(NAME scene/left_out.${effect}
           COMMAND ${left_out}/check.sh $<TARGET_FILE:count_steps_without_none>
                   $<TARGET_FILE:count_steps_without_${effect}> ${effect} ${type})
  set_tests_properties(scene/left_out.${effect} PROPERTIES TIMEOUT 300)
endforeach()

# Walls with seeded bugs, each of which a test must find: fuzz/bugs/walls/walls.json, sown by fuzz/bugs/seed.cmake.
target_link_libraries(test_scene PRIVATE ${CMAKE_DL_LIBS})
if(PLUMB_ONE_COMPILATION)  # the linter sows nothing
  target_compile_definitions(test_scene PRIVATE PLUMB_SEEDED_WALLS="")
  return()
endif()
set(bugs ${PROJECT_SOURCE_DIR}/fuzz/bugs)
set(sown ${CMAKE_CURRENT_BINARY_DIR}/seeded_walls)
file(GLOB pristine CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/solver/scene/wall/*)
add_custom_command(OUTPUT ${sown}/stamp
  COMMAND ${CMAKE_COMMAND} -D SOURCE=${PROJECT_SOURCE_DIR} -D TABLES=${bugs}/walls/walls.json -D OUT=${sown} -P ${bugs}/seed.cmake
  COMMAND ${CMAKE_COMMAND} -E touch ${sown}/stamp
  DEPENDS ${bugs}/seed.cmake ${bugs}/walls/walls.json ${pristine} COMMENT "Seeding bugs of walls" VERBATIM)
add_library(seeded_walls MODULE ${bugs}/walls/seeded_walls.cpp)
set_source_files_properties(${bugs}/walls/seeded_walls.cpp PROPERTIES OBJECT_DEPENDS ${sown}/stamp)
target_include_directories(seeded_walls BEFORE PRIVATE ${sown})
target_link_libraries(seeded_walls PRIVATE plumb_solver Boost::headers plumb_flags)
target_compile_options(seeded_walls PRIVATE -include ${bugs}/seeded_bug.hpp -ftls-model=initial-exec)
target_link_options(seeded_walls PRIVATE -Wl,-Bsymbolic)
set_target_properties(seeded_walls PROPERTIES PREFIX "" UNITY_BUILD OFF CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
add_dependencies(test_scene seeded_walls)
target_compile_definitions(test_scene PRIVATE PLUMB_SEEDED_WALLS="$<TARGET_FILE:seeded_walls>")
