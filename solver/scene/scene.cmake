# plumb::scene. One source an effect; effect_rows.inc lists them in the order in which they act.
set(plumb_effects gravity linear hertz damping friction rolling twisting cohesion drag conduction moving_walls)
set(effect_rows ${plumb_effects})
list(TRANSFORM effect_rows REPLACE "(.+)" "row<&Effects::\\1>(),\n")
string(CONCAT effect_rows ${effect_rows})
file(CONFIGURE OUTPUT effects/effect_rows.inc CONTENT "${effect_rows}")
set(effect_sources ${plumb_effects})
list(TRANSFORM effect_sources REPLACE "(.+)" "scene/effect/\\1.cpp")
add_library(plumb_scene STATIC scene/check_scene.cpp scene/columns.cpp scene/effects.cpp scene/facts.cpp scene/hertz_contact.cpp scene/mass.cpp
            scene/measures.cpp scene/named.cpp scene/named_few.cpp scene/named_many.cpp scene/narrow_phase.cpp scene/neighbours.cpp scene/part.cpp
            scene/passes.cpp scene/plan.cpp scene/simulation.cpp
            scene/world_setup.cpp ${effect_sources})
add_library(plumb::scene ALIAS plumb_scene)
set_target_properties(plumb_scene PROPERTIES PLUMB_EFFECTS "${plumb_effects}")
set_source_files_properties(scene/effects.cpp PROPERTIES INCLUDE_DIRECTORIES ${CMAKE_CURRENT_BINARY_DIR}/effects)
# Each effect an object of its own: a program whose list leaves one out does not link it.
set_source_files_properties(scene/effects.cpp ${effect_sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
target_link_libraries(plumb_scene PUBLIC plumb_solver PRIVATE $<BUILD_INTERFACE:plumb_flags> $<BUILD_INTERFACE:Boost::headers>)
# Threads for the solver's calls in a step, where the compiler has them; g++'s flag is nothing for clang-tidy.
if(NOT PLUMB_ONE_COMPILATION)
  find_package(OpenMP COMPONENTS CXX)
endif()
if(OpenMP_CXX_FOUND)
  target_link_libraries(plumb_scene PRIVATE OpenMP::OpenMP_CXX)
endif()
# As for the methods: small functions of contacts, of which -O2 makes calls.
target_compile_options(plumb_scene PRIVATE $<$<CONFIG:Release>:-O3>)
target_compile_definitions(plumb_scene PRIVATE EIGEN_DONT_PARALLELIZE)
