# What other projects get: cmake --install BUILD --component development, or all of it. find_package(plumb COMPONENTS ..) and
# pkg-config plumb find it there; the headers are <plumb/...>, the sources' own "solver/..." written anew.
include(CMakePackageConfigHelpers)

# A component's public headers are those named here and all that they include.
function(plumb_closure out)
  set(found ${ARGN})
  set(open ${ARGN})
  while(open)
    list(POP_FRONT open header)
    file(STRINGS ${CMAKE_CURRENT_SOURCE_DIR}/${header} lines REGEX "^#include \"[^\"]+\"")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include \"(solver/)?([^\"]+)\".*" "\\2" included "${line}")
      if(NOT included IN_LIST found)
        list(APPEND found ${included})
        list(APPEND open ${included})
      endif()
    endforeach()
  endwhile()
  set(${out} ${found} PARENT_SCOPE)
endfunction()

# plumb_install_headers(HEADER..) writes them and their closure to build/include/plumb and installs them from there.
set(plumb_include ${CMAKE_CURRENT_BINARY_DIR}/include)
function(plumb_install_headers)
  plumb_closure(headers ${ARGN})
  foreach(header IN LISTS headers)
    file(READ ${CMAKE_CURRENT_SOURCE_DIR}/${header} text)
    string(REPLACE "#include \"solver/" "#include \"plumb/" text "${text}")
    file(CONFIGURE OUTPUT include/plumb/${header} CONTENT "${text}" @ONLY)
    get_filename_component(folder ${header} DIRECTORY)
    install(FILES ${plumb_include}/plumb/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plumb/${folder} COMPONENT development)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
  endforeach()
endfunction()

# plumb_install_library(COMPONENT TARGET..): what find_package's COMPONENT brings, as plumb::NAME.
function(plumb_install_library component)
  foreach(target IN LISTS ARGN)
    string(REPLACE plumb_ "" name ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
    target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  endforeach()
  install(TARGETS ${ARGN} EXPORT plumb-${component}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT development)
  install(EXPORT plumb-${component} NAMESPACE plumb:: FILE plumb-${component}.cmake DESTINATION ${plumb_cmake}
          COMPONENT development)
endfunction()

# plumb_install_pkgconfig(NAME LIBRARY DESCRIPTION) for the C libraries; the tree may be moved as a whole.
function(plumb_install_pkgconfig name library description)
  file(RELATIVE_PATH plumb_up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  configure_file(plumb.pc.in ${name}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endfunction()

set(plumb_cmake ${CMAKE_INSTALL_LIBDIR}/cmake/plumb)
plumb_install_headers(contact.hpp pose.hpp diagnosis.hpp method/methods.hpp method/automatic.hpp method/convex.hpp shape/superellipsoid.hpp
                      shape/hull.hpp shape/chart.hpp shape/curvature.hpp shape/ray.hpp patch/patch.hpp plumb.h plumb_solver.h plumb_adapter.hpp
                      plumb_recorder.h)
plumb_install_library(solver plumb_solver plumb_scalars)
plumb_install_headers(batch/batch.hpp)
plumb_install_library(batch plumb_batch)
plumb_install_library(c plumb_c)
plumb_install_pkgconfig(plumb plumb "Contacts of ellipsoids and superquadrics by their common normal")
if(PLUMB_REFERENCE)
  plumb_install_headers(reference/reference.hpp reference/convex_bounds.hpp reference/search/stationary.hpp reference/condition/condition_proof.hpp reference/condition/nearby.hpp
                        reference/touch/touch.hpp)
  plumb_install_library(reference plumb_reference)
  plumb_install_library(certify plumb_certify)
  plumb_install_pkgconfig(plumb-certify plumb_certify "Certificates of such contacts, by interval arithmetic")
endif()
if(PLUMB_SCENE)
  plumb_install_headers(scene/simulation.hpp scene/named.hpp scene/check_scene.hpp)
  plumb_install_library(scene plumb_scene)
endif()

configure_package_config_file(plumb-config.cmake.in plumb-config.cmake INSTALL_DESTINATION ${plumb_cmake})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/plumb-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/plumb-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/plumb-config-version.cmake
        DESTINATION ${plumb_cmake} COMPONENT development)
