#include <glisson/core/backend.hpp>
