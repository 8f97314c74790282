#The step loop with every effect, \
    and with each one 's file left out: the linker takes of plumb_scene' s archive only what the list
#of effects names, and each program brings a list of its own.
set(left_out ${folder} / left_out) get_target_property(effects plumb_scene PLUMB_EFFECTS)
    foreach (effect IN ITEMS none ${effects}) set(rows ${effects}) list(REMOVE_ITEM rows ${effect})
        list(TRANSFORM rows REPLACE "(.+)"
                                    "row<&Effects::\\1>(),\n") string(CONCAT rows ${rows})
            file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR} / without_${effect} / effect_rows.inc CONTENT "${rows}")
                add_executable(count_steps_without_${effect} ${left_out} / main.cpp ${PROJECT_SOURCE_DIR} / solver /
                               scene / effects.cpp)
                    target_include_directories(count_steps_without_${effect} PRIVATE ${CMAKE_CURRENT_BINARY_DIR} /
                                               without_${effect})
                        target_link_libraries(count_steps_without_${effect} PRIVATE plumb_scene plumb_flags)
                            set_target_properties(count_steps_without_${effect} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${
                                                      PROJECT_BINARY_DIR} /
                                                  tests) endforeach() find_program(PLUMB_VALGRIND valgrind REQUIRED)
                                foreach (effect IN LISTS effects) string(REGEX MATCHALL "[^_]+" words ${effect})
                                    set(type "") foreach (word IN LISTS words) string(SUBSTRING $ {
                                      word
                                    } 0 1 first) string(TOUPPER ${first} first) string(SUBSTRING $ { word } 1 - 1 rest)
                                        string(APPEND type ${first} ${rest}) endforeach()
                                            add_test(NAME scene / left_out.${effect} COMMAND ${left_out} / check.sh $ <
                                                     TARGET_FILE : count_steps_without_none > $ <
                                                     TARGET_FILE : count_steps_without_${effect} > ${effect} ${type})
                                                set_tests_properties(scene / left_out.${effect} PROPERTIES TIMEOUT 300)
                                                    endforeach()
