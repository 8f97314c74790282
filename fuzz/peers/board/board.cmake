# The adapters of the board, one shared library each in BUILD/board, by `ninja board_peers`: nothing of it is in `all`, and each is
# there only where its Debian package is (.ci/setup.sh, group board). They stand on solver/plumb_adapter.hpp alone.
add_custom_target(board_peers)

# add_board_peer(NAME SOURCE INCLUDES LIBRARY..): NAME is what the solver calls itself. One that is not installed is left out.
function(add_board_peer name source include)
  if(NOT include)
    set(missing "its headers")
  endif()
  foreach(library IN LISTS ARGN)
    find_library(PLUMB_BOARD_${library} ${library})
    mark_as_advanced(PLUMB_BOARD_${library})
    if(NOT PLUMB_BOARD_${library})
      set(missing lib${library})
    endif()
    list(APPEND libraries ${PLUMB_BOARD_${library}})
  endforeach()
  if(missing)
    message(STATUS "board: no ${name}, for want of ${missing}")
    return()
  endif()
  add_library(board_${name} MODULE EXCLUDE_FROM_ALL peers/board/${source})
  target_compile_definitions(board_${name} PRIVATE BOARD_NAME="${name}")
  target_include_directories(board_${name} SYSTEM PRIVATE ${include})
  target_link_libraries(board_${name} PRIVATE plumb_flags ${libraries})
  # The header's own standard; Simbody's headers do not compile with a later one.
  set_target_properties(board_${name} PROPERTIES CXX_STANDARD 17 PREFIX "" OUTPUT_NAME ${name}
                        LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/board)
  add_dependencies(board_peers board_${name})
endfunction()

find_path(PLUMB_BOARD_BULLET btBulletCollisionCommon.h PATH_SUFFIXES bullet)
find_path(PLUMB_BOARD_SIMBODY SimTKmath.h PATH_SUFFIXES simbody)
find_path(PLUMB_BOARD_MUJOCO mujoco/mujoco.h)

foreach(solver pair epa mpr)
  add_board_peer(bullet-${solver}-float bullet_${solver}.cpp "${PLUMB_BOARD_BULLET}" BulletCollision LinearMath)
  add_board_peer(bullet-${solver}-double bullet_${solver}.cpp "${PLUMB_BOARD_BULLET}" BulletCollision-float64 LinearMath-float64)
  if(TARGET board_bullet-${solver}-double)
    target_compile_definitions(board_bullet-${solver}-double PRIVATE BT_USE_DOUBLE_PRECISION)
  endif()
endforeach()
add_board_peer(simbody simbody.cpp "${PLUMB_BOARD_SIMBODY}" SimTKmath SimTKcommon)
add_board_peer(mujoco mujoco.cpp "${PLUMB_BOARD_MUJOCO}" mujoco)
