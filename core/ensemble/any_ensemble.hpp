// Many simulations of one mesh that differ in material parameters, loads, boundary values and time settings.
#pragma once

#include <cstdint>
#include <string>

#include <glisson/core/any_simulation.hpp>

namespace glisson {

enum class MemberStatus {
  running,
  finished,  ///< reached its end time, or its quasi-static run ended (see report().ending)
  failed,    ///< stopped where it was; error() says why. The others go on.
};

/// Members are numbered from 0. Each has its own time step, step count, energies and results, and gets the
/// same bits alone and among others, for any number of threads.
class AnyEnsemble {
 public:
  virtual ~AnyEnsemble() = default;

  virtual int member_count() const = 0;
  /// Advances every member that still runs by `count` of its own steps. A member that fails does not throw.
  virtual void step(std::int64_t count = 1) = 0;
  virtual MemberStatus status(int member) const = 0;
  /// Why a failed member stopped; empty for the others.
  virtual const std::string& error(int member) const = 0;
  /// State and results of a member; of a failed one, where it stopped. Throws Error(run) if it failed before
  /// its first step. Do not step it by itself.
  virtual AnySimulation& member(int member) = 0;

  virtual std::string device() const = 0;  ///< "Ensemble float, 2 threads, avx512: 16 members a group"
  virtual std::size_t memory_bytes() const = 0;

  /// No member runs any more.
  bool finished() const {
    for (int k = 0; k < member_count(); ++k)
      if (status(k) == MemberStatus::running) return false;
    return true;
  }
};

}  // namespace glisson
