# Tests of the tree itself: include arrows, sizes, and headers that compile alone.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

set(GLISSON_CHECKS ${PROJECT_SOURCE_DIR}/tests/checks)
add_test(NAME checks.includes
  COMMAND ${Python3_EXECUTABLE} ${GLISSON_CHECKS}/check_includes.py ${PROJECT_SOURCE_DIR})
add_test(NAME checks.size COMMAND ${Python3_EXECUTABLE} ${GLISSON_CHECKS}/check_size.py ${PROJECT_SOURCE_DIR})
add_test(NAME checks.themselves COMMAND ${Python3_EXECUTABLE} ${GLISSON_CHECKS}/test_checks.py)

# Every public header alone, those that a source includes first aside: that source is the proof. Not part of the default
# build: the test builds it.
set(folders core cpu cuda contact shells models run)
set(headers "")
set(first_includes "")
foreach(folder IN LISTS folders)
  file(GLOB_RECURSE found CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/${folder}/*.hpp)
  list(APPEND headers ${found})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.cpp)
  foreach(source IN LISTS sources)
    file(STRINGS ${source} first LIMIT_COUNT 1 REGEX "^#include")
    string(REGEX REPLACE "^#include [<\"](glisson/)?([^>\"]*).*" "\\2" first "${first}")
    list(APPEND first_includes "${first}")
  endforeach()
endforeach()
list(REMOVE_ITEM headers ${first_includes})
set(sources "")
foreach(header IN LISTS headers)
  string(MAKE_C_IDENTIFIER ${header} name)
  set(source ${PROJECT_BINARY_DIR}/checks/headers/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "#include <glisson/${header}>\n#include <glisson/${header}>\n")
  list(APPEND sources ${source})
endforeach()
add_library(check_headers OBJECT EXCLUDE_FROM_ALL ${sources})
target_link_libraries(check_headers PRIVATE glisson::run glisson::models glisson::contact glisson::shells glisson::cpu glisson::cuda
  glisson::core)
target_compile_options(check_headers PRIVATE -O0 -Wall -Wextra -Wno-missing-field-initializers)
if(NOT GLISSON_SANITIZE)
  add_test(NAME checks.headers_compile_alone
    COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target check_headers)
  set_tests_properties(checks.headers_compile_alone PROPERTIES TIMEOUT 900 RUN_SERIAL ON)
endif()
