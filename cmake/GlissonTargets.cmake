# glisson_library(name SOURCES... DEPENDS ...): a folder of the tree as a library with the alias glisson::name.
# Folders are reached as <glisson/name/...> in the build tree through links, after installation as they are.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/include/glisson)

function(glisson_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/include/glisson/${name} SYMBOLIC)
  add_library(glisson_${name} STATIC ${arg_SOURCES})
  add_library(glisson::${name} ALIAS glisson_${name})
  set_target_properties(glisson_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(glisson_${name} PUBLIC cxx_std_20)
  target_include_directories(glisson_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(glisson_${name} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
  glisson_warnings(glisson_${name})
  glisson_precompile(glisson_${name})
  install(TARGETS glisson_${name} EXPORT GlissonTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/glisson/${name}
    FILES_MATCHING PATTERN "*.hpp")
endfunction()

# glisson_precompile(target [headers]): what most files include, and these.
function(glisson_precompile target)
  if(GLISSON_QUICK_BUILD OR GLISSON_PRECOMPILED)
    target_precompile_headers(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:${PROJECT_SOURCE_DIR}/cmake/precompiled.hpp> ${ARGN})
    # g++ 12 warns of its own headers once they are precompiled
    target_compile_options(${target} PRIVATE "$<$<AND:$<COMPILE_LANGUAGE:CXX>,$<CXX_COMPILER_ID:GNU>>:-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-array-bounds>")
  endif()
endfunction()

function(glisson_warnings target)
  target_compile_options(${target} PRIVATE
    "$<$<COMPILE_LANGUAGE:CXX>:-Wall;-Wextra;-Wshadow;-Wpedantic;-Wno-missing-field-initializers>"
    $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>  # wrong in g++ 12 (bug 105651)
    $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<BOOL:${GLISSON_WERROR}>>:-Werror>)
  if(GLISSON_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${GLISSON_SANITIZE} -fno-omit-frame-pointer
      $<$<CXX_COMPILER_ID:GNU>:-fno-sanitize-recover=all>)
    if(GLISSON_NO_SANITIZE)
      target_compile_options(${target} PRIVATE -fno-sanitize=${GLISSON_NO_SANITIZE})
    endif()
    target_link_options(${target} PUBLIC -fsanitize=${GLISSON_SANITIZE})
  endif()
  if(GLISSON_BUILD_FUZZERS)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()
