#include <glisson/core/mesh/mesh.hpp>
