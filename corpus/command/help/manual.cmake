# Man pages of plumb and of each program that is installed, from what --help prints, where help2man is there; completion for bash and zsh.
install(FILES corpus/command/help/shell/plumb.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME plumb COMPONENT programs)
install(FILES corpus/command/help/shell/_plumb DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT programs)

find_program(PLUMB_HELP2MAN help2man)
if(NOT PLUMB_HELP2MAN)
  return()
endif()
set(manual ${PROJECT_BINARY_DIR}/share/man/man1)
set(commands ${plumb_programs})
list(FILTER commands EXCLUDE REGEX "-host$")  # the processes of foreign solvers are nobody's command
foreach(program IN LISTS commands)
  # plumb's own page lists those that there are.
  set(described ${program})
  if(program STREQUAL "plumb")
    set(described ${commands})
  endif()
  add_custom_command(OUTPUT ${manual}/${program}.1 VERBATIM DEPENDS ${described} plumb ${PROJECT_SOURCE_DIR}/corpus/command/help/manual
    COMMAND ${PROJECT_SOURCE_DIR}/corpus/command/help/manual $<TARGET_FILE_DIR:plumb> ${program} ${manual}/${program}.1
    COMMENT "Man page of ${program}")
  list(APPEND pages ${manual}/${program}.1)
endforeach()
add_custom_target(manual ALL DEPENDS ${pages})
install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT programs)
