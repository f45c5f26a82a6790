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
