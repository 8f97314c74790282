# cmake -D SOURCE=REPOSITORY -D TABLES=FILE;.. -D OUT=FOLDER -P seed.cmake
#
# Writes solver/ with the tables' bugs in it to OUT/solver, and OUT/bugs.inc: the bugs' numbers and rows. A row is
#   name, kind, seen   what it is, in words, and what a user would see of it
#   file               under solver/
#   find               text that is there exactly once; without it, that is `right`
#   right, wrong       the part of it that is replaced: an expression by (seeded_bug() == K ? (wrong) : (right)), what ends with
#                      ";" by if (seeded_bug() == K) { wrong } else { right }
#   survives           why no engine kills it; absent where one should
# A row that no longer fits the sources ends this with its name: rows do not rot.
cmake_minimum_required(VERSION 3.25)

function(refuse reason)
  message(NOTICE "${table}: ${name}: ${reason}")  # on one line, which FATAL_ERROR breaks
  message(FATAL_ERROR "no bugs were seeded")
endfunction()

function(require_once text part what)
  string(FIND "${text}" "${part}" first)
  string(FIND "${text}" "${part}" last REVERSE)
  if(first EQUAL -1)
    refuse("${what} is not there")
  elseif(NOT first EQUAL last)
    refuse("${what} is there more than once")
  endif()
endfunction()

# The row's `field` to the variable of that name; `otherwise` where it has none.
macro(read_field field)
  string(JSON ${field} ERROR_VARIABLE error GET "${row}" ${field})
  if(error AND ${ARGC} GREATER 1)
    set(${field} "${ARGV1}")
  elseif(error)
    refuse("has no ${field}")
  endif()
endmacro()

function(mutation out)
  if(right MATCHES ";$")
    set(${out} "if (::plumb::seeded_bug() == ${number}) { ${wrong} } else { ${right} }" PARENT_SCOPE)
  else()
    set(${out} "(::plumb::seeded_bug() == ${number} ? (${wrong}) : (${right}))" PARENT_SCOPE)
  endif()
endfunction()

file(GLOB_RECURSE files RELATIVE ${SOURCE}/solver ${SOURCE}/solver/*.hpp ${SOURCE}/solver/*.cpp ${SOURCE}/solver/*.h)
list(FILTER files EXCLUDE REGEX "^(reference|batch)/|^scene/[^/]*$|^scene/(body|contact|effect|material|named)/")
foreach(file IN LISTS files)
  file(READ ${SOURCE}/solver/${file} "pristine_${file}")
  set("mutated_${file}" "${pristine_${file}}")
endforeach()

set(number 0)
set(names)
set(rows)
set(table_text)
foreach(table IN LISTS TABLES)
  file(READ ${table} json)
  string(JSON count LENGTH "${json}")
  foreach(index RANGE 1 ${count})
    math(EXPR number "${number} + 1")
    math(EXPR position "${index} - 1")
    string(JSON row GET "${json}" ${position})
    set(name "row ${index}")
    read_field(name)
    if(NOT name MATCHES "^[a-z][a-z0-9-]*$" OR name STREQUAL "none" OR name IN_LIST names)
      refuse("no name for a bug, or another's")
    endif()
    foreach(field IN ITEMS kind seen file right wrong)
      read_field(${field})
    endforeach()
    read_field(find "${right}")
    if(NOT file IN_LIST files)
      refuse("solver/${file} is not there")
    endif()
    require_once("${pristine_${file}}" "${find}" "in solver/${file}, what it would find,")
    require_once("${find}" "${right}" "in `find`, `right`")
    mutation(mutated)
    string(REPLACE "${right}" "${mutated}" seeded "${find}")
    require_once("${mutated_${file}}" "${find}" "in solver/${file}, what it would find, with the earlier bugs in,")
    string(REPLACE "${find}" "${seeded}" "mutated_${file}" "${mutated_${file}}")
    list(APPEND names ${name})
    string(APPEND rows "{\"${name}\", ${number}},\n")
    string(APPEND table_text "${separator}${row}")
    set(separator ",\n")
  endforeach()
endforeach()

# Only what has changed is written: the rest need not be compiled again.
function(write_if_different path text)
  file(CONFIGURE OUTPUT ${path} CONTENT "@text@" @ONLY NEWLINE_STYLE UNIX)
endfunction()
foreach(file IN LISTS files)
  write_if_different(${OUT}/solver/${file} "${mutated_${file}}")
endforeach()
write_if_different(${OUT}/bugs.inc "constexpr Row kRows[] = {\n${rows}};
constexpr char kTable[] = PLUMB_SEEDED_BUGS_MARK R\"table(\n[${table_text}])table\";\n")
