// All laws of membranes and shells; core/materials/shell_law_table.hpp has their parameters as data.
#pragma once

#include <glisson/core/materials/laws.hpp>
#include <glisson/shells/laws/fung.hpp>
#include <glisson/shells/laws/linear.hpp>
#include <glisson/shells/laws/neo_hookean.hpp>
#include <glisson/shells/laws/two_fibre.hpp>

namespace glisson::shells {

template <class R>
using MembraneLaws = TypeList<Linear<R>, NeoHookean<R>, NeoHookeanCompressible<R>, Fung<R>, TwoFibre<R>>;
/// Those that may be the membrane part of a rotation-free shell.
template <class R>
using ShellLaws = TypeList<Linear<R>, NeoHookean<R>, NeoHookeanCompressible<R>>;

}  // namespace glisson::shells
