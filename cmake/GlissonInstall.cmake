# Installation and the package that find_package(Glisson) finds; examples/ build against it.
include(CMakePackageConfigHelpers)

configure_file(${PROJECT_SOURCE_DIR}/cmake/version.hpp.in ${PROJECT_BINARY_DIR}/include/glisson/version.hpp @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/include/glisson/version.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/glisson)

set(GLISSON_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Glisson)
install(EXPORT GlissonTargets NAMESPACE glisson:: DESTINATION ${GLISSON_PACKAGE_DIR})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/GlissonConfig.cmake.in
  ${PROJECT_BINARY_DIR}/GlissonConfig.cmake INSTALL_DESTINATION ${GLISSON_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/GlissonConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/GlissonConfig.cmake ${PROJECT_BINARY_DIR}/GlissonConfigVersion.cmake
  DESTINATION ${GLISSON_PACKAGE_DIR})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${PROJECT_SOURCE_DIR}/models/format/glisson.xsd DESTINATION ${CMAKE_INSTALL_DATADIR}/glisson)
