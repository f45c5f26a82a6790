#include <glisson/run/make_simulation.hpp>
