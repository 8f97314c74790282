# Other people's solvers behind solver/plumb_solver.h: one shared library each, in the folder where corpus/solvers/foreign_solver.cpp
# looks for them, and only where what they need is installed.
find_library(PLUMB_LIBCCD ccd)
find_path(PLUMB_LIBCCD_INCLUDE ccd/ccd.h)
# Its headers have no version; pkg-config has.
find_package(PkgConfig QUIET)
if(PKG_CONFIG_FOUND)
  pkg_check_modules(PLUMB_LIBCCD_PC QUIET ccd)
endif()
find_library(PLUMB_LIBFCL fcl)
find_path(PLUMB_LIBFCL_INCLUDE fcl/fcl.h)

function(add_peer name)
  add_library(peer_${name} MODULE peers/peer.cpp ${ARGN})
  target_include_directories(peer_${name} SYSTEM PRIVATE ${PLUMB_LIBCCD_INCLUDE})
  target_compile_definitions(peer_${name} PRIVATE PLUMB_LIBCCD_VERSION="${PLUMB_LIBCCD_PC_VERSION}")
  target_link_libraries(peer_${name} PRIVATE plumb_solver plumb_flags ${PLUMB_LIBCCD})
  set_target_properties(peer_${name} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/peers)
  add_dependencies(peers peer_${name})
endfunction()

if(PLUMB_LIBCCD AND PLUMB_LIBCCD_INCLUDE)
  add_peer(libccd_epa peers/libccd_epa.cpp peers/libccd.cpp)
  add_peer(libccd_mpr peers/libccd_mpr.cpp peers/libccd.cpp)
  if(PLUMB_LIBFCL AND PLUMB_LIBFCL_INCLUDE)
    add_peer(fcl peers/fcl.cpp)
    target_include_directories(peer_fcl SYSTEM PRIVATE ${PLUMB_LIBFCL_INCLUDE})
    target_link_libraries(peer_fcl PRIVATE ${PLUMB_LIBFCL})
    target_compile_definitions(peer_fcl PRIVATE NDEBUG)  # see fcl.cpp
  endif()
endif()
