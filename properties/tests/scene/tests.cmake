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

# Walls with seeded bugs: fuzz/bugs/walls.
plumb_add_sown_library(test_scene walls scene/wall plumb_solver Boost::headers)
