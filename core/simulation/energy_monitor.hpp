// Energies of a run and the check that they balance.
#pragma once

#include <vector>

#include <glisson/core/any_simulation.hpp>
#include <glisson/core/simulation/archive.hpp>
#include <glisson/core/simulation/node_state.hpp>

namespace glisson {

/// Share by which the energies fail to balance: |imbalance| / largest energy that ever took part [-].
double relative_imbalance(const Energies& energies, double largest);
/// The largest term, the scale of the balance [J].
double largest_term(const Energies& energies);

/// Accumulates what the node update dissipates and holds the last complete account.
template <class B, class R>
class EnergyMonitor {
 public:
  EnergyMonitor(B& backend, int node_count)
      : backend_(backend),
        host_(static_cast<std::size_t>(chunks_of(node_count, node_energy_chunk))),
        chunks_(backend.template allocate<NodeEnergies>(host_.size())) {
    backend_.copy_in(host_.data(), chunks_.get(), host_.size());
  }

  NodeEnergies* chunks() const { return chunks_.get(); }
  int chunk_count() const { return static_cast<int>(host_.size()); }
  const Energies& last() const { return last_; }
  double last_time() const { return time_; }

  /// Only what the node update knows.
  Energies node_sums() const {
    backend_.copy_out(chunks_.get(), host_.data(), host_.size());
    NodeEnergies sum;
    for (const auto& c : host_) {
      sum.kinetic += c.kinetic;
      sum.damping += c.damping;
      sum.damping_ahead += c.damping_ahead;
    }
    Energies parts;
    parts.kinetic = sum.kinetic;
    parts.damping = sum.damping - sum.damping_ahead;
    return parts;
  }
  /// Completes the account of time t from its parts; returns the relative imbalance.
  double close(double t, Energies parts, bool prony) {
    if (!started_) initial_ = parts.kinetic + parts.strain + parts.hourglass;
    started_ = true;
    parts.initial = initial_;
    if (prony) parts.viscous = parts.imbalance();  // what the laws' own energy does not explain
    largest_ = std::max(largest_, largest_term(parts));
    last_ = parts;
    time_ = t;
    return relative_imbalance(parts, largest_);
  }

  void save(std::ostream& out) const {
    std::vector<NodeEnergies> now(host_.size());
    backend_.copy_out(chunks_.get(), now.data(), now.size());
    write_array<NodeEnergies>(out, now);
    write_value(out, last_);
    write_value(out, Scalars{time_, initial_, largest_, started_});
  }
  void load(std::istream& in) {
    host_ = read_array<NodeEnergies>(in, host_.size());
    backend_.copy_in(host_.data(), chunks_.get(), host_.size());
    last_ = read_value<Energies>(in);
    const auto s = read_value<Scalars>(in);
    time_ = s.time, initial_ = s.initial, largest_ = s.largest, started_ = s.started;
  }

 private:
  struct Scalars {
    double time, initial, largest;
    bool started;
  };

  B& backend_;
  mutable std::vector<NodeEnergies> host_;
  Buffer<NodeEnergies> chunks_;
  Energies last_;
  double time_ = 0, initial_ = 0, largest_ = 0;
  bool started_ = false;
};

}  // namespace glisson
