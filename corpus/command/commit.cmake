# cmake -D SOURCE=.. -D HEADER=.. -P commit.cmake: writes the commit that is built into a header, anew only when it is another.
execute_process(COMMAND git describe --always --dirty WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE commit
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#define PLUMB_COMMIT \"${commit}\"\n")
