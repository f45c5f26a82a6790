// The common tail of all loads: add a force to each node of a list and, when energies are wanted, count the
// work it does.
#pragma once

#include <vector>

#include <glisson/core/chunk_sums.hpp>
#include <glisson/core/loads/provider_bytes.hpp>
#include <glisson/core/loads/upload.hpp>

namespace glisson {

template <class R>
GLISSON_HD Vec3<R> xyz(const Vec4<R>& a) {
  return {a.x, a.y, a.z};
}

template <class R>
GLISSON_HD bool is_zero(const Vec3<R>& a) {
  return a.x == R(0) && a.y == R(0) && a.z == R(0);
}

constexpr int entries_per_sum = 16;  ///< small, so that short lists still make enough bodies for a team

/// f[n] += rule.force(i, n) for entry i of a list. A node occurs once in a list. nodes = nullptr: entry i is
/// node i.
template <class R, class Rule>
struct AddForces {
  Rule rule;
  const int* nodes;  ///< internal node of an entry, ascending [-]  [entry_count]
  Vec4<R>* f;        ///< force [N]                                 [node_count]
  int node_count;

  GLISSON_HD int node(int i) const { return nodes ? nodes[i] : i; }
  GLISSON_HD Vec3<R> add(int i) const {
    const int n = node(i);
    const Vec3<R> g = rule.force(i, n);
    if (is_zero(g)) return g;
    f[n] = {f[n].x + g.x, f[n].y + g.y, f[n].z + g.z, f[n].w};
    return g;
  }
  GLISSON_HD void operator()(int i) const { add(i); }
};

/// (g(n-1) + g(n)) . v(n-1/2), in double: times half the step it is the work of a force [W].
template <class R>
GLISSON_HD double twice_power(const Vec3<R>& before, const Vec3<R>& g, const Vec4<R>& v) {
  return (double(before.x) + double(g.x)) * double(v.x) + (double(before.y) + double(g.y)) * double(v.y) +
         (double(before.z) + double(g.z)) * double(v.z);
}

/// AddForces over chunks of entries, with the work of the step that ended now, (g(n-1) + g(n))/2 . dt
/// v(n-1/2), in double.
template <class R, class Rule>
struct AddForcesWithWork {
  static constexpr int chunk = entries_per_sum, cost = 10 * chunk;
  AddForces<R, Rule> forces;
  const Vec4<R>* v;  ///< velocity at t - dt/2 [m/s]  [node_count]
  double* work;      ///< [J]                         [ceil(count / chunk)]
  int count;         ///< entries
  double half_dt;  ///< half of the step that ended now, 0 if none did [s]
  R share;         ///< share of this step's force that the next step counts [-]
  int node_count = forces.node_count;

  using Sum = double;
  GLISSON_HD int node(int c) const { return forces.node(c * chunk); }
  GLISSON_HD int entry_count() const { return count; }
  GLISSON_HD void add(int i, Sum& sum) const {
    const int n = forces.node(i);
    const Vec3<R> before = forces.rule.before(i, n);
    const Vec3<R> g = forces.add(i);
    if (is_zero(before) && is_zero(g)) return;  // most nodes of contact: spares their velocities
    sum += twice_power(before, g, v[n]);
    forces.rule.remember(i, share * g);
  }
  GLISSON_HD static void join(Sum& a, const Sum& b) { a += b; }
  GLISSON_HD void leave(int c, const Sum& sum) const {
    if (half_dt > 0) work[c] += half_dt * sum;
  }
  GLISSON_HD void operator()(int c) const { run_chunk(*this, c); }
};

/// For rules whose last force must be stored; rules proportional to an amplitude compute it instead.
template <class R>
struct LastForces {
  Vec4<R>* last = nullptr;  ///< [N]  [entry_count]
  GLISSON_HD Vec3<R> before(int i, int) const { return xyz(last[i]); }
  GLISSON_HD void remember(int i, const Vec3<R>& g) const { last[i] = {g.x, g.y, g.z, R(0)}; }
};

/// Work of one list of forces since the start. The central difference keeps KE(n) = sum m v(n-1/2).v(n+1/2)/2
/// in balance with the trapezoidal work (g(n-1) + g(n))/2 . (u(n) - u(n-1)) of all forces. The velocity
/// starts at t = 0, half a step before v(1/2): the force of step 0 acts for half a step only and counts half.
template <Backend B, class R>
class ListWork {
 public:
  ListWork(B& backend, int entry_count)
      : backend_(backend),
        entry_count_(entry_count),
        chunk_count_(chunks_of(entry_count, entries_per_sum)),
        chunks_(detail::zeros<double>(backend, std::size_t(chunk_count_))) {}

  /// Adds the rule's forces; counts work when the step asks for it.
  template <class Rule>
  void run(const StepView<R>& step, const int* nodes, const Rule& rule) {
    run(step, nodes, rule, entry_count_);
  }
  /// The same for a list that holds `count` entries now, at most as many as were announced.
  template <class Rule>
  void run(const StepView<R>& step, const int* nodes, const Rule& rule, int count) {
    const AddForces<R, Rule> forces{rule, nodes, step.f, step.node_count};
    if (counts(step))
      backend_.for_each(
          chunks_of(count, entries_per_sum),
          AddForcesWithWork<R, Rule>{forces, step.v, chunks_.get(), count, half_dt(), R(share(step))});
    else
      backend_.for_each(count, forces);
    finish(step);
  }

  static bool counts(const StepView<R>& step) { return step.advance && step.monitor; }
  static double share(const StepView<R>& step) { return step.step == 0 ? 0.5 : 1.0; }
  /// Half of the step that ended now; 0 when the forces at its beginning are not known [s].
  double half_dt() const { return 0.5 * dt_before_; }
  double* chunks() const { return chunks_.get(); }
  int chunk_count() const { return chunk_count_; }
  void finish(const StepView<R>& step) {
    if (step.advance) dt_before_ = step.monitor ? step.dt : 0;
  }

  double total() const {
    std::vector<double> host(static_cast<std::size_t>(chunk_count_));
    if (chunk_count_) backend_.copy_out(chunks_.get(), host.data(), host.size());
    double sum = 0;
    for (const double part : host) sum += part;
    return sum;
  }
  void save(detail::ByteWriter& out) const {
    out.value(dt_before_).buffer(backend_, chunks_, std::size_t(chunk_count_));
  }
  void load(detail::ByteReader& in) {
    in.value(dt_before_);
    in.buffer(backend_, chunks_, std::size_t(chunk_count_));
  }

 private:
  B& backend_;
  int entry_count_, chunk_count_;
  Buffer<double> chunks_;
  double dt_before_ = 0;  ///< of the last counted step; 0: none [s]
};

}  // namespace glisson
