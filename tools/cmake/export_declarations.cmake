cmake_minimum_required(VERSION 3.25)

# Writes RESULT, a linker's version script that makes visible what headers in FOLDERS of the project at ROOT
# declare, and hides all else: those that HEADERS include, which are installed, and those that files of
# other folders include.
include(${CMAKE_CURRENT_LIST_DIR}/included_headers.cmake)

file(GLOB others RELATIVE ${ROOT} ${ROOT}/vo/*/*.cpp ${ROOT}/vo/*/*.h ${ROOT}/synth/*/*.cpp
     ${ROOT}/synth/*/*.h)
list(JOIN FOLDERS "|" own)
list(FILTER others EXCLUDE REGEX "^(${own})/[^/]*$")
edvo_included_headers(${ROOT} headers ${HEADERS} ${others})
list(FILTER headers INCLUDE REGEX "^(${own})/[^/]*\\.h$")

# The format of the sources puts what a namespace declares at the beginning of a line. A question mark
# stands for a space or a bracket, which a pattern cannot hold.
set(patterns)
foreach(header IN LISTS headers)
  string(REGEX MATCH "^[a-z]+" namespace ${header})
  file(STRINGS ${ROOT}/${header} classes REGEX "^(class|struct) [A-Za-z0-9]+.*{$")
  foreach(class IN LISTS classes)
    string(REGEX REPLACE "^(class|struct) ([A-Za-z0-9]+).*$" "${namespace}::\\2" class "${class}")
    list(APPEND patterns "${class}::*" "typeinfo?for?${class}" "typeinfo?name?for?${class}" "vtable?for?${class}")
  endforeach()
  file(STRINGS ${ROOT}/${header} functions REGEX "^(\\[\\[noreturn\\]\\] )?[A-Za-z][^(]*[ &*][A-Za-z0-9_]+\\(")
  foreach(function IN LISTS functions)
    string(REGEX REPLACE "^[^(]*[ &*]([A-Za-z0-9_]+)\\(.*$" "${namespace}::\\1" function "${function}")
    list(APPEND patterns "${function}?*")
  endforeach()
  file(STRINGS ${ROOT}/${header} operators REGEX "^[A-Za-z][^(]* operator")
  if(operators)
    list(APPEND patterns "${namespace}::operator*")
  endif()
endforeach()
list(REMOVE_DUPLICATES patterns)
list(SORT patterns)
list(JOIN patterns ";\n    " lines)
file(WRITE ${RESULT} "{\nglobal:\n  extern \"C++\" {\n    ${lines};\n  };\nlocal:\n  *;\n};\n")
