# The constitutive laws as Class:header (core/materials/<header>.hpp). Instantiation files are written from this list;
# the same classes stand in core/materials/laws.hpp, and a test compares the two.
set(GLISSON_LAWS
  "NeoHookean:neo_hookean"
  "StVenantKirchhoff:st_venant_kirchhoff"
  "ArrudaBoyce:arruda_boyce"
  "Polynomial:polynomial"
  "TransverselyIsotropic:transversely_isotropic"
  "Ogden:ogden"
)

# glisson_law_files(out prefix type law_template find_template): one file per law and precision, which defines
# <prefix>_<law>_<precision>(), and one that looks these up, a pointer to LawKernels<type<precision>> each.
function(glisson_law_files out prefix type law_template find_template)
  string(REGEX REPLACE "^.*(\\.[a-z]+)\\.in$" "\\1" extension ${law_template})
  set(files)
  set(DECLARATIONS "")
  foreach(LAW_REAL IN ITEMS float double)
    set(calls "")
    foreach(law IN LISTS GLISSON_LAWS)
      string(REPLACE ":" ";" law ${law})
      list(GET law 0 LAW_CLASS)
      list(GET law 1 LAW_HEADER)
      set(file ${CMAKE_CURRENT_BINARY_DIR}/solids_${LAW_HEADER}_${LAW_REAL}${extension})
      configure_file(${law_template} ${file} @ONLY)
      list(APPEND files ${file})
      set(function ${prefix}_${LAW_CLASS}_${LAW_REAL})
      string(APPEND DECLARATIONS "const LawKernels<${type}<${LAW_REAL}>>* ${function}();\n")
      list(APPEND calls "detail::${function}()")
    endforeach()
    list(JOIN calls ", " CALLS_${LAW_REAL})
  endforeach()
  set(file ${CMAKE_CURRENT_BINARY_DIR}/find_kernels${extension})
  configure_file(${find_template} ${file} @ONLY)
  set(${out} ${files} ${file} PARENT_SCOPE)
endfunction()
