# The constitutive laws as Class:header (core/materials/<header>.hpp). Instantiation files are written from this list;
# the same classes stand in core/materials/laws.hpp, and a test compares the two.
set(GLISSON_LAWS
  "NeoHookean:neo_hookean"
)
